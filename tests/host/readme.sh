#!/bin/sh
# SPDX-License-Identifier: MIT
# The README's first program compiles as printed and draws a whole picture.  The pictures and
# links of the pages exist, their figures are right, and the gallery has every shipped scene.
. "$(dirname "$0")/../lib/script.sh"

# -- the first program ------------------------------------------------------------------

program=$scratch/first
first_program >"$program.c"
check "the README has a program" grep -q tp_engine_next_tile "$program.c"
check "it compiles without a warning" cc -std=c11 -Wall -Wextra -Werror -Iinclude \
    "$program.c" build/host/libtidepool.a -o "$program"
# tests/host/first.ini has the numbers of tp_scene_init, and names the picture
# used there.
"${TP_PROGRAM:-build/host/tidepool}" render tests/host/first.ini --texels 16 \
    --rung exact --size 320x240 --frames 30:30 --hash | sed 's/.* //' >"$scratch/want"
draws() { "$1" >"$scratch/got" && cmp "$scratch/want" "$scratch/got"; }
check "its picture 30 is that of the scene file with the same numbers" draws "$program"
moves() { ! cmp -s "$scratch/want" "$scratch/still"; }
"${TP_PROGRAM:-build/host/tidepool}" render tests/host/first.ini --texels 16 \
    --rung exact --size 320x240 --frames 0:0 --hash | sed 's/.* //' >"$scratch/still"
check "picture 30 differs from picture 0" moves
# The built-in picture is generated from the shipped one.
ripple()
{
    echo '/* SPDX-License-Identifier: MIT */'
    echo '/* Made by `tests/host/readme.sh --write` of assets/textures/water-normal.png, at 16'
    echo ' * texels a side; not to be edited. */'
    "${TP_PROGRAM:-build/host/tidepool}" bake tests/host/first.ini --texels 16 --name sea \
        -o "$scratch/sea.c" &&
        awk '/^static const uint32_t sea_ripple/, /^};/' "$scratch/sea.c" |
        sed 's/sea_ripple/ripple/'
}
if [ "${1:-}" = --write ]; then
    ripple >src/world/sea_ripple.inc
    exit
fi
same_ripple() { ripple | cmp - src/world/sea_ripple.inc; }
check "the built-in picture is the shipped one, 16 texels a side" same_ripple
small() { [ "$(grep -o 0x src/world/sea_ripple.inc | wc -l)" -le 1024 ]; }
check "it is no larger than 4 KB" small

# The sizes on the page for embedders equal the library's.
cat >"$scratch/sizes.c" <<'END'
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tidepool/tidepool.h"
int main(int argc, char **argv)         /* WIDTH HEIGHT FORMAT ROWS VERTICES */
{
    tp_scene scene;
    if (argc != 6)
        return 1;
    tp_scene_init(&scene);
    scene.grid.vertices = atoi(argv[5]);
    const tp_config c = {
        .width = (uint32_t)atoi(argv[1]), .height = (uint32_t)atoi(argv[2]),
        .tile_height = (uint32_t)atoi(argv[4]),
        .format = strcmp(argv[3], "rgb565") ? TP_FORMAT_XRGB8888 : TP_FORMAT_RGB565,
    };
    return printf("%zu\n", tp_engine_bytes(&c, &scene)) < 0;
}
END
sizes()
{
    cc -std=c11 -Wall -Wextra -Werror -Iinclude "$scratch/sizes.c" \
        build/host/libtidepool.a -o "$scratch/sizes" || return 1
    sed -n '/^| [0-9]*x[0-9]* | [a-z]/s/[|x]/ /gp' include/tidepool/README.md |
        sed 's/ rgb8888/ xrgb8888/' >"$scratch/rows"
    [ "$(wc -l <"$scratch/rows")" -ge 6 ] || return 1
    while read -r width height format rows vertices bytes; do
        is "$width $rows $vertices $("$scratch/sizes" "$width" "$height" "$format" "$rows" \
            "$vertices")" "$width $rows $vertices $(echo "$bytes" | tr -d ,)" || return 1
    done <"$scratch/rows"
}
check "include/tidepool/README.md gives the measured bytes" sizes

# -- pictures ---------------------------------------------------------------------------

size_of()       # PNG: prints width and height from the header
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
pictures()      # prints the README's links to pictures
{
    for picture in $(grep -o '([^)]*\.png)' README.md | tr -d '()'); do
        [ -s "$picture" ] || { echo "no $picture"; return 1; }
    done
}
check "the README's pictures are there" pictures
check "one picture is the sheet of all scenes" grep -q 'assets/gallery/sheet.png' README.md
light() { [ "$(wc -c <"$1")" -le "$2" ]; }
check "the sheet is no heavier than 1.5 MB" light assets/gallery/sheet.png 1500000
for picture in assets/gallery/tour-*.png; do
    [ ! -e "$picture" ] || check "$picture is no heavier than 120 KB" light "$picture" 120000
done
keys()          # prints the preview's keys: the first one of each action
{
    "${TP_PROGRAM:-build/host/tidepool}" manual >"$scratch/page"
    sed -n '/^\.SH KEYS/,/^\.SH EXIT/s/^\\fB\([^ ]*\).*\\fR (.*/\1/p' "$scratch/page" |
        sed 's/\\fR$//; s/\\-/-/g' >"$scratch/keys"
    grep -qx F1 "$scratch/keys" || { echo "the manual lists no keys"; return 1; }
    while read -r key; do
        grep -qF "\`$key\`" ports/app/preview/KEYS.md || { echo "the page lacks $key"; return 1; }
    done <"$scratch/keys"
}
check "ports/app/preview/KEYS.md lists the preview's keys" keys

# -- links ------------------------------------------------------------------------------

links()         # each link of a page leads to a file or a folder
{
    for page in README.md assets/charts/README.md \
        $(find include ports src tests -name '[A-Z]*.md'); do
        for link in $(grep -o '](\([^)#: ]*\))' "$page" | sed 's/^](//; s/)$//'); do
            [ -e "$(dirname "$page")/$link" ] || { echo "$page: no $link"; return 1; }
        done
    done
}
check "every link of a page leads to a file" links
finish
