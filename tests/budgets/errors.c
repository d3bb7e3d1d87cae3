/* SPDX-License-Identifier: MIT */
/* How far each rung is off: shipped scenes at 320x240 by it and by the exact rungs.
 *
 *     errors SCENE.ini...
 *
 * Lines: error RUNG CLASS PX COLOUR SCENE TICK.  Outlines: pixels that are water in one
 * picture alone, over the exact picture's borders of water met going down its columns.
 * Colours: the rms of 255 of the worst channel, of pixels that are water in both.  And
 *     slope COLOUR SCENE: such a rms over the rms of an added small wave's slopes */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "host/stage.h"
#include "raster/raster.h"
#include "scene/prices.h"

enum { WIDTH = 320, HEIGHT = 240, COUNT = WIDTH * HEIGHT, LATE = 100 };

#define SMALL_SLOPE  0.02       /* k A */
#define SMALL_LENGTH 4          /* m */

typedef struct {
    uint32_t pixel[COUNT];
    bool     water[COUNT];
} drawing;

static const char *const rungs[TP_KINDS][TP_KIND_RUNGS] = {
    { "triangles", "rows", "projected", "flat" }, { "exact", "quick" },
    { "full", "layers", "colour" }, { "off", "on" },
};

static const char *const classes[] = {
    "level", "level_glossy", "level_sparks", "gentle", "gentle_glossy", "gentle_sparks",
    "steep", "steep_glossy", "steep_sparks",
};

/* One tile over all; the samples' keys are the first plane of its scratch. */
static void draw(drawing *to, const stage *s, const tp_scene *scene,
                 const tp_world *world)
{
    const tp_frame_config config = { .width = WIDTH, .height = HEIGHT };
    void *block = malloc(tp_frame_bytes(scene, &s->assets.names, &config));
    uint32_t *scratch = malloc(tp_frame_scratch_bytes(&config));
    tp_frame *frame;
    tp_tile   tile;

    if (!block || !scratch
        || tp_frame_init(&frame, scene, &s->assets.names, &config, block, NULL))
        abort();
    tp_frame_begin(frame, world);
    tp_frame_tile(frame, 0, scratch, &tile);
    for (size_t i = 0; i < COUNT; i++)
        to->water[i] = TP_MARK(scratch[i]) == TP_MARK_WATER;
    memcpy(to->pixel, tile.pixels, sizeof to->pixel);
    free(scratch);
    free(block);
}

static double rms_of(const drawing *a, const drawing *b)
{
    double sum[3] = { 0, 0, 0 }, worst = 0;
    uint32_t count = 0;

    for (size_t i = 0; i < COUNT; i++) {
        if (!a->water[i] || !b->water[i])
            continue;
        count++;
        for (int c = 0; c < 3; c++) {
            const int off = (int)(a->pixel[i] >> 8 * c & 255)
                          - (int)(b->pixel[i] >> 8 * c & 255);
            sum[c] += off * off;
        }
    }
    for (int c = 0; c < 3; c++)
        worst = fmax(worst, sum[c]);
    return count ? sqrt(worst / count) : 0;
}

static double px_of(const drawing *exact, const drawing *b)
{
    uint32_t elsewhere = 0, borders = 0;

    for (size_t i = 0; i < COUNT; i++) {
        elsewhere += exact->water[i] != b->water[i];
        borders += i >= WIDTH && exact->water[i] != exact->water[i - WIDTH];
    }
    return borders ? (double)elsewhere / borders : 0;
}

static const uint8_t counts[TP_KINDS] = { TP_VISIBILITIES, TP_SHADINGS, TP_RATES,
                                          TP_LODS };

typedef struct {
    uint8_t of[TP_KINDS];
} choice;

static tp_scene scene_by(const stage *s, choice c)
{
    tp_scene scene = s->file.scene;

    scene.quality.visibility = c.of[TP_KIND_VISIBILITY] + 1;
    scene.quality.shading = c.of[TP_KIND_SHADING] + 1;
    scene.quality.rate = c.of[TP_KIND_RATE] + 1;
    scene.quality.lod = c.of[TP_KIND_LOD] + 1;
    scene.quality.error_px = scene.quality.error_colour = 0;
    return scene;
}

/* All of a kind against its exact one, the other kinds as in `base`. */
static void compare(const stage *s, uint32_t tick, const tp_outlook *o, choice base,
                    int kind)
{
    static drawing exact, other;

    for (uint8_t i = 0; i < counts[kind]; i++) {
        base.of[kind] = i;
        const tp_scene scene = scene_by(s, base);
        draw(i ? &other : &exact, s, &scene, s->world);
        printf("error %s %s %.4f %.4f %s %u\n", rungs[kind][i], classes[o->sea],
               i ? px_of(&exact, &other) : 0, i ? rms_of(&exact, &other) : 0,
               s->file.name, (unsigned)tick);
    }
}

/* Rates with each shading, and lines left out with each way to see that fits the scene:
 * what a rung spoils may depend on the others. */
static void compare_all(const stage *s, uint32_t tick)
{
    const tp_outlook o = tp_outlook_of(&s->file.scene, &s->assets.names, WIDTH, HEIGHT);
    choice base = { { 0, 0, 0, 0 } };

    if (o.overlooks)
        compare(s, tick, &o, base, TP_KIND_VISIBILITY);
    compare(s, tick, &o, base, TP_KIND_SHADING);
    for (uint8_t i = 0; i < TP_SHADINGS; i++) {
        base.of[TP_KIND_SHADING] = i;
        compare(s, tick, &o, base, TP_KIND_RATE);
    }
    base.of[TP_KIND_SHADING] = 0;
    for (uint8_t i = 0; i < (o.overlooks ? TP_VISIBILITIES : 1); i++) {
        base.of[TP_KIND_VISIBILITY] = i;
        compare(s, tick, &o, base, TP_KIND_LOD);
    }
}

/* Of scenes whose waves are plain; the wave's phase is any. */
static void lay_a_wave(stage *s)
{
    static drawing without, more;
    tp_wave  *last = &s->file.scene.wave[TP_WAVES - 1];

    if (last->amplitude > 0 || tp_world_ocean(s->world))
        return;
    tp_scene scene = scene_by(s, (choice){ { 0, 0, 0, 0 } });
    draw(&without, s, &scene, s->world);
    *last = (tp_wave){ .length = SMALL_LENGTH * TP_FX_ONE, .heading = 70 * TP_FX_ONE,
                       .power = 1 };
    last->amplitude = (tp_fx)lround(SMALL_SLOPE * SMALL_LENGTH / 6.2831853 * 65536);
    if (stage_world(s))
        exit(1);
    scene = scene_by(s, (choice){ { 0, 0, 0, 0 } });
    draw(&more, s, &scene, s->world);
    printf("slope %.4f %s\n", rms_of(&without, &more) / (SMALL_SLOPE * sqrt(0.5)),
           s->file.name);
}

static int measure(const char *path)
{
    options o = { .command = "errors", .scene = path, .width = WIDTH, .height = HEIGHT };
    stage s;
    int code = stage_open(&s, &o);

    if (!code) {
        compare_all(&s, 0);
        for (int i = 0; i < LATE; i++)
            tp_world_step(s.world, &s.file.scene, NULL);
        compare_all(&s, LATE);
        if (!stage_world(&s))
            lay_a_wave(&s);
    }
    stage_close(&s);
    return code;
}

int main(int argc, char **argv)
{
    int code = 0;

    for (int i = 1; i < argc && !code; i++)
        code = measure(argv[i]);
    return code;
}
