/* SPDX-License-Identifier: MIT */
/* Angles, directions and rotations: sine and arc tangent by tables, lengths and unit
 * vectors, and rotations as three rows of unit vectors. */
#include "base/base.h"
#include "fixed/arithmetic.h"

/* -- sine, cosine, arc tangent ------------------------------------------------------- */

/* Sines by a quarter wave of 256 steps and linear interpolation: [G5] of the models, "1024
 * a turn".  The chord of a step lies below the sine by at most (pi/512)^2 / 8 = 4.7e-6.
 * Two symmetries are exact: sin(-a) = -sin(a), sin(half turn - a) = sin(a). */

static const tp_q30 quarter_wave[258] = {
#include "fixed/trig_table.inc"
};

static const tp_turn octant[130] = {
#include "fixed/atan_table.inc"
};

/* Bit 31 of the angle is the sign.  Bit 30 marks the quarters where the wave runs back to
 * 0: there the angle is negated, which modulo half a turn mirrors the angle into [0,
 * quarter].  The step takes 9 bits, to let the quarter itself read entry 256; the
 * fraction takes 22 bits. */
tp_q30 tp_sin(tp_turn angle)
{
    const uint32_t a = angle & 0x40000000 ? 0u - angle : angle;
    const tp_q30 *at = quarter_wave + (a >> 22 & 0x1ff);
    const uint32_t rise = (uint32_t)(at[1] - at[0]);
    const int32_t y = at[0] + (int32_t)((uint64_t)rise * (a << 10) >> 32);
    return (int32_t)angle < 0 ? -y : y;
}

tp_q30 tp_cos(tp_turn angle)
{
    return tp_sin(angle + 0x40000000u);
}

tp_fx tp_fx_sin(tp_turn angle)
{
    return (tp_sin(angle) + (1 << 13)) >> 14;
}

tp_fx tp_fx_cos(tp_turn angle)
{
    return (tp_cos(angle) + (1 << 13)) >> 14;
}

/* Returns the angle of a slope small/large <= 1, by a table of 128 steps.  The chord errs
 * by at most 0.65 / 128^2 / 8 / (2 pi) = 7.9e-7 turn. */
static tp_turn octant_angle(uint32_t small, uint32_t large)
{
    TP_ASSERT(small <= large && large > 0);
    const int shift = tp_clz(large);
    const uint32_t inverse = tp_recip_norm(large << shift);
    const uint32_t slope = (uint32_t)((uint64_t)(small << shift) * inverse >> 32);
    const tp_turn *at = octant + (slope >> 24);                 /* slope is Q1.31 */
    return at[0] + (uint32_t)((uint64_t)(at[1] - at[0]) * (slope << 8) >> 32);
}

static inline uint32_t magnitude(int32_t x)
{
    return x < 0 ? 0u - (uint32_t)x : (uint32_t)x;
}

tp_turn tp_atan2(int32_t y, int32_t x)
{
    const uint32_t rise = magnitude(y), run = magnitude(x);
    if ((rise | run) == 0)
        return 0;
    tp_turn angle = rise <= run ? octant_angle(rise, run)
                                : 0x40000000u - octant_angle(run, rise);
    if (x < 0)
        angle = 0x80000000u - angle;
    return y < 0 ? 0u - angle : angle;
}

/* A degree is 2^32 / 360 of a turn, an LSB of 16.16 is 2^16 / 360; the scale has 24
 * more bits.  Whole turns are removed first: the removal is exact, and the product
 * then fits 64 bits. */
tp_turn tp_turn_of_degrees(tp_fx degrees)
{
    const int64_t scale = 3054198966;           /* round(2^40 / 360) */
    const int32_t rest = degrees % (360 * TP_FX_ONE);
    return (tp_turn)(uint64_t)((rest * scale + (1 << 23)) >> 24);
}

/* -- directions and lengths ---------------------------------------------------------- */

/* Directions and lengths.  The squared length of a 16.16 vector overflows 32 bits
 * beyond 181 m [G3].  Squares are summed in 64 bits, and the sum is normalised by
 * its leading zeros. */

static uint64_t square(int32_t x)
{
    return (uint64_t)((int64_t)x * x);
}

static int32_t q30_round(int64_t q60)
{
    return (int32_t)((q60 + (1 << 29)) >> 30);
}

tp_q30 tp_dir3_dot(tp_dir3 a, tp_dir3 b)
{
    return q30_round((int64_t)a.x * b.x + (int64_t)a.y * b.y + (int64_t)a.z * b.z);
}

tp_dir3 tp_dir3_cross(tp_dir3 a, tp_dir3 b)
{
    return (tp_dir3){
        q30_round((int64_t)a.y * b.z - (int64_t)a.z * b.y),
        q30_round((int64_t)a.z * b.x - (int64_t)a.x * b.z),
        q30_round((int64_t)a.x * b.y - (int64_t)a.y * b.x),
    };
}

/* Rounds to nearest, like tp_fx_sqrt. */
tp_fx tp_vec3_length(tp_vec3 v)
{
    const uint64_t sum = square(v.x) + square(v.y) + square(v.z);   /* <= 3 2^62 */
    const uint32_t r = tp_isqrt64(sum);
    if (r >= (uint32_t)TP_FX_MAX)
        return TP_FX_MAX;
    return (tp_fx)(sum - (uint64_t)r * r > r ? r + 1 : r);
}

/* Returns x / length in Q2.30, rounded half up.  |x inverse| < 2^63.  The rounding cannot
 * overflow: an x at the end of its range makes the inverse small. */
static tp_q30 normalised_component(int32_t x, uint32_t inverse, int shift)
{
    TP_ASSERT(shift >= 2 && shift <= 33);
    return (tp_q30)(((int64_t)x * inverse + ((int64_t)1 << (shift - 1))) >> shift);
}

/* n = sum 2^(2 half) / 2^32 lies in [2^30, 2^32).  The inverse is 2^47 / sqrt(n), and
 * 2^30 x / sqrt(sum) = x inverse / 2^(33 - half).  half <= 31. */
tp_dir3 tp_normalise(int32_t x, int32_t y, int32_t z)
{
    const uint64_t sum = square(x) + square(y) + square(z);
    if (sum == 0)
        return (tp_dir3){ 0, TP_Q30_ONE, 0 };
    const uint32_t high = (uint32_t)(sum >> 32);
    const int half = (high != 0 ? tp_clz(high) : 32 + tp_clz((uint32_t)sum)) >> 1;
    const uint32_t inverse = tp_rsqrt_norm((uint32_t)(sum << 2 * half >> 32));
    return (tp_dir3){
        normalised_component(x, inverse, 33 - half),
        normalised_component(y, inverse, 33 - half),
        normalised_component(z, inverse, 33 - half),
    };
}

/* -- rotations ----------------------------------------------------------------------- */

/* Rotations, stored as three rows of unit vectors.
 *
 * A frame first looks along -z.  Its heading turns the frame about y, its pitch lifts
 * the frame about the frame's own right, its roll turns the frame about its own back
 * axis.  A rotation is built once a frame and moves every vertex: its sine has 27 good
 * bits where tp_sin has 17. */

typedef struct { tp_q30 sin, cos; } sine_cosine;

/* Starts from the nearest of the 1024 knots of the sine table, where tp_sin is exact.  d is
 * the distance to the knot in radians:
 *     sin(a + d) = sin a + d cos a - d^2/2 sin a
 * |d| <= pi/1024; the first omitted term is d^3/6 < 5e-9. */
static sine_cosine sine_pair(tp_turn angle)
{
    const tp_turn knot = (angle + (1u << 21)) & ~((1u << 22) - 1);
    const int32_t turns = (int32_t)(angle - knot);
    const tp_q30 d = (tp_q30)((turns * (int64_t)TP_Q30(1.5707963267948966)
                               + (1 << 29)) >> 30);     /* 2 pi 2^30 / 2^32 = pi/2 */
    const tp_q30 half_square = (tp_q30)(((int64_t)d * d + (1 << 30)) >> 31);
    const tp_q30 s = tp_sin(knot), c = tp_cos(knot);
    return (sine_cosine){
        s + tp_q30_mul(c, d) - tp_q30_mul(s, half_square),
        c - tp_q30_mul(s, d) - tp_q30_mul(c, half_square),
    };
}

/* Returns a s + b t, rounded half up once. */
static tp_dir3 blend(tp_dir3 a, tp_q30 s, tp_dir3 b, tp_q30 t)
{
    const int64_t half = 1 << 29;
    return (tp_dir3){
        (tp_q30)(((int64_t)a.x * s + (int64_t)b.x * t + half) >> 30),
        (tp_q30)(((int64_t)a.y * s + (int64_t)b.y * t + half) >> 30),
        (tp_q30)(((int64_t)a.z * s + (int64_t)b.z * t + half) >> 30),
    };
}

tp_rotation tp_rotation_from_angles(tp_turn heading, tp_turn pitch, tp_turn roll)
{
    const sine_cosine h = sine_pair(heading), p = sine_pair(pitch), r = sine_pair(roll);
    const tp_dir3 world_up = { 0, TP_Q30_ONE, 0 };
    const tp_dir3 level_right = { h.cos, 0, h.sin };
    const tp_dir3 level_back = { -h.sin, 0, h.cos };
    const tp_dir3 lifted_up = blend(world_up, p.cos, level_back, p.sin);
    return (tp_rotation){
        .x = blend(level_right, r.cos, lifted_up, -r.sin),
        .y = blend(lifted_up, r.cos, level_right, r.sin),
        .z = blend(level_back, p.cos, world_up, -p.sin),
    };
}

tp_vec3 tp_rotate(const tp_rotation *r, tp_vec3 v)
{
    return (tp_vec3){ tp_dot_dir(v, r->x), tp_dot_dir(v, r->y), tp_dot_dir(v, r->z) };
}

tp_vec3 tp_rotate_back(const tp_rotation *r, tp_vec3 v)
{
    return (tp_vec3){
        tp_dot_dir(v, (tp_dir3){ r->x.x, r->y.x, r->z.x }),
        tp_dot_dir(v, (tp_dir3){ r->x.y, r->y.y, r->z.y }),
        tp_dot_dir(v, (tp_dir3){ r->x.z, r->y.z, r->z.z }),
    };
}

/* A row of A B is the row of A times B: the transpose of B applied to the row of A. */
static tp_dir3 row_times(tp_dir3 row, const tp_rotation *b)
{
    const tp_vec3 v = tp_rotate_back(b, (tp_vec3){ row.x, row.y, row.z });
    return (tp_dir3){ v.x, v.y, v.z };
}

tp_rotation tp_rotation_mul(const tp_rotation *a, const tp_rotation *b)
{
    return (tp_rotation){ row_times(a->x, b), row_times(a->y, b), row_times(a->z, b) };
}
