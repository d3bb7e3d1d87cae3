/* SPDX-License-Identifier: MIT */
#include "ladder_pictures.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/timing.h"
#include "frame/tools.h"
#include "tools/bake/program_memory.h"
#include "tools/reference/image.h"

enum { PICTURES = 2, BAND = 16, THREADS = 2 };

static const uint32_t ticks[PICTURES] = { 60, 300 };

/* -- pictures ------------------------------------------------------------------------ */

/* Pictures of one step at the ticks. */
typedef struct {
    uint32_t *pixel[PICTURES];
} pictures;

static bool pictures_take(pictures *p, size_t pixels)
{
    bool taken = true;

    for (int i = 0; i < PICTURES; i++) {
        p->pixel[i] = malloc(pixels * sizeof *p->pixel[i]);
        taken = taken && p->pixel[i];
    }
    return taken;
}

static void pictures_free(pictures *p)
{
    for (int i = 0; i < PICTURES; i++)
        free(p->pixel[i]);
}

static double mean_square(const uint32_t *a, const uint32_t *b, size_t pixels)
{
    double sum = 0;

    for (size_t i = 0; i < pixels; i++)
        for (int k = 0; k < 24; k += 8) {
            const double d = (double)(a[i] >> k & 255) - (double)(b[i] >> k & 255);
            sum += d * d;
        }
    return sum / 3 / (double)pixels;
}

/* Opens the scene with the rows of a step. */
static int open_step(loaded_scene *s, const options *o, const ladder_step *step)
{
    options plain = *o;

    plain.band = o->band ? o->band : BAND;
    plain.format = TP_FORMAT_XRGB8888;
    plain.quiet = true;
    plain.stepped = false;
    int code = loaded_scene_load(s, &plain);
    code = code ? code : set_ladder_apply(s, &plain, step);
    return code ? code : loaded_scene_open_renderer(s, &plain);
}

static void copy_picture(const picture *p, uint32_t *pixels)
{
    for (uint32_t y = 0; y < p->height; y++)
        memcpy(pixels + (size_t)y * p->width, picture_row(p, y), p->width * sizeof *pixels);
}

/* Sets RAM and flash of the step's baked program, in RGB565 unless --format names another. */
static int measure_program(ladder_step *step, const loaded_scene *s, const options *o,
                           component_search_worlds *worlds)
{
    options baked = *o;
    program_memory memory;

    baked.format = o->formatted ? o->format : TP_FORMAT_RGB565;
    baked.band = o->band ? o->band : BAND;
    const int code = program_memory_find(&memory, &s->file.scene, &s->assets.names, &baked,
                                         worlds);
    if (!code) {
        step->ram = program_memory_ram(&memory);
        step->flash = program_memory_flash(&memory);
    }
    return code;
}

/* Draws the pictures of a step; measured: sets its RAM and flash too. */
static int draw_step(ladder_step *step, const options *o, pictures *to, bool measured,
                     component_search_worlds *worlds)
{
    loaded_scene s;
    int code = open_step(&s, o, step);

    for (int i = 0; i < PICTURES && !code; i++) {
        while (s.world->tick < ticks[i])
            tp_world_step(&tp_program_all, s.world, &s.file.scene, NULL);
        frame_renderer_draw(&s.renderer, s.world);
        copy_picture(&s.renderer.picture, to->pixel[i]);
    }
    if (!code && measured)
        code = measure_program(step, &s, o, worlds);
    loaded_scene_close(&s);
    return code;
}

static void measure_against(ladder_step *step, const pictures *exact, const pictures *drawn,
                            size_t pixels)
{
    double sum = 0, db = 0;

    for (int i = 0; i < PICTURES; i++) {
        const double square = mean_square(exact->pixel[i], drawn->pixel[i], pixels);
        sum += square / PICTURES;
        db += (square > 0 ? 10 * log10(65025 / square) : 99) / PICTURES;
    }
    step->added = sqrt(sum);
    step->db = db;
}

/* Draws the pictures with the reference. */
static int draw_reference(const options *o, const ladder_step *exact, pictures *to)
{
    loaded_scene s;
    int code = open_step(&s, o, exact);

    for (int i = 0; i < PICTURES && !code; i++) {
        ref_scene scene;
        ref_image image;
        while (s.world->tick < ticks[i])
            tp_world_step(&tp_program_all, s.world, &s.file.scene, NULL);
        ref_scene_open(&scene, &s.file.scene, &s.assets.names, s.world, o->width,
                       o->height, false);
        ref_image_draw(&image, &scene, o->width, o->height, REF_SAMPLES, THREADS);
        for (uint32_t n = 0; n < o->width * o->height; n++)
            to->pixel[i][n] = ref_image_pixel(&image, n % o->width, n / o->width);
        ref_image_free(&image);
    }
    loaded_scene_close(&s);
    return code;
}

static double total_error(const pictures *reference, const pictures *drawn, size_t pixels)
{
    double sum = 0;

    for (int i = 0; i < PICTURES; i++)
        sum += mean_square(reference->pixel[i], drawn->pixel[i], pixels) / PICTURES;
    return sqrt(sum);
}

int ladder_pictures_measure(ladder_step *step, uint32_t count, const options *o, bool reference)
{
    static const tp_rung_set none = { .of = { 0 } };
    const size_t pixels = (size_t)o->width * o->height;
    ladder_step first = { .set = none };
    component_search_worlds worlds = { .known = false };
    pictures exact = { { NULL } }, drawn = { { NULL } }, truth = { { NULL } };
    progress p = progress_begin();
    int code = pictures_take(&exact, pixels) && pictures_take(&drawn, pixels)
                       && pictures_take(&truth, pixels)
                   ? EXIT_DONE : log_fail_memory(6 * pixels * 4);

    code = code ? code : draw_step(&first, o, &exact, false, NULL);
    if (reference && !code)
        code = draw_reference(o, &first, &truth);
    for (uint32_t i = 0; i < count && !code; i++) {
        progress_show(&p, i, count);
        code = draw_step(&step[i], o, &drawn, true, count > 1 ? &worlds : NULL);
        measure_against(&step[i], &exact, &drawn, pixels);
        step[i].total = reference ? total_error(&truth, &drawn, pixels) : -1;
    }
    log_progress("");
    dry_run_close(&worlds.run);
    pictures_free(&exact);
    pictures_free(&drawn);
    pictures_free(&truth);
    return code;
}
