/* SPDX-License-Identifier: MIT */
/* The baked scene on a bare Cortex-M: drawn tile by tile, as for a board with an SPI
 * display, and reported as CRCs; they must equal the host's.  Program and tile size are
 * baked with the scene.
 *
 * The empty functions are marks for instruction counters: they separate the core's work
 * for a whole frame, for its tiles and for a tick of the world. */
#include "baked.h"
#include "base/base.h"
#include "board.h"
#include "frame/tools.h"
#include "frame_crc.h"
#include "pixel/pixel.h"
#include "semihost.h"
#include "trace_marks.h"

#ifndef BOARD_FIRST
#define BOARD_FIRST 60          /* after 1 s: drops have fallen and foam exists */
#endif
#ifndef BOARD_FRAMES
#define BOARD_FRAMES 2
#endif

TRACE_MARK(count_as_frame)
TRACE_MARK(count_as_tiles)
TRACE_MARK(count_as_tick)
TRACE_MARK(count_end)

/* -- drawing and reports ------------------------------------------------------------- */

typedef struct {
    uint32_t crc, water, dropped;
} picture_sums;

static picture_sums draw(tp_frame *frame, void *scratch, const tp_world *world)
{
    tp_tile tile;
    picture_sums p = { 0 };

    count_as_frame();
    tp_frame_begin(frame, world);
    count_as_tiles();
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++) {
        count_end();
        p.crc = frame_crc_add_tile(p.crc, &baked_config, &tile);
        p.water += tp_frame_water_pixels(frame, scratch, &tile);
        p.dropped += tile.dropped;
        count_as_tiles();
    }
    count_end();
    return p;
}

static void tick(tp_world *world)
{
    count_as_tick();
    tp_world_step(&baked_program, world, &baked_scene, NULL);
    count_end();
}

static void say_frame(uint32_t n, const picture_sums *p, tp_draw_stats held)
{
    semihost_number("frame ", n, 10, 4);
    semihost_number(" crc32 ", p->crc, 16, 8);
    semihost_decimal("\nwater ", p->water);
    semihost_decimal(" vertices ", held.vertices);
    semihost_decimal(" triangles ", held.triangles);
    semihost_decimal(" dropped ", held.dropped + p->dropped);
    semihost_write("\n");
}

static void say_ram(tp_ram_use ram, size_t world_bytes)
{
    semihost_decimal("ram frame ", (uint32_t)ram.frame);
    semihost_decimal(" vertices ", (uint32_t)ram.vertices);
    semihost_decimal(" tables ", (uint32_t)ram.tables);
    semihost_decimal(" mirror ", (uint32_t)ram.mirror);
    semihost_decimal(" scratch ", (uint32_t)ram.scratch);
    semihost_decimal(" world ", (uint32_t)world_bytes);
    semihost_decimal(" stack ", board_stack_used());
    semihost_decimal(" reserve ", board_stack_bytes());
    semihost_decimal(" arena ", (uint32_t)(arena_end - arena_start));
    semihost_write("\n");
}

static void say_picture(void)
{
    const tp_config *c = &baked_config;

    semihost_decimal("picture ", c->width);
    semihost_decimal("x", c->height);
    semihost_write(" ");
    semihost_write(tp_format_name(c->format));
    semihost_decimal(" ", c->tile_width ? c->tile_width : c->width);
    semihost_decimal("x", c->tile_height ? c->tile_height : c->height);
    semihost_write("\n");
}

/* Allocates memory in the arena; on failure reports the sizes and stops. */
static void *take(tp_arena *arena, size_t bytes, const char *what)
{
    const size_t left = arena->bytes - arena->used;
    void *memory = tp_arena_alloc(arena, 1, bytes);

    if (!memory) {
        semihost_decimal(what, (uint32_t)bytes);
        semihost_decimal(" bytes, left ", (uint32_t)left);
        semihost_stop("");
    }
    return memory;
}

int main(void)
{
    const size_t world_bytes = baked_world_bytes;
    tp_arena  arena = tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
    const size_t bytes = baked_frame_bytes();
    void *block = take(&arena, bytes, "the frame does not fit: ");
    void *scratch = take(&arena, baked_scratch_bytes, "the tile does not fit: ");
    tp_world *world = take(&arena, world_bytes, "the world does not fit: ");
    tp_frame *frame;
    tp_error  err;

    if (baked_frame_init(&frame, block, bytes, &err))
        semihost_stop("the frame cannot be made");
    if (baked_world_init(world, world_bytes, &err))
        semihost_stop("the world cannot be made");
    for (uint32_t n = 0; n < BOARD_FIRST; n++)
        tp_world_step(&baked_program, world, &baked_scene, NULL);
    for (uint32_t n = 0; n < BOARD_FRAMES; n++) {
        const picture_sums p = draw(frame, scratch, world);
        say_frame(BOARD_FIRST + n, &p, tp_frame_stats(frame));
        tick(world);
    }
    say_ram(tp_frame_ram(frame), world_bytes);
    say_picture();
    return 0;
}
