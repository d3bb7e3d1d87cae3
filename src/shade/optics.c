/* SPDX-License-Identifier: MIT */
/*
 * Reflection and refraction at the water's surface [F1]-[F4], absorption in the water, and
 * the tables of span stages: constant tables, and tables computed in integers when a
 * number of the scene changes.
 *
 * Grazing light needs no special case.  With ci = -N.I the refracted ray T = eta I + (eta
 * ci - ct) N has |T|^2 = eta^2 + ct^2 - eta^2 ci^2 = 1 and N.T = -ct <= -0.66 for either
 * sign of ci: T is always a unit vector into the water.
 *
 * The absorption rate of a tint is in halvings of light per metre, from the binary
 * logarithm of each channel over the distance at which the tint is reached.
 */
#include "fixed/arithmetic.h"
#include "shade/optics.h"
#include "shade/shade.h"

#define INDEX    TP_Q30(TP_WATER_INDEX)
#define ETA      TP_Q30(TP_WATER_ETA)
#define ETA2     TP_Q30(0.562781355)
#define R0       TP_Q30(0.020373188)        /* (0.333 / 2.333)^2 */
#define Q60_ONE  ((int64_t)TP_Q30_ONE * TP_Q30_ONE)

static int32_t q30_round(int64_t q60)
{
    return (int32_t)((q60 + (1 << 29)) >> 30);
}

/* Cosine of the refracted ray, sqrt(1 - eta^2 (1 - c^2)), for |c| <= 1: 0.66..1. */
static tp_q30 cos_refracted(tp_q30 c)
{
    const tp_q30 s2 = q30_round(Q60_ONE - (int64_t)c * c);

    return (tp_q30)tp_isqrt64((uint64_t)(Q60_ONE - (int64_t)s2 * ETA2));
}

/* ((a - b) / (a + b))^2 for a, b in 0..1.333, a + b >= 0.66.  The sum in Q2.30 needs one
 * shift at most to reach the reciprocal's range; its inverse is then Q1.31. */
static tp_q30 fresnel_term(tp_q30 a, tp_q30 b)
{
    const uint32_t sum = (uint32_t)a + (uint32_t)b;
    const int      up = tp_clz(sum);
    const int64_t  part = (int64_t)(a - b) * tp_recip_norm(sum << up);  /* < 2^63 */
    const tp_q30   r = (tp_q30)((part + ((int64_t)1 << (32 - up))) >> (33 - up));

    return tp_q30_mul(r, r);
}

tp_q30 tp_fresnel(tp_q30 cos_i)
{
    const tp_q30 c = tp_clamp(cos_i, 0, TP_Q30_ONE), ct = cos_refracted(c);

    const tp_q30 rs = fresnel_term(c, tp_q30_mul(INDEX, ct));
    const tp_q30 rp = fresnel_term(ct, tp_q30_mul(INDEX, c));

    return (tp_q30)(((uint32_t)rs + (uint32_t)rp + 1) >> 1);   /* both are 1 at grazing */
}

tp_q30 tp_fresnel_schlick(tp_q30 cos_i)
{
    const tp_q30 m = TP_Q30_ONE - tp_clamp(cos_i, 0, TP_Q30_ONE), m2 = tp_q30_mul(m, m);

    return R0 + tp_q30_mul(TP_Q30_ONE - R0, tp_q30_mul(tp_q30_mul(m2, m2), m));
}

/* Returns the clamped dot product: unit vectors are rounded, and their dot product may
 * exceed 1 by a few LSB. */
static tp_q30 cosine_clamped_to_magnitude_1(tp_dir3 a, tp_dir3 b)
{
    return tp_clamp(tp_dir3_dot(a, b), -TP_Q30_ONE, TP_Q30_ONE);
}

/* in a + normal b, rounded once: |in a| + |normal b| <= 2^60 + 2^61. */
static tp_dir3 weighted_sum(tp_dir3 in, tp_q30 a, tp_dir3 normal, int64_t b)
{
    return (tp_dir3){ q30_round((int64_t)in.x * a + normal.x * b),
                      q30_round((int64_t)in.y * a + normal.y * b),
                      q30_round((int64_t)in.z * a + normal.z * b) };
}

tp_dir3 tp_reflect(tp_dir3 incident, tp_dir3 normal)
{
    return weighted_sum(incident, TP_Q30_ONE, normal,
                        -2 * (int64_t)cosine_clamped_to_magnitude_1(incident, normal));
}

tp_dir3 tp_refract(tp_dir3 incident, tp_dir3 normal)
{
    const tp_q30 ci = -cosine_clamped_to_magnitude_1(incident, normal);
    const int64_t lean = (int64_t)tp_q30_mul(ETA, ci) - cos_refracted(ci);

    return weighted_sum(incident, ETA, normal, lean);
}

/* depth a / b, rounded half up, b > 0; |depth a| <= 2^31 2^30.01. */
static tp_fx depth_times_ratio(tp_fx depth, tp_q30 a, tp_q30 b)
{
    const int64_t way = (int64_t)depth * a;
    int64_t q = way / b, rest = way % b;

    if (rest < 0) {
        q--;                            /* C rounds towards 0; this rounds down ... */
        rest += b;
    }
    q += rest >= b - rest;              /* ... and halves up */
    return tp_fx_saturate(q);
}

static tp_fx infinite_offset(tp_q30 a)
{
    return a > 0 ? TP_FX_MAX : a < 0 ? TP_FX_MIN : 0;
}

tp_floor_offset tp_refract_offset(tp_dir3 refracted, tp_fx depth)
{
    if (refracted.y >= 0)
        return (tp_floor_offset){ infinite_offset(refracted.x),
                                  infinite_offset(refracted.z) };
    return (tp_floor_offset){ depth_times_ratio(depth, refracted.x, -refracted.y),
                              depth_times_ratio(depth, refracted.z, -refracted.y) };
}

/* -- absorption ---------------------------------------------------------------------- */

const uint16_t tp_absorb_fall[65] = {
#include "shade/fall_table.inc"
};

/* log2(n) of 1 <= n < 2^16, Q16.  Each squaring of the mantissa yields one binary digit. */
static uint32_t log2_q16(uint32_t n)
{
    int      zeros = tp_clz(n);
    uint32_t digits = (uint32_t)(31 - zeros);
    uint64_t m = (uint64_t)n << zeros;                  /* Q1.31 */

    for (int i = 0; i < 16; i++) {
        m = m * m >> 31;
        digits = digits << 1 | (uint32_t)(m >> 32);
        m >>= m >> 32;
    }
    return digits;
}

/* Sets the halvings per metre, Q16.16.  A channel halves at most 9 times over `clear`
 * metres, because a channel of 0 counts as 1/512.  At the least `clear`, 1/65536 m, the
 * rate is below 2^36; rates beyond 32 bits saturate. */
void tp_absorb_init(tp_absorb *absorb, uint32_t tint, tp_fx clear)
{
    for (int k = 0; k < 3; k++) {
        uint32_t channel = tint >> (16 - 8 * k) & 0xff;
        uint64_t whole = 9 * 65536 - log2_q16(2 * channel + 1);
        uint64_t rate = (whole << 16) / (uint32_t)(clear > 0 ? clear : 1);
        absorb->halvings[k] = rate < UINT32_MAX ? (uint32_t)rate : UINT32_MAX;
    }
}

/* -- tables of span stages ----------------------------------------------------------- */

const tp_entry16 tp_steep_table[TP_STEEP + 1] = {
#include "shade/steep_table.inc"
};

const tp_entry8 tp_fresnel_table[257] = {
#include "shade/fresnel_table.inc"
};

const tp_entry8 tp_schlick_table[257] = {
#include "shade/schlick_table.inc"
};

const uint8_t tp_drop_gloss[TP_GLOSS] = {
#include "shade/gloss_table.inc"
};

/* Returns base^n for base in 0..1, Q2.30, by repeated squaring. */
static tp_q30 power(tp_q30 base, uint32_t n)
{
    TP_ASSERT(base >= 0 && base <= TP_Q30_ONE);
    tp_q30 result = TP_Q30_ONE;

    for (; n; n >>= 1) {
        if (n & 1)
            result = tp_q30_mul(result, base);
        base = tp_q30_mul(base, base);
    }
    return result;
}

static uint32_t exponent(tp_fx shininess)
{
    return (uint32_t)tp_clamp(shininess >> 16, 1, 1000);
}

/* Blinn's lobe (N.H)^(4 n) [F5] as a function of c = 2 (N.H)^2 - 1: ((1 + c) / 2)^(2 n). */
static tp_q30 blinn_lobe_double_angle(tp_q30 cos_double, uint32_t n)
{
    return power(cos_double / 2 + TP_Q30_ONE / 2, 2 * n);
}

/* Converts a lobe value of 0..1 into a table entry, scaled by the strength. */
static uint16_t shine_entry(tp_q30 lobe, tp_fx strength)
{
    return (uint16_t)(tp_fx_mul(lobe >> 14, strength) >> 8);
}

/* Fills the table from its end.  Rounded products of falling numbers do not rise, so all
 * entries before a 0 are 0. */
TP_ALWAYS_INLINE void fill_shine(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess,
                                 tp_fx strength, int blinn)
{
    const uint32_t n = exponent(shininess);
    int32_t i = TP_SHINE;

    TP_ASSERT(shine != NULL && strength >= 0);
    for (; i >= 0; i--) {
        const tp_q30 c = i * (TP_Q30_ONE / TP_SHINE);
        shine[i] = shine_entry(blinn ? blinn_lobe_double_angle(c, n) : power(c, n), strength);
        if (shine[i] == 0)
            break;
    }
    for (; i >= 0; i--)
        shine[i] = 0;
}

void tp_shade_shine(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess, tp_fx strength)
{
    fill_shine(shine, shininess, strength, 0);
}

void tp_shade_shine_blinn(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess, tp_fx strength)
{
    fill_shine(shine, shininess, strength, 1);
}

void tp_shade_gloss(uint8_t gloss[TP_GLOSS], tp_fx shininess)
{
    for (int32_t i = 0; i < TP_GLOSS; i++)
        gloss[i] = (uint8_t)(power(i * (TP_Q30_ONE / (TP_GLOSS - 1)),
                                   exponent(shininess)) >> 22);
}

void tp_shade_gloss_blinn(uint8_t gloss[TP_GLOSS], tp_fx shininess)
{
    for (int32_t i = 0; i < TP_GLOSS; i++)
        gloss[i] = (uint8_t)(blinn_lobe_double_angle(i * (TP_Q30_ONE / (TP_GLOSS - 1)),
                                   exponent(shininess)) >> 22);
}
