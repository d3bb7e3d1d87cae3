#!/bin/sh
# SPDX-License-Identifier: MIT
# The preview in a window of a private X server: pixels, mouse, resizing, minimising, a
# lost display, resuming. view_keys.sh tests every key.
#     view.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/display.sh"
display_begin "$1"

# -- without a display ----------------------------------------------------------------

refuses() {     # NAME=VALUE...
    env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER "$@" \
        timeout 20 "$program" view three-swells >log 2>&1
    [ $? -eq 4 ] && grep -q "no window can be opened" log && grep -q "tidepool render" log
}
check "no display: says so, names a way out, exits 4" refuses
check "a display that is gone: the same" refuses DISPLAY=:9797
check "a driver that fails: the same" refuses SDL_VIDEODRIVER=x11

says() {        # PATTERN ARGUMENT...
    pattern=$1
    shift
    timeout 20 "$program" view "$@" >log 2>&1
    [ $? -eq 3 ] && grep -q "$pattern" log
}
check "unknown scene: exits 3 before any window" says "did you mean three-swells" \
    three-swels
printf 'drop = Retrun\n' >home/bad.ini
check "a file of keys that is wrong: its line" says "^home/bad.ini:1: .*did you mean Return" \
    three-swells --keys home/bad.ini

# -- a window and its pixels -------------------------------------------------------------

begin_server
scene=three-swells
check "a window opens" open_view three-swells --size 320x240 --no-panel
check "the title tells the size and a picture's time" until_true titled \
    '320x240: [0-9]*\.[0-9] ms'
top one.ppm
check "the water moves" until_true top_is_not one.ppm
press p
until_true titled paused
shot shown.png
window_is() {   # PICTURE: except for the message at the bottom
    top now.ppm && convert "$1" -crop "320x180+0+0" +repage -depth 8 part.png \
        && same_pixels now.ppm part.png
}
check "a screenshot is the picture of the window, bit for bit" window_is shown.png

drag() {        # BUTTON FROM-X FROM-Y BY
    do_x mousemove --window "$window" "$2" "$3" mousedown "$1"
    for _ in 1 2 3 4; do
        do_x mousemove_relative "$4" 0 sleep 0.05
    done
    do_x mouseup "$1"
}
drag 1 160 120 10
shot turned.png
check "dragging turns the camera" differ shown.png turned.png
do_x mousemove --window "$window" 100 60
shot left.png
check "moving the mouse without a button does not" cmp -s turned.png left.png
do_x mousemove --window "$window" 100 60 click 4
shot nearer.png
check "the wheel goes nearer" differ left.png nearer.png

do_x windowsize "$window" 400 300
check "a resized window gets a picture of its size" until_true titled 400x300
shot large.png
check "and screenshots of it" size_is large.png 400x300
press p
until_true not_titled paused
do_x windowunmap --sync "$window" sleep 0.5
do_x windowmap --sync "$window" sleep 0.3
top one.ppm
check "after it was minimised the water goes on" until_true top_is_not one.ppm
check "Esc ends with exit code 0" quit_view

check "a window of another format opens" open_view three-swells --size 160x128 \
    --format i1 --scale 2 --no-panel
press p
until_true titled paused
shot bits.png
convert bits.png -scale 200% -crop 320x180+0+0 +repage large.png
eval "$(do_x getwindowgeometry --shell "$window" | grep '^[XY]')"
until_true take 320x180+$X+$Y now.ppm
check "in black and white, each pixel twice as large" same_pixels now.ppm large.png
kill -TERM "$(viewing)"
end_view
check "SIGTERM ends it with exit code 0" test "$code" -eq 0

# -- the bar between picture and panel -----------------------------------------------------

open_view minimal --size 320x240
eval "$(do_x getwindowgeometry --shell "$window" | grep ^WIDTH)"
if [ "$WIDTH" -gt 320 ]; then
    until_true titled 320x240
    drag 1 323 200 10
    check "the bar is dragged" until_true titled 360x240
    do_x mousemove --window "$window" 363 200 click --repeat 2 --delay 60 1
    check "a double click puts it back" until_true titled 320x240
else
    skip "the bar" "libimgui-dev"
fi
quit_view

# -- a recorded tape: played by render, its last frame equals the window's picture -------

scene=tank
open_view tank --size 320x240 --tape played.tape --set pool.splash_interval=0 --no-panel
sleep 0.3
do_x windowfocus "$window" key --delay 0 1 2 3 4 5 6
sleep 0.2
do_x mousemove --window "$window" 160 130 click --repeat 5 --delay 0 3
sleep 0.2
at_least() { [ "$(places played | wc -l)" -ge "$1" ]; }
until_true at_least 11
drag 3 150 130 8
press bracketleft bracketleft
hold 0.3 a
hold 0.3 Home
hold 0.3 Prior
sleep 0.3
press p
until_true titled paused
shot last.png
check "the recorder ends with exit code 0" quit_view
told() { grep -q -e "$1" played.tape; }
check "the tape tells of every poke, of one moment too" at_least 11
check "and of stirring" at_least 14
check "and of the walk" told "aside=-"

check "render plays the tape to the screenshot's bits" \
    replayed last.png tank --size 320x240 --tape played.tape --set pool.splash_interval=0

# -- the display is lost, and --resume goes on ----------------------------------------------

scene=three-swells
open_view three-swells --size 320x240 --no-panel --set wave0.amplitude=0.9
until_true top one.ppm
until_true top_is_not one.ppm           # some frames later
press p
until_true titled paused
kill "$server"
wait "$server"
server=""
end_view
check "a lost display ends it with exit code 5" test "$code" -eq 5
check "and says how to go on" grep -q -e "--resume" log
begin_server
check "--resume opens a window" open_view --resume --size 320x240 --no-panel
check "and tells the picture it goes on with" until_true grep -q \
    "continuing three-swells at picture [1-9]" log
press p
press F5
shot again.png
quit_view
open_view three-swells --size 320x240 --no-panel --set wave0.amplitude=0.9
press p
press F5
shot fresh.png
quit_view
check "with what was changed" cmp -s again.png fresh.png

# The scene's name and description above the panel's buttons.
named() {       # NAME.png
    screen all.ppm
    convert all.ppm -crop 320x36+334+8 +repage "$1"
}
open_view three-swells --size 320x240
eval "$(do_x getwindowgeometry --shell "$window" | grep ^WIDTH)"
if [ "$WIDTH" -gt 320 ]; then
    sleep 0.5
    named opened.png
    quit_view
    open_view --resume --size 320x240
    sleep 0.5
    named resumed.png
    check "and the panel names the scene" same_pixels opened.png resumed.png
else
    skip "the panel" "libimgui-dev"
fi
quit_view
finish
