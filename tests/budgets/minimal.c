/* SPDX-License-Identifier: MIT */
/* Draws the baked scene on a bare Cortex-M with its baked shader list and no other part of
 * the core: the cost for the smallest user. Bands of 16 rows are drawn and discarded. */
#include "cortex-m/baked.h"
#include "cortex-m/board.h"
#include "cortex-m/trace_marks.h"
#include "cortex-m/semihost.h"
#include "frame/tools.h"

#define FRAMES 2

TRACE_MARK(count_as_frame)
TRACE_MARK(count_as_tiles)
TRACE_MARK(count_end)
TRACE_MARK(count_section)

/* Draws the bands and returns the number of water pixels. */
static uint32_t draw(tp_frame *frame, void *scratch, const tp_world *world)
{
    uint32_t water = 0;
    tp_tile  tile;

    count_as_frame();
    tp_frame_begin(frame, world);
    count_as_tiles();
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++) {
        count_end();
        water += tp_frame_water_pixels(frame, scratch, &tile);
        count_as_tiles();
    }
    count_end();
    return water;
}

static int run(void)
{
    const tp_program *program = &baked_program;
    uint8_t *at = arena_start;
    size_t block = baked_frame_bytes();
    size_t scratch = baked_scratch_bytes;
    size_t bytes = baked_world_bytes;
    tp_world *world = (tp_world *)(void *)(at + ((block + 7) & ~(size_t)7));
    tp_frame *frame;

    at = (uint8_t *)world + ((bytes + 7) & ~(size_t)7);
    if (baked_frame_init(&frame, arena_start, block, NULL)
        || baked_world_init(world, bytes, NULL))
        return 1;
    semihost_write("size 320x240\n");
    for (uint32_t n = 0; n < FRAMES; n++) {
        semihost_decimal("frame ", n);
        semihost_decimal("\nwater ", draw(frame, at, world));
        semihost_decimal(" vertices ", tp_frame_stats(frame).vertices);
        semihost_decimal(" triangles ", tp_frame_stats(frame).triangles);
        semihost_decimal(" dropped ", tp_frame_stats(frame).dropped);
        semihost_write("\n");
        tp_world_step(program, world, &baked_scene, NULL);
    }
    semihost_decimal("ram frame ", (uint32_t)block);
    semihost_decimal(" scratch ", (uint32_t)scratch);
    semihost_decimal(" world ", (uint32_t)bytes);
    semihost_decimal(" stack ", board_stack_used());
    semihost_write("\n");
    count_section();
    return 0;
}

int main(void)
{
    return run();
}
