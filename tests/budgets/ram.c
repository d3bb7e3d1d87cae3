/* SPDX-License-Identifier: MIT */
/* Measures the memory that a scene takes on a bare Cortex-M, by tile size: the baked program
 * draws into a picture of the whole size with its lines stored, with streamed lines, and with
 * streamed lines of which 2 KB and 4 KB are kept, each with exactly the bytes that the frame
 * asks for.
 *
 * Prints the use of the memory for each case, and the picture's CRC, which is equal in all
 * cases; the marks let the plugin count the frame's instructions. */
#include "base/base.h"
#include "cortex-m/baked.h"
#include "cortex-m/board.h"
#include "cortex-m/trace_marks.h"
#include "cortex-m/semihost.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "world/world.h"

enum { WIDTH = 320, HEIGHT = 240, FIRST = 60 };

TRACE_MARK(count_as_frame)
TRACE_MARK(count_as_tiles)
TRACE_MARK(count_end)
TRACE_MARK(count_section)

static const uint32_t sizes[][2] = {
    { 320, 16 }, { 320, 4 }, { 160, 8 }, { 64, 16 }, { 64, 8 }, { 64, 6 }, { 32, 32 },
    { 32, 16 },
};

static uint16_t picture[WIDTH * HEIGHT];
static tp_program program;

/* Returns the picture's CRC; *water receives its pixels of water. */
static uint32_t draw(tp_frame *frame, void *scratch, const tp_world *world, uint32_t *water)
{
    uint32_t crc = 0;
    tp_tile  tile;


    tp_frame_begin(frame, world);           /* the first begin fills tables */
    count_as_frame();
    tp_frame_begin(frame, world);
    count_as_tiles();
    for (uint32_t i = 0;
         tp_frame_draw_tile_direct(frame, i, scratch, picture, 2 * WIDTH, &tile); i++) {
        count_end();
        *water += tp_frame_water_pixels(frame, scratch, &tile);
        count_as_tiles();
    }
    count_end();
    for (uint32_t y = 0; y < HEIGHT; y++)
        crc = tp_crc32_pixels(crc, TP_FORMAT_RGB565, picture + y * WIDTH, WIDTH);
    return crc;
}

static void say(const char *how, const uint32_t size[2], tp_ram_use ram, size_t scratch,
                size_t world, uint32_t water, uint32_t crc)
{
    semihost_write("ram ");
    semihost_write(how);
    semihost_decimal(" tile ", size[0]);
    semihost_decimal("x", size[1]);
    semihost_decimal(" frame ", ram.frame);
    semihost_decimal(" vertices ", ram.vertices);
    semihost_decimal(" tables ", ram.tables);
    semihost_decimal(" mirror ", ram.mirror);
    semihost_decimal(" scratch ", scratch);
    semihost_decimal(" world ", world);
    semihost_decimal(" stack ", board_stack_used());
    semihost_decimal(" water ", water);
    semihost_decimal(" crc ", crc);
    semihost_write("\n");
    count_section();
}

static void measure(const char *how, const uint32_t size[2], uint32_t kept_bytes)
{
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_width = size[0],
                               .tile_height = size[1],
                               .format = TP_FORMAT_RGB565,
                               .program = &program,
                               .assets = &baked_assets,
                               .kept_bytes = kept_bytes };
    const size_t world_bytes = baked_world_bytes;
    const size_t scratch_bytes = tp_frame_direct_scratch_bytes(&config, &baked_scene);
    tp_arena  arena = tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
    void *block = tp_arena_alloc(&arena, 1, tp_frame_bytes(&config, &baked_scene));
    void     *scratch = tp_arena_alloc(&arena, 1, scratch_bytes);
    tp_world *world = tp_arena_alloc(&arena, 1, world_bytes);
    tp_frame *frame;

    if (arena.failed
        || tp_frame_init(&frame, &config, &baked_scene, block,
                         tp_frame_bytes(&config, &baked_scene), NULL)
        || baked_world_init(world, world_bytes, NULL))
        semihost_stop("the scene does not fit");
    while (world->tick < FIRST)
        tp_world_step(&program, world, &baked_scene, NULL);
    uint32_t water = 0;
    const uint32_t crc = draw(frame, scratch, world, &water);
    say(how, size, tp_frame_ram(frame), scratch_bytes, world_bytes, water, crc);
}

static void measure_sizes(const char *how, uint32_t kept_bytes)
{
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        measure(how, sizes[i], kept_bytes);
}

int main(void)
{
    program = baked_program;
    measure_sizes("stored", 0);
    if (program.method.triangles)
        program.method.triangles = &tp_method_streamed;
    if (program.method.walk)
        program.method.walk = &tp_method_streamed_walk;
    program.draw.kept_lines = &tp_draw_kept_lines;
    measure_sizes("streamed", 0);
    measure_sizes("kept-2k", 2048);
    measure_sizes("kept-4k", 4096);
    return 0;
}
