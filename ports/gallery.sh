#!/bin/sh
# SPDX-License-Identifier: MIT
# Draws every shipped scene for the README, and a contact sheet of all scenes; board_steps.sh
# draws them as a board would; then tour.sh takes pictures of the preview and of the page.
#
#   ports/gallery.sh PROGRAM FOLDER
#
# Each scene is drawn at a frame typical for its subject; a scene not listed here at 300.
set -eu
[ $# = 2 ] || { echo "usage: ports/gallery.sh PROGRAM FOLDER" >&2; exit 2; }
program=$1 folder=$2
command -v montage >/dev/null || {
    echo "gallery: the sheet needs montage (package imagemagick)" >&2
    exit 3
}

frames='
calm-bay      0
count-64      0
count-100     0
deep-sea      520
flat-calm     0
from-above    200
harbour       500
minimal       0
night-sea     120
pond          600
raindrops     300
shore-break   332
storm         340
tank          150
three-swells  600
'

frame_of()      # SCENE
{
    echo "$frames" | awk -v scene="$1" '$1 == scene { n = $2; found = 1 }
                                        END { print found ? n : 300 }'
}

scenes=$("$program" scenes | cut -d' ' -f1)
mkdir -p "$folder"
for scene in $scenes; do
    n=$(frame_of "$scene")
    echo "  $folder/$scene.png"
    "$program" render "$scene" --size 640x480 --frames "$n:$n" --out "$folder/$scene.png"
done

cells=
for scene in $scenes; do
    cells="$cells -label $scene $folder/$scene.png"
done
echo "  $folder/sheet.png"
# shellcheck disable=SC2086
montage -font DejaVu-Sans -pointsize 14 $cells -resize 256x192 -geometry 256x192+3+3 \
    -tile 5x -background '#f4f4f0' -fill '#202428' -depth 8 -strip "PNG24:$folder/sheet.png"
"${0%/*}/board_steps.sh" "$program" "$folder/boards"
"${0%/*}/tour.sh" "$program" "$folder"
