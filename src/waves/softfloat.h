/* SPDX-License-Identifier: MIT */
/* Numbers with an exponent, for set-up only, and the exponential functions and wave
 * numbers of waves over a depth. */
#ifndef TP_WAVES_SOFTFLOAT_H
#define TP_WAVES_SOFTFLOAT_H
#include <stdint.h>
#include "tidepool/fixed.h"

/* -- numbers of 32 bits with an exponent --------------------------------------------- */

/* Numbers of 32 bits with an exponent, for set-up only.
 *
 * k_inf h spans 2^-25 to 2^22, and its k six decades: no single fixed-point format keeps
 * their relative errors, [G2].  A sum, product, reciprocal or root has a relative error of
 * at most 2^-28.  Nothing overflows except the conversion to fixed point, which
 * saturates. */

/* The number m 2^e with m in [2^31, 2^32); m = 0 for 0. */
typedef struct {
    uint32_t m;
    int      e;
} tp_scaled;

/* Returns x / 2^bits.  An x of more than 32 bits is truncated, with a relative
 * error below 2^-31. */
tp_scaled tp_scaled_from_fixed(uint64_t x, int bits);

tp_scaled tp_scaled_add(tp_scaled a, tp_scaled b);
tp_scaled tp_scaled_mul(tp_scaled a, tp_scaled b);
tp_scaled tp_scaled_recip(tp_scaled x);         /* x > 0, also for tp_scaled_rsqrt */
tp_scaled tp_scaled_rsqrt(tp_scaled x);
tp_scaled tp_scaled_sqrt(tp_scaled x);

/* tp_scaled_fixed returns x 2^bits, rounded half up; saturates.
 * tp_scaled_fx returns 16.16. */
int64_t tp_scaled_fixed(tp_scaled x, int bits);
tp_fx   tp_scaled_fx(tp_scaled x);

/* -- exponential functions ----------------------------------------------------------- */

/* Building blocks of waves over a depth: e^-x, tanh x and related functions.  Arguments are
 * x >= 0 in 8.24 [G2]. */

/* Returns e^-x as Q0.32, within 2^-30; 2^32 - 1 at 0; 0 from 23 on. */
uint32_t tp_exp_neg(uint32_t x_q24);

static inline tp_q30 tp_exp_neg_q30(uint32_t x_q24)
{
    return (tp_q30)(((uint64_t)tp_exp_neg(x_q24) + 2) >> 2);
}

/* tanh x as Q0.32, and tanh x / x as Q1.31, 2^31 at 0.  Both have a relative error below
 * 2^-29, or half of their last bit. */
typedef struct {
    uint32_t tanh_q32, ratio_q31;
} tp_tanh;
tp_tanh tp_tanh_evaluate(uint32_t x_q24);

/* Returns 1 - tanh^2 x as Q1.31. */
static inline uint32_t tp_sech_squared(tp_tanh at)
{
    return 0x80000000u - (uint32_t)((uint64_t)at.tanh_q32 * at.tanh_q32 >> 33);
}

/* Returns 1 / sinh^2 x for x > 0; relative error below 2^-26 up to x = 4, below
 * 2^-30 from there on. */
tp_scaled tp_csch_squared(tp_scaled x);

/* -- wave numbers over a depth, water_depth.c ---------------------------------------- */

/* tp_scaled_from_depth converts a depth; land counts as 1/16 m.  tp_scaled_q24
 * converts x to 8.24, saturated. */
tp_scaled tp_scaled_from_depth(tp_fx depth);
uint32_t  tp_scaled_q24(tp_scaled x);

/* Converts a wave number from Q31.32; negative numbers count as 0. */
static inline tp_scaled tp_scaled_from_wave_number(int64_t k_q32)
{
    return tp_scaled_from_fixed(k_q32 > 0 ? (uint64_t)k_q32 : 0, 32);
}

/* Solves k tanh(kh) = k_inf for k, by [B4] and `steps` of [B6]; see
 * tp_depth_wave_number.  Both arguments are > 0. */
tp_scaled tp_depth_wave_number_scaled(tp_scaled k_inf, tp_scaled depth, int steps);

/* From this k_inf h on, k is k_inf: the difference, 2 e^-24, is below 2^-33. */
#define TP_DEPTH_DEEP_Q24 (12u << 24)

/* 2^32 / 2 pi: turns of a radian, Q0.32. */
#define TP_OVER_TWO_PI_Q32 683565276

#endif
