/* SPDX-License-Identifier: MIT */
/* The baked scene on a bare Cortex-M: drawn band by band, as a board with an SPI display
 * would, and told in CRCs, which must be the host's.
 *
 * The empty functions are marks for whoever counts instructions: what the core does for a
 * whole frame, for its tiles and for a tick of the world. */
#include "baked.h"
#include "board.h"
#include "marks.h"
#include "semihost.h"

#ifndef BOARD_SIZE
#define BOARD_SIZE 320, 240
#endif
#ifndef BOARD_BAND
#define BOARD_BAND 16
#endif
#ifndef BOARD_FIRST
#define BOARD_FIRST 60          /* a second on, when drops have fallen and foam is made */
#endif
#ifndef BOARD_FRAMES
#define BOARD_FRAMES 2
#endif

MARK(count_as_frame)
MARK(count_as_tiles)
MARK(count_as_tick)
MARK(count_end)

/* -- a picture ----------------------------------------------------------------- */

/* Draws one frame; its CRC.  A band takes the picture's whole width, so the rows of the
 * tiles follow each other. */
static uint32_t draw(tp_frame *frame, const tp_frame_config *config, void *scratch,
                     const tp_world *world, uint32_t *water_pixels)
{
    tp_tile  tile;
    uint32_t crc = 0;
    *water_pixels = 0;
    count_as_frame();
    tp_frame_begin(frame, world);
    count_as_tiles();
    for (uint32_t i = 0; tp_frame_tile(frame, i, scratch, &tile); i++) {
        count_end();
        const uint8_t *row = tile.pixels;
        for (uint32_t y = tile.y0; y < tile.y1; y++, row += tile.stride)
            crc = tp_crc32_pixels(crc, config->format, row, (int)config->width);
        *water_pixels += tp_frame_water_pixels(frame, scratch, &tile);
        count_as_tiles();
    }
    count_end();
    return crc;
}

static void tick(tp_world *world)
{
    count_as_tick();
    tp_world_step(world, &baked_scene, NULL);
    count_end();
}

static void say_frame(uint32_t n, uint32_t crc, uint32_t water, tp_frame_stats held)
{
    semihost_number("frame ", n, 10, 4);
    semihost_number(" crc32 ", crc, 16, 8);
    semihost_decimal("\nwater ", water);
    semihost_decimal(" vertices ", held.vertices);
    semihost_decimal(" triangles ", held.triangles);
    semihost_decimal(" dropped ", held.dropped);
    semihost_write("\n");
}

static void say_ram(tp_frame_ram ram, size_t world_bytes)
{
    semihost_decimal("ram frame ", (uint32_t)ram.frame);
    semihost_decimal(" vertices ", (uint32_t)ram.vertices);
    semihost_decimal(" tables ", (uint32_t)ram.tables);
    semihost_decimal(" mirror ", (uint32_t)ram.mirror);
    semihost_decimal(" scratch ", (uint32_t)ram.scratch);
    semihost_decimal(" world ", (uint32_t)world_bytes);
    semihost_decimal(" stack ", board_stack_used());
    semihost_write("\n");
}

int main(void)
{
    const tp_frame_config config = { BOARD_SIZE, 0, BOARD_BAND, TP_FORMAT_RGB565 };
    const size_t world_bytes = tp_world_bytes(&baked_scene, &baked_assets);
    tp_arena  arena = tp_arena_over(arena_start, (size_t)(arena_end - arena_start));
    void     *block = tp_arena_take(&arena, 1, tp_frame_bytes(&baked_scene, &baked_assets,
                                                              &config));
    void     *scratch = tp_arena_take(&arena, 1, tp_frame_scratch_bytes(&config));
    tp_world *world = tp_arena_take(&arena, 1, world_bytes);
    tp_frame *frame;
    tp_error  err;

    if (arena.failed
        || tp_frame_init(&frame, &baked_scene, &baked_assets, &config, block, &err))
        semihost_stop("the frame does not fit");
    if (tp_world_init(world, world_bytes, &baked_scene, &baked_assets, &err))
        semihost_stop("the world cannot be made");
    while (world->tick < BOARD_FIRST)
        tp_world_step(world, &baked_scene, NULL);
    for (uint32_t n = 0; n < BOARD_FRAMES; n++) {
        uint32_t water;
        const uint32_t crc = draw(frame, &config, scratch, world, &water);
        say_frame(BOARD_FIRST + n, crc, water, tp_frame_last_stats(frame));
        tick(world);
    }
    say_ram(tp_frame_memory(frame), world_bytes);
    return 0;
}
