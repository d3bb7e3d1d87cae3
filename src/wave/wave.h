/* SPDX-License-Identifier: MIT */
/* The sum of swells, opened up for those who evaluate many points: the grid adds one
 * wave at a time with phases that it keeps per row and column.
 *
 * A sea says once what its points need: tp_sea.sharpened and tp_sea.crossed.  Bodies take
 * the two as literals, so a plain sea pays for neither. */
#ifndef TP_WAVE_SUM_H
#define TP_WAVE_SUM_H
#include "base/base.h"
#include "tidepool/wave.h"

#define TP_SEA_SLOPE_MAX TP_FX(7.99)

/* Sines go in as Q8.24.  |A| <= 2^20 in 16.16, |QA| < 2^25 and all of them together too,
 * slopes < 2^31 in Q2.30; profiles are below 2, their derivatives below 2.5: products
 * have 57 bits at the most and sixteen of them 61. */
typedef struct {
    int64_t x, y, z;                    /* displacement, Q.40 */
    int64_t hx, hz;                     /* k A D f', Q.54 */
    int64_t bxx, bxz, bzz;              /* QkA D D sin th, Q.54; if not crossed, bxx is
                                         * the sum of QkA sin th and the others are 0 */
} tp_sea_sum;

/* k D x / 2 pi in turns: exact modulo a turn [G1]. */
static inline tp_turn tp_swell_turns(int64_t turns_per_metre, tp_fx x)
{
    return (tp_turn)((uint64_t)turns_per_metre * (uint64_t)(int64_t)x >> 16);
}

/* [A3]: f - mean and f', Q8.24, of a sine and cosine in Q2.30.  b = (s + 1)/2 and its
 * powers p are at most 2^30, f' = power p c below 2.48: both products have 62 bits. */
TP_ALWAYS_INLINE void tp_swell_sharpen(const tp_swell *w, tp_q30 s, tp_q30 c,
                                       int32_t *f, int32_t *df)
{
    const tp_q30 b = (s >> 1) + (TP_Q30_ONE >> 1);
    tp_q30 p = TP_Q30_ONE;

    for (int32_t n = w->power; n > 1; n--)
        p = tp_q30_mul(p, b);
    *f = (int32_t)(((int64_t)p * b + ((int64_t)1 << 34)) >> 35) - w->mean_q24;
    *df = (int32_t)(((int64_t)p * c * w->power + ((int64_t)1 << 35)) >> 36);
}

/* Adds one swell at phase th: the terms of [A7] and [A9]. */
TP_ALWAYS_INLINE void tp_swell_add_as(tp_sea_sum *sum, const tp_swell *w, tp_turn th,
                                      int sharpened, int crossed)
{
    const tp_q30 sine = tp_sin(th), cosine = tp_cos(th);
    int32_t s = sine >> 6, c = cosine >> 6, f = s, df = c;

    if (sharpened)
        tp_swell_sharpen(w, sine, cosine, &f, &df);
    sum->x  += (int64_t)w->reach_x * c;
    sum->z  += (int64_t)w->reach_z * c;
    sum->y  += (int64_t)w->amplitude * f;
    sum->hx += (int64_t)w->slope_x * df;
    sum->hz += (int64_t)w->slope_z * df;
    if (crossed) {
        sum->bxx += (int64_t)w->bend_xx * s;
        sum->bxz += (int64_t)w->bend_xz * s;
        sum->bzz += (int64_t)w->bend_zz * s;
    } else {
        sum->bxx += (int64_t)w->bend * s;
    }
}

/* All swells of a sea, each at the sum of its two phases. */
TP_ALWAYS_INLINE tp_sea_sum tp_sea_sum_all(const tp_sea *sea, const tp_turn *a,
                                           const tp_turn *b, int sharpened, int crossed)
{
    tp_sea_sum sum = { 0 };

    for (uint32_t i = 0; i < sea->count; i++)
        tp_swell_add_as(&sum, &sea->swell[i], a[i] + b[i], sharpened, crossed);
    return sum;
}

TP_ALWAYS_INLINE int64_t tp_sea_faded(int64_t x, tp_fx fade)
{
    return fade == TP_FX_ONE ? x : (x >> 16) * fade;
}

/* num / det as a slope: num in Q.23, `inverse` 2^62 over det, which in Q4.28 was shifted
 * up to 32 bits.  |num| < 2^7.2, so 31 bits and a product of 62; det > 0.047, so the
 * quotient has 29 bits of Q.17.  One comparison finds the few that are held. */
TP_ALWAYS_INLINE tp_fx tp_sea_slope(int64_t num, int shift, int32_t inverse)
{
    const int32_t most = TP_SEA_SLOPE_MAX;
    const int32_t slope = ((int32_t)(num * inverse >> (40 - shift)) + 1) >> 1;

    if ((uint32_t)(slope + most) > 2 * (uint32_t)most)
        return slope < 0 ? -most : most;
    return slope;
}

/* The displaced point of rest place (x0, z0), the sum scaled by `fade` (16.16, 0..1).
 * Slopes are those of gerstner.c's head; without cross terms h / (1 - sum QkA sin th). */
TP_ALWAYS_INLINE tp_sea_point tp_sea_sum_point_as(const tp_sea_sum *sum, tp_fx x0,
                                                  tp_fx z0, tp_fx fade, int crossed)
{
    const int64_t half = (int64_t)1 << 23;
    const int32_t one = 1 << 28;                                    /* J is Q4.28 */
    int32_t hx = (int32_t)(tp_sea_faded(sum->hx, fade) >> 30);      /* Q8.24 */
    int32_t hz = (int32_t)(tp_sea_faded(sum->hz, fade) >> 30);
    int32_t jxx = one - (int32_t)(tp_sea_faded(sum->bxx, fade) >> 26);
    int32_t jzz = one, bxz = 0, det = jxx;                          /* Jxz = -bxz */

    if (crossed) {
        jzz = one - (int32_t)(tp_sea_faded(sum->bzz, fade) >> 26);
        bxz = (int32_t)(tp_sea_faded(sum->bxz, fade) >> 26);
        det = (int32_t)(((int64_t)jxx * jzz - (int64_t)bxz * bxz) >> 28);
    }
    int     shift = tp_clz((uint32_t)det);
    int32_t inverse = (int32_t)(tp_recip_norm((uint32_t)det << shift) >> 1);
    int64_t nx = ((int64_t)hx + 1) >> 1, nz = ((int64_t)hz + 1) >> 1;

    if (crossed) {
        nx = ((int64_t)hx * jzz + (int64_t)hz * bxz + (1 << 28)) >> 29;
        nz = ((int64_t)hz * jxx + (int64_t)hx * bxz + (1 << 28)) >> 29;
    }
    return (tp_sea_point){
        .position = { tp_fx_plus(x0, (tp_fx)((tp_sea_faded(sum->x, fade) + half) >> 24)),
                      (tp_fx)((tp_sea_faded(sum->y, fade) + half) >> 24),
                      tp_fx_plus(z0, (tp_fx)((tp_sea_faded(sum->z, fade) + half) >> 24)) },
        .slope_x = tp_sea_slope(nx, shift, inverse),
        .slope_z = tp_sea_slope(nz, shift, inverse),
    };
}

/* Of sums with the cross terms, whatever the sea. */
tp_sea_point tp_sea_sum_point(const tp_sea_sum *sum, tp_fx x0, tp_fx z0, tp_fx fade);

/* [A3]: the mean of f, Q8.24; the greatest A |f - mean|; and of a k A in Q2.30 no less
 * than its greatest k A f', twice that if sharpened (see twist_of in swell.c), 16.16. */
int32_t tp_sharp_mean(int32_t power);
tp_fx   tp_sharp_height(tp_fx amplitude, int32_t power);
tp_fx   tp_sharp_tilt(tp_q30 slope, int32_t power);

/* jacobian.c: Jxx Jzz - Jxz^2 of [A9] at a place at rest, 16.16: below 1 the water is
 * squeezed together, at 0 it would fold.  `phases` of the tick. */
tp_fx tp_sea_jacobian(const tp_sea *sea, const tp_turn phases[TP_WAVES], tp_fx x, tp_fx z);
#endif
