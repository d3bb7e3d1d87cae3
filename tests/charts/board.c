/* SPDX-License-Identifier: MIT */
/* Draws a baked scene with other settings, picture after picture, on a bare Cortex-M and on
 * this machine; one program a scene. board.sh counts the instructions of each picture.
 *
 *     WIDTHxHEIGHT TICK [WORD]... / [WIDTHxHEIGHT] [TICK] [WORD]... / ...
 *
 * The words (words.h; "bare" leaves the boat out) are separated by blanks, and come from
 * the command line or by semihosting. Each "/" begins another picture of the scene as
 * baked; size and tick stay unless given again. Each picture prints a line
 *     run WIDTH HEIGHT TICK WATER_PIXELS VERTICES TRIANGLES DROPPED CRC32
 *
 * The marks count the tick that leads to TICK, a frame's beginning, and the frame's tiles,
 * after a first frame that has filled the caches. */
#include "base/base.h"
#include "cortex-m/baked.h"
#include "cortex-m/trace_marks.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "world/world.h"
#include "tests/lib/board_output.h"
#include "tests/charts/words.h"

enum { BAND = 16, WORDS = 16384 };
static const tp_format format = TP_FORMAT_RGB565;

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);

TRACE_MARK(count_as_tick)
TRACE_MARK(count_as_frame)
TRACE_MARK(count_as_tiles)
TRACE_MARK(count_end)
TRACE_MARK(count_section)

/* -- memory -------------------------------------------------------------------------- */

#if __STDC_HOSTED__
#include <stdlib.h>

static _Alignas(64) uint8_t memory[16 << 20];

static tp_arena whole_arena(void) { return tp_arena_init(memory, sizeof memory); }
_Noreturn static void leave(int code) { exit(code); }
#else
#include "cortex-m/board.h"

static tp_arena whole_arena(void)
{
    return tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
}

_Noreturn static void leave(int code) { semihost_exit(code); }
#endif

_Noreturn static void stop(const char *why, const char *what)
{
    say("board: ");
    say(why);
    say(what);
    say("\n");
    leave(1);
}

/* -- settings of a picture ----------------------------------------------------------- */

typedef struct {
    tp_scene  scene;
    tp_assets assets;
    uint32_t  width, height, tick;
    bool      still;            /* no setting that the world depends on was changed */
} board_wish;

static void read_word(board_wish *w, const char *word, size_t bytes)
{
    const size_t by = word_until(word, 'x');
    bool still = true;

    if (*word < '0' || *word > '9') {
        if (word_begins(word, "bare"))
            w->assets.boat = NULL;
        else if (!word_set(&w->scene, word, bytes, &still))
            stop("not understood: ", word);
        w->still = w->still && still && w->assets.boat == baked_assets.boat;
    } else if (by == bytes)
        w->tick = word_number(word);
    else {
        w->width = word_number(word);
        w->height = word_number(word + by + 1);
    }
}

/* Reads the words up to the next "/" and returns the text behind the "/". */
static const char *read_wish(board_wish *w, const char *text)
{
    w->scene = baked_scene;
    w->assets = baked_assets;
    w->still = true;
    for (; *text && *text != '/'; text += *text == ' ') {
        const size_t bytes = word_until(text, ' ');
        if (bytes > 0)
            read_word(w, text, bytes);
        text += bytes;
    }
    return text + (*text == '/');
}

/* -- pictures ------------------------------------------------------------------------ */

typedef struct {
    tp_world *world;            /* world one tick before the picture's tick, or at tick 0 */
    size_t    bytes;
    tp_arena  left;             /* memory behind the world */
    uint32_t  tick;             /* tick of the picture */
    bool      usual;            /* the scene as baked, without changes */
} past;

static void make_past(past *p, const board_wish *w)
{
    tp_arena arena = whole_arena();

    if (p->world && p->usual && w->still && p->tick == w->tick)
        return;
    p->bytes = tp_world_bytes(&tp_program_all, &w->scene, &w->assets);
    p->world = tp_arena_alloc(&arena, 1, p->bytes);
    p->left = arena;
    p->tick = w->tick;
    p->usual = w->still;
    if (!p->world || !p->bytes
        || tp_world_init(&tp_program_all, p->world, p->bytes, &w->scene, &w->assets,
                         NULL))
        stop("the world cannot be made", "");
    while (p->world->tick + 1 < w->tick)
        tp_world_step(&tp_program_all, p->world, &w->scene, NULL);
}

static uint32_t draw_tiles(const tp_frame *frame, void *scratch, uint32_t *crc)
{
    uint32_t water = 0;
    tp_tile  tile;

    count_as_tiles();
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++) {
        count_end();
        const uint8_t *row = tile.pixels;
        for (uint32_t y = tile.y0; y < tile.y1; y++, row += tile.stride)
            *crc = tp_crc32_pixels(*crc, format, row, (int)tile.x1);
        water += tp_frame_water_pixels(frame, scratch, &tile);
        count_as_tiles();
    }
    count_end();
    return water;
}

static void say_run(const board_wish *w, uint32_t water, tp_draw_stats held, uint32_t crc)
{
    say_number("run ", w->width);
    say_number(" ", w->height);
    say_number(" ", w->tick);
    say_number(" ", water);
    say_number(" ", held.vertices);
    say_number(" ", held.triangles);
    say_number(" ", held.dropped);
    say_number(" ", crc);
    say("\n");
}

static void draw(const board_wish *w, const past *p)
{
    const tp_config config = { .width = w->width,
                               .height = w->height,
                               .tile_height = BAND,
                               .format = format,
                               .assets = &w->assets };
    tp_arena  arena = p->left;
    tp_world *world = tp_arena_alloc(&arena, 1, p->bytes);
    void *scratch = tp_arena_alloc(&arena, 1, tp_frame_scratch_bytes(&config, &w->scene));
    void *block = tp_arena_alloc(&arena, 1, tp_frame_bytes(&config, &w->scene));
    uint32_t  crc = 0;
    tp_frame *frame;

    if (arena.failed
        || tp_frame_init(&frame, &config, &w->scene, block,
                         tp_frame_bytes(&config, &w->scene), NULL))
        stop("the frame does not fit", "");
    memcpy(world, p->world, p->bytes);
    tp_frame_begin(frame, world);
    if (w->tick > 0) {
        count_as_tick();
        tp_world_step(&tp_program_all, world, &w->scene, NULL);
        count_end();
    }
    count_as_frame();
    tp_frame_begin(frame, world);
    count_end();
    const uint32_t water = draw_tiles(frame, scratch, &crc);
    say_run(w, water, tp_frame_stats(frame), crc);
    count_section();
}

static void draw_all(const char *text)
{
    static board_wish w = { .width = 320, .height = 240, .tick = 60 };
    static past p;

    do {
        text = read_wish(&w, text);
        make_past(&p, &w);
        draw(&w, &p);
    } while (*text);
}

#if __STDC_HOSTED__
/* Joins the arguments into one text, as semihosting supplies them. */
int main(int argc, char **argv)
{
    static char words[WORDS];
    size_t n = 0;

    for (int i = 1; i < argc; i++) {
        const int more = snprintf(words + n, sizeof words - n, "%s ", argv[i]);
        n += (size_t)more;
        if (n >= sizeof words)
            stop("too many words", "");
    }
    draw_all(words);
    return 0;
}
#else
int main(void)
{
    static char words[WORDS];

    if (!semihost_words(words, sizeof words))
        stop("too many words", "");
    draw_all(words);
    return 0;
}
#endif
