/* SPDX-License-Identifier: MIT */
/* Unit normals (-sx, 1, -sz) / sqrt(1 + sx^2 + sz^2) of slopes within 1, Q3.12, the format
 * of the engine's stages: to the last bit, by a table of roots with and without Newton's
 * steps, by the first terms of the series, and as plain slopes.
 *
 * Results are Q2.30 or coarser; errors_normalise.c lists the formats. */
#include "tests/charts/kernels.h"
#include "shade/material.h"
#include "shade/slope.h"

enum { ONE = 4096 };

#define METHOD static __attribute__((noinline)) tp_dir3
#define RUN(method) \
    static void run_##method(const int32_t *in, int32_t *out) \
    { \
        for (uint32_t i = 0; i < KERNEL_UNITS; i++) { \
            const tp_dir3 n = method(in[2 * i], in[2 * i + 1]); \
            out[3 * i] = n.x; \
            out[3 * i + 1] = n.y; \
            out[3 * i + 2] = n.z; \
        } \
    }

static uint16_t table[64];          /* 1 / sqrt by the top 6 bits, Q0.16 of Q1.31 */

static void fill(int32_t *in)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++) {
        in[2 * i] = kernel_spread(i, KERNEL_STEP, ONE);
        in[2 * i + 1] = kernel_spread(i, KERNEL_CROSS, ONE);
    }
    for (uint32_t i = 16; i < 64; i++)
        table[i] = (uint16_t)tp_isqrt64(((uint64_t)1 << 62) / ((2 * i + 1) << 25));
}

static void fill_packed(int32_t *in)
{
    fill(in);
    for (uint32_t i = 0; i < 2 * KERNEL_UNITS; i += 2)
        in[i] = (int32_t)tp_dir_pack(tp_normalise(-in[i], ONE, -in[i + 1]));
}

static inline uint32_t high(uint32_t a, uint32_t b)
{
    return (uint32_t)((uint64_t)a * b >> 32);
}

/* -- the engine's functions ---------------------------------------------------------- */

METHOD whole(int32_t sx, int32_t sz) { return tp_normalise(-sx, ONE, -sz); }
RUN(whole)

METHOD short_of_whole(int32_t sx, int32_t sz)
{
    const tp_vec_q14 n = tp_vec_q14_unit(-sx, ONE, -sz);
    return (tp_dir3){ n.x, n.y, n.z };
}
RUN(short_of_whole)

METHOD steep(int32_t sx, int32_t sz)
{
    const tp_ray n = tp_slope_normal(sx, sz);
    return (tp_dir3){ n.x, n.y, n.z };
}
RUN(steep)

METHOD steep_near(int32_t sx, int32_t sz)
{
    const int32_t ny = tp_rsqrt_one_plus_nearest(tp_slope_square(sx, sz));
    return (tp_dir3){ -(sx * ny >> 12), ny, -(sz * ny >> 12) };
}
RUN(steep_near)

/* Unpacks a normal from one word with ten bits for each part, the format of meshes; as
 * stored, and normalised. */
METHOD packed(int32_t word, int32_t unused)
{
    const tp_packed_dir n = (tp_packed_dir)word;
    (void)unused;
    return (tp_dir3){ tp_dir_x(n), tp_dir_y(n), tp_dir_z(n) };
}
RUN(packed)

METHOD packed_unit(int32_t word, int32_t unused)
{
    const tp_packed_dir p = (tp_packed_dir)word;
    const tp_vec_q14 n = tp_vec_q14_unit(tp_dir_x(p), tp_dir_y(p), tp_dir_z(p));
    (void)unused;
    return (tp_dir3){ n.x, n.y, n.z };
}
RUN(packed_unit)

METHOD packed_32(int32_t word, int32_t unused)
{
    const tp_vec_q14 n = tp_vec_q14_unpack((tp_packed_dir)word);
    (void)unused;
    return (tp_dir3){ n.x, n.y, n.z };
}
RUN(packed_32)

/* -- the sum in 32 bits -------------------------------------------------------------- */

/* Slopes below 1.2 each keep 1 + sx^2 + sz^2 below 4: as Q26 the sum is between 2^26 and
 * 2^28, and 64 times the sum is in the range of tp_rsqrt_norm, without leading zeros to
 * count. */
static inline uint32_t normal_sum(int32_t sx, int32_t sz)
{
    return ((1u << 24) + tp_slope_square(sx, sz)) << 6;
}

/* Normal from its height, Q2.30, with the sign of the height reversed: negative products
 * keep compilers from unsigned multiplication. */
static inline tp_dir3 by_height(int32_t sx, int32_t sz, int32_t minus)
{
    return (tp_dir3){ (int32_t)((int64_t)sx * minus >> 12), -minus,
                      (int32_t)((int64_t)sz * minus >> 12) };
}

/* Normal from 1 / sqrt of the sum, Q1.31 of twice the height. */
static inline tp_dir3 by_root(int32_t sx, int32_t sz, uint32_t r)
{
    return by_height(sx, sz, -(int32_t)(r >> 2));
}

METHOD sum_32(int32_t sx, int32_t sz)
{
    return by_root(sx, sz, tp_rsqrt_norm(normal_sum(sx, sz)));
}
RUN(sum_32)

static const uint16_t lines[193] = {
#include "fixed/rsqrt_table.inc"
};

/* tp_rsqrt_norm without Newton's step. */
METHOD sum_lines(int32_t sx, int32_t sz)
{
    const uint32_t n = normal_sum(sx, sz);
    const uint16_t *at = lines + ((n >> 24) - 64);
    const int32_t rise = at[1] - at[0];
    return by_root(sx, sz, ((0x10000u + at[0]) << 15)
                           + (uint32_t)(rise * (int32_t)(n >> 8 & 0xffff) >> 1));
}
RUN(sum_lines)

/* Nearest of 48 entries, then Newton's steps r (3 - n r^2) / 2, r in Q2.30. */
static inline tp_dir3 by_table(int32_t sx, int32_t sz, int steps)
{
    const uint32_t n = normal_sum(sx, sz);
    uint32_t r = (uint32_t)table[n >> 26] << 15;
    for (int i = 0; i < steps; i++)
        r = (uint32_t)((uint64_t)r * ((3u << 28) - high(n, high(r, r))) >> 29);
    return by_height(sx, sz, -(int32_t)(r >> 1));
}

METHOD newton_0(int32_t sx, int32_t sz) { return by_table(sx, sz, 0); }
METHOD newton_1(int32_t sx, int32_t sz) { return by_table(sx, sz, 1); }
METHOD newton_2(int32_t sx, int32_t sz) { return by_table(sx, sz, 2); }
RUN(newton_0)
RUN(newton_1)
RUN(newton_2)

/* -- without a root ------------------------------------------------------------------ */

/* 1 - q/2, and 1 - q/2 + 3 q^2 / 8, in Q2.30 from q in Q24. */
METHOD series_1(int32_t sx, int32_t sz)
{
    const int32_t ny = TP_Q30_ONE - (int32_t)(tp_slope_square(sx, sz) << 5);
    return (tp_dir3){ -(int32_t)((int64_t)sx * ny >> 12), ny,
                      -(int32_t)((int64_t)sz * ny >> 12) };
}
RUN(series_1)

METHOD series_2(int32_t sx, int32_t sz)
{
    const uint32_t half = tp_slope_square(sx, sz) << 5;
    const int32_t ny = TP_Q30_ONE - (int32_t)(half - (high(half, half) * 6));
    return (tp_dir3){ -(int32_t)((int64_t)sx * ny >> 12), ny,
                      -(int32_t)((int64_t)sz * ny >> 12) };
}
RUN(series_2)

METHOD slopes(int32_t sx, int32_t sz) { return (tp_dir3){ -sx, ONE, -sz }; }
RUN(slopes)

/* -- list of kernels ----------------------------------------------------------------- */

#define ROW(name, method, bytes) { "normalise", name, fill, run_##method, 2, 3, bytes }
#define PACKED(name, method, bytes) \
    { "normalise", name, fill_packed, run_##method, 2, 3, bytes }
const kernel kernels_normalise[] = {
    ROW("tp_normalise", whole, 386),
    ROW("unit-14", short_of_whole, 386),
    ROW("steep", steep, 1026),
    ROW("steep-near", steep_near, 1026),
    PACKED("packed", packed, 0),
    PACKED("packed-unit", packed_unit, 386),
    PACKED("packed-32", packed_32, 386),
    ROW("sum-32", sum_32, 386),
    ROW("lines", sum_lines, 386),
    ROW("newton-0", newton_0, 96),
    ROW("newton-1", newton_1, 96),
    ROW("newton-2", newton_2, 96),
    ROW("series-1", series_1, 0),
    ROW("series-2", series_2, 0),
    ROW("slopes", slopes, 0),
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
