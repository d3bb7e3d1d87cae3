/* SPDX-License-Identifier: MIT */
/* Fixed-point arithmetic beyond tidepool/fixed.h: saturation, roots, reciprocals,
 * angles, vectors, rotations, text. */
#ifndef TP_FIXED_ARITHMETIC_H
#define TP_FIXED_ARITHMETIC_H
#include "tidepool/fixed.h"

/* Returns a b / 2^30, rounded half up.  A number of any format times a Q2.30 of magnitude
 * <= 1 keeps its format.  The caller keeps |a b| below 2^61. */
static inline int32_t tp_q30_mul(int32_t a, tp_q30 b)
{
    return (int32_t)(((int64_t)a * b + (1 << 29)) >> 30);
}

static inline int32_t tp_clamp(int32_t x, int32_t low, int32_t high)
{
    return x < low ? low : x > high ? high : x;
}

static inline int32_t tp_abs(int32_t x) { return x < 0 ? -x : x; }  /* x > INT32_MIN */

/* tp_clamp_abs clamps x to -most..most, most >= 0.  tp_fx_saturate saturates x to 16.16. */
static inline int64_t tp_clamp_abs(int64_t x, int64_t limit)
{
    return x > limit ? limit : x < -limit ? -limit : x;
}

static inline tp_fx tp_fx_saturate(int64_t x)
{
    return x > TP_FX_MAX ? TP_FX_MAX : x < TP_FX_MIN ? TP_FX_MIN : (tp_fx)x;
}

/* Saturating a + b and a - b, computed in 32 bits. */
static inline tp_fx tp_fx_add_sat(tp_fx a, tp_fx b)
{
#if defined(__GNUC__)
    tp_fx sum;
    if (__builtin_expect(__builtin_add_overflow(a, b, &sum), 0))
        return a < 0 ? TP_FX_MIN : TP_FX_MAX;
    return sum;
#else
    return tp_fx_saturate((int64_t)a + b);
#endif
}

static inline tp_fx tp_fx_sub_sat(tp_fx a, tp_fx b)
{
#if defined(__GNUC__)
    tp_fx left;
    if (__builtin_expect(__builtin_sub_overflow(a, b, &left), 0))
        return a < 0 ? TP_FX_MIN : TP_FX_MAX;
    return left;
#else
    return tp_fx_saturate((int64_t)a - b);
#endif
}

/* Returns n / d, halves rounded away from 0.  Rounding is symmetric: a step and its reverse
 * add up to 0.  d > 0, and |n| + d / 2 must fit 64 bits. */
static inline int64_t tp_div_rounded(int64_t n, int64_t d)
{
    return (n < 0 ? n - d / 2 : n + d / 2) / d;
}

/* Returns x^2 (3 - 2x) after x is clamped to 0..1. */
static inline tp_fx tp_smoothstep(tp_fx x)
{
    x = tp_clamp(x, 0, TP_FX_ONE);
    return tp_fx_mul(tp_fx_mul(x, x), 3 * TP_FX_ONE - 2 * x);
}

/* Counts the leading zeros of x != 0. */
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

/* As tp_clz, in steps: for loops of vector units that have no such instruction. */
static inline int tp_clz_in_steps(uint32_t x)
{
    int n = x >> 16 ? 0 : 16, more;

    more = x << n >> 24 ? 0 : 8;
    n += more;
    more = x << n >> 28 ? 0 : 4;
    n += more;
    more = x << n >> 30 ? 0 : 2;
    n += more;
    return n + (x << n >> 31 ? 0 : 1);
}

tp_fx  tp_fx_div(tp_fx a, tp_fx b);     /* rounded half up; saturates; x/0 by sign of x */
tp_fx  tp_fx_sqrt(tp_fx x);             /* nearest; 0 for x <= 0 */
tp_fx  tp_fx_rsqrt(tp_fx x);            /* 1/sqrt(x) within 1 LSB; saturates for x <= 0 */
/* Returns n / d as C's operator does, by shifts: 8 to 15 instructions a bit of the result.
 * n and d above INT64_MIN, d != 0.  tp_quotient is for the few divisions of a tick or a
 * picture: without others, a program for 32 bits links no library's division. */
int64_t tp_quotient_by_shifts(int64_t n, int64_t d);
static inline int64_t tp_quotient(int64_t n, int64_t d)
{
#if UINTPTR_MAX > UINT32_MAX
    return n / d;
#else
    return tp_quotient_by_shifts(n, d);
#endif
}

tp_fx  tp_fx_recip(tp_fx x);            /* 1/x rounded half up; saturates; 0: max */
uint32_t tp_isqrt64(uint64_t x);        /* floor of the root, exact */

/* Reciprocal for the hot path, without division.  For n in [2^31, 2^32) returns 2^63/n in
 * [2^31, 2^32]; the value 2^32 is returned as 2^32 - 1.  Relative error below 2^-29. */
uint32_t tp_recip_norm(uint32_t n);

/* Reciprocal square root for the hot path.  n in [2^30, 2^32) is x in [1/4, 1) as Q0.32.
 * Returns 1/sqrt(x) in Q1.31, [2^31, 2^32-1]; relative error below 2^-28. */
uint32_t tp_rsqrt_norm(uint32_t n);

/* Sine and cosine of an angle, in Q2.30, by a quarter-wave table and linear interpolation.
 * The error is below 5e-6: within 1 LSB of 16.16 after rounding ([G5], 1024 a turn). */
tp_q30 tp_sin(tp_turn angle);
tp_q30 tp_cos(tp_turn angle);

/* Height of a surface at a point, m, and the slopes dy/dx and dy/dz; all 16.16. */
typedef struct { tp_fx height, slope_x, slope_z; } tp_height_slope;

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

/* Returns v.d in the format of v, rounded half up once.  Each |component of v| < 2^30: the
 * sum of three products of 2^60 stays below 2^62. */
static inline int32_t tp_dot_dir(tp_vec3 v, tp_dir3 d)
{
    return (int32_t)(((int64_t)v.x * d.x + (int64_t)v.y * d.y + (int64_t)v.z * d.z
                      + (1 << 29)) >> 30);
}

tp_q30  tp_dir3_dot(tp_dir3 a, tp_dir3 b);
tp_dir3 tp_dir3_cross(tp_dir3 a, tp_dir3 b);
tp_fx   tp_vec3_length(tp_vec3 v);              /* saturates */

/* Returns the direction of (x, y, z); the three share any one format.  The error of each
 * component is below 2^-27.  (0, 0, 0) gives (0, 1, 0). */
tp_dir3 tp_normalise(int32_t x, int32_t y, int32_t z);

/* Heading turns the -z axis towards +x (clockwise from above), pitch lifts the -z axis,
 * roll then lowers the right side.  The rows of the result are right, up and backward
 * (local +z) of the turned frame in world axes: v_local = R v_world. */
tp_rotation tp_rotation_from_angles(tp_turn heading, tp_turn pitch, tp_turn roll);
tp_vec3 tp_rotate(const tp_rotation *r, tp_vec3 v);      /* R v: world to local */
tp_vec3 tp_rotate_back(const tp_rotation *r, tp_vec3 v); /* R^T v: local to world */
tp_rotation tp_rotation_mul(const tp_rotation *a, const tp_rotation *b);    /* A B */

/* Reads decimal text into 16.16, rounded to nearest: [+-] digits [. digits] [e [+-]
 * digits], no locale, any number of digits; "5." and ".5" are numbers too.  Exact halves
 * round up.  Reads at most `bytes`, stops at the first byte after the number, and returns
 * the number of bytes read.  Returns 0 if the text starts with no number, and leaves *x
 * unchanged.  A magnitude beyond the range saturates and sets *beyond to 1.  Otherwise
 * *beyond is unchanged; `beyond` may be NULL. */
uint32_t tp_fx_read(const char *text, uint32_t bytes, tp_fx *x, int *beyond);

/* Reads the same text format into 48.16; numbers beyond +-10^14 saturate to
 * +-TP_WIDE_MAX. */
uint32_t tp_fx_read_wide(const char *text, uint32_t bytes, int64_t *x);
#define TP_WIDE_MAX ((int64_t)100000000000000 << 16)

/* Writes the shortest decimal number that tp_fx_read turns back into x, with a terminator.
 * Returns its length (<= 14). */
uint32_t tp_fx_write(tp_fx x, char text[16]);

#endif
