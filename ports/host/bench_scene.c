/* SPDX-License-Identifier: MIT */
/* The parameters of scene S. */
#include "bench_scene.h"
#include <stdlib.h>
#include <string.h>
#include "say.h"

const char *const bench_work_name[BENCH_WORKS] = { "plain", "full", "smooth" };

/* -- textures -------------------------------------------------------------------- */

static size_t texture_word_count(uint32_t side)
{
    return tp_texture_bytes(side, side) / sizeof(uint32_t);
}

int bench_scene_open(bench_scene *s)
{
    static uint32_t texels[BENCH_MAP * BENCH_MAP];
    const size_t words = BENCH_MAPS * texture_word_count(BENCH_MAP)
                         + TP_FACES * texture_word_count(BENCH_FACE);
    tp_error err = { 0 };

    memset(s, 0, sizeof *s);
    s->memory = malloc(words * sizeof *s->memory);
    if (!s->memory)
        return log_fail_memory(words * sizeof *s->memory);
    uint32_t *free_words = s->memory;
    for (int i = 0; i < BENCH_MAPS; i++, free_words += texture_word_count(BENCH_MAP)) {
        bench_map_fill((bench_map)i, texels);
        if (tp_texture_init(&s->map[i], texels, BENCH_MAP, BENCH_MAP, free_words,
                            tp_texture_bytes(BENCH_MAP, BENCH_MAP), &err))
            return log_fail_error("bench", &err);
    }
    for (int i = 0; i < TP_FACES; i++, free_words += texture_word_count(BENCH_FACE)) {
        bench_face_fill(i, texels);
        if (tp_texture_init(&s->face[i], texels, BENCH_FACE, BENCH_FACE, free_words,
                            tp_texture_bytes(BENCH_FACE, BENCH_FACE), &err))
            return log_fail_error("bench", &err);
    }
    return EXIT_DONE;
}

void bench_scene_close(bench_scene *s)
{
    free(s->memory);
    s->memory = NULL;
}

/* -- the scene ------------------------------------------------------------------- */

static void set_sea(tp_scene *s, uint32_t points)
{
    s->grid.cols = s->grid.rows = (int32_t)points;
    s->grid.cell = (tp_fx)(20 * TP_FX_ONE / ((int32_t)points - 1));
    s->grid.reach = 0;
    s->grid.follow = 0;
    s->wave[0] = (tp_wave){ TP_FX(0.20), TP_FX(6), TP_FX(0.15), TP_FX(30), 0, TP_FX(1),
                            1 };
    s->wave[1] = (tp_wave){ TP_FX(0.12), TP_FX(3.5), TP_FX(0.15), TP_FX(75), 0, TP_FX(1),
                            1 };
    s->wave[2] = (tp_wave){ TP_FX(0.06), TP_FX(2), TP_FX(0.15), TP_FX(-20), 0, TP_FX(1),
                            1 };
}

/* Sets a sky of one colour, the clear colour of other renderers, and turns off every effect
 * of BENCH_FULL. */
static void set_plain(tp_scene *s)
{
    s->camera.y = TP_FX(3);
    s->camera.z = TP_FX(8.65);
    s->camera.pitch = TP_FX(-15.6);
    s->camera.fov = TP_FX(60);
    s->light.colour = 0xffffff;
    s->sky.horizon = s->sky.zenith = 0x90b4d0;
    s->sky.haze = 0;
    s->water.colour = 0xffffff;
    s->water.filter = TP_FILTER_NEAREST;
    s->water.specular = 0;
    s->water.reflection = 0;
    s->layer[0].map.size = TP_FX(2.5);
}

/* Sets all effects.  The exposure is 5/4: a value of 1 would cost nothing. */
static void set_full(tp_scene *s, bool smooth)
{
    s->sky.kind = TP_SKY_CUBE;
    s->hdr.value = TP_FX(1.25);
    s->light.heading = TP_FX(20);
    s->water.colour = 0x609098;
    s->water.filter = smooth ? TP_FILTER_LINEAR : TP_FILTER_NEAREST;
    s->water.specular = TP_FX(1);
    s->water.shininess = TP_FX(96);
    s->water.reflection = TP_FX(1);
    s->water.fresnel = TP_FRESNEL_SCHLICK;
    s->layer[1].map = (tp_scene_map){ .size = TP_FX(4), .drift_x = TP_FX(0.2) };
    s->layer[1].colour = 0x304048;
    s->layer[2].map = (tp_scene_map){ .size = TP_FX(7), .drift_z = TP_FX(0.15) };
    s->layer[2].colour = 0x304048;
    s->distortion.map = (tp_scene_map){ .size = TP_FX(5), .drift_x = TP_FX(-0.1) };
    s->distortion.strength = TP_FX(0.15);
    s->ripple.map = (tp_scene_map){ .size = TP_FX(3), .drift_x = TP_FX(0.12) };
    s->ripple.bump = TP_FX(0.6);
}

void bench_scene_set(bench_scene *s, bench_work work, uint32_t points)
{
    tp_scene_level(&s->scene);
    s->assets = (tp_assets){ .layer[0] = &s->map[BENCH_MOTTLE] };
    set_sea(&s->scene, points);
    set_plain(&s->scene);
    if (work == BENCH_PLAIN)
        return;
    set_full(&s->scene, work == BENCH_SMOOTH);
    s->assets.layer[1] = &s->map[BENCH_CRESTS];
    s->assets.layer[2] = &s->map[BENCH_DRIFT];
    s->assets.distortion = &s->map[BENCH_BEND];
    s->assets.ripple = &s->map[BENCH_RIPPLE];
    for (int i = 0; i < TP_FACES; i++)
        s->assets.sky[i] = &s->face[i];
}
