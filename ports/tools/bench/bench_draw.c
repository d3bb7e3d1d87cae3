/* SPDX-License-Identifier: MIT */
/* Frames of the benchmark's scene by this engine: one thread, whole frames, one world tick
 * per frame. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "app/files/log.h"
#include "app/files/timing.h"
#include "app/scene/frame_renderer.h"
#include "bench.h"
#include "world/world.h"

static int begin_world(const bench_scene *s, tp_world *world)
{
    tp_error err = { 0 };
    if (tp_world_init(&tp_program_all, world, sizeof *world, &s->scene, &s->assets, &err))
        return log_fail_error("bench", &err);
    for (int i = 0; i < BENCH_TICK; i++)
        tp_world_step(&tp_program_all, world, &s->scene, NULL);
    return EXIT_DONE;
}

double bench_decibels(const bench_list *list, const bench_figure *f,
                      const uint32_t *pixels)
{
    const size_t count = (size_t)f->width * f->height;
    double squares = 0;
    if (!list->kept)
        return -1;
    for (size_t i = 0; i < count; i++)
        for (int shift = 0; shift < 24; shift += 8) {
            const double d = (double)(pixels[i] >> shift & 255)
                           - (double)(list->kept[i] >> shift & 255);
            squares += d * d;
        }
    return squares > 0 ? 10 * log10(255.0 * 255 * 3 * (double)count / squares)
                       : (double)INFINITY;
}

static int keep(bench_list *list, bench_figure *f, const picture *p, bool first)
{
    uint32_t *pixels = malloc((size_t)f->width * f->height * sizeof *pixels);
    if (!pixels)
        return log_fail_memory((size_t)f->width * f->height * sizeof *pixels);
    for (uint32_t y = 0; y < f->height; y++)
        picture_expand_row(p, y, pixels + (size_t)y * f->width);
    f->decibels = first ? -1 : bench_decibels(list, f, pixels);
    if (!first) {
        free(pixels);
        return EXIT_DONE;
    }
    free(list->kept);
    list->kept = pixels;
    return EXIT_DONE;
}

static int write_picture(const bench_figure *f, const picture *p, const char *folder)
{
    char name[160];
    snprintf(name, sizeof name, "%s/%s-%ux%u-%u-tidepool.png", folder,
             bench_work_name[f->work], (unsigned)f->width, (unsigned)f->height,
             (unsigned)f->points);
    return picture_write_png(p, name);
}

/* Draws a round.  The first frame, at tick BENCH_TICK, is not timed: it warms up the
 * caches, and its picture is compared. */
static int draw_round(bench_list *list, const bench_scene *s, frame_renderer *c,
                      tp_world *world, bench_figure *f, int round, bool first,
                      const char *folder)
{
    timings times = { 0 };
    int code = EXIT_DONE;
    frame_renderer_draw(c, world);
    if (round == 0) {
        f->water = c->water_pixels;
        code = keep(list, f, &c->picture, first);
        if (!code && folder)
            code = write_picture(f, &c->picture, folder);
    }
    for (uint32_t i = 0; i < list->frames && !code; i++) {
        tp_world_step(&tp_program_all, world, &s->scene, NULL);
        const uint64_t begin = processor_us();
        frame_renderer_draw(c, world);
        timings_add(&times, processor_us() - begin);
    }
    f->us[round] = timings_median(&times);
    timings_free(&times);
    return code;
}

int bench_draw(bench_list *list, bench_scene *s, bench_figure *f, int round, bool first,
               const char *folder)
{
    const tp_config config = {
        .width = f->width,
        .height = f->height,
        .format = TP_FORMAT_XRGB8888,
    };
    tp_world world;
    frame_renderer c;
    bench_scene_set(s, f->work, f->points);
    s->scene.quality.visibility = (int32_t)f->rungs.visibility;
    s->scene.quality.shading = (int32_t)f->rungs.shading;
    frame_renderer_plan(&c, &config, 1);
    c.plan = tp_plan_make(&s->scene, &s->assets, f->width, f->height);
    int code = frame_renderer_open(&c, &s->scene, &s->assets);
    if (!code)
        code = begin_world(s, &world);
    if (!code)
        code = draw_round(list, s, &c, &world, f, round, first, folder);
    frame_renderer_close(&c);
    return code;
}
