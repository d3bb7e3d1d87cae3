/* SPDX-License-Identifier: MIT */
/* The rest of the core's arithmetic: saturation, roots, reciprocals, text. */
#ifndef TP_FX_FX_H
#define TP_FX_FX_H
#include "tidepool/fixed.h"

/* a b / 2^30, rounded half up: a number of any format times a Q2.30 of magnitude
 * <= 1 keeps its format; the caller keeps |a b| below 2^61. */
static inline int32_t tp_q30_mul(int32_t a, tp_q30 b)
{
    return (int32_t)(((int64_t)a * b + (1 << 29)) >> 30);
}

static inline int32_t tp_clamp(int32_t x, int32_t low, int32_t high)
{
    return x < low ? low : x > high ? high : x;
}

static inline int32_t tp_abs(int32_t x) { return x < 0 ? -x : x; }  /* x > INT32_MIN */

/* x held within +-most, most >= 0; and into 16.16: saturates. */
static inline int64_t tp_limit(int64_t x, int64_t most)
{
    return x > most ? most : x < -most ? -most : x;
}

static inline tp_fx tp_fx_held(int64_t x)
{
    return x > TP_FX_MAX ? TP_FX_MAX : x < TP_FX_MIN ? TP_FX_MIN : (tp_fx)x;
}

/* a + b and a - b, saturating, in 32 bits. */
static inline tp_fx tp_fx_plus(tp_fx a, tp_fx b)
{
#if defined(__GNUC__)
    tp_fx sum;
    if (__builtin_expect(__builtin_add_overflow(a, b, &sum), 0))
        return a < 0 ? TP_FX_MIN : TP_FX_MAX;
    return sum;
#else
    return tp_fx_held((int64_t)a + b);
#endif
}

static inline tp_fx tp_fx_minus(tp_fx a, tp_fx b)
{
#if defined(__GNUC__)
    tp_fx left;
    if (__builtin_expect(__builtin_sub_overflow(a, b, &left), 0))
        return a < 0 ? TP_FX_MIN : TP_FX_MAX;
    return left;
#else
    return tp_fx_held((int64_t)a - b);
#endif
}

/* n / d, halves away from 0, so that there and back is nothing; d > 0, and |n| + d / 2
 * fits. */
static inline int64_t tp_quotient(int64_t n, int64_t d)
{
    return (n < 0 ? n - d / 2 : n + d / 2) / d;
}

/* x^2 (3 - 2x) of x held in 0..1. */
static inline tp_fx tp_smoothstep(tp_fx x)
{
    x = tp_clamp(x, 0, TP_FX_ONE);
    return tp_fx_mul(tp_fx_mul(x, x), 3 * TP_FX_ONE - 2 * x);
}

/* Leading zeros of x != 0. */
static inline int tp_clz(uint32_t x)
{
#if defined(__GNUC__)
    return __builtin_clz(x);
#else
    int n = 0;
    for (; !(x & 0x80000000u); x <<= 1)
        n++;
    return n;
#endif
}

tp_fx  tp_fx_div(tp_fx a, tp_fx b);     /* rounded half up; saturates; x/0 by sign of x */
tp_fx  tp_fx_sqrt(tp_fx x);             /* nearest; 0 for x <= 0 */
tp_fx  tp_fx_rsqrt(tp_fx x);            /* 1/sqrt(x) within 1 LSB; saturates for x <= 0 */
tp_fx  tp_fx_recip(tp_fx x);            /* 1/x rounded half up; saturates; 0: max */
uint32_t tp_isqrt64(uint64_t x);        /* floor of the root, exact */

/* The hot path's reciprocal: for n in [2^31, 2^32) returns 2^63/n in [2^31, 2^32],
 * the latter as 2^32-1; relative error below 2^-29.  No division. */
uint32_t tp_recip_norm(uint32_t n);

/* The hot path's reciprocal root: for n in [2^30, 2^32) (that is x in [1/4, 1) as
 * Q0.32) returns 1/sqrt(x) in Q1.31, [2^31, 2^32-1]; relative error below 2^-28. */
uint32_t tp_rsqrt_norm(uint32_t n);

/* Sine and cosine of an angle, Q2.30, by a quarter-wave table and interpolation;
 * error below 5e-6, so within 1 LSB of 16.16 after rounding ([G5], 1024 a turn). */
tp_q30 tp_sin(tp_turn angle);
tp_q30 tp_cos(tp_turn angle);

/* What lies on a surface at a place: its height and dy/dx, dy/dz, all 16.16. */
typedef struct { tp_fx height, slope_x, slope_z; } tp_relief;

static inline tp_vec3 tp_vec3_add(tp_vec3 a, tp_vec3 b)
{
    const tp_vec3 sum = { a.x + b.x, a.y + b.y, a.z + b.z };
    return sum;
}

static inline tp_vec3 tp_vec3_sub(tp_vec3 a, tp_vec3 b)
{
    const tp_vec3 difference = { a.x - b.x, a.y - b.y, a.z - b.z };
    return difference;
}

/* v.d in the format of v, rounded half up once.  |v| < 2^30 each: the sum of three
 * products of 2^60 stays below 2^62. */
static inline int32_t tp_dot_dir(tp_vec3 v, tp_dir3 d)
{
    return (int32_t)(((int64_t)v.x * d.x + (int64_t)v.y * d.y + (int64_t)v.z * d.z
                      + (1 << 29)) >> 30);
}

tp_q30  tp_dir3_dot(tp_dir3 a, tp_dir3 b);
tp_dir3 tp_dir3_cross(tp_dir3 a, tp_dir3 b);
tp_fx   tp_vec3_length(tp_vec3 v);              /* saturates */

/* The direction of (x, y, z) of any one format, each magnitude error < 2^-27;
 * (0, 0, 0) gives (0, 1, 0). */
tp_dir3 tp_normalise(int32_t x, int32_t y, int32_t z);

/* Heading turns the -z axis towards +x (clockwise from above), pitch lifts it, roll
 * then lowers its right side.  Rows of the result: right, up and backward (local +z)
 * of the turned frame in world axes, so v_local = R v_world. */
tp_rotation tp_rotation_of(tp_turn heading, tp_turn pitch, tp_turn roll);
tp_vec3 tp_rotate(const tp_rotation *r, tp_vec3 v);      /* R v: world to local */
tp_vec3 tp_rotate_back(const tp_rotation *r, tp_vec3 v); /* R^T v: local to world */
tp_rotation tp_rotation_mul(const tp_rotation *a, const tp_rotation *b);    /* A B */

/* Decimal text to 16.16, rounded to nearest: [+-] digits [. digits] [e [+-] digits], no
 * locale, any number of digits.  Reads at most `bytes`, stops at the first byte that is
 * not part of the number and returns how many it read; 0: no number there, *x is kept.
 * A magnitude beyond the range saturates and sets *beyond to 1 (may be NULL; otherwise
 * it is kept).  "5." and ".5" are numbers too; exact halves round up. */
uint32_t tp_fx_read(const char *text, uint32_t bytes, tp_fx *x, int *beyond);

/* The same into 48.16; beyond +-10^14 saturates to +-TP_WIDE_MAX. */
uint32_t tp_fx_read_wide(const char *text, uint32_t bytes, int64_t *x);
#define TP_WIDE_MAX ((int64_t)100000000000000 << 16)

/* The shortest decimal that reads back to x, terminated; returns its length (<= 14). */
uint32_t tp_fx_write(tp_fx x, char text[16]);
#endif
