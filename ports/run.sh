#!/bin/sh
# SPDX-License-Identifier: MIT
# Shows a scene in a window; without a display draws a picture and a film of it instead.
#
#   ports/run.sh PROGRAM SCENE
set -eu
[ $# = 2 ] || { echo "usage: ports/run.sh PROGRAM SCENE" >&2; exit 2; }
program=$1 scene=$2

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    echo "the preview of $scene: F1 lists the keys, Escape quits"
    code=0
    "$program" view "$scene" || code=$?
    [ $code -eq 4 ] || exit $code           # 4: no display could be opened
fi

mkdir -p out
echo "no display: drawing $scene"
"$program" render "$scene" --size 960x540 --out "out/$scene.png"
film="render $scene --size 640x360 --frames 0:299"
if command -v ffmpeg >/dev/null; then
    "$program" $film --out - | ffmpeg -v error -y -i - -pix_fmt yuv420p "out/$scene.mp4"
    set -- "out/$scene.mp4"
else
    "$program" $film --out "out/$scene.y4m"
    set -- "out/$scene.y4m"
fi
echo "picture:           $PWD/out/$scene.png"
echo "film of 5 seconds: $PWD/$1"
