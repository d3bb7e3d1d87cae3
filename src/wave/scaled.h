/* SPDX-License-Identifier: MIT */
/* Numbers of 32 bits with an exponent, for set-up only.
 *
 * k_inf h spans 2^-25 to 2^22, and its k six decades: no single fixed-point format keeps
 * their relative errors, [G2].  A sum, product, reciprocal or root has a relative error of
 * at most 2^-28.  Nothing overflows except the conversion to fixed point, which
 * saturates. */
#ifndef TP_WAVE_SCALED_H
#define TP_WAVE_SCALED_H
#include <stdint.h>
#include "tidepool/fixed.h"

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
#endif
