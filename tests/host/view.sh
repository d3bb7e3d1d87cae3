#!/bin/sh
# SPDX-License-Identifier: MIT
# The preview in a window of an X server of its own: keys, mouse, resizing, pixels.
#     view.sh PROGRAM
# One line a case; the last line is "N passed, M failed", and the exit code tells too.
program=$(realpath "$1") || exit 2
missing=""
need() { command -v "$1" >/dev/null || missing="$missing${missing:+, }$2"; }
need Xvfb xvfb
need xdotool xdotool
need import imagemagick
need pgrep procps
if [ -n "$missing" ]; then
    echo "skipped: the preview in a window (package $missing)"
    exit 0
fi
work=$(mktemp -d) || exit 2
server="" viewer=""
cleanup() {
    [ -z "$viewer" ] || kill "$viewer" 2>/dev/null
    [ -z "$server" ] || kill "$server" 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT
trap 'exit 1' INT TERM HUP
cd "$work" || exit 2
passed=0 failed=0

# check NAME COMMAND...
check() {
    name=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
        echo "ok - $name"
    else
        failed=$((failed + 1))
        echo "FAILED - $name"
        sed 's/^/     | /' log 2>/dev/null | tail -3
    fi
}

# until_true COMMAND...: tries for ten seconds.
until_true() {
    for _ in $(seq 100); do
        "$@" && return 0
        sleep 0.1
    done
    return 1
}

# -- without a display ----------------------------------------------------------------

refuses() {     # NAME=VALUE...
    env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER "$@" \
        timeout 20 "$program" view three-swells >log 2>&1
    [ $? -eq 3 ] && grep -q "no window can be opened" log && grep -q "tidepool render" log
}
check "no display: says so, names a way out, exits 3" refuses
check "a display that is gone: the same" refuses DISPLAY=:9797
check "a driver that fails: the same" refuses SDL_VIDEODRIVER=x11

unknown() {
    timeout 20 "$program" view three-swels >log 2>&1
    [ $? -eq 3 ] && grep -q "did you mean three-swells" log
}
check "unknown scene: exits 3 before any window" unknown

# -- a server and a window --------------------------------------------------------------

exec 7>number
Xvfb -displayfd 7 -screen 0 800x600x24 -nolisten tcp -noreset >/dev/null 2>&1 &
server=$!
until_true test -s number || { echo "FAILED - Xvfb starts"; exit 1; }
DISPLAY=:$(cat number)
export DISPLAY

start() {
    SDL_VIDEODRIVER=x11 SDL_AUDIODRIVER=dummy timeout 120 "$program" view "$@" >log 2>&1 &
    viewer=$!
}
find_window() {
    window=$(timeout 5 xdotool search --onlyvisible --name '^tidepool: ' 2>/dev/null | \
        head -1)
    [ -n "$window" ]
}
title() { timeout 5 xdotool getwindowname "$window"; }
titled() { title | grep -q "$1"; }
press() { timeout 5 xdotool windowfocus "$window" key "$@"; }
screen() {
    eval "$(timeout 5 xdotool getwindowgeometry --shell "$window" | grep '^[XYWH]')"
    timeout 10 import -silent -window root -crop "${WIDTH}x$HEIGHT+$X+$Y" +repage -depth \
        8 "$1"
}
differ() { ! cmp -s "$1" "$2"; }
size_is() { [ "$(identify -format '%wx%h' "$1")" = "$2" ]; }
same_pixels() { [ "$(compare -metric AE "$1" "$2" null: 2>&1)" = 0 ]; }

start three-swells --size 320x240
check "a window opens" until_true find_window
[ -n "$window" ] || exit 1
check "the title tells the size and a frame's time" until_true titled \
    '320x240: [0-9]*\.[0-9] ms'
screen one.ppm
sleep 0.5
screen two.ppm
check "the water moves" differ one.ppm two.ppm
press space
check "Space pauses" until_true titled paused
screen one.ppm
sleep 0.5
screen two.ppm
check "a paused picture stands" cmp -s one.ppm two.ppm

press p
check "P saves a screenshot" until_true test -s three-swells-0001.png
check "the screenshot is the picture of the window, bit for bit" \
    same_pixels one.ppm three-swells-0001.png

timeout 5 xdotool windowfocus "$window" keydown w
sleep 0.4
timeout 5 xdotool keyup w
sleep 0.2
screen three.ppm
check "W moves the camera, also while the water stands" differ one.ppm three.ppm
timeout 5 xdotool mousemove --window "$window" 160 120 mousedown 1
for x in 170 180 190 200; do
    timeout 5 xdotool mousemove --window "$window" "$x" 120
    sleep 0.05
done
timeout 5 xdotool mouseup 1
sleep 0.2
screen four.ppm
check "dragging turns the camera" differ three.ppm four.ppm
timeout 5 xdotool mousemove --window "$window" 100 60
sleep 0.3
screen five.ppm
check "moving the mouse without a button does not" cmp -s four.ppm five.ppm

timeout 5 xdotool windowsize "$window" 400 300
check "a resized window gets a picture of its size" until_true titled 400x300
press F12
check "F12 saves the next screenshot" until_true test -s three-swells-0002.png
check "the screenshot has the new size" size_is three-swells-0002.png 400x300

press F1
check "F1 prints the keys" until_true grep -q "Esc  *quit" log
press Escape
wait "$viewer"
check "Esc ends with exit code 0" test $? -eq 0
viewer=""

start three-swells --size 160x128 --format i1
check "a window of another format opens" until_true find_window
press space
until_true titled paused
press p
check "its screenshot" until_true test -s three-swells-0003.png
screen six.ppm
check "shows black and white, bit for bit" same_pixels six.ppm three-swells-0003.png
kill -TERM "$(pgrep -P "$viewer")"
wait "$viewer"
check "SIGTERM ends it with exit code 0" test $? -eq 0
viewer=""

# -- a tape of what was done: played by render it ends in the picture of the window ------

start tank --size 320x240 --tape played.tape --set pool.poke_every=0
check "a window that records opens" until_true find_window
sleep 0.3
timeout 5 xdotool mousemove --window "$window" 160 130 click 3
sleep 0.3
press comma comma
timeout 5 xdotool windowfocus "$window" keydown a
sleep 0.3
timeout 5 xdotool keyup a
for light in bracketright Prior; do
    timeout 5 xdotool keydown $light
    sleep 0.3
    timeout 5 xdotool keyup $light
done
sleep 0.5
press space
until_true titled paused
press p
check "the screenshot of the tank" until_true test -s tank-0001.png
press Escape
wait "$viewer"
check "the recorder ends with exit code 0" test $? -eq 0
viewer=""
check "the tape tells of the poke" grep -q "poke=.* poke_x=" played.tape
check "the tape tells of slow motion" grep -q "slower=" played.tape
check "the tape tells of the walk" grep -q "aside=" played.tape
check "the tape tells of the light" grep -q "light_turn=[1-9]" played.tape
check "and of its height" grep -q "light_tilt=[1-9]" played.tape

# Its frames are the clock's pictures: one of them is the screenshot.
replayed() {
    "$program" render tank --size 320x240 --tape played.tape --frames 600 \
        --set pool.poke_every=0 --hash >hashes || return 1
    "$program" render tank --size 320x240 --tape played.tape --frames 600 \
        --set pool.poke_every=0 --hash | cmp -s - hashes || return 1
    crc=$(convert tank-0001.png -depth 8 bgra:- | perl -0777 -ne '
        my $crc = ~0 & 0xffffffff;
        s/(...)./$1\0/gs;
        for my $byte (unpack "C*", $_) {
            $crc ^= $byte;
            $crc = $crc & 1 ? $crc >> 1 ^ 0xedb88320 : $crc >> 1 for 1 .. 8;
        }
        printf "%08x", ~$crc & 0xffffffff;')
    grep -q "$crc" hashes
}
check "render plays the tape, twice the same, to the screenshot's bits" replayed

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
