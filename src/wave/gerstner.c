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

/* g / (2 pi L) in Q8.120, for g <= 100 m/s^2 and L >= 1/4 m below 64: the high and the
 * low half.  g / 2 pi is divided by L digit by digit, of 32 bits, as on paper. */
static void frequency_squared(tp_fx gravity, tp_fx length, uint64_t half[2])
{
    const uint64_t over_two_pi = 0x28be60db9391054a;        /* 2^64 / 2 pi */
    uint64_t low = (over_two_pi & 0xffffffff) * (uint32_t)gravity;
    uint64_t high = (over_two_pi >> 32) * (uint32_t)gravity + (low >> 32);
    uint32_t digit[5] = { (uint32_t)(high >> 40), (uint32_t)(high >> 8),
                          (uint32_t)(high << 24) | (uint32_t)low >> 8,
                          (uint32_t)low << 24, 0 };
    uint64_t rest = 0;

    for (int i = 0; i < 5; i++) {
        uint64_t part = rest << 32 | digit[i];
        digit[i] = (uint32_t)(part / (uint32_t)length);
        rest = part % (uint32_t)length;
    }
    half[0] = (uint64_t)digit[1] << 32 | digit[2];
    half[1] = (uint64_t)digit[3] << 32 | digit[4];
}

/* The root of a number of 128 bits, > 0, within 2 of 2^64 once the number is shifted up:
 * the root s of its high half, then the rest over 2 s, as long division goes on. */
static uint64_t root_of(const uint64_t half[2])
{
    uint64_t high = half[0], low = half[1];
    int      up = 0;

    for (; high >> 62 == 0; up++) {
        high = high << 2 | low >> 62;
        low <<= 2;
    }
    uint32_t s = tp_isqrt64(high);
    uint64_t rest = high - (uint64_t)s * s;                 /* <= 2 s */
    return (((uint64_t)s << 32) + (rest << 31 | low >> 33) / s) >> up;
}

/* omega dt / 2 pi = sqrt(g / (2 pi L)) x speed / 60 in Q0.64, modulo a turn.  Within
 * 2^-64 at natural speed: ten years later a wave is not a part in 10^9 of a turn off, where a
 * root of 32 bits would be off by a whole turn.  Without gravity waves stand still. */
static uint64_t turns_per_tick(tp_fx gravity, tp_fx length, tp_fx speed)
{
    const uint32_t over = TP_TICKS_PER_SECOND << 12;        /* Q60 x Q16 to Q64 */
    uint64_t half[2];

    if (gravity <= 0)
        return 0;
    frequency_squared(gravity, length, half);
    uint64_t root = root_of(half);                          /* Q4.60, below 8 */
    uint64_t high = (root >> 32) * (uint32_t)speed;
    uint64_t low = (root & 0xffffffff) * (uint32_t)speed;
    return (high / over << 32) + ((high % over << 32) + low + over / 2) / over;
}

/* `sharp` is Q k A after the clamp of the sum. */
static tp_swell swell_of(const tp_wave *w, tp_fx amplitude, tp_fx sharp, tp_fx gravity)
{
    tp_rotation turned = tp_rotation_of(tp_turn_of_degrees(w->heading), 0, 0);
    tp_q30  dx = turned.x.z, dz = -turned.x.x;      /* 28 bits, for far phases */
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
    for (uint32_t i = 0; i < TP_WAVES; i++) {       /* those beyond count are all 0 */
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
