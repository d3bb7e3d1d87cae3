#!/bin/sh
# SPDX-License-Identifier: MIT
# The panel in a window of a private X server, driven by keys and mouse.
# tests/host/panel_demo prints the panel's requests; sanitizers watch it if they are
# installed.
#     panel.sh PROGRAM
# Each case prints a line; the last line is "N passed, M failed", and the exit code
# agrees.
demo=$(dirname "$(realpath "$1")")/tests/host/panel_demo
watched=build/san/tests/host/panel_demo
[ ! -x $watched ] || demo=$(realpath $watched)
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/display.sh"
display_begin "$1"
[ -x "$demo" ] && "$demo" --has || {
    skip "the panel in a window" "libsdl2-dev, libimgui-dev"
    exit 0
}
export SDL_VIDEODRIVER=x11 SDL_AUDIODRIVER=dummy SDL_RENDER_DRIVER=software
# SDL's libraries keep some memory until the end: leaks count by function names.
export LSAN_OPTIONS=exitcode=0
says() { until_true grep -qxE "$1" log; }
twice() { [ "$(grep -cx "$1" log)" -ge 2 ]; }
silent() { ! grep -qE "$1" log; }

begin_server 1000x620
window_name='^panel demo'
start() {
    timeout -k 5 100 "$demo" "$@" >log 2>&1 &
    viewer=$!
    until_true find_window && says ready && timeout 5 xdotool windowfocus "$window"
}
key() { timeout 10 xdotool key --delay 40 "$@"; }
write() { timeout 10 xdotool type --delay 40 "$1"; }
point() { timeout 5 xdotool mousemove --window "$window" "$1" "$2"; }

# Clicks after the mouse has arrived.
click() {       # X Y [BUTTON]
    point "$1" "$2"
    sleep 0.1
    timeout 5 xdotool click "${3:-1}"
}
ends() {
    wait "$viewer"
    code=$?
    viewer=""
    grep -E 'ports/|imgui|ImGui|MallocWrapper|runtime error' log >own
    [ "$code" -eq 0 ] && [ ! -s own ] && return
    echo "exit code $code" | cat - own >log
    false
}

# Found rows are listed below the search, from y 189 on, 20 px apart, in a panel of 320 px
# at the right of 960: values are at x 778 to 931.
search() {
    key F3
    write "$1"
}

check "a window with the panel opens" start --panel 320
[ -n "$window" ] || exit 1

# -- keys of the picture stay its own --------------------------------------------------

key w space 1
check "letters are the picture's" says 'left key W'
check "and the space bar" says 'left key Space'
key F5
check "and function keys" says 'left key F5'
click 300 300
check "clicks beside the panel are the picture's" says 'left click 300,300'

# -- search and numbers ----------------------------------------------------------------

search wave0.ste
key Tab Tab
key Return
write 0.4
key Return
check "a row that was searched for is typed in" says 'set wave0.steepness=0\.4'
check "what was typed was nobody else's" silent 'left key [0a.]'
key F5
check "function keys are the picture's there too" \
    until_true twice 'left key F5'
key Return
write 7,5
key Return
check "a bad number is refused" says 'refused wave0.steepness=7,5'
key Return
write 3
key Escape
write w
check "Esc gives the keyboard back" until_true twice 'left key W'
check "and leaves the number as it was" silent 'steepness=3'

search wave0.ste
click 943 189
check "a value's button puts it back" says 'reset wave0.steepness'
point 830 189
timeout 5 xdotool mousedown 1
for x in 850 870 890; do
    point "$x" 189
    sleep 0.1
done
timeout 5 xdotool mouseup 1
check "dragging a slider sets the value as it goes" says 'set wave0.steepness=0\..* \.\.\.'
check "and is over when it is let go" says 'set wave0.steepness=0\.[0-9]*'
click 830 189 3
key ctrl+a
write 0.125
key Return
check "the right button types it" says 'set wave0.steepness=0\.125'
timeout 5 xdotool keydown ctrl
click 850 189
timeout 5 xdotool keyup ctrl
write 0.75
key Return
check "and so does Ctrl with the left one" says 'set wave0.steepness=0\.75'
key Return
write 0.125
key Return
key Tab space Right Right space
check "arrows move a slider" says 'set wave0.steepness=0\.145'

# The scene has one of sixteen waves.  The others are counted as fifteen rows and shown on
# request, below a header: first wave1's header, then its row.
search 'wave steepness'
sleep 0.2
click 830 249 3
sleep 0.2
write 0.5
key Return
check "a search lists what the scene has" silent 'wave[1-9][0-9]*\.steepness'
search 'wave steepness'
sleep 0.2
click 700 209
sleep 0.3
click 830 249 3
sleep 0.2
key ctrl+a
write 0.3
key Return
check "and what it has not when that is opened" says 'set wave1.steepness=0\.3'
search 'wave9 steepness'
key Tab Tab Return
write 0.3
key Return
check "where it has none of them they are shown at once" says 'set wave9.steepness=0\.3'

# -- the other kinds -------------------------------------------------------------------

search tank.sea
click 786 189
check "a switch is switched" says 'set tank.sea=off'
search water.fresnel
click 880 189
sleep 0.2
key Down Return
check "a choice is chosen by keys" says 'set water.fresnel=schlick'
search sky.zenith
click 890 189
key ctrl+a
write '#102030'
key Return
check "a colour is typed" says 'set sky.zenith=#102030'
click 790 189
sleep 0.2
click 870 300
check "and picked" says 'set sky.zenith=#.* \.\.\.'
key Escape
check "Esc closes what dropped down, and that alone" silent 'left key Escape'
search layer1.texture
click 922 189
sleep 0.2
key Down Return
check "a picture is chosen from those there are" says 'set layer1.texture=foam.png'
key Escape

# -- buttons, figures, hiding ----------------------------------------------------------

click 670 73
check "a button does what its key does" says 'act undo'
key ctrl+z
check "the key still does it" says 'left key Z'
click 760 129
check "figures have the stages measured" says 'measures on'
key F2
check "hidden, it has nothing measured" says 'measures off'
check "and clicks are the picture's" eval 'click 800 300; says "left click 800,300"'
key F2
search sky.haze
key Tab Tab Return
write 900
key Return
check "shown again, it is searched" says 'set sky.haze=900'
key Escape
click 680 129
click 800 17
sleep 0.2
key Down Return
check "a scene is chosen" says 'open storm'
timeout 5 xdotool windowsize "$window" 700 500
sleep 0.3
search clock.scale
key Tab Tab Return
write 2
key Return
check "after the window was made smaller it goes on" says 'set clock.scale=2'
key Escape
sleep 0.1
key Escape
check "it ends without a leak and without a fault" ends
finish
