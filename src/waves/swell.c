/* SPDX-License-Identifier: MIT */
/* Swells of deep water from the waves of a user, [A3], [A7] and [G1]-[G2] of the models,
 * with the bounds needed by the sums, and their phases at a tick. */
#include "base/base.h"
#include "waves/deep_water.h"

/* -- sharpened crests ---------------------------------------------------------------- */

/* Sines with sharpened crests, [A3] of the models: f = 2 ((sin th + 1) / 2)^power.  The
 * mean of f over a turn is subtracted; otherwise the water level would depend on the power.
 * The per-vertex part is tp_swell_sharpen in deep_water.h. */

/* 2 C(2n, n) / 4^n for n = 1..8: exact in 14 bits or fewer. */
static const int32_t mean_q14[8] = {
    16384, 12288, 10240, 8960, 8064, 7392, 6864, 6435
};

/* Returns the mean of f, Q8.24. */
static int32_t sharp_mean(int32_t power)
{
    return mean_q14[tp_clamp(power, 1, 8) - 1] * (1 << 10);
}

/* 2 - mean is at least 1: a crest is never nearer to the mean than a trough. */
tp_fx tp_sharp_max_height(tp_fx amplitude, int32_t power)
{
    int64_t crest = 2 * (1 << 24) - sharp_mean(power);
    return (tp_fx)((amplitude * crest + (1 << 24) - 1) >> 24);
}

/* Takes k A in Q2.30 and returns an upper bound of k A f', twice the bound if sharpened
 * (see swell_cross_term_bound), 16.16.  f' is at most 1, 1.30, 1.55, 1.77 ... 2.47 [A3]; 1
 * + 0.3 (power - 1) is at least as large. */
static tp_fx sharp_slope_bound(tp_q30 slope, int32_t power)
{
    int64_t n = tp_clamp(power, 1, 8) - 1, tenths = n ? 2 * (10 + 3 * n) : 10;
    return (tp_fx)((slope * tenths / 10 + (1 << 14) - 1) >> 14);
}

/* -- swells -------------------------------------------------------------------------- */

/* Conversion of user waves to swells of the core, [A7] and [G1]-[G2] of the models, with
 * the bounds needed by the sums: amplitudes up to 0.3 of the length, and a sum of Q k A up
 * to 0.95; above, all waves are scaled down by the same factor [A11]. */

#define BEND_MAX     TP_Q30(0.95)
#define BEND_CROSSED TP_Q30(0.3)
#define TWO_PI_Q28   1686629713LL

/* Returns g / (2 pi L) in Q8.120, below 64, for g <= 100 m/s^2 and L >= 1/4 m;
 * high_low[0] is the high half, high_low[1] the low half.  Divides g / 2 pi by L in
 * digits of 32 bits, by long division. */
static void squared_turns_per_second(tp_fx gravity, tp_fx length, uint64_t high_low[2])
{
    TP_ASSERT(gravity > 0 && gravity <= 100 * TP_FX_ONE && length >= TP_FX_ONE / 4);
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
    high_low[0] = (uint64_t)digit[1] << 32 | digit[2];
    high_low[1] = (uint64_t)digit[3] << 32 | digit[4];
}

/* Returns the square root of a number of 128 bits, > 0, within 2 of 2^64 after the
 * number is shifted up.  As in long division: first the root s of the high half, then
 * the rest over 2 s. */
static uint64_t sqrt_128(const uint64_t high_low[2])
{
    TP_ASSERT((high_low[0] | high_low[1]) != 0);
    uint64_t high = high_low[0], low = high_low[1];
    int      up = 0;

    for (; high >> 62 == 0; up++) {
        high = high << 2 | low >> 62;
        low <<= 2;
    }
    uint32_t s = tp_isqrt64(high);
    uint64_t rest = high - (uint64_t)s * s;                 /* <= 2 s */
    return (((uint64_t)s << 32) + (rest << 31 | low >> 33) / s) >> up;
}

/* Returns omega dt / 2 pi = sqrt(g / (2 pi L)) x speed / 60 in Q0.64, modulo a turn; within
 * 2^-64 at natural speed.  After ten years a wave is off by less than 10^-9 of a turn; with
 * a root of 32 bits the error would be a whole turn.  Without gravity waves stand still. */
static uint64_t turns_per_tick(tp_fx gravity, tp_fx length, tp_fx speed)
{
    const uint32_t over = TP_TICKS_PER_SECOND << 12;        /* Q60 x Q16 to Q64 */
    uint64_t half[2];

    if (gravity <= 0)
        return 0;
    squared_turns_per_second(gravity, length, half);
    uint64_t root = sqrt_128(half);                          /* Q4.60, below 8 */
    uint64_t high = (root >> 32) * (uint32_t)speed;
    uint64_t low = (root & 0xffffffff) * (uint32_t)speed;
    return (high / over << 32) + ((high % over << 32) + low + over / 2) / over;
}

/* Returns Q0.32 times Q2.30 in Q0.32.  Turns have up to 34 bits: the product is
 * computed in two halves. */
static int64_t scale_turns(uint64_t turns, tp_q30 d)
{
    int64_t high = (int64_t)(turns >> 16) * d, low = (int64_t)(turns & 0xffff) * d;
    return (high + (low >> 16) + (1 << 13)) >> 14;
}

/* Returns Q A = (Q k A) L / 2 pi: 30 and 27 bits make Q.46, over Q.28 gives Q.18. */
static tp_fx swell_displacement(tp_q30 bend, tp_fx length)
{
    return (tp_fx)(((int64_t)bend * length / TWO_PI_Q28 + 2) >> 2);
}

/* Returns k A = 2 pi A / L: 31 and 20 bits make Q.44; two more bits, and the
 * quotient is Q2.30. */
static tp_q30 swell_slope(tp_fx amplitude, tp_fx length)
{
    return (tp_q30)((TWO_PI_Q28 * amplitude * 4 + length / 2) / length);
}

/* Bounds the slope that the cross terms of wave w with the waves of `deep` add to the
 * surface.  The cross terms make the part adj(B) g / (1 - tr B) of the slopes g; B = I - J,
 * and g is about h.  In adj(B) h a wave has no effect on itself.  Two waves have at most
 * the greater of q1 k2 A2 and q2 k1 A1, because the sine of one wave meets the cosine of
 * the other.  Over 1 - sum q the result bounds the angle in radians.  Rounded up.  The
 * tilt of sharpened waves counts twice, because their sine and their f' are large
 * together. */
static tp_fx swell_cross_term_bound(const tp_deep_water *deep, const tp_swell *w)
{
    tp_fx sum = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *v = &deep->swell[i];
        tp_fx a = tp_q30_mul(v->tilt, w->bend), b = tp_q30_mul(w->tilt, v->bend);
        sum += (a > b ? a : b) + 1;
    }
    return sum;
}

static bool needs_cross_terms(const tp_deep_water *deep)
{
    const tp_fx most = TP_FX(0.026);                        /* 1.49 degrees */
    return deep->count > 1 && deep->steepness_sum > 0
        && (deep->steepness_sum > BEND_CROSSED
            || deep->cross_term_bound > tp_q30_mul(most, TP_Q30_ONE - deep->steepness_sum));
}

static tp_swell make_swell(const tp_wave_exact *w, tp_fx amplitude, tp_fx length,
                           tp_q30 bend)
{
    tp_fx   reach = swell_displacement(bend, length);
    tp_q30  slope = swell_slope(amplitude, length);
    int32_t power = tp_clamp(w->power, 1, 8);

    return (tp_swell){
        .turns_x = scale_turns(w->turns, w->dx),
        .turns_z = scale_turns(w->turns, w->dz),
        .turns_tick = w->turns_tick,
        .turns = w->turns,
        .phase = w->phase,
        .amplitude = amplitude,
        .orbit_x = tp_q30_mul(reach, w->dx),
        .orbit_z = tp_q30_mul(reach, w->dz),
        .slope_x = tp_q30_mul(slope, w->dx),
        .slope_z = tp_q30_mul(slope, w->dz),
        .bend_xx = tp_q30_mul(tp_q30_mul(bend, w->dx), w->dx),
        .bend_xz = tp_q30_mul(tp_q30_mul(bend, w->dx), w->dz),
        .bend_zz = tp_q30_mul(tp_q30_mul(bend, w->dz), w->dz),
        .bend = bend,
        .tilt = sharp_slope_bound(slope, power),
        .power = power,
        .mean_q24 = sharp_mean(power),
    };
}

void tp_deep_water_append_wave(tp_deep_water *deep, const tp_wave_exact *wave)
{
    if (deep->count == TP_WAVES || wave->amplitude <= 0)
        return;
    TP_ASSERT(wave->turns >> 17 != 0 && wave->turns <= (uint64_t)4 << 32);
    TP_ASSERT(wave->steepness >= 0 && deep->steepness_sum <= BEND_MAX);
    tp_fx  length = (tp_fx)((((uint64_t)1 << 48) + wave->turns / 2) / wave->turns);
    tp_fx  cap = (tp_fx)(((int64_t)length * 3 + 5) / 10);
    tp_fx  amplitude = wave->amplitude < cap ? wave->amplitude : cap;
    tp_q30 left = BEND_MAX - deep->steepness_sum;
    tp_q30 bend = wave->steepness < left ? wave->steepness : left;

    deep->capped |= wave->amplitude > cap;
    deep->clamped |= wave->steepness > left;
    deep->sharpened |= wave->power > 1;
    deep->height += tp_sharp_max_height(amplitude, wave->power);
    deep->max_displacement += swell_displacement(bend, length) + 1;
    deep->steepness += (wave->steepness + (1 << 13)) >> 14;
    deep->steepness_sum += bend;
    tp_swell *w = &deep->swell[deep->count];
    *w = make_swell(wave, amplitude, length, bend);
    deep->cross_term_bound += swell_cross_term_bound(deep, w);
    deep->count++;
    deep->crossed = needs_cross_terms(deep);
}

static tp_wave_exact make_exact_wave(const tp_wave *w, tp_q30 steepness, tp_fx gravity)
{
    TP_ASSERT(w->length >= TP_FX_ONE / 4);
    tp_rotation turned = tp_rotation_from_angles(tp_turn_of_degrees(w->heading), 0, 0);

    return (tp_wave_exact){
        .turns = (((uint64_t)1 << 48) + (uint32_t)w->length / 2) / (uint32_t)w->length,
        .dx = turned.x.z, .dz = -turned.x.x,        /* 28 bits, for far phases */
        .amplitude = w->amplitude,
        .steepness = steepness,
        .turns_tick = turns_per_tick(gravity, w->length, w->speed),
        .phase = tp_turn_of_degrees(w->phase),
        .power = w->exponent,
    };
}

/* The sum of the steepnesses fits 32 bits: at most sixteen of 1. */
static tp_fx sum_steepness(const tp_wave *waves, uint32_t count)
{
    tp_fx sum = 0;

    for (uint32_t i = 0; i < count; i++)
        sum += waves[i].amplitude > 0 ? waves[i].steepness : 0;
    return sum;
}

void tp_deep_water_init(tp_deep_water *deep, const tp_wave *waves, uint32_t count,
                        tp_fx gravity)
{
    memset(deep, 0, sizeof *deep);
    tp_deep_water_init_compact(deep, waves, count, gravity);
}

void tp_deep_water_init_compact(tp_deep_water *deep, const tp_wave *waves, uint32_t count,
                                tp_fx gravity)
{
    count = count < TP_WAVES ? count : TP_WAVES;
    tp_fx asked = sum_steepness(waves, count);
    bool  clamped = asked > TP_FX(0.95);

    memset(deep, 0, offsetof(tp_deep_water, swell));
    for (uint32_t i = 0; i < count; i++) {
        if (waves[i].amplitude <= 0)
            continue;
        int64_t share = waves[i].steepness;
        share = clamped ? share * BEND_MAX / asked : share << 14;
        tp_wave_exact exact = make_exact_wave(&waves[i], (tp_q30)share, gravity);
        tp_deep_water_append_wave(deep, &exact);
    }
    deep->steepness = asked;
    deep->clamped = clamped;
}

void tp_deep_water_phases(const tp_deep_water *deep, uint64_t tick, tp_fx lag,
                          tp_turn phases[TP_WAVES])
{
    TP_ASSERT(deep->count <= TP_WAVES);
    TP_ASSERT(lag >= 0 && lag <= TP_FX_ONE);
    for (uint32_t i = deep->count; i < TP_WAVES; i++)
        phases[i] = 0;
    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        uint64_t turns = tick * w->turns_tick - (w->turns_tick >> 16) * (uint32_t)lag;
        phases[i] = w->phase - (tp_turn)(turns >> 32);
    }
}
