#!/bin/sh
# SPDX-License-Identifier: MIT
# A module supplied by a program: ports/examples/buoy, linked with the unchanged library.
# It is drawn, mirrored, moved by the water and shaded by a stage of its own.  Its
# parameters work on the command line, in scene files, tapes and kept worlds, and in bake.
#     own_module.sh PROGRAM
root=$PWD
build=$(realpath "${TP_BUILD:-build/host}") || exit 2
make --no-print-directory -s MORE=ports/examples/buoy \
    BUILD="${TP_BUILD:-build/host}" more "${TP_BUILD:-build/host}/screen_fake.so" || exit 2
plain=$(realpath "$1") || exit 2
set -- "$build/more/buoy/tidepool"
. "$(dirname "$0")/../lib/script.sh"
program_begin "$1"
scene=$root/assets/scenes/three-swells.ini

# hashes OPTION...: prints the hash of a picture without a boat, after 60 ticks.
hashes() {
    timeout 60 "$program" render "$scene" --set boat.mesh= --size 160x120 --frames 60:60 \
        --hash "$@" 2>err </dev/null || { echo "exit $?"; cat err; }
}

# -- drawing ---------------------------------------------------------------------------

expect "without it the program draws as the shipped one" 0 "" \
    render "$scene" --size 160x120 --frames 3 --hash
cp out with
timeout 60 "$plain" render "$scene" --size 160x120 --frames 3 --hash >out 2>err
same "bit for bit" "$(cat out)" "$(cat with)"

on="--set buoy.on=1 --set buoy.z=-9 --set buoy.size=1"
off=$(hashes)
seen=$(hashes $on)
same "it is drawn as it was when this test was written" "$seen" \
    "frame 0060 crc32 5033fe65"
same "and with it other pixels" "$([ "$seen" != "$off" ]; echo $?)" 0
for tiling in "--band 7" "--strip 32" "--threads 2" "--stream" "--band 8 --strip 32 --kept 2k" \
    "--band 4 --strip 48 --kept 2k --threads 3"; do
    same "by the same pixels with $tiling" "$(hashes $on $tiling)" "$seen"
done
same "its stage takes the colour of its row" \
    "$([ "$(hashes $on --set buoy.colour=#20c040)" != "$seen" ]; echo $?)" 0

mirrored=$(hashes $on --set mirror.method=stencil)
unmirrored=$(hashes $on --set mirror.method=none)
same "the sharp mirror shows it" "$([ "$mirrored" != "$unmirrored" ]; echo $?)" 0
same "and shows nothing without it" \
    "$(hashes --set mirror.method=none)" "$(hashes --set mirror.method=stencil)"
same "clear water shows what of it lies below" \
    "$([ "$(hashes $on --set water.clarity=8 --set mirror.method=none)" != \
         "$(hashes --set water.clarity=8 --set mirror.method=none)" ]; echo $?)" 0

# -- its parameters ---------------------------------------------------------------------

expect "a number out of its row's range is refused" 2 "buoy.size" \
    render "$scene" --set buoy.size=11 --hash
expect "a row that it has not is no row" 2 "buoy.colours" \
    render "$scene" --set buoy.colours=1 --hash
program=$plain
expect "nor is it one of the shipped program" 2 "buoy.on" render "$scene" --set buoy.on=1 --hash
program=$build/more/buoy/tidepool
{ cat "$scene"; printf '[buoy]\non = 1\nz = -9\nsize = 1\n'; } |
    sed "s,\.\./,$root/assets/,; s,^mesh.*,mesh =," >buoy.ini
timeout 60 "$program" render buoy.ini --size 160x120 --frames 60:60 --hash >out 2>err
same "a scene file tells of it" "$(cat out)" "$seen"
printf '[buoy]\nsize = 11\n' >bad.ini
expect "and is refused by line where it is wrong" 3 "^bad.ini:2: buoy.size" \
    render bad.ini --hash

{ echo "tape 2 three-swells"; echo "20 set buoy.size=2"; } >size.tape
frames() {
    timeout 60 "$program" render "$scene" --set boat.mesh= --size 96x64 --frames 40 \
        --hash $on "$@" 2>err
}
frames >small
frames --set buoy.size=2 >large
frames --tape size.tape >taped
same "a tape's change shows from its picture on" \
    "$(head -n 20 taped | cmp - small 2>&1 | cut -d: -f2)" \
    " EOF on - after byte $(head -n 20 taped | wc -c), line 20"
same "and is as if it had been so" "$(tail -n 1 taped)" "$(tail -n 1 large)"

# -- kept worlds ------------------------------------------------------------------------

FAKE_FB="96 64 32 384 64 2 16 8 8 8 0 8 24 8 0 0"
export FAKE_FB
yes 'what was on the screen' | head -c 24576 >fb0
: >log
shown() {
    FAKE_LOG=log LD_PRELOAD=$build/screen_fake.so timeout 60 "$program" show "$scene" \
        --set boat.mesh= $on --device fb0 --hash "$@" 2>err </dev/null
}
shown --frames 0:40 >all
shown --frames 0:25 --keep world >first
shown --frames 0:40 --keep world >rest
same "a kept world goes on with it, bit for bit" "$(wc -l <all) $(tail -n 15 rest)" \
    "41 $(tail -n 15 all)"
same "in which its state is a chunk with its id" "$(grep -aco 'youb' world)" 1

# -- baked -------------------------------------------------------------------------------

cat >main.c <<'END'
#include <stdio.h>
#include <stdlib.h>
#include "pixel/pixel.h"

extern const tp_scene        baked_scene;
extern const tp_assets       baked_assets;
extern const tp_program          baked_program;
extern const tp_config baked_config;

int main(void)
{
    const size_t bytes = tp_world_bytes(&baked_program, &baked_scene, &baked_assets);
    tp_world *world = malloc(bytes);
    tp_frame *frame;
    tp_tile   tile;
    uint32_t  crc = 0;
    const size_t frame_bytes = tp_frame_bytes(&baked_config, &baked_scene);
    void *block = malloc(frame_bytes);
    void *scratch = malloc(tp_frame_scratch_bytes(&baked_config, &baked_scene));

    if (tp_world_init(&baked_program, world, bytes, &baked_scene, &baked_assets, NULL)
        || tp_frame_init(&frame, &baked_config, &baked_scene, block, frame_bytes,
                         NULL))
        return 1;
    for (int n = 0; n < 60; n++)
        tp_world_step(&baked_program, world, &baked_scene, NULL);
    tp_frame_begin(frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++)
        crc = tp_crc32(crc, tile.pixels, tile.stride * (tile.y1 - tile.y0));
    printf("frame 0060 crc32 %08x\n", (unsigned)crc);
    return 0;
}
END
run bake "$scene" --set boat.mesh= $on --size 160x120 --format xrgb8888 --name baked -o b.c
judge "it is baked" 0 "bytes of RAM"
same "with its stage in the list" "$(grep -c 'tp_stage_buoy,$' b.c)" 1
own=$build/more/buoy/ports/examples/buoy
${CC:-cc} -std=c11 -I"$root/include" -I"$root/src" -I"$root" \
    -DTP_MORE='"ports/examples/buoy/list.h"' \
    main.c b.c "$own/buoy.o" "$own/buoy_drawing.o" "$build/libtidepool.a" -o baked 2>err
same "the baked program draws it, by its own list" "$(./baked)" "$seen"

finish
