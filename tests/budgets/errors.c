/* SPDX-License-Identifier: MIT */
/* Measures the error of each rung: shipped scenes at 160x120 and 320x240, against the
 * reference picture (tests/lib/quality_error.h).
 *
 *     errors SCENE.ini...
 *
 * Prints lines: error RUNG CLASS PX COLOUR SCENE TICK, the error that the rung adds to the
 * exact rung's error; "exact ..." with the exact rungs' errors; and
 *     slope COLOUR SCENE: rms of the picture that a small added wave causes, per slope */
#include <stdio.h>
#include "world/module.h"
#include "quality/prices.h"
#include "tests/lib/quality_error.h"

#define SMALL_SLOPE  0.02       /* k A, the slope */
#define SMALL_LENGTH 4          /* wavelength, m */

static const char *const rungs[TP_KINDS][TP_KIND_RUNGS] = {
    { "triangles", "rows", "projected", "flat" }, { "exact", "quick" },
    { "full", "layers", "colour" },
};

static const char *const classes[] = {
    "level", "level_glossy", "level_sparks", "gentle", "gentle_glossy", "gentle_sparks",
    "steep", "steep_glossy", "steep_sparks",
    "coastal", "coastal_glossy", "coastal_sparks",
};

static const uint8_t counts[TP_KINDS] = { TP_VISIBILITIES, TP_SHADINGS, TP_RATES };

typedef struct {
    uint8_t of[TP_KINDS];
} rung_choice;

static tp_scene scene_by(const loaded_scene *s, rung_choice c)
{
    tp_scene scene = s->file.scene;

    scene.quality.visibility = c.of[TP_KIND_VISIBILITY] + 1;
    scene.quality.shading = c.of[TP_KIND_SHADING] + 1;
    scene.quality.rate = c.of[TP_KIND_RATE] + 1;
    scene.quality.error_px = scene.quality.error_colour = 0;
    return scene;
}

typedef struct {
    truth_drawing    truth[2];        /* reference of renderers; reference of shading */
    error      exact[2];        /* errors of the exact rungs */
    tp_view_estimate estimate;
    uint32_t   tick;
} error_ground;

/* Rounds an error up to two decimals, as the plan prints it: the error of three rungs
 * together was measured up to 0.01 above the sum of their errors. */
static double rounded_up(double x)
{
    return x > 0 ? ceil(x * 100 + 0.1) / 100 : 0;
}

static void say(const loaded_scene *s, const error_ground *g, const char *rung, error e)
{
    printf("error %s %s %.4f %.4f %s %u\n", rung, classes[g->estimate.sea],
           rounded_up(e.px), rounded_up(e.colour), s->file.name, (unsigned)g->tick);
}

/* Compares all rungs of a kind, with the other kinds as in `base`. The printed error is
 * the part beyond the error of the kind's first rung, or of the exact rungs if that is
 * greater. */
static void compare(const loaded_scene *s, const error_ground *g, rung_choice base,
                    int kind)
{
    static truth_drawing other;
    const bool shaded = kind == TP_KIND_SHADING || kind == TP_KIND_RATE;
    error first = { 0, 0 };

    for (uint8_t i = 0; i < counts[kind]; i++) {
        if (kind == TP_KIND_VISIBILITY && !g->estimate.fits[i])
            continue;
        if (kind == TP_KIND_SHADING && i > 0 && !g->estimate.quick)
            continue;
        base.of[kind] = i;
        const tp_scene scene = scene_by(s, base);
        draw(&other, s, &scene, s->world);
        const error e = error_of(&g->truth[shaded], &other);
        first = i ? first : worse(e, g->exact[shaded]);
        say(s, g, rungs[kind][i], beyond(e, first));
    }
}

/* Compares shadings with each renderer, and shading rates with each shading and renderer:
 * the error of a rung may depend on the other rungs. */
static void compare_all(const loaded_scene *s, uint32_t tick)
{
    static truth_drawing exact;
    static error_ground  g;
    const tp_scene scene = exact_scene(s);
    rung_choice base = { { 0, 0, 0 } };

    const tp_plan_input in = { tp_program_all.modules, &s->file.scene, &s->assets.names,
                               width, height };
    g.estimate = tp_view_estimate_make(&in);
    g.tick = tick;
    draw(&exact, s, &scene, s->world);
    for (uint32_t i = 0; i < 2; i++) {
        draw_truth(&g.truth[i], s, s->world, i + 1);
        g.exact[i] = error_of(&g.truth[i], &exact);
        printf("exact %.4f %.4f %s %u\n", g.exact[i].px, g.exact[i].colour, s->file.name,
               (unsigned)tick);
    }
    compare(s, &g, base, TP_KIND_VISIBILITY);
    for (uint8_t v = 0; v < counts[TP_KIND_VISIBILITY]; v++) {
        if (!g.estimate.fits[v])
            continue;
        base.of[TP_KIND_VISIBILITY] = v;
        base.of[TP_KIND_SHADING] = 0;
        base.of[TP_KIND_RATE] = 0;
        compare(s, &g, base, TP_KIND_SHADING);
        for (uint8_t i = 0; i < (g.estimate.quick ? TP_SHADINGS : 1); i++) {
            base.of[TP_KIND_SHADING] = i;
            compare(s, &g, base, TP_KIND_RATE);
        }
    }
}

/* Adds a small wave to a scene with plain waves; the wave's phase does not matter. */
static void lay_a_wave(loaded_scene *s)
{
    static truth_drawing without, more;
    tp_wave  *last = &s->file.scene.wave[TP_WAVES - 1];

    if (last->amplitude > 0 || tp_world_coastal(s->world))
        return;
    tp_scene scene = scene_by(s, (rung_choice){ { 0, 0, 0 } });
    draw(&without, s, &scene, s->world);
    *last = (tp_wave){ .length = SMALL_LENGTH * TP_FX_ONE, .heading = 70 * TP_FX_ONE,
                       .exponent = 1 };
    last->amplitude = (tp_fx)lround(SMALL_SLOPE * SMALL_LENGTH / 6.2831853 * 65536);
    if (loaded_scene_make_world(s))
        exit(1);
    scene = scene_by(s, (rung_choice){ { 0, 0, 0 } });
    draw(&more, s, &scene, s->world);
    printf("slope %.4f %s\n",
           error_of(&without, &more).colour / (SMALL_SLOPE * sqrt(0.5)),
           s->file.name);
}

static int measure(const char *path)
{
    options o = { .command = "errors", .scene = path, .width = width, .height = height };
    loaded_scene s;
    int code = loaded_scene_open(&s, &o);

    if (!code) {
        for (uint32_t tick = 0; tick <= LAST; tick++) {
            if (is_looked_at(tick))
                compare_all(&s, tick);
            tp_world_step(&tp_program_all, s.world, &s.file.scene, NULL);
        }
        if (!loaded_scene_make_world(&s))
            lay_a_wave(&s);
    }
    loaded_scene_close(&s);
    return code;
}

int main(int argc, char **argv)
{
    int code = 0;

    for (uint32_t size = 1; size <= 2 && !code; size++) {
        width = 160 * size;
        height = 120 * size;
        for (int i = 1; i < argc && !code; i++)
            code = measure(argv[i]);
    }
    return code;
}
