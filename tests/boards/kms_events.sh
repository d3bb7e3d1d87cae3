#!/bin/sh
# SPDX-License-Identifier: MIT
# Events at a screen of ports/kms while a picture is shown, on an emulated PC with a
# Debian kernel: the monitor is unplugged and plugged in; the whole card disappears and
# returns with a monitor of another size. A program that refuses to start prints the
# reason in one line.
#
#   tests/boards/kms_events.sh [PROGRAM]
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

program=${1:-build/host/tidepool}
scene=three-swells screen=build/host/scenes/three-swells-screen

vm_lacks "events of screens by mode setting" amd64 && exit 0
build "$program" build/host/tests/boards/same_picture build/host/tests/boards/vm_state \
    >"$scratch/built" 2>&1
check "one static file shows a scene" alone build "$screen"
[ "$failed" = 0 ] || exit 1

cat >"$scratch/cases" <<'EOF'
show="three-swells-screen --on kms --size 640x480 --frames 3:3 --hash --hold"
said=/tmp/said

start()
{
    $show </dev/tty1 >$said 2>&1 &
    shown=$!
}
drawn()         # COUNT: the picture was drawn this often
{
    [ "$(grep -c "^frame" $said)" -ge "$1" ]
}
lit()
{
    vm_state /dev/tty1 | grep -q "mode 1 640x480"
}
dark()
{
    vm_state /dev/tty1 | grep -q "^crtc .*buffer 0 "
}
refused()       # WORDS OPTION...: exit 4 and one line; the console does not change
{
    words=$1; shift
    three-swells-screen --on kms --frames 3:3 "$@" </dev/tty1 >/tmp/refused 2>&1
    [ $? = 4 ] && cat /tmp/refused && grep -q "$words" /tmp/refused &&
        [ "$(wc -l </tmp/refused)" = 1 ] && unchanged
}
unchanged()
{
    vm_state /dev/tty1 >/tmp/now
    diff /tmp/before /tmp/now
}
until_true test -e /dev/dri/card0
vm_state /dev/tty1 >/tmp/before
connector=$(echo /sys/class/drm/card0-*)

check "a device that is not there" refused "No such file" --device /dev/dri/card7
check "a device that is no card" refused "is not a graphics card" --device /dev/null
check "a picture larger than every mode" refused "smaller than" --size 4096x4000
echo off >"$connector/status"
check "no monitor" refused "nothing is connected"
echo detect >"$connector/status"

start
check "it starts" until_true drawn 1
check "another program uses the screen" eval \
    'vm_state /dev/tty1 >/tmp/before; refused "another program uses the screen"'
ask shot start
echo off >"$connector/status"
check "unplugged, it goes on without a screen" until_true dark
ask shot off
echo detect >"$connector/status"
check "plugged in, it draws again" until_true drawn 2
check "in its mode" lit
ask shot plugged

bus=$(readlink -f /sys/class/drm/card0/device)
echo 1 >"$bus/remove"
check "the card goes" [ ! -e /dev/dri/card0 ]
echo edid/800x600.bin >/sys/module/drm/parameters/edid_firmware
usleep 1200000
check "the program does not" kill -0 $shown
echo 1 >/sys/bus/pci/rescan
check "the card comes back, and it draws again" until_true drawn 3
check "on another monitor" [ "$(cat /sys/class/drm/card*-*/modes)" = 800x600 ]
ask shot back
kill $shown
wait $shown
check "it ends by the signal that was sent" [ $? = 143 ]
check "and has said nothing else" eval '! grep -v "^frame" $said'

insmod /bin/drm_shmem_helper.ko
insmod /bin/vgem.ko
check "the first card has no screens now" eval \
    'readlink /sys/class/drm/card0/device | grep -q vgem'
start
check "the second is taken" until_true drawn 1
ask shot second
kill $shown
wait $shown
EOF

"$program" render "$scene" --size 640x480 --frames 3:3 \
    --out "$scratch/want.png" >/dev/null
same()          # NAME [BITS [centred]]
{
    shot=$1; shift
    build/host/tests/boards/same_picture "$vm_work/$shot.ppm" "$scratch/want.png" "$@"
}
vm_disk events amd64 "$scratch/cases" bochs "$screen" build/host/tests/boards/vm_state \
    $(vm_modules amd64 vgem | sed "s|^|$vm_folder/amd64/modules/|")
check "the machine boots" vm_boot events amd64 "" -vga std
vm_results events bochs
check "the picture of the host" same start
check "the same when it was plugged in" same plugged
check "the same in the middle of another monitor" same back 888 centred
check "the same on the second card" same second 888 centred
refuse "another one while it is unplugged" same off
finish
