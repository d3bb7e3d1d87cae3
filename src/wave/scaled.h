/* SPDX-License-Identifier: MIT */
/* Numbers of 32 bits with an exponent, for set-up alone.
 *
 * k_inf h spans 2^-25 to 2^22 and k of it six decades: no one fixed-point format keeps
 * their relative errors, [G2].  A sum, product, reciprocal or root of these errs by 2^-28
 * of itself at the most, and nothing overflows but the way back, which saturates. */
#ifndef TP_WAVE_SCALED_H
#define TP_WAVE_SCALED_H
#include <stdint.h>
#include "tidepool/fixed.h"

/* m 2^e with m in [2^31, 2^32); 0 is m = 0. */
typedef struct {
    uint32_t m;
    int      e;
} tp_scaled;

/* x / 2^bits; beyond 32 bits x is cut, by less than 2^-31 of itself. */
tp_scaled tp_scaled_of(uint64_t x, int bits);

tp_scaled tp_scaled_add(tp_scaled a, tp_scaled b);
tp_scaled tp_scaled_mul(tp_scaled a, tp_scaled b);
tp_scaled tp_scaled_recip(tp_scaled x);         /* x > 0, as here: */
tp_scaled tp_scaled_rsqrt(tp_scaled x);
tp_scaled tp_scaled_sqrt(tp_scaled x);

/* x 2^bits, rounded half up; saturates.  The same as 16.16. */
int64_t tp_scaled_fixed(tp_scaled x, int bits);
tp_fx   tp_scaled_fx(tp_scaled x);
#endif
