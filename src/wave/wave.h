/* SPDX-License-Identifier: MIT */
/* The sum of swells, opened up for those who evaluate many points: the grid adds one
 * wave at a time with phases that it keeps per row and column. */
#ifndef TP_WAVE_SUM_H
#define TP_WAVE_SUM_H
#include "base/base.h"
#include "tidepool/wave.h"

/* Sines go in as Q8.24.  |A| < 2^20 in 16.16 and slopes < 2^31 in Q2.30, so a product
 * has 55 bits and sixteen of them 59. */
typedef struct {
    int64_t x, y, z;                    /* displacement, Q.40 */
    int64_t hx, hz;                     /* k A D cos th, Q.54 */
    int64_t bxx, bxz, bzz;              /* QkA D D sin th, Q.54 */
} tp_sea_sum;

/* k D x / 2 pi in turns: exact modulo a turn [G1]. */
static inline tp_turn tp_swell_turns(int64_t turns_per_metre, tp_fx x)
{
    return (tp_turn)((uint64_t)turns_per_metre * (uint64_t)(int64_t)x >> 16);
}

/* Adds one swell at phase th: the terms of [A7] and [A9]. */
TP_ALWAYS_INLINE void tp_swell_add(tp_sea_sum *sum, const tp_swell *w, tp_turn th)
{
    int32_t s = tp_sin(th) >> 6, c = tp_cos(th) >> 6;

    sum->x   += (int64_t)w->reach_x * c;
    sum->z   += (int64_t)w->reach_z * c;
    sum->y   += (int64_t)w->amplitude * s;
    sum->hx  += (int64_t)w->slope_x * c;
    sum->hz  += (int64_t)w->slope_z * c;
    sum->bxx += (int64_t)w->bend_xx * s;
    sum->bxz += (int64_t)w->bend_xz * s;
    sum->bzz += (int64_t)w->bend_zz * s;
}

/* The displaced point of rest place (x0, z0), the sum scaled by `fade` (16.16, 0..1). */
tp_sea_point tp_sea_sum_point(const tp_sea_sum *sum, tp_fx x0, tp_fx z0, tp_fx fade);
#endif
