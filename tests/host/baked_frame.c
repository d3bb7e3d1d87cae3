/* SPDX-License-Identifier: MIT */
/* Draws a baked scene by the baked frame, or with GENERAL defined by tp_frame_init: prints
 * its memory and the CRC of two pictures, and the errors of too little memory and of none. */
#include <stdio.h>
#include "cortex-m/baked.h"
#include "tidepool/tidepool.h"

static uint64_t block[1 << 17], scratch[1 << 17], state[1 << 16];

#ifdef GENERAL
static size_t block_bytes(void)
{
    return tp_frame_bytes(&baked_config, &baked_scene);
}
static tp_status make(tp_frame **frame, void *memory, size_t bytes, tp_error *err)
{
    return tp_frame_init(frame, &baked_config, &baked_scene, memory, bytes, err);
}
static size_t scratch_bytes(bool direct)
{
    return direct ? tp_frame_direct_scratch_bytes(&baked_config, &baked_scene)
                  : tp_frame_scratch_bytes(&baked_config, &baked_scene);
}
#else
static size_t block_bytes(void) { return baked_frame_bytes(); }
static tp_status make(tp_frame **frame, void *memory, size_t bytes, tp_error *err)
{
    return baked_frame_init(frame, memory, bytes, err);
}
static size_t scratch_bytes(bool direct)
{
    return direct ? baked_direct_scratch_bytes : baked_scratch_bytes;
}
#endif

static uint32_t draw(tp_frame *frame, const tp_world *world)
{
    uint32_t crc = 0;
    tp_tile  tile;

    tp_frame_begin(frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++)
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            crc = tp_crc32_pixels(crc, baked_config.format, (const char *)tile.pixels
                                  + (y - tile.y0) * tile.stride, (int)(tile.x1 - tile.x0));
    return crc;
}

static void say_error(tp_frame **frame, void *memory, size_t bytes)
{
    tp_error err = { .code = TP_OK };
    char     text[160];

    make(frame, memory, bytes, &err);
    tp_error_text(&err, text, sizeof text);
    printf("%s\n", text);
}

int main(void)
{
    tp_world *world = (tp_world *)(void *)state;
    tp_frame *frame;
    const size_t bytes = block_bytes();

    if (bytes > sizeof block || baked_scratch_bytes > sizeof scratch
        || baked_world_init(world, sizeof state, NULL)
        || make(&frame, block, bytes, NULL))
        return 1;
    printf("%zu %zu %zu\n", bytes, scratch_bytes(false), scratch_bytes(true));
    for (int n = 0; n < 2; n++) {
        printf("%08x\n", (unsigned)draw(frame, world));
        for (int tick = 0; tick < 30; tick++)
            tp_world_step(&baked_program, world, &baked_scene, NULL);
    }
    say_error(&frame, block, bytes - 1);
    say_error(&frame, NULL, bytes);
    say_error(&frame, (char *)block + 4, bytes);
    say_error(NULL, block, bytes);
    return 0;
}
