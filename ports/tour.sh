#!/bin/sh
# SPDX-License-Identifier: MIT
# Takes the README's pictures of the preview and of the page, each reduced to few colours
# and at most 120 KB.
#
#   ports/tour.sh PROGRAM FOLDER
#
# The preview runs in a display of its own and is driven by key presses.  The page, if built
# in build/web, is opened in Chromium.  If a machine lacks a needed program, the picture is
# left as it was, and a message names the program.
set -u
[ $# = 2 ] || { echo "usage: ports/tour.sh PROGRAM FOLDER" >&2; exit 2; }
program=$(realpath "$1") || exit 3
folder=$(realpath "$2") || exit 3
page=$(realpath -m build/web)/index.html

lacks() {       # PICTURES COMMAND...
    pictures=$1
    shift
    for command in "$@"; do
        command -v "$command" >/dev/null || {
            echo "tour: left out: $pictures (no $command)"
            return 0
        }
    done
    return 1
}
lacks "the tour" convert && exit 0

work=$(mktemp -d) || exit 3
server= viewer= lost=0
lose() {        # TEXT [CODE]
    echo "tour: $1" >&2
    lost=${2:-3}
    return 1
}
cleanup() {
    [ -z "$viewer" ] || kill "$viewer" 2>/dev/null
    [ -z "$server" ] || kill "$server" 2>/dev/null
    wait
    rm -rf "$work"
}
trap cleanup EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP
export HOME="$work" XDG_CONFIG_HOME="$work/config" XDG_STATE_HOME="$work/state"
export XDG_CACHE_HOME="$work/cache" LC_ALL=C

# until_true COMMAND...: repeats a command until it succeeds, for at most 20 s.
until_true() {
    for _ in $(seq 100); do
        "$@" && return 0
        sleep 0.2
    done
    return 1
}

# keep PICTURE NAME: saves with the most colours that fit into 120 KB.
keep() {
    [ -s "$1" ] || { lose "$2.png could not be taken"; return; }
    for colours in 256 192 128 96 64 48 32; do
        convert "$1" +dither -colors $colours -strip "PNG8:$work/few.png"
        [ "$(wc -c <"$work/few.png")" -gt 120000 ] || break
    done
    cp "$work/few.png" "$folder/$2.png" || { lose "$2.png was not written"; return; }
    echo "  $folder/$2.png: $colours colours"
}

# -- the preview -----------------------------------------------------------------------

start() {       # SCENE OPTION...
    (cd "$work" && SDL_VIDEODRIVER=x11 SDL_AUDIODRIVER=dummy \
        exec "$program" view "$@") >"$work/log" 2>&1 &
    viewer=$!
    until_true find_window || lose "no window was opened" 4
}
find_window() {
    window=$(xdotool search --onlyvisible --name '^tidepool: ' 2>/dev/null | head -1)
    [ -n "$window" ]
}
press() { xdotool windowfocus "$window" key "$@"; }
take() {        # SECONDS NAME: takes the window's picture after a time
    sleep "$1"
    import -silent -window "$window" "$work/whole.png"
    keep "$work/whole.png" "$2"
}
stop() {        # the first Escape may close a dialog instead
    for _ in 1 2 3 4 5; do
        kill -0 "$viewer" 2>/dev/null || break
        press Escape 2>/dev/null
        sleep 0.5
    done
    kill "$viewer" 2>/dev/null
    wait "$viewer"
    viewer=
}

tour_of_preview() {
    Xvfb -displayfd 7 -screen 0 1600x1000x24 -nolisten tcp -noreset \
        7>"$work/number" >/dev/null 2>&1 &
    server=$!
    until_true test -s "$work/number" || { lose "no display" 4; return; }
    DISPLAY=:$(cat "$work/number")
    export DISPLAY
    start three-swells || return 1
    sleep 8
    press F3                    # the panel's search
    xdotool type wave0
    take 1 tour-panel
    stop
    start night-sea || return 1
    sleep 4
    press F1
    take 1 tour-keys
    stop
    start three-swells --no-panel || return 1
    sleep 6
    press p F4 F8               # compared: reference, exact, triangles, rows, projected,
    press shift+F8 shift+F8 shift+F8 shift+F8 shift+F8          # flat
    take 2 tour-compare
    stop
}
lacks "the preview" Xvfb xdotool import || tour_of_preview

# -- the page --------------------------------------------------------------------------

tour_of_page() {
    timeout 60 chromium --headless=new --no-sandbox --disable-gpu --hide-scrollbars \
        --user-data-dir="$work/chromium" --window-size=960,640 --virtual-time-budget=8000 \
        --screenshot="$work/page.png" "file://$page#scene=tank&frame=150" >"$work/log" 2>&1
    keep "$work/page.png" tour-page
}
if [ -s "$page" ]; then
    lacks "the page" chromium || tour_of_page
else
    echo "tour: left out: the page (make web builds it)"
fi
exit $lost
