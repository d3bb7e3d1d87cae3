# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2034,SC2154
# Windows on a private X server: keys, mouse and pictures of the preview; read by `.` after
# script.sh.

server="" viewer=""
display_end() {
    [ -z "$viewer" ] || kill "$viewer" 2>/dev/null
    [ -z "$server" ] || kill "$server" 2>/dev/null
}
at_end display_end

# display_begin PROGRAM: cases of the preview, with a home of their own; messages are in
# file log. Exits if a tool is missing.
display_begin() {
    missing=""
    for tool in Xvfb:xvfb xdotool:xdotool import:imagemagick pgrep:procps; do
        command -v "${tool%:*}" >/dev/null || missing="$missing${missing:+, }${tool#*:}"
    done
    "$1" view no-such-scene 2>&1 | grep -q 'built without the preview' &&
        missing="$missing${missing:+, }libsdl2-dev"
    [ -z "$missing" ] || { skip "the preview in a window" "$missing"; exit 0; }
    program_begin "$1"
    messages=log
    export HOME="$work/home" XDG_STATE_HOME="$work/state" XDG_CONFIG_HOME="$work/config"
    mkdir -p home state config
}

# -- display and window ------------------------------------------------------------------

begin_server() {        # [WIDTHxHEIGHT]
    rm -f number
    exec 7>number
    Xvfb -displayfd 7 -screen 0 "${1:-1000x600}x24" -nolisten tcp -noreset >/dev/null 2>&1 &
    server=$!
    exec 7>&-
    until_true test -s number || { fail "Xvfb starts"; exit 1; }
    DISPLAY=:$(cat number)
    export DISPLAY
}

window_name='^tidepool: '
find_window() {
    window=$(timeout 5 xdotool search --onlyvisible --name "$window_name" 2>/dev/null | \
        head -1)
    [ -n "$window" ]
}

# open_view ARGUMENT...: opens a preview; its window is in $window, its messages in file
# log.
open_view() {
    SDL_VIDEODRIVER=x11 SDL_AUDIODRIVER=dummy timeout 120 "$program" view "$@" >log 2>&1 &
    viewer=$!
    window=""
    until_true find_window && return
    fail "no window"
    exit 1
}

# Waits for the end of the preview; the exit code is in $code.
end_view() {
    code=0
    wait "$viewer" || code=$?
    viewer=""
}
quit_view() {
    press Escape
    end_view
    [ "$code" -eq 0 ]
}
viewing() { pgrep -P "$viewer"; }

# -- keys and mouse ----------------------------------------------------------------------

do_x() { timeout 10 xdotool "$@"; }
press() { do_x windowfocus "$window" key --delay 60 "$@"; }
hold() {        # SECONDS KEY...
    seconds=$1
    shift
    do_x windowfocus "$window" keydown "$@" sleep "$seconds" keyup "$@"
}

# -- the window's picture ----------------------------------------------------------------

title() { timeout 5 xdotool getwindowname "$window"; }
titled() { title | grep -q "$1"; }
not_titled() { ! titled "$1"; }

# screen NAME.ppm: saves the window. top NAME.ppm: saves the window's upper part, free of
# messages.
screen() {
    eval "$(timeout 5 xdotool getwindowgeometry --shell "$window" | grep '^[XYWH]')"
    take "${WIDTH}x$HEIGHT+$X+$Y" "$1"
}
top() {
    eval "$(timeout 5 xdotool getwindowgeometry --shell "$window" | grep '^[XY]')"
    sides=$(title | sed -n 's/.* \([0-9]*\)x\([0-9]*\):.*/WIDTH=\1 HEIGHT=\2/p')
    [ -n "$sides" ] || return 1         # no picture yet
    eval "$sides"
    take "${WIDTH}x$((HEIGHT - 60))+$X+$Y" "$1"
}
take() { timeout 10 import -silent -window root -crop "$1" +repage -depth 8 "$2"; }
top_is() { top now.ppm && cmp -s now.ppm "$1"; }
top_is_not() { top now.ppm && differ now.ppm "$1"; }

# shot NAME.png: takes the screenshot of F12, named after the scene file $scene.
shot() {
    rm -f "$scene"-[0-9]*.png
    press F12
    until_true test -s "$scene-0001.png" && mv "$scene-0001.png" "$1"
}
# replayed NAME.png RENDER-ARGUMENT...: true if one of the first 300 frames is the
# screenshot.
replayed() {
    crc=$(convert "$1" -depth 8 bgra:- | perl -0777 -ne '
        my $crc = ~0 & 0xffffffff;
        s/(...)./$1\0/gs;
        for my $byte (unpack "C*", $_) {
            $crc ^= $byte;
            $crc = $crc & 1 ? $crc >> 1 ^ 0xedb88320 : $crc >> 1 for 1 .. 8;
        }
        printf "%08x", ~$crc & 0xffffffff;')
    shift
    "$program" render "$@" --frames 300 --hash >hashes && grep -q "$crc" hashes
}

# places TAPE: prints height and place of each poke.
places() {
    awk '{ for (i = 2; i <= NF; i++) {
               split($i, part, /[_=]/)
               if (part[1] ~ /^poke[2-8]?$/)
                   at[$1 " " part[1]] = at[$1 " " part[1]] " " substr($i, length(part[1]) + 1)
           } }
         END { for (poke in at) print at[poke] }' "$1.tape"
}
differ() { [ -s "$1" ] && [ -s "$2" ] && ! cmp -s "$1" "$2"; }
size_is() { [ "$(identify -format '%wx%h' "$1")" = "$2" ]; }
same_pixels() { [ "$(compare -metric AE "$1" "$2" null: 2>&1)" = 0 ]; }
