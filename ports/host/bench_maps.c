/* SPDX-License-Identifier: MIT */
/* Textures of the benchmark's scene: sums of sines, which tile without a seam. */
#include "bench_maps.h"
#include "fx/fx.h"
#include <stdbool.h>

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

void bench_map_fill(bench_map map, uint32_t *texels)
{
    for (uint32_t i = 0; i < BENCH_MAP * BENCH_MAP; i++)
        texels[i] = sample_map(map, i % BENCH_MAP, i / BENCH_MAP);
}

/* -- a sky ----------------------------------------------------------------------- */

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

void bench_face_fill(int face, uint32_t *texels)
{
    for (int32_t i = 0; i < BENCH_FACE * BENCH_FACE; i++) {
        const int32_t right = 2 * (i % BENCH_FACE) + 1 - BENCH_FACE;
        const int32_t down = 2 * (i / BENCH_FACE) + 1 - BENCH_FACE;
        texels[i] = sample_sky(cube_direction(face, right, down));
    }
}
