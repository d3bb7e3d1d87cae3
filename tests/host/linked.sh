#!/bin/sh
# SPDX-License-Identifier: MIT
# Programs that name no tp_program: a baked file brings its own, and nothing else of the
# library is linked; without a baked file the library brings everything.
#
#   tests/host/linked.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"

program=$1
cat >"$scratch/sea.c" <<'END'
#include <stdio.h>
#include "tidepool/tidepool.h"
#ifdef BAKED
extern const tp_scene  baked_scene;
extern const tp_config baked_config;
#else
extern const tp_scene  alone_scene;
extern const tp_assets alone_assets;
#endif
static uint64_t memory[1 << 17];
int main(void)
{
    tp_engine *sea;
    tp_tile    tile;
    uint32_t   crc = 0;
#ifdef BAKED
    const tp_scene *scene = &baked_scene;
    tp_config config = baked_config;
    config.program = NULL;              /* the linked one */
#else
    const tp_scene *scene = &alone_scene;
    const tp_config config = { .width = 320, .height = 240, .format = TP_FORMAT_RGB565,
                               .assets = &alone_assets };
#endif
    if (tp_engine_init(&sea, &config, scene, memory, sizeof memory, NULL))
        return 1;
    tp_engine_begin(sea);
    while (tp_engine_next_tile(sea, &tile))
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            crc = tp_crc32_pixels(crc, TP_FORMAT_RGB565, (const char *)tile.pixels
                                  + (y - tile.y0) * tile.stride, 320);
    return printf("%08x\n", (unsigned)crc) < 0;
}
END
"$program" bake count-64 --texels 64 --size 320x240 --format rgb565 --no-input \
    --name baked -o "$scratch/baked.c" 2>"$scratch/log" || cat "$scratch/log"
"$program" bake count-64 --texels 64 --name alone -o "$scratch/alone.c"
picture()       # OPTION...
{
    "$program" render count-64 --texels 64 --size 320x240 --format rgb565 --frames 0:0 \
        --hash "$@" | sed 's/.* //'
}
# The baked program draws the plan's rungs; the library draws those that the scene names, and
# exact ones in the rows that are left open.
set --
for row in rate=layers layers=nearest distortion=nearest ripple=nearest visibility=rows \
    shading=quick; do set -- "$@" --set "quality.$row"; done
picture >"$scratch/want-baked"
picture --rung exact "$@" >"$scratch/want-alone"

links()         # NAME FLAG
{
    cc -std=c11 -Wall -Wextra -Werror -O1 -ffunction-sections -fdata-sections $2 -Iinclude \
        "$scratch/sea.c" "$scratch/$1.c" build/host/libtidepool.a -Wl,--gc-sections \
        -o "$scratch/$1"
}
draws() { "$scratch/$1" | cmp - "$scratch/want-$1"; }
stages()        # NAME: prints its stages
{
    nm "$scratch/$1" | sed -n 's/.* tp_stage_//p' | sort
}
check "a program links with a baked file" links baked -DBAKED
check "and without a list" links alone
check "the first draws the host's picture by its own program" draws baked
check "the second draws it by everything" draws alone
stages baked >"$scratch/few"
stages alone >"$scratch/all"
of_list()       # true if every linked stage is in the baked list
{
    grep -o 'tp_stage_[a-z_0-9]*' "$scratch/baked.c" | sed 's/tp_stage_//' | sort -u |
        comm -13 - "$1" | { ! grep .; }
}
check "the first has the stages of its list alone" of_list "$scratch/few"
refuse "everything has no more than that list" of_list "$scratch/all"
whole() { [ "$(wc -l <"$1")" -ge 80 ]; }
check "the second has all stages" whole "$scratch/all"
refuse "the first has all stages" whole "$scratch/few"
finish
