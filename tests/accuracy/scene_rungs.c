/* SPDX-License-Identifier: MIT */
/*
 * The rungs of a scene, each against the scene's exact picture, as lines of a table: scene,
 * rung, PSNR in dB (mean of two ticks), largest difference of a channel. Each rung is drawn
 * in small tiles too: tiles that change a pixel are an error.
 *
 *     scene_rungs SCENE.ini [--only NAME] [--rung NAME] [--set NAME=VALUE]...
 *
 * The options are those of the scene's cheapest rungs, the line `cheap`; with --only, of the
 * only line, of that name. Without --rung the plan's rungs are taken. Rungs that change no
 * pixel of the scene are left out.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/scene/loaded_scene.h"
#include "tests/charts/picture.h"
#include "tests/lib/frames.h"
#include "world/text.h"

enum { WIDTH = 320, HEIGHT = 240, PIXELS = WIDTH * HEIGHT, TICKS = 2 };

static const uint32_t ticks[TICKS] = { 60, 300 };

/* Pictures of the scene at the ticks. */
typedef struct {
    uint32_t pixel[TICKS][PIXELS];
} pictures;

static pictures exact, drawn, tiled;
static bool failed;

/* -- drawing ------------------------------------------------------------------------- */

static void draw(const loaded_scene *s, uint32_t width, uint32_t height, uint32_t *pixels)
{
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_width = width,
                               .tile_height = height };
    test_frame f = frame_of(&s->file.scene, &s->assets.names, &config);

    frame_draw_picture(&f, s->world, pixels);
    frame_free(&f);
}

/* Opens the scene at a tick. */
static void open_at(loaded_scene *s, options *o, uint32_t tick)
{
    if (loaded_scene_load(s, o) != EXIT_DONE || loaded_scene_make_world(s) != EXIT_DONE)
        exit(EXIT_INPUT);
    if (!o->rung)               /* the plan's rungs, as bake takes them */
        tp_rung_set_apply_some(&s->file.scene, &s->plan.set, s->plan.open);
    while (s->world->tick < tick)
        tp_world_step(&tp_program_all, s->world, &s->file.scene, NULL);
}

/* -- lines of the table -------------------------------------------------------------- */

static int largest_difference(const uint32_t *a, const uint32_t *b)
{
    int most = 0;

    for (size_t i = 0; i < PIXELS; i++)
        for (int shift = 0; shift < 24; shift += 8) {
            const int off = abs((int)(a[i] >> shift & 255) - (int)(b[i] >> shift & 255));
            most = off > most ? off : most;
        }
    return most;
}

/* Draws the rung at tick number i in large and in small tiles. */
static void draw_rung(const loaded_scene *s, const char *scene, const char *rung, uint32_t i)
{
    draw(s, WIDTH, 16, drawn.pixel[i]);
    draw(s, 48, 7, tiled.pixel[i]);
    if (memcmp(drawn.pixel[i], tiled.pixel[i], sizeof drawn.pixel[i]) == 0)
        return;
    fprintf(stderr, "%s, %s: tiles of 48x7 change the picture of tick %u\n", scene, rung,
            (unsigned)ticks[i]);
    failed = true;
}

static void print_line(const char *scene, const char *rung)
{
    double psnr = 0;
    int most = 0;

    if (memcmp(&exact, &drawn, sizeof exact) == 0)
        return;
    for (uint32_t i = 0; i < TICKS; i++) {
        const int off = largest_difference(exact.pixel[i], drawn.pixel[i]);
        const double db = off ? picture_psnr(exact.pixel[i], drawn.pixel[i], PIXELS) : 99;
        psnr += db / TICKS;
        most = off > most ? off : most;
    }
    printf("%s,%s,%.1f,%d\n", scene, rung, psnr, most);
    fflush(stdout);
}

/* -- rungs --------------------------------------------------------------------------- */

/* True if the row chooses a rung of the picture. */
static bool is_rung_row(const tp_param *row)
{
    return strncmp(row->name, "quality.", 8) == 0 && row->kind == TP_PARAM_CHOICE;
}

/* Draws a rung of a row in the exact scenes, one for each tick. */
static void try_rung(loaded_scene at[TICKS], const char *scene, const tp_param *row,
                     int32_t value)
{
    char rung[64], word[32];

    for (uint32_t i = 0; i < TICKS; i++) {
        int32_t *to = scene_number(&at[i].file.scene, row);
        *to = value;
        tp_param_text(&at[i].file.scene, row, word, sizeof word);
        snprintf(rung, sizeof rung, "%s=%s", row->name + 8, word);
        draw_rung(&at[i], scene, rung, i);
        *to = TP_RUNG_EXACT;
    }
    print_line(scene, rung);
}

static void try_all_rungs(loaded_scene at[TICKS], const char *scene)
{
    uint32_t count;
    const tp_param *rows = tp_params(&count);

    for (uint32_t i = 0; i < count; i++)
        for (int32_t value = 2; is_rung_row(&rows[i]) && value <= rows[i].high; value++)
            try_rung(at, scene, &rows[i], value);
}

/* Draws the scene with options, and prints its line. */
static void draw_scene(options *o, const char *scene, const char *rung)
{
    for (uint32_t i = 0; i < TICKS; i++) {
        loaded_scene s;
        open_at(&s, o, ticks[i]);
        draw_rung(&s, scene, rung, i);
        loaded_scene_close(&s);
    }
    print_line(scene, rung);
}

/* -- command line -------------------------------------------------------------------- */

static bool read_cheap(options *o, int argc, char **argv, const char **only)
{
    for (int i = 2; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--only") == 0)
            *only = argv[i + 1];
        else if (strcmp(argv[i], "--rung") == 0)
            o->rung = argv[i + 1];
        else if (strcmp(argv[i], "--set") == 0)
            o->settings[o->n_settings++] = argv[i + 1];
        else
            return false;
    }
    return argc >= 2 && argc % 2 == 0;
}

int main(int argc, char **argv)
{
    const char *settings[32];
    options cheap = { .command = "scene_rungs", .settings = settings, .quiet = true,
                      .width = WIDTH, .height = HEIGHT };
    loaded_scene at[TICKS];
    char scene[64];
    const char *only = NULL;

    if (argc > 32 || !read_cheap(&cheap, argc, argv, &only)) {
        fprintf(stderr, "usage: scene_rungs SCENE.ini [--only NAME] [--rung NAME] "
                        "[--set NAME=VALUE]...\n");
        return EXIT_USAGE;
    }
    const char *slash = strrchr(argv[1], '/');
    snprintf(scene, sizeof scene, "%s", slash ? slash + 1 : argv[1]);
    scene[strcspn(scene, ".")] = 0;
    cheap.scene = argv[1];
    options plain = { .command = cheap.command, .scene = argv[1], .rung = "exact",
                      .quiet = true };
    for (uint32_t i = 0; i < TICKS; i++) {
        open_at(&at[i], &plain, ticks[i]);
        draw(&at[i], WIDTH, 16, exact.pixel[i]);
    }
    if (!only)
        try_all_rungs(at, scene);
    for (uint32_t i = 0; i < TICKS; i++)
        loaded_scene_close(&at[i]);
    plain.rung = "fast";
    if (!only)
        draw_scene(&plain, scene, "fast");
    draw_scene(&cheap, scene, only ? only : "cheap");
    return failed ? EXIT_CHECK : EXIT_DONE;
}
