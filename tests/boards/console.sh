#!/bin/sh
# SPDX-License-Identifier: MIT
# A program that shows a scene restores the console of a Debian kernel, however the
# program ends: mode, keyboard, console switching, terminal, frame buffer, card and the
# screen's text are equal before and after.
#
#   tests/boards/console.sh [PROGRAM]
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

scene=tank screen=build/host/scenes/tank-screen state=$TP_BUILD/tests/boards/vm_state

vm_lacks "the console of Linux" amd64 && exit 0
check "one static file shows a scene" alone build "$screen"
[ "$failed" = 0 ] || exit 1

cat >"$scratch/common" <<'EOF'
shows="tank-screen --on $on --size 64x48"

# A process keeps a console open; otherwise the kernel forgets its terminal's settings.
hold()
{
    [ -z "$holder" ] || kill $holder 2>/dev/null
    sleep 1000 </dev/tty1 &
    holder=$!
}

# begin PROGRAM...: starts the program on the first console, like a login there, and waits
# until it draws.
begin()
{
    hold
    echo >/tmp/said
    setsid -c "$@" </dev/tty1 >/tmp/said 2>&1 &
    parent=$!
    until_true grep -q "^frame" /tmp/said
    child=$(grep -l "^PPid:[^0-9]$parent$" /proc/[0-9]*/status | sed "s/[^0-9]//g")
}

# left CODE: the program has ended with this code, and the console is restored.
left()
{
    [ -z "$parent" ] || { wait $parent 2>/dev/null; code=$?; }
    cat /tmp/said
    vm_state /dev/tty1 >/tmp/after
    echo "exit $code"
    diff /tmp/before /tmp/after && [ $code = "$1" ]
}

# During the drawing all settings differ.
drawing()
{
    vm_state /dev/tty1 >/tmp/during
    cat /tmp/during
    grep -q "mode graphics" /tmp/during && grep -q "switching process" /tmp/during &&
        ! grep -x -F -q "$(grep terminal /tmp/before)" /tmp/during
}

echo "some text" >/dev/tty1
echo 0 >/sys/class/graphics/fbcon/cursor_blink
# Blinking may have ended while the cursor was off: hidden and shown again, it is on.
printf '\033[?25l\033[?25h' >/dev/tty1
hold
chvt 1
vm_state /dev/tty1 >/tmp/before
ask shot $boot-before
check "before, the console is a text console" grep -q "mode text" /tmp/before
[ -z "$things" ] || grep -v colour /tmp/before

begin $shows --hash
check "the console is taken while it draws" drawing
kill $parent
check "SIGTERM" left 143

$shows --frames 1 --hash </dev/tty1 >/tmp/said 2>&1 &
parent=$!
check "the last frame was shown" left 0

for signal in INT HUP QUIT SEGV ABRT BUS FPE ILL KILL; do
    begin $shows --hash
    kill -$signal $child
    check "SIG$signal to who draws" left $((128 + $(kill -l $signal)))
done
for signal in INT HUP SEGV ABRT KILL; do
    begin $shows --hash
    kill -$signal $parent
    until_true sh -c "! kill -0 $child 2>/dev/null"
    check "SIG$signal to who watches" left $((128 + $(kill -l $signal)))
done

begin $shows --hash
ask key ctrl-c
check "Ctrl-C on its keyboard" left 130
begin $shows --hash
ask key esc
check "Esc on its keyboard" left 0

begin $shows --hash
kill -STOP $child
kill -TERM $parent
check "SIGTERM while it is stopped" left 143

begin $shows --hash
chvt 2
vm_state /dev/tty2 >/tmp/away
check "another console is a text console" grep -q "mode text" /tmp/away
chvt 1
check "and coming back, it draws again" drawing
kill $parent
check "SIGTERM after another console was in front" left 143
begin $shows --hash
chvt 2
kill $parent
wait $parent
code=$? parent=
chvt 1
check "SIGTERM while another console is in front" left 143

ask shot $boot-after
EOF

cat >"$scratch/failures" <<'EOF'
refused()       # WORDS OPTION...: exit 4 and one line
{
    words=$1; shift
    tank-screen --on $on "$@" </dev/tty1 >/tmp/said 2>&1 &
    parent=$!
    left 4 && [ "$(wc -l </tmp/said)" = 1 ] && grep -q "$words" /tmp/said
}
check "a device that is not there" refused "No such file" --device /dev/none
check "a device that is none" refused "/dev/null" --device /dev/null
check "a screen that is too small" refused "smaller" --size 4000x4000
busy()          # CODE: exit 4 and one line
{
    cat /tmp/busy
    [ $1 = 4 ] && [ "$(wc -l </tmp/busy)" = 1 ] && grep -q busy /tmp/busy
}
begin $shows --hash
tank-screen --on $on >/tmp/busy 2>&1
check "a screen that is busy" busy $?
kill $parent
check "and who had it, gives it back" left 143
vm_state /dev/tty1 graphics
tank-screen --on $on </dev/tty1 >/tmp/busy 2>&1
check "a console that is busy" busy $?
vm_state /dev/tty1 text
EOF

cat >"$scratch/careless" <<'EOF'
# The state left by a careless program is detected; each thing against the state before.
for thing in $(echo "$things" | tr , " "); do
    vm_state /dev/tty1 >/tmp/before
    vm_state /dev/tty1 $thing &
    usleep 500000
    vm_state /dev/tty1 >/tmp/after
    check "$thing left so would be found" eval '! cmp /tmp/before /tmp/after'
    kill $! 2>/dev/null
done
EOF

# name | words for the kernel | modules | things left behind
while IFS="|" read -r on words modules things; do
    on=$(echo $on) words=$(echo $words) things=$(echo $things)
    cat "$scratch/common" "$scratch/failures" "$scratch/careless" >"$scratch/cases"
    vm_disk $on amd64 "$scratch/cases" "$modules" "$screen" "$state"
    check "$on: the machine boots" vm_boot $on amd64 \
        "$words boot=$on on=$on things=$things" -vga std
    vm_results $on
    check "$on: the text is on the screen again" "build/host/tests/boards/same_picture" \
        "$vm_work/$on-before.ppm" "$vm_work/$on-after.ppm"
done <<EOF
fb  | vga=0x301 |       | raw,process,colours,graphics
kms |           | bochs | crtc,master,graphics
EOF
finish
