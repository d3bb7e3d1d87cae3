/* SPDX-License-Identifier: MIT */
/* Gerstner waves, [A7]-[A11] of the models.
 *
 * Normals are the exact ones of [A10], as slopes: N = (hz Jxz - hx Jzz, det, hx Jxz -
 * hz Jxx), so dy/dx = -Nx/Ny = (hx Jzz - hz Jxz) / det.  The clamp of [A11] keeps the
 * smallest eigenvalue of J at 0.05 or above, so det > 0 and the quotient exists.
 * Everything is taken at the rest point: the form that is printed with the displaced
 * point inside the sine is a different, wrong surface ([A10]). */
#include "wave/wave.h"

#define STEEPNESS_MAX TP_FX(0.95)
#define SLOPE_MAX     TP_FX(7.99)
#define TWO_PI        TP_FX(6.283185307)
#define J_ONE         (1 << 28)         /* the Jacobian is Q4.28 */

/* The wave's turns per tick in Q0.64: sqrt(g / (2 pi L)) x speed / 60.
 * g/L <= 400 in Q24.40 has 49 bits; with 1/(2 pi) in Q0.32 in two halves nothing is
 * lost; the root of a Q.56 is a Q.28 below 2^31. */
static uint64_t turns_per_tick(tp_fx gravity, tp_fx length, tp_fx speed)
{
    const uint64_t over_two_pi = 683565276;     /* 2^32 / (2 pi) */
    uint64_t ratio = ((uint64_t)gravity << 40) / (uint32_t)length;
    uint64_t f2 = (ratio >> 32) * over_two_pi
                + ((ratio & 0xffffffffu) * over_two_pi >> 32);
    uint64_t p = (uint64_t)tp_isqrt64(f2 << 16) * (uint32_t)speed;  /* Q.44 */

    return ((p / TP_TICKS_PER_SECOND) << 20)
         + ((p % TP_TICKS_PER_SECOND) << 20) / TP_TICKS_PER_SECOND;
}

/* `sharp` is Q k A after the clamp of the sum. */
static tp_swell swell_of(const tp_wave *w, tp_fx amplitude, tp_fx sharp, tp_fx gravity)
{
    tp_turn heading = tp_turn_of_degrees(w->heading);
    tp_q30  dx = tp_sin(heading), dz = -tp_cos(heading);
    tp_fx   reach = tp_fx_div(tp_fx_mul(sharp, w->length), TWO_PI);
    int64_t ka = ((int64_t)TWO_PI * amplitude << 14) / w->length;   /* Q2.30 */
    int32_t s = sharp << 14;                                        /* Q2.30 */

    return (tp_swell){
        .turns_x = (int64_t)dx * (1 << 18) / w->length,
        .turns_z = (int64_t)dz * (1 << 18) / w->length,
        .turns_tick = turns_per_tick(gravity, w->length, w->speed),
        .phase = tp_turn_of_degrees(w->phase),
        .amplitude = amplitude,
        .reach_x = tp_q30_mul(reach, dx),
        .reach_z = tp_q30_mul(reach, dz),
        .slope_x = tp_q30_mul((int32_t)ka, dx),
        .slope_z = tp_q30_mul((int32_t)ka, dz),
        .bend_xx = tp_q30_mul(tp_q30_mul(s, dx), dx),
        .bend_xz = tp_q30_mul(tp_q30_mul(s, dx), dz),
        .bend_zz = tp_q30_mul(tp_q30_mul(s, dz), dz),
    };
}

void tp_sea_init(tp_sea *sea, const tp_wave *waves, uint32_t count, tp_fx gravity)
{
    tp_fx share = TP_FX_ONE;

    *sea = (tp_sea){ .count = 0 };
    if (count > TP_WAVES)
        count = TP_WAVES;
    for (uint32_t i = 0; i < count; i++) {
        if (waves[i].amplitude > 0)
            sea->steepness += waves[i].steepness;
    }
    sea->clamped = sea->steepness > STEEPNESS_MAX;
    if (sea->clamped)
        share = tp_fx_div(STEEPNESS_MAX, sea->steepness);

    for (uint32_t i = 0; i < count; i++) {
        const tp_wave *w = &waves[i];
        if (w->amplitude <= 0)
            continue;
        tp_fx cap = tp_fx_mul(w->length, TP_FX(0.3));
        tp_fx amplitude = w->amplitude < cap ? w->amplitude : cap;
        tp_fx sharp = tp_fx_mul(w->steepness, share);
        sea->capped |= w->amplitude > cap;
        sea->swell[sea->count++] = swell_of(w, amplitude, sharp, gravity);
        sea->height += amplitude;
        sea->reach += tp_fx_div(tp_fx_mul(sharp, w->length), TWO_PI) + 1;
    }
}

void tp_sea_phases(const tp_sea *sea, uint64_t tick, tp_turn phases[TP_WAVES])
{
    for (uint32_t i = 0; i < sea->count; i++) {
        const tp_swell *w = &sea->swell[i];
        phases[i] = w->phase - (tp_turn)(tick * w->turns_tick >> 32);
    }
}

/* (hx, hz) Q8.24 times the adjoint of J over det; see the head of this file.
 * |num| < 60 in Q8.24 fits 30 bits, the reciprocal 32. */
static tp_fx slope_over(int64_t num_q52, int shift, uint32_t reciprocal)
{
    int64_t slope = (num_q52 >> 28) * (int64_t)reciprocal >> (43 - shift);
    return slope > SLOPE_MAX ? SLOPE_MAX
         : slope < -SLOPE_MAX ? -SLOPE_MAX : (tp_fx)slope;
}

static int64_t faded(int64_t x, tp_fx fade)
{
    return fade == TP_FX_ONE ? x : (x >> 16) * fade;
}

tp_sea_point tp_sea_sum_point(const tp_sea_sum *sum, tp_fx x0, tp_fx z0, tp_fx fade)
{
    const int64_t half = (int64_t)1 << 23;
    int32_t hx = (int32_t)(faded(sum->hx, fade) >> 30);     /* Q8.24 */
    int32_t hz = (int32_t)(faded(sum->hz, fade) >> 30);
    int32_t jxx = J_ONE - (int32_t)(faded(sum->bxx, fade) >> 26);
    int32_t jzz = J_ONE - (int32_t)(faded(sum->bzz, fade) >> 26);
    int32_t jxz = (int32_t)(-(faded(sum->bxz, fade) >> 26));
    int32_t det = (int32_t)(((int64_t)jxx * jzz - (int64_t)jxz * jxz) >> 28);
    int     shift = tp_clz((uint32_t)det);
    uint32_t r = tp_recip_norm((uint32_t)det << shift);

    return (tp_sea_point){
        .position = { x0 + (tp_fx)((faded(sum->x, fade) + half) >> 24),
                      (tp_fx)((faded(sum->y, fade) + half) >> 24),
                      z0 + (tp_fx)((faded(sum->z, fade) + half) >> 24) },
        .slope_x = slope_over((int64_t)hx * jzz - (int64_t)hz * jxz, shift, r),
        .slope_z = slope_over((int64_t)hz * jxx - (int64_t)hx * jxz, shift, r),
    };
}

tp_sea_point tp_sea_at_rest(const tp_sea *sea, const tp_turn phases[TP_WAVES],
                            tp_fx x0, tp_fx z0)
{
    tp_sea_sum sum = { 0 };

    for (uint32_t i = 0; i < sea->count; i++) {
        const tp_swell *w = &sea->swell[i];
        tp_swell_add(&sum, w, phases[i] + tp_swell_turns(w->turns_x, x0)
                                        + tp_swell_turns(w->turns_z, z0));
    }
    return tp_sea_sum_point(&sum, x0, z0, TP_FX_ONE);
}

tp_sea_point tp_sea_above(const tp_sea *sea, const tp_turn phases[TP_WAVES],
                          tp_fx x, tp_fx z)
{
    tp_fx x0 = x, z0 = z;
    tp_sea_point at = tp_sea_at_rest(sea, phases, x0, z0);

    for (int n = 0; n < 8; n++) {
        x0 += x - at.position.x;
        z0 += z - at.position.z;
        at = tp_sea_at_rest(sea, phases, x0, z0);
    }
    return at;
}
