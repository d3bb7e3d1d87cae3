#!/bin/sh
# SPDX-License-Identifier: MIT
# The preview in a window of a private X server: the key of every action has the effect
# given in the list of actions.
#     view_keys.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/display.sh"
display_begin "$1"
covered=""

# does ACTION... -- NAME COMMAND...: a case for these actions.
does() {
    while [ "$1" != -- ]; do
        covered="$covered $1"
        shift
    done
    shift
    check "$@"
}

begin_server

# -- held keys, and their tape -----------------------------------------------------------

scene=raindrops
check "a window that records opens" open_view raindrops --size 160x120 --no-panel \
    --tape held.tape
for key in w s a d e q Up Down Left Right i k j l Home End Prior Next; do
    hold 0.1 $key
done
hold 0.1 shift w
press space
check "Esc ends it" quit_view
told() { grep -q -e " $1" held.tape; }
does forward -- "W moves forward" told 'ahead=0.0[67]'
does backward -- "S back" told 'ahead=-0.0[67]'
does left -- "A left" told 'aside=-0.0[67]'
does right -- "D right" told 'aside=0.0[67]'
does up -- "E up" told 'up=0.0[67]'
does down -- "Q down" told 'up=-0.0[67]'
does run -- "Shift is four times as fast" told 'ahead=0.2[67]'
does north -- "Up moves the sphere away" told 'sphere_z=-'
does south -- "Down nearer" told 'sphere_z=0'
does west -- "Left left" told 'sphere_x=-'
does east -- "Right right" told 'sphere_x=0'
does sail -- "I sails faster" told 'throttle=[1-9]'
does brake -- "K slower" told 'throttle=-'
does port -- "J turns the rudder" told 'rudder=-'
does starboard -- "L the other way" told 'rudder=[1-9]'
does light_left -- "Home turns the light left" told 'light_turn=-'
does light_right -- "End right" told 'light_turn=[1-9]'
does light_up -- "Page Up raises it" told 'light_tilt=[1-9]'
does light_down -- "Page Down lowers it" told 'light_tilt=-'
does drop -- "Space lets a drop fall" told 'drops=1'

# -- pokes and the clock -------------------------------------------------------------------

scene=tank
check "the tank opens" open_view tank --size 160x120 --no-panel --tape tank.tape \
    --set pool.splash_interval=0
for number in 1 2 3 4 5 6; do
    press $number
    sleep 0.15
done
press bracketleft bracketleft bracketright
press m
do_x mousemove_relative 40 0
sleep 0.1
do_x mousemove_relative 0 -25
sleep 0.1
press m
press ctrl+q
end_view
does quit -- "Ctrl+Q ends with exit code 0" test "$code" -eq 0
six() { [ "$(places tank | wc -l)" -eq 6 ] && [ "$(places tank | sort -u | wc -l)" -eq 6 ]; }
does poke1 poke2 poke3 poke4 poke5 poke6 -- "1 to 6 poke at six places" six
clock() { [ "$(grep -o 'slower=[-0-9]*' tank.tape | tr '\n' ' ')" = "$1" ]; }
does slower faster -- "[ halves the clock, ] doubles it" clock 'slower=1 slower=1 slower=-1 '
turned() { grep -q ' turn=[1-9]' tank.tape && grep -q ' tilt=' tank.tape; }
does mouse -- "M: the mouse turns the camera" turned

# -- time ------------------------------------------------------------------------------------

scene=three-swells
check "the swells open" open_view three-swells --size 320x240
press p
does pause -- "P pauses" until_true titled paused
shot stood.png
sleep 0.3
shot stands.png
check "a paused picture stands" cmp -s stood.png stands.png
press period
shot one.png
press period period
shot three.png
step() { differ stood.png one.png && differ one.png three.png; }
does step -- ". goes one picture on" step
press comma comma
shot back.png
press comma
shot before.png
back() { cmp -s one.png back.png && cmp -s stood.png before.png; }
does step_back -- ", goes back, to the same bits" back
press p
sleep 0.5
press p
shot later.png
hold 0.3 BackSpace
shot earlier.png
does rewind -- "Backspace runs backwards" differ later.png earlier.png
press F5
shot first.png
sleep 0.2
press F5
shot again.png
restart() { cmp -s first.png again.png && differ first.png earlier.png; }
does restart -- "F5 restarts, each time with the same picture" restart

# -- camera modes ----------------------------------------------------------------------------

look() {        # KEY NAME.png: the camera may glide
    press "$1"
    shot "$2"
    for _ in 1 2 3 4 5; do
        cp "$2" last.png
        sleep 0.1
        shot "$2"
        cmp -s last.png "$2" && return
    done
}
look t top.png
does look_top -- "T looks from above" differ first.png top.png
look b boat.png
boat() { differ first.png boat.png && differ top.png boat.png; }
does look_boat -- "B looks from the boat" boat
look f free.png
hold 0.2 d
shot flown.png
look o orbit.png
hold 0.2 d
shot round.png
orbit() { differ orbit.png round.png; }
free() { differ boat.png free.png && differ free.png flown.png; }
does look_free -- "F flies" free
does look_orbit -- "O goes round" orbit
press f

# -- overlays ---------------------------------------------------------------------------------

press F5
top bare.ppm
press F1
does help -- "F1 shows the keys" until_true top_is_not bare.ppm
press Escape
check "Esc hides them, and ends nothing" until_true top_is bare.ppm
press F4
does figures -- "F4 shows figures" until_true top_is_not bare.ppm
press F4
until_true top_is bare.ppm || echo "     | the picture is not as before"

press F8
press F8
does compare -- "F8 shows the difference" until_true top_is_not bare.ppm
top exact.ppm
for _ in 1 2 3 4; do press shift+F8; done
does against -- "Shift+F8 to another way" until_true top_is_not exact.ppm
press F8
check "and F8 one picture again" until_true top_is bare.ppm

# -- pixels and the window ----------------------------------------------------------------------

shot true.png
press F6
shot other.png
for _ in 1 2 3 4 5; do press F6; done
shot same.png
formats() { ! same_pixels true.png other.png && same_pixels true.png same.png; }
does format -- "F6 takes the next format, and the first one after the last" formats
press F7
does scale -- "F7: pixels twice as large" until_true titled 160x120
press F7 F7 F7
check "and after four as they were" until_true titled 320x240
press F11
does full -- "F11: the whole screen" until_true titled x600
press F11
check "and a window again" until_true titled x240

press F9
does film -- "F9 films" until_true titled filming
sleep 0.3
press F9
until_true not_titled filming
filmed() { [ -s three-swells-0001.mp4 ] || [ -s three-swells-0001.y4m ]; }
check "into a file" until_true filmed
press F10
does tape -- "F10 records a tape" until_true titled 'on tape'
press p
hold 0.2 w
press F10
until_true not_titled 'on tape'
check "with what was done" grep -q 'ahead=' three-swells-0001.tape
press p
until_true titled paused

# -- scenes ------------------------------------------------------------------------------------

# -- a value changed in the panel, undone, saved --------------------------------------------

# A floating boat keeps its state over changes, so pictures are compared at the beginning.
start() {       # NAME.png
    press F5
    shot "$1"
}

# panel_tells: true if the panel's message line, below its buttons, has text: it is not of
# one colour.
panel_colours() {
    screen all.ppm
    convert all.ppm -crop 300x14+340+105 +repage -format '%k' info:
}
panel_tells() { [ "$(panel_colours)" -gt 1 ]; }
panel_is_silent() { [ "$(panel_colours)" -eq 1 ]; }

# panel_at X: true if the panel's dark edge, not water, is at x.
panel_at() {
    eval "$(do_x getwindowgeometry --shell "$window" | grep '^[XYH]')"
    until_true panel_seen $((X + $1)) $((Y + HEIGHT - 2))
}
panel_seen() {
    timeout 10 import -silent -window root -crop "1x1+$1+$2" +repage -depth 8 rgb:- |
        od -An -tu1 | awk '{ exit !($1 < 40 && $2 < 40 && $3 < 50) }'
}

start plain.png
hold 0.3 w
shot away.png
press ctrl+c
start begun.png
does begin_here -- "Ctrl+C makes the scene begin where one is" cmp -s away.png begun.png
check "which is elsewhere" differ plain.png begun.png
for step in x y z heading pitch; do press ctrl+z; done
start again.png
check "and can be undone" cmp -s plain.png again.png
eval "$(do_x getwindowgeometry --shell "$window" | grep ^WIDTH)"
if [ "$WIDTH" -gt 320 ]; then
    press F2
    does panel -- "F2 hides the panel" until_true titled 666x240
    press F2
    check "and shows it again" until_true titled 320x240
    shot told.png
    check "what was saved is told in the panel" until_true panel_tells
    press F4 F4
    check "and no longer when something else was done" until_true panel_is_silent
    press shift+F2
    does side -- "Shift+F2 puts it at the left" panel_at 2
    check "as wide as it was" until_true titled 320x240
    press shift+F2
    check "and at the right again" panel_at $((WIDTH - 3))
    press ctrl+minus
    does smaller -- "Ctrl+- makes letters and panel smaller" until_true titled 405x240
    press ctrl+equal
    does larger -- "Ctrl+= larger" until_true titled 320x240
    press F3
    do_x type --delay 40 wave0.amplitude
    press Tab Tab Return
    do_x type --delay 40 0.9
    press Return Escape
    start high.png
    does search -- "F3 finds a parameter, and its value reaches the world" \
        differ plain.png high.png
    press ctrl+z
    start undone.png
    does undo -- "Ctrl+Z takes it back" cmp -s plain.png undone.png
    press ctrl+y
    start redone.png
    does redo -- "Ctrl+Y makes it again" cmp -s high.png redone.png
    wanted='^amplitude *= *0.9'
    undoes=yes
else
    skip "the panel" "libimgui-dev"
    covered="$covered panel side smaller larger search undo redo"
    wanted='^amplitude'
fi
press ctrl+s
does save -- "Ctrl+S saves the scene" until_true grep -q "$wanted" three-swells.ini
press ctrl+r
shot reloaded.png
press F5
shot restarted.png
does reload -- "Ctrl+R reads the file again" cmp -s reloaded.png restarted.png

# -- scenes ------------------------------------------------------------------------------------

swells=$(title | sed 's/,.*//')
press shift+n ctrl+r n          # reloading keeps the index in the list
check "the one after the one before is the same" until_true titled "$swells"
press n
does next_scene -- "N opens the next scene" until_true not_titled "$swells"
press shift+n
does last_scene -- "Shift+N the one before" until_true titled "$swells"
check "Esc ends it" quit_view
does shot -- "F12 saved pictures" test -s true.png

# -- undo while the water stands: no trace is left ---------------------------------------------

# put NAME VALUE: types a value into the panel.
put() {
    press F3
    do_x type --delay 40 "$1"
    press Tab Tab Return
    do_x type --delay 40 "$2"
    press Return Escape
}
scene=tank
if [ "${undoes:-}" ]; then
    check "the tank opens, on tape" open_view tank --size 320x240 --tape undone.tape
    press 2 5
    sleep 0.5
    press p
    until_true titled paused
    shot before.png
    put pool.cols 40
    until_true grep -q 'set pool.cols=40' undone.tape
    # A typed or undone value reaches the picture a little later.
    changed() { shot changed.png; differ before.png changed.png; }
    check "a pool made anew while paused is another picture" until_true changed
    press ctrl+z
    undone() { shot undone.png; cmp -s before.png undone.png; }
    check "undone it is the picture before, to the bit" until_true undone
    put pool.splash_height 0.2          # the help of pool.drive_min, before it, has both words
    check "a row is found by its name before others by their help" \
        until_true grep -q 'set pool.splash_height=0.2' undone.tape
    hold 0.2 a
    put light.ambient 0.1
    press ctrl+z ctrl+y
    press period comma period period    # back to the change, and forward
    shot last.png
    check "Esc ends the tape" quit_view
    forgotten() { ! grep -q 'pool.cols' undone.tape && grep -q 'look aside' undone.tape \
        && [ "$(grep -c 'set light.ambient' undone.tape)" -eq 1 ]; }
    check "the tape forgets what was undone, and not the walk since" forgotten
    check "and plays to the same bits" \
        replayed last.png tank --size 320x240 --tape undone.tape
fi

# -- every action of the list --------------------------------------------------------------------

every() {
    sed -n 's/^    X([A-Z0-9_]*, *"[a-z]*", *"\([a-z0-9_]*\)".*/\1/p' \
        "$root/ports/app/session/actions.h" | sort >listed
    printf '%s\n' $covered | sort -u | diff listed - >log && [ -s listed ]
}
check "every action of the list has a case" every
finish
