/* SPDX-License-Identifier: MIT */
/* Methods for the water's normal, as slopes dy/dx and dy/dz:
 *     exact   from the sum of waves, with the cross terms of [A10]
 *     cheap   without cross terms
 *     five-N  from the heights N cells of 0.25 m to the four sides [A6]
 *     map-N   from a normal map with N bits in each of three channels, made from the exact
 *             normals: unpacking and a division */
#include "base/base.h"
#include "tests/charts/normals.h"
#include "waves/deep_water.h"

#define WAVE(amplitude, length, heading, phase) \
    { TP_FX(amplitude), TP_FX(length), TP_FX(0.7) / 3, TP_FX(heading), TP_FX(phase), \
      TP_FX_ONE, 1 }

const tp_wave normals_wave[NORMALS_WAVES] = {
    WAVE(0.45, 22, 70, 0), WAVE(0.30, 13, 115, 140), WAVE(0.15, 7, 20, 250),
};

/* -- the water, evaluated once ------------------------------------------------------- */

enum { STEPS = 4 };             /* of 1, 2, 4 and 8 cells */

static tp_deep_water  deep;
static tp_turn phases[TP_WAVES];
static tp_fx   rest[KERNEL_UNITS][2], around[KERNEL_UNITS][STEPS][4];
static bool    known;

static tp_fx height(tp_fx x, tp_fx z)
{
    return tp_deep_water_sample(&deep, phases, x, z, NULL).position.y;
}

static void look_up(uint32_t i)
{
    const tp_fx x = normals_x(i), z = normals_z(i);

    rest[i][0] = x;
    rest[i][1] = z;
    tp_deep_water_sample(&deep, phases, x, z, rest[i]);
    for (int n = 0; n < STEPS; n++) {
        const tp_fx far = NORMALS_CELL << n;
        around[i][n][0] = height(x - far, z);
        around[i][n][1] = height(x + far, z);
        around[i][n][2] = height(x, z - far);
        around[i][n][3] = height(x, z + far);
    }
}

static void prepare(bool crossed)
{
    if (!known) {
        tp_deep_water_init(&deep, normals_wave, NORMALS_WAVES, NORMALS_GRAVITY);
        tp_deep_water_phases(&deep, NORMALS_TICK, 0, phases);
        for (uint32_t i = 0; i < KERNEL_UNITS; i++)
            look_up(i);
        known = true;
    }
    deep.crossed = crossed;
}

/* -- from the waves ------------------------------------------------------------------ */

static void fill_rest(int32_t *in)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++) {
        in[2 * i] = rest[i][0];
        in[2 * i + 1] = rest[i][1];
    }
}

static void fill_exact(int32_t *in)
{
    prepare(true);
    fill_rest(in);
}

static void fill_cheap(int32_t *in)
{
    prepare(false);
    fill_rest(in);
}

static void run_waves(const int32_t *in, int32_t *out)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++, in += 2, out += 2) {
        const tp_surface_point at =
            tp_deep_water_displace_point(&deep, phases, in[0], in[1]);
        out[0] = at.slope_x;
        out[1] = at.slope_z;
    }
}

/* -- from five heights --------------------------------------------------------------- */

static void fill_heights(int32_t *in, int n)
{
    prepare(true);
    for (uint32_t i = 0; i < KERNEL_UNITS; i++)
        for (int k = 0; k < 4; k++)
            *in++ = around[i][n][k];
}

TP_ALWAYS_INLINE void five(const int32_t *in, int32_t *out, tp_fx spacing)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++, in += 4, out += 2) {
        const tp_height_slope at = tp_neighbour_height_slope(0, in, spacing);
        out[0] = at.slope_x;
        out[1] = at.slope_z;
    }
}

#define FIVE(cells, n) \
    static void fill_five_##cells(int32_t *in) { fill_heights(in, n); } \
    static void run_five_##cells(const int32_t *in, int32_t *out) \
    { five(in, out, NORMALS_CELL << n); }
FIVE(1, 0)
FIVE(2, 1)
FIVE(4, 2)
FIVE(8, 3)

/* -- from a map ---------------------------------------------------------------------- */

/* Channels are relative to the middle value, half = 2^(bits - 1). Up to 8 bits all three
 * channels fit one word; with more bits z has a word of its own. */
static int32_t channel(tp_q30 n, int bits)
{
    const int64_t most = (1 << (bits - 1)) - 1, half = (int64_t)1 << 29;
    return (int32_t)((n * most + half) >> 30) + (1 << (bits - 1));
}

static void fill_map(int32_t *in, int bits)
{
    prepare(true);
    for (uint32_t i = 0; i < KERNEL_UNITS; i++, in += 2) {
        const tp_surface_point at =
            tp_deep_water_displace_point(&deep, phases, rest[i][0], rest[i][1]);
        const tp_dir3 n = tp_normalise(-at.slope_x, TP_FX_ONE, -at.slope_z);
        const uint32_t x = (uint32_t)channel(n.x, bits), z = (uint32_t)channel(n.z, bits);
        const uint32_t y = (uint32_t)channel(n.y, bits);
        in[0] = (int32_t)(bits > 8 ? x << bits | y : x << 2 * bits | y << bits | z);
        in[1] = (int32_t)(bits > 8 ? z : 0);
    }
}

/* Reciprocal 2^31 / up: a channel times the reciprocal is below 2^16, as Q.31 below
 * 2^47. */
TP_ALWAYS_INLINE void map(const int32_t *in, int32_t *out, int bits)
{
    const uint32_t mask = (1u << bits) - 1;
    const int32_t  half = 1 << (bits - 1);

    for (uint32_t i = 0; i < KERNEL_UNITS; i++, in += 2, out += 2) {
        const uint32_t word = (uint32_t)in[0], low = bits > 8 ? (uint32_t)in[1] : word;
        const int32_t  x = (int32_t)(word >> (bits > 8 ? bits : 2 * bits) & mask) - half;
        const int32_t  y = (int32_t)((bits > 8 ? word : word >> bits) & mask) - half;
        const int32_t  z = (int32_t)(low & mask) - half;
        const int64_t  over = 0x80000000u / (uint32_t)(y > 0 ? y : 1);
        out[0] = (int32_t)(-x * over >> 15);
        out[1] = (int32_t)(-z * over >> 15);
    }
}

#define MAP(bits) \
    static void fill_map_##bits(int32_t *in) { fill_map(in, bits); } \
    static void run_map_##bits(const int32_t *in, int32_t *out) { map(in, out, bits); }
MAP(4)
MAP(5)
MAP(6)
MAP(7)
MAP(8)
MAP(16)

/* Last number: bytes of a place, a height in 16.16 or a texel. */
#define FIVE_ROW(cells) \
    { "normals", "five-" #cells, fill_five_##cells, run_five_##cells, 4, 2, 4 }
#define MAP_ROW(bits) \
    { "normals", "map-" #bits, fill_map_##bits, run_map_##bits, 2, 2, (3 * bits + 7) / 8 }

const kernel kernels_normals[] = {
    { "normals", "exact", fill_exact, run_waves, 2, 2, 0 },
    { "normals", "cheap", fill_cheap, run_waves, 2, 2, 0 },
    FIVE_ROW(1), FIVE_ROW(2), FIVE_ROW(4), FIVE_ROW(8),
    MAP_ROW(4), MAP_ROW(5), MAP_ROW(6), MAP_ROW(7), MAP_ROW(8), MAP_ROW(16),
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
