/* SPDX-License-Identifier: MIT */
/* The textures and the parameters of scene S.  The textures are sums of sines, which tile
 * without a seam. */
#include "bench_scene.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "fixed/arithmetic.h"

/* -- textures ------------------------------------------------------------------------ */

/* Fills texels of maps and of the faces of the cube. */

enum { SINES = 6 };

/* Sines over one repeat: number of periods along s and t, and the phase. */
static const struct {
    int8_t  s, t;
    uint8_t begin;              /* phase, 1/256 turn */
} sines[BENCH_MAPS][SINES] = {
    [BENCH_CRESTS] = { { 3, 1, 0 }, { -2, 4, 80 }, { 5, 3, 160 },
                       { -6, 2, 33 }, { 1, 7, 201 }, { 8, -5, 120 } },
    [BENCH_DRIFT]  = { { 2, 3, 17 }, { -4, 1, 97 }, { 3, -5, 180 },
                       { 6, 4, 61 }, { -1, 8, 140 }, { 7, 7, 230 } },
    [BENCH_BEND]   = { { 1, 2, 40 }, { -2, 1, 140 }, { 3, 2, 220 },
                       { -1, 3, 5 }, { 4, -1, 66 }, { 2, -4, 190 } },
    [BENCH_RIPPLE] = { { 4, 2, 70 }, { -3, 6, 11 }, { 7, -2, 150 },
                       { 2, 9, 90 }, { -8, 5, 240 }, { 10, 3, 190 } },
};

static tp_turn sine_phase(bench_map map, int k, uint32_t x, uint32_t y)
{
    const int32_t turns = sines[map][k].s * (int32_t)x + sines[map][k].t * (int32_t)y;
    return ((uint32_t)turns + sines[map][k].begin) << 24;
}

/* Height: sum of the sines, -1..1 in 1/256.  sample_slope: derivative of the sum along s or
 * t. */
static int32_t sample_height(bench_map map, uint32_t x, uint32_t y)
{
    int32_t sum = 0;
    for (int k = 0; k < SINES; k++)
        sum += tp_sin(sine_phase(map, k, x, y)) >> 16;
    return sum / (SINES * 64);
}

static int32_t sample_slope(bench_map map, uint32_t x, uint32_t y, bool along_t)
{
    int32_t sum = 0;
    for (int k = 0; k < SINES; k++) {
        const int32_t periods = along_t ? sines[map][k].t : sines[map][k].s;
        sum += periods * (tp_cos(sine_phase(map, k, x, y)) >> 20);
    }
    return sum / (SINES * 16);
}

static uint32_t pack_colour(int32_t r, int32_t g, int32_t b)
{
    return 0xff000000u | (uint32_t)tp_clamp(r, 0, 255) << 16
         | (uint32_t)tp_clamp(g, 0, 255) << 8 | (uint32_t)tp_clamp(b, 0, 255);
}

/* Returns mottled blues with a grid of darker lines. */
static uint32_t sample_mottle(uint32_t x, uint32_t y)
{
    const int32_t noise = (int32_t)((x * 2654435761u ^ y * 2246822519u) * 3266489917u
                                    >> 28);
    const int32_t line = x % 32 == 0 || y % 32 == 0 ? 48 : 0;
    return pack_colour(70 - line + noise, 140 - line + noise, 190 - line + noise);
}

static uint32_t sample_map(bench_map map, uint32_t x, uint32_t y)
{
    if (map == BENCH_MOTTLE)
        return sample_mottle(x, y);
    if (map == BENCH_BEND)
        return pack_colour(128 + sample_height(map, x, y),
                           128 + sample_height(map, y, x + 77), 0);
    if (map == BENCH_RIPPLE)
        return pack_colour(128 - sample_slope(map, x, y, false) / 4,
                           128 + sample_slope(map, x, y, true) / 4, 240);
    const int32_t grey = 64 + sample_height(map, x, y);
    return pack_colour(grey, grey, grey);
}

static void bench_map_fill(bench_map map, uint32_t *texels)
{
    for (uint32_t i = 0; i < BENCH_MAP * BENCH_MAP; i++)
        texels[i] = sample_map(map, i % BENCH_MAP, i / BENCH_MAP);
}

/* -- a sky --------------------------------------------------------------------------- */

/* Returns the direction through a point of a cube's face; right, down: -128..128 in units
 * of 1/128 of half the face. */
static tp_dir3 cube_direction(int face, int32_t right, int32_t down)
{
    const int32_t one = BENCH_FACE;
    switch (face) {
    case 0:  return tp_normalise(one, -down, right);
    case 1:  return tp_normalise(-one, -down, -right);
    case 2:  return tp_normalise(-right, one, down);
    case 3:  return tp_normalise(-right, -one, -down);
    case 4:  return tp_normalise(-right, -down, one);
    default: return tp_normalise(right, -down, -one);
    }
}

/* Returns a colour of sky: whiter towards the horizon, with clouds from sines of the
 * direction. */
static uint32_t sample_sky(tp_dir3 d)
{
    const int32_t x = d.x >> 14, y = d.y >> 14, z = d.z >> 14;      /* Q16 */
    const int32_t up = y > 0 ? y >> 8 : 0;                          /* 0..256 */
    const int32_t cloud = (tp_sin((tp_turn)(x * 9 + y * 31) << 14) >> 24)
                        + (tp_sin((tp_turn)(z * 11 - y * 23 + x * 5) << 14) >> 24);
    const int32_t white = cloud > 0 ? cloud / 2 : 0;
    return pack_colour(206 - (up * 140 >> 8) + white, 220 - (up * 100 >> 8) + white,
                       234 - (up * 60 >> 8) + white / 2);
}

/* Fill texels 0xffRRGGBB, row-major: BENCH_MAP^2 of a map, BENCH_FACE^2 of face 0..5 of a
 * cube. */
static void bench_face_fill(int face, uint32_t *texels)
{
    for (int32_t i = 0; i < BENCH_FACE * BENCH_FACE; i++) {
        const int32_t right = 2 * (i % BENCH_FACE) + 1 - BENCH_FACE;
        const int32_t down = 2 * (i / BENCH_FACE) + 1 - BENCH_FACE;
        texels[i] = sample_sky(cube_direction(face, right, down));
    }
}

/* -- parameters ---------------------------------------------------------------------- */

/* Makes the textures once, and sets the parameters of a work. */

const char *const bench_work_name[BENCH_WORKS] = { "plain", "full", "smooth" };

/* -- textures ------------------------------------------------------------------------ */

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

/* -- the scene ----------------------------------------------------------------------- */

static void set_sea(tp_scene *s, uint32_t points)
{
    s->grid.vertices = (int32_t)(points * points / 3);
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
    s->hdr.exposure_factor = TP_FX(1.25);
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
