/* SPDX-License-Identifier: MIT */
/* Rings of droplets, [A4] [A5] of the models.
 *
 * tp_ring_evaluate computes the terms that do not depend on the point (age, crest,
 * decay) once a picture, including all divisions.  At a point most rings cost one
 * comparison of x.  For the others squared distances decide, in 64 bits.  The few
 * rings with the point in their band cost two reciprocal roots.  1 / rho gives the
 * distance and the direction.  q = 1 / sqrt(rho + rho0) gives the spreading s =
 * sqrt(rho0) q and its slope: s^3 / (2 rho0) = s q^2 / 2. */
#include <stdbool.h>
#include "base/base.h"
#include "tidepool/world.h"
#include "waves/deep_water.h"
#include "waves/softfloat.h"

#define REACH       (16384 * TP_FX_ONE)     /* largest radius: squares fit 2^61 */
#define DECAYS      20                      /* 4 m x exp(-20) is below half of 2^-24 */
#define SLOPE_MOST  134049956               /* 7.99, Q8.24 */
#define PI_Q20      3294199

static bool is_in_range(tp_fx x, tp_fx low, tp_fx high)
{
    return x >= low && x <= high;
}

bool tp_ring_is_valid(const tp_ring *ring)
{
    return is_in_range(ring->amplitude, 0, TP_FX(4))
           && is_in_range(ring->length, TP_FX(0.02), TP_FX(64))
           && is_in_range(ring->speed, TP_FX(0.01), TP_FX(64))
           && is_in_range(ring->decay, TP_FX(0.05), TP_FX(1000))
           && is_in_range(ring->spread, TP_FX(0.01), TP_FX(1000))
           && is_in_range(ring->attack, 0, TP_FX(8));
}

/* -- once a picture ------------------------------------------------------------------ */

/* Returns ticks x 65536 since the impact. */
static int64_t ring_age(const tp_ring *ring, int64_t now)
{
    return (int64_t)((uint64_t)now - (uint64_t)ring->start);
}

/* True if the age exceeds DECAYS: nothing is left.  Younger ages are < 1200 x 2^26 <
 * 2^37. */
static bool has_faded(const tp_ring *ring, int64_t age)
{
    return age >= (int64_t)DECAYS * TP_TICKS_PER_SECOND * ring->decay;
}

/* Returns c a: speed < 2^22.1, and the product has 60 bits.  Converts Q32 x
 * seconds x 60 to Q24. */
static int64_t rear_radius_q24(const tp_ring *ring, int64_t age)
{
    const int64_t over = TP_TICKS_PER_SECOND << 8;
    return ((int64_t)ring->speed * age + over / 2) / over;
}

/* Returns exp(-a / tau), Q0.30; a / tau < DECAYS. */
static tp_q30 decay_factor(const tp_ring *ring, int64_t age)
{
    uint64_t over = (uint64_t)TP_TICKS_PER_SECOND * (uint32_t)ring->decay;
    return tp_exp_neg_q30((uint32_t)((((uint64_t)age << 24) + over / 2) / over));
}

/* Returns smoothstep(a / tr) = t^2 (3 - 2 t), Q2.30. */
static tp_q30 attack_factor(const tp_ring *ring, int64_t age)
{
    int64_t whole = (int64_t)TP_TICKS_PER_SECOND * ring->attack;   /* < 2^25.1 */

    if (age >= whole)
        return TP_Q30_ONE;
    int64_t t = (age << 30) / whole;
    int64_t square = t * t >> 30;
    return (tp_q30)(square * (3 * (int64_t)TP_Q30_ONE - 2 * t) >> 30);
}

/* Returns A0 times a share: 16.16 and Q2.30 to Q8.24. */
static int32_t scale_ring_amplitude(const tp_ring *ring, tp_q30 share)
{
    return (int32_t)(((int64_t)ring->amplitude * share + (1 << 21)) >> 22);
}

bool tp_ring_evaluate(const tp_ring *ring, int64_t now, tp_ring_now *at)
{
    TP_ASSERT(ring->length > 0 && ring->decay > 0 && ring->attack >= 0);
    int64_t age = ring_age(ring, now);

    if (age <= 0 || has_faded(ring, age))
        return false;
    int64_t rear = rear_radius_q24(ring, age);
    int64_t outer = ((rear + 255) >> 8) + ring->length;
    int32_t gain = scale_ring_amplitude(
        ring, tp_q30_mul(decay_factor(ring, age), attack_factor(ring, age)));
    if (outer >= REACH || gain <= 0)
        return false;

    uint64_t turns = (((uint64_t)1 << 48) + (uint32_t)ring->length / 2)
                   / (uint32_t)ring->length;                    /* < 2^38 */
    *at = (tp_ring_now){
        .x = ring->x, .z = ring->z,
        .outer = (tp_fx)outer,
        .gain_q24 = gain,
        .inner2 = (rear >> 8) * (rear >> 8),
        .outer2 = outer * outer,
        .rear_q24 = rear,
        .turns_q32 = (int64_t)turns,
        .steep_q22 = (uint32_t)((turns * PI_Q20 + (1 << 29)) >> 30),
        .root_q24 = tp_isqrt64((uint64_t)(uint32_t)ring->spread << 32),
        .length = ring->length,
        .spread = ring->spread,
    };
    return true;
}

/* -- at a point ---------------------------------------------------------------------- */

/* Normalised inverse square root of x > 0: n is x shifted up, r is 1 / sqrt(n / 2^32) as
 * Q1.31 in [1, 2], `half` is half of the shift: sqrt(x) = sqrt(n / 2^32) 2^(32 - half). */
typedef struct {
    uint32_t n, r;
    int      half;
} inverse_root;

static inline inverse_root make_inverse_root(uint64_t x)
{
    uint32_t high = (uint32_t)(x >> 32);
    int      half = (high ? tp_clz(high) : 32 + tp_clz((uint32_t)x)) >> 1;
    uint32_t n = (uint32_t)(x << 2 * half >> 32);

    return (inverse_root){ n, tp_rsqrt_norm(n), half };
}

/* Returns s(rho) = sqrt(rho0 / (rho0 + rho)), Q2.30, and the share of s that is lost per
 * metre, -s'/s = 1 / (2 (rho0 + rho)), Q.22.  The sum is 2^17 to 2^39 in Q24, and `half`
 * is 12 to 23: no shift is negative. */
static inline tp_q30 spreading_factor(const tp_ring_now *ring, int64_t rho_q24,
                                      int32_t *loss_per_m_q22)
{
    const int64_t sum = rho_q24 + (int64_t)ring->spread * 256;
    TP_ASSERT(sum >> 17 > 0 && sum >> 39 == 0);
    inverse_root q = make_inverse_root((uint64_t)sum);
    uint64_t s = (uint64_t)ring->root_q24 * q.r >> (45 - q.half);

    *loss_per_m_q22 = (int32_t)((uint64_t)q.r * q.r >> 32 >> (49 - 2 * q.half));
    return s < TP_Q30_ONE ? (tp_q30)s : TP_Q30_ONE;
}

typedef struct {
    int64_t height, slope_x, slope_z;       /* Q.24 */
} ring_sums;

/* Adds a ring at (dx, dz) from the centre, 16.16; d2 is the squared
 * distance, 0 < d2 < 2^60. */
static void add_ring(ring_sums *sum, const tp_ring_now *ring, int32_t dx, int32_t dz,
                     uint64_t d2)
{
    TP_ASSERT(d2 > 0 && d2 >> 60 == 0);
    inverse_root over = make_inverse_root(d2);
    int64_t rho = (int64_t)((uint64_t)over.n * over.r >> (23 + over.half));
    int64_t way = rho - ring->rear_q24;            /* 0 at the rear, L at the front */

    if (way <= 0 || way >= (int64_t)ring->length * 256)
        return;                             /* the squares were rounded outwards */
    tp_turn turns = (tp_turn)((uint64_t)(way * ring->turns_q32) >> 24);
    int32_t loss_per_m;
    tp_q30  s = spreading_factor(ring, rho, &loss_per_m);
    tp_q30  w = (tp_q30)(((int64_t)TP_Q30_ONE - tp_cos(turns)) >> 1);
    int64_t high = ((int64_t)ring->gain_q24 * s + (1 << 29)) >> 30;
    /* s W' - s^3 W / (2 rho0) over s, Q22: pi / L < 2^29.3, the rest < 2^28. */
    int64_t steep = ((int64_t)ring->steep_q22 * tp_sin(turns)
                     - (int64_t)loss_per_m * w) >> 30;
    int64_t slope = tp_clamp_abs((high * steep + (1 << 21)) >> 22, SLOPE_MOST);
    /* Divides by rho: d r < 2^62, and 2^(33 - half) turns the product into a Q2.30
     * of magnitude <= 1. */
    int     down = 33 - over.half;
    int64_t round = (int64_t)1 << (down - 1);

    sum->height += (high * w + (1 << 29)) >> 30;
    sum->slope_x += (slope * ((dx * (int64_t)over.r + round) >> down) + (1 << 29)) >> 30;
    sum->slope_z += (slope * ((dz * (int64_t)over.r + round) >> down) + (1 << 29)) >> 30;
}

static tp_fx round_q24_to_fx(int64_t q24)
{
    return tp_fx_saturate((q24 + 128) >> 8);
}

tp_height_slope tp_ring_height_slope(const tp_ring_now *rings, uint32_t count, tp_fx x,
                                     tp_fx z)
{
    ring_sums sum = { 0, 0, 0 };

    for (uint32_t i = 0; i < count; i++) {
        const tp_ring_now *ring = &rings[i];
        int64_t dx = (int64_t)x - ring->x, dz = (int64_t)z - ring->z;
        if (dx >= ring->outer || dx <= -ring->outer
            || dz >= ring->outer || dz <= -ring->outer)
            continue;
        int64_t d2 = dx * dx + dz * dz;
        if (d2 > ring->inner2 && d2 < ring->outer2)
            add_ring(&sum, ring, (int32_t)dx, (int32_t)dz, (uint64_t)d2);
    }
    return (tp_height_slope){ round_q24_to_fx(sum.height), round_q24_to_fx(sum.slope_x),
                              round_q24_to_fx(sum.slope_z) };
}

/* -- the end of a ring --------------------------------------------------------------- */

bool tp_ring_is_spent(const tp_ring *ring, int64_t now, tp_fx max_distance)
{
    int64_t age = ring_age(ring, now);

    if (age <= 0)
        return false;
    if (has_faded(ring, age))
        return true;
    int64_t rear = rear_radius_q24(ring, age);
    if ((rear >> 8) > max_distance || (rear >> 8) + ring->length >= REACH)
        return true;
    tp_ring_now at = {
        .root_q24 = tp_isqrt64((uint64_t)(uint32_t)ring->spread << 32),
        .spread = ring->spread,
    };
    int32_t loss_per_m;
    tp_q30  s = spreading_factor(&at, rear + (int64_t)ring->length * 128, &loss_per_m);
    return tp_q30_mul(scale_ring_amplitude(ring, decay_factor(ring, age)), s) < 1 << 8;
}
