#!/bin/sh
# SPDX-License-Identifier: MIT
# The README's first program compiles as it stands there and draws a whole picture; what
# it shows is there, and every shipped scene is in the gallery.
. tests/gates/lib.sh

program=$scratch/first
first_program >"$program.c"
check "the README has a program" grep -q tp_frame_tile "$program.c"
check "it compiles without a warning" cc -std=c11 -Wall -Wextra -Werror -Iinclude \
    "$program.c" build/host/libtidepool.a -o "$program"
check "it draws every pixel" "$program"

size_of()       # PNG: its sides, from the header
{
    od -An -tu1 -j16 -N8 "$1" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }'
}
in_gallery()    # SCENE
{
    [ "$(size_of "assets/gallery/$1.png")" = 640x480 ]
}
for scene in assets/scenes/*.ini; do
    scene=$(basename "$scene" .ini)
    check "the gallery shows $scene, 640x480" in_gallery "$scene"
done
pictures()      # that the README links to
{
    for picture in $(grep -o '([^)]*\.png)' README.md | tr -d '()'); do
        [ -s "$picture" ] || { echo "no $picture"; return 1; }
    done
}
check "the README's pictures are there" pictures
check "one of them is the sheet" grep -q 'assets/gallery/sheet.png' README.md
light() { [ "$(wc -c <"$1")" -le "$2" ]; }
check "the sheet is no heavier than 1.5 MB" light assets/gallery/sheet.png 1500000
for picture in assets/gallery/tour-*.png; do
    [ ! -e "$picture" ] || check "$picture is no heavier than 120 KB" light "$picture" 120000
done
preview() { sed -n '/^## The preview/,/^## /p' README.md; }
keys()          # of the preview: the first that each action has
{
    "${TP_PROGRAM:-build/host/tidepool}" manual >"$scratch/page"
    sed -n '/^\.SH KEYS/,/^\.SH EXIT/s/^\\fB\([^ ]*\).*\\fR (.*/\1/p' "$scratch/page" |
        sed 's/\\fR$//; s/\\-/-/g' >"$scratch/keys"
    grep -qx F1 "$scratch/keys" || { echo "the manual lists no keys"; return 1; }
    while read -r key; do
        preview | grep -qF "\`$key\`" || { echo "the README lacks $key"; return 1; }
    done <"$scratch/keys"
}
check "the README knows the preview's keys" keys
exit $((failures > 0))
