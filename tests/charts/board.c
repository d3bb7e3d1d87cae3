/* SPDX-License-Identifier: MIT */
/* A baked scene as its settings want it, picture after picture: one program a scene on a
 * bare Cortex-M and on this machine, for whoever counts what they cost.
 *
 *     WIDTHxHEIGHT TICK [NAME=VALUE]... / [WIDTHxHEIGHT] [TICK] [NAME=VALUE]... / ...
 *
 * Words parted by blanks, of the command line or the semihosting one; each "/" begins
 * another picture, of the scene as it was baked; size and tick stay as they were if they
 * are not told anew.  Of each a line
 *     run WIDTH HEIGHT TICK WATER_PIXELS VERTICES TRIANGLES DROPPED CRC32
 *
 * The marks count a tick, the one that leads to TICK, a frame's beginning and its tiles,
 * after a frame that has filled what is filled once. */
#if __STDC_HOSTED__
#include <stdio.h>
#include <stdlib.h>
#endif
#include "cortex-m/baked.h"

enum { BAND = 16, WORDS = 16384 };
static const tp_format format = TP_FORMAT_RGB565;

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);

#define MARK(name) \
    void name(void); \
    __attribute__((noinline)) void name(void) { __asm__ volatile("" ::: "memory"); }
MARK(count_as_tick)
MARK(count_as_frame)
MARK(count_as_tiles)
MARK(count_end)
MARK(count_section)

/* -- words and memory ---------------------------------------------------------------- */

#if __STDC_HOSTED__
static _Alignas(64) uint8_t memory[16 << 20];

static tp_arena whole_arena(void) { return tp_arena_over(memory, sizeof memory); }
static void say(const char *text) { fputs(text, stdout); }
_Noreturn static void leave(int code) { exit(code); }
#else
#include "cortex-m/board.h"
#include "cortex-m/semihost.h"

static tp_arena whole_arena(void)
{
    return tp_arena_over(arena_start, (size_t)(arena_end - arena_start));
}

static void say(const char *text) { semihost_write(text); }
_Noreturn static void leave(int code) { semihost_exit(code); }
#endif

static void say_number(const char *before, uint32_t n)
{
    char  text[12];
    char *c = text + sizeof text - 1;

    *c = '\0';
    do
        *--c = (char)('0' + n % 10);
    while (n /= 10);
    say(before);
    say(c);
}

_Noreturn static void stop(const char *why, const char *what)
{
    say("board: ");
    say(why);
    say(what);
    say("\n");
    leave(1);
}

/* -- a picture's wishes -------------------------------------------------------------- */

typedef struct {
    tp_scene scene;
    uint32_t width, height, tick;
    bool     still;             /* nothing was set that the world knows of */
} wish;

static size_t until(const char *text, char end)
{
    size_t n = 0;

    while (text[n] && text[n] != ' ' && text[n] != end)
        n++;
    return n;
}

static uint32_t number_of(const char *text, size_t bytes)
{
    uint32_t n = 0;

    for (size_t i = 0; i < bytes; i++) {
        if (text[i] < '0' || text[i] > '9')
            stop("no number: ", text);
        n = n * 10 + (uint32_t)(text[i] - '0');
    }
    return n;
}

static bool begins(const char *text, const char *with)
{
    while (*with && *text == *with)
        text++, with++;
    return !*with;
}

static void set(wish *w, const char *word, size_t bytes)
{
    const size_t name = until(word, '=');
    const tp_param *param = name < bytes ? tp_param_find(word, name) : NULL;

    if (!param || tp_param_set(&w->scene, param, word + name + 1, bytes - name - 1, NULL))
        stop("not understood: ", word);
    w->still = w->still && (begins(word, "quality.") || begins(word, "grid."));
}

static void read_word(wish *w, const char *word, size_t bytes)
{
    const size_t by = until(word, 'x');

    if (*word < '0' || *word > '9')
        set(w, word, bytes);
    else if (by == bytes)
        w->tick = number_of(word, bytes);
    else {
        w->width = number_of(word, by);
        w->height = number_of(word + by + 1, bytes - by - 1);
    }
}

/* Up to the next "/", and past it. */
static const char *read_wish(wish *w, const char *text)
{
    w->scene = baked_scene;
    w->still = true;
    for (; *text && *text != '/'; text += *text == ' ') {
        const size_t bytes = until(text, ' ');
        if (bytes > 0)
            read_word(w, text, bytes);
        text += bytes;
    }
    return text + (*text == '/');
}

/* -- pictures ------------------------------------------------------------------------ */

typedef struct {
    tp_world *world;            /* a tick before the picture's, or at 0 */
    size_t    bytes;
    tp_arena  left;             /* behind it */
    uint32_t  tick;             /* that the picture is of */
    bool      usual;            /* of the scene as baked */
} past;

static void make_past(past *p, const wish *w)
{
    tp_arena arena = whole_arena();

    if (p->world && p->usual && w->still && p->tick == w->tick)
        return;
    p->bytes = tp_world_bytes(&w->scene, &baked_assets);
    p->world = tp_arena_take(&arena, 1, p->bytes);
    p->left = arena;
    p->tick = w->tick;
    p->usual = w->still;
    if (!p->world || !p->bytes
        || tp_world_init(p->world, p->bytes, &w->scene, &baked_assets, NULL))
        stop("the world cannot be made", "");
    while (p->world->tick + 1 < w->tick)
        tp_world_step(p->world, &w->scene, NULL);
}

static uint32_t draw_tiles(const tp_frame *frame, void *scratch, uint32_t *crc)
{
    uint32_t water = 0;
    tp_tile  tile;

    count_as_tiles();
    for (uint32_t i = 0; tp_frame_tile(frame, i, scratch, &tile); i++) {
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

static void say_run(const wish *w, uint32_t water, tp_frame_stats held, uint32_t crc)
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

static void draw(const wish *w, const past *p)
{
    const tp_frame_config config = { w->width, w->height, 0, BAND, format };
    tp_arena  arena = p->left;
    tp_world *world = tp_arena_take(&arena, 1, p->bytes);
    void     *scratch = tp_arena_take(&arena, 1, tp_frame_scratch_bytes(&config));
    void     *block = tp_arena_take(&arena, 1, tp_frame_bytes(&w->scene, &baked_assets,
                                                              &config));
    uint32_t  crc = 0;
    tp_frame *frame;

    if (arena.failed || tp_frame_init(&frame, &w->scene, &baked_assets, &config, block,
                                      NULL))
        stop("the frame does not fit", "");
    memcpy(world, p->world, p->bytes);
    tp_frame_begin(frame, world);
    if (w->tick > 0) {
        count_as_tick();
        tp_world_step(world, &w->scene, NULL);
        count_end();
    }
    count_as_frame();
    tp_frame_begin(frame, world);
    count_end();
    const uint32_t water = draw_tiles(frame, scratch, &crc);
    say_run(w, water, tp_frame_last_stats(frame), crc);
    count_section();
}

static void draw_all(const char *text)
{
    static wish w = { .width = 320, .height = 240, .tick = 60 };
    static past p;

    do {
        text = read_wish(&w, text);
        make_past(&p, &w);
        draw(&w, &p);
    } while (*text);
}

#if __STDC_HOSTED__
/* Arguments become one text, as semihosting gives them. */
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
