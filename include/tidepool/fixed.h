/* SPDX-License-Identifier: MIT */
/* Fixed-point numbers, angles, vectors and rotations of scenes, worlds and frames.
 *
 * The type names the format.  Rounding: products and quotients round half up (towards plus
 * infinity); sums of many products do not drift as with a bare >>.  Overflow: functions
 * marked "saturates" clamp to the type's ends; the others state the range that the caller
 * must keep.  No function traps. */
#ifndef TP_FIXED_H
#define TP_FIXED_H
#include <stdint.h>

/* TP_BEGIN_C and TP_END_C enclose each header's declarations: C++ then links the library's
 * C functions. */
#ifdef __cplusplus
#define TP_BEGIN_C extern "C" {
#define TP_END_C   }
#define TP_STATIC_ASSERT(condition, text) static_assert(condition, text)
#else
#define TP_BEGIN_C
#define TP_END_C
#define TP_STATIC_ASSERT(condition, text) _Static_assert(condition, text)
#endif

TP_BEGIN_C

typedef int32_t  tp_fx;     /* Q16.16: 1.0 is 0x10000, range +-32767.99998 */
typedef int32_t  tp_q30;    /* Q2.30: sines, unit vectors, slopes below 2 */
typedef uint32_t tp_turn;   /* binary angle: 2^32 is one turn, wraps for free */

#define TP_FX_ONE  0x10000
#define TP_FX_MAX  INT32_MAX
#define TP_FX_MIN  INT32_MIN
#define TP_Q30_ONE 0x40000000

/* For constants only: the compiler evaluates the double, and no program contains one.
 * TP_DEG wraps: TP_DEG(360) is 0, TP_DEG(-90) is TP_DEG(270). */
#define TP_FX(x)   ((tp_fx)((x) * 65536.0 + ((x) < 0 ? -0.5 : 0.5)))
#define TP_Q30(x)  ((tp_q30)((x) * 1073741824.0 + ((x) < 0 ? -0.5 : 0.5)))
#define TP_DEG(x)  ((tp_turn)(int64_t)((x) * (4294967296.0 / 360.0)))

TP_STATIC_ASSERT(-1 >> 1 == -1, "the core assumes arithmetic right shift");

/* a b / 2^16, rounded half up; the caller keeps |a b| below 2^47. */
static inline tp_fx tp_fx_mul(tp_fx a, tp_fx b)
{
    return (tp_fx)(((int64_t)a * b + 0x8000) >> 16);
}

tp_fx   tp_fx_sin(tp_turn angle);
tp_fx   tp_fx_cos(tp_turn angle);
tp_turn tp_atan2(int32_t y, int32_t x); /* any format; error < 2^-18 turn; (0,0): 0 */

/* Converts degrees in 16.16, of any size, to an angle; wraps; error < 2^-31 turn per
 * degree. */
tp_turn tp_turn_of_degrees(tp_fx degrees);

/* Entries of small tables.  On x86-64 an entry takes a word, because vector units gather
 * only words: 6 KB more per view there, none elsewhere. */
#if defined(__x86_64__)
typedef uint32_t tp_entry8, tp_entry16;
#else
typedef uint8_t  tp_entry8;
typedef uint16_t tp_entry16;
#endif

typedef struct { tp_fx  x, y, z; } tp_vec3;     /* metres unless a name says otherwise */
typedef struct { tp_q30 x, y, z; } tp_dir3;     /* unit vector */
typedef struct { tp_dir3 x, y, z; } tp_rotation;/* rows: world to local; orthonormal */

TP_END_C
#endif
