/* SPDX-License-Identifier: MIT */
/* A program with one baked scene for a raw screen: a single file to copy to a small
 * Linux board.
 *
 * SCENE-screen [--on fb|kms] [--device PATH] [--size WxH] [--frames N|A:B] [--hold]
 *                [--hash] [--keep FILE] */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "cortex-m/baked.h"
#include "fullscreen.h"
#include "pixel/pixel.h"

#define BAND_ROWS 32            /* rows per tile, drawn directly into the picture */

typedef struct {
    picture   picture;
    tp_frame *frame;
    void     *block, *scratch;
} baked_drawing;

static void *claim(size_t bytes)
{
    void *memory = malloc(bytes);
    if (!memory)
        exit(log_fail_memory(bytes));
    return memory;
}

/* -- callbacks of the loop ----------------------------------------------------------- */

static int prepare(void *user, uint32_t width, uint32_t height, tp_format format)
{
    baked_drawing *d = user;
    const tp_config config = { .width = width,
                               .height = height,
                               .format = format,
                               .tile_height = height < BAND_ROWS ? height : BAND_ROWS,
                               .assets = &baked_assets };
    const size_t row_bytes = tp_format_row_bytes(format, (int)width);
    tp_error err = { 0 };
    free(d->picture.rows);
    free(d->block);
    free(d->scratch);
    d->picture = (picture){ format, width, height, row_bytes, claim(row_bytes * height) };
    const size_t bytes = tp_frame_bytes(&config, &baked_scene);
    d->block = claim(bytes);
    d->scratch = claim(tp_frame_direct_scratch_bytes(&config, &baked_scene));
    if (tp_frame_init(&d->frame, &config, &baked_scene, d->block, bytes, &err))
        return log_fail_error("screen", &err);
    return EXIT_DONE;
}

static const picture *draw(void *user, const tp_world *world, uint32_t frame)
{
    baked_drawing *d = user;
    tp_tile tile;
    (void)frame;
    tp_frame_begin(d->frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile_direct(
             d->frame, i, d->scratch, d->picture.rows, d->picture.row_bytes, &tile);
         i++)
        ;
    return &d->picture;
}

/* -- the command line ---------------------------------------------------------------- */

#define TAKES "--on " SHOW_PORTS ", --device PATH, --size WxH, --frames N|A:B, --hold," \
              " --hash, --keep FILE"

static int refuse(const char *word)
{
    return log_fail(EXIT_USAGE, "%s: unknown option; expected " TAKES, word);
}

/* Refuses signs and blanks, accepted by sscanf. */
static bool is_plain(const char *value)
{
    return value[strspn(value, "0123456789:x")] == '\0';
}

static bool read_frames(show *s, const char *value)
{
    char end;
    uint32_t count;
    s->counted = true;
    if (!is_plain(value))
        return false;
    if (sscanf(value, "%" SCNu32 ":%" SCNu32 "%c", &s->first, &s->last, &end) == 2)
        return s->first <= s->last;
    if (sscanf(value, "%" SCNu32 "%c", &count, &end) != 1 || count == 0)
        return false;
    s->first = 0;
    s->last = count - 1;
    return true;
}

static bool read_size(show *s, const char *value)
{
    char end;
    return is_plain(value)
        && sscanf(value, "%" SCNu32 "x%" SCNu32 "%c", &s->width, &s->height, &end) == 2
        && s->width >= 16 && s->width <= 4096 && s->height >= 16 && s->height <= 4096;
}

/* Reads an option and its value.  Returns false for an unknown option or a wrong value. */
static bool read_option(show *s, const char *name, const char *value)
{
    if (strcmp(name, "--on") == 0)
        return (s->port = show_port(value)) != NULL;
    if (strcmp(name, "--device") == 0)
        return *(s->device = value) != 0;
    if (strcmp(name, "--keep") == 0)
        return *(s->keep = value) != 0;
    if (strcmp(name, "--size") == 0)
        return read_size(s, value);
    return strcmp(name, "--frames") == 0 && read_frames(s, value);
}

static int read_all(show *s, int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--hold") == 0)
            s->hold = true;
        else if (strcmp(argv[i], "--hash") == 0)
            s->hash = true;
        else if (i + 1 == argc || !read_option(s, argv[i], argv[i + 1]))
            return refuse(argv[i]);
        else
            i++;
    }
    return EXIT_DONE;
}

int main(int argc, char **argv)
{
    baked_drawing d = { 0 };
    show s = { .port = &screen_fb, .scene = &baked_scene, .assets = &baked_assets,
               .user = &d, .prepare = prepare, .draw = draw };
    tp_error err = { 0 };
    streams_begin();
    if (argc == 2 && strcmp(argv[1], "--help") == 0) {
        puts("Shows a scene on a screen without a window system.  Options:\n" TAKES
             "; Esc ends it.");
        return streams_finish();
    }
    const int code = read_all(&s, argc, argv);
    if (code)
        return code;
    s.world_bytes = tp_world_bytes(&tp_program_all, &baked_scene, &baked_assets);
    s.world = claim(s.world_bytes);
    if (tp_world_init(&tp_program_all, s.world, s.world_bytes, &baked_scene,
                      &baked_assets, &err))
        return log_fail_error("screen", &err);
    return show_run(&s);
}
