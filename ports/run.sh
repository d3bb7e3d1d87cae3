#!/bin/sh
# SPDX-License-Identifier: MIT
# Shows a scene in a window.  Without a display draws a picture and a short film into the
# folder out and prints their paths.  Exits with the program's exit code.
#
#   ports/run.sh PROGRAM SCENE
set -eu
[ $# = 2 ] || { echo "usage: ports/run.sh PROGRAM SCENE" >&2; exit 2; }
program=$1 scene=$2 no_display=4        # the program's exit code without a display

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    echo "the preview of $scene: F1 lists the keys, Escape quits"
    code=0
    "$program" view "$scene" || code=$?
    [ $code -eq $no_display ] || exit $code
fi

name=${scene##*/}
picture=out/${name%.ini}.png film=out/${name%.ini}.apng
echo "no display: drawing $scene into files"
mkdir -p out
"$program" render "$scene" --size 960x540 --out "$picture"
"$program" render "$scene" --size 320x240 --format rgb565 --frames 0:177 --every 3 \
    --out "$film"
megabytes=$(wc -c <"$film" | awk '{ printf $1 < 1e5 ? "%.2f" : "%.1f", $1 / 1e6 }')
echo "  $PWD/$picture: a picture, 960x540"
echo "  $PWD/$film: 3 seconds, 320x240, 20 pictures a second, $megabytes MB;"
echo "      an animated PNG, which every browser plays"
