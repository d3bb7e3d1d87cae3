/* SPDX-License-Identifier: MIT */
/* Draws a baked scene for each row of span.h between the marks of span.sh, and prints
 *     run CHART FROM KEY WATER-PIXELS
 *
 * Freestanding if the compiler is in freestanding mode, else with a C library. */
#include "tests/charts/span.h"
#include "base/base.h"
#include "frame/tools.h"
#include "tidepool/modules.h"

#define MARK(name) \
    void name(void); \
    __attribute__((noinline)) void name(void) { __asm__ volatile("" ::: "memory"); }
MARK(count_as_tiles)
MARK(count_end)
MARK(count_section)

#if __STDC_HOSTED__
#include <stdio.h>
static uint64_t memory[4 << 20];
static void say(const char *text) { fputs(text, stdout); }
static tp_arena whole(void) { return tp_arena_init(memory, sizeof memory); }
#else
#include "cortex-m/board.h"
#include "cortex-m/semihost.h"
static void say(const char *text) { semihost_write(text); }
static tp_arena whole(void)
{
    return tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
}
#endif

enum { WIDTH = 320, HEIGHT = 240, BAND = 16 };

static void say_number(uint32_t n)
{
    char  text[12];
    char *c = text + sizeof text - 1;

    *c = '\0';
    do
        *--c = (char)('0' + n % 10);
    while (n /= 10);
    say(c);
}

static span_scene s;

/* Draws the scene. Returns false if the scene cannot be drawn. */
static bool draw(uint32_t *water)
{
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = BAND,
                               .format = TP_FORMAT_RGB565,
                               .assets = &s.assets };
    const size_t world_bytes = tp_world_bytes(&tp_program_all, &s.scene, &s.assets);
    tp_arena  arena = whole();
    void *block = tp_arena_alloc(&arena, 1, tp_frame_bytes(&config, &s.scene));
    void *scratch = tp_arena_alloc(&arena, 1, tp_frame_scratch_bytes(&config, &s.scene));
    tp_world *world = tp_arena_alloc(&arena, 1, world_bytes);
    tp_frame *frame;
    tp_tile   tile;

    *water = 0;
    if (arena.failed
        || tp_frame_init(&frame, &config, &s.scene, block,
                         tp_frame_bytes(&config, &s.scene), NULL)
        || tp_world_init(&tp_program_all, world, world_bytes, &s.scene, &s.assets, NULL))
        return false;
    tp_frame_begin(frame, world);
    count_as_tiles();
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++) {
        count_end();
        *water += tp_frame_water_pixels(frame, scratch, &tile);
        count_as_tiles();
    }
    count_end();
    count_section();
    return true;
}

int main(void)
{
    for (const span_row *row = span_rows; row->chart; row++) {
        uint32_t water;
        if (!span_begin(&s, row) || !draw(&water)) {
            say("a picture cannot be drawn\n");
            return 1;
        }
        say("run ");
        say(row->chart);
        say(row->from ? " " : " -");
        say(row->from ? row->from : "");
        say(" ");
        say(row->key);
        say(" ");
        say_number(water);
        say("\n");
    }
    return 0;
}
