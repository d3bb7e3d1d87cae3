/* SPDX-License-Identifier: MIT */
/*
 * Waves of deep water: swells, and the rings of droplets.
 *
 * Swells are sines, sharpened sines and Gerstner waves in any mixture, [A1]-[A3] and
 * [A7]-[A11] of the models.  A rest point (x0, z0) of still water moves to
 *     x = x0 + sum QA Dx cos th,  y = sum A (f - mean),  z = z0 + sum QA Dz cos th,
 *     th = k (D . p0) - omega t + phase,  f = 2 ((sin th + 1) / 2)^power,
 * D the direction of travel, `mean` the mean of f over a turn; with power 1 f - mean is sin
 * th.  `steepness` is Q k A: the sharpness of a crest is independent of its height.
 *
 * All points of 16.16 are valid.  Height and slopes are correct everywhere; a position that
 * waves would carry beyond 16.16 is clamped to the range.  Against exact arithmetic the
 * phase of a wave is off by up to (|x| + |z|) (1.5e-9 + 1e-8 k) radians, and its height by
 * A times this error: 0.3 mm at (30 km, 30 km) for A = 1 m and a length of 20 m.
 */
#ifndef TP_WAVES_DEEP_WATER_H
#define TP_WAVES_DEEP_WATER_H
#include <stdbool.h>
#include <stdint.h>
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "tidepool/scene.h"
#include "tidepool/world.h"

/* A wave in the symbols of the models, with full precision. */
typedef struct {
    uint64_t turns;         /* k / 2 pi, turns per metre, Q0.32; 1/2000 to 4 turns per
                             * metre */
    tp_q30   dx, dz;        /* D, a unit vector */
    tp_fx    amplitude;     /* A, m, 0..16 */
    tp_q30   steepness;     /* Q k A, 0..1 */
    uint64_t turns_tick;    /* omega dt / 2 pi, turns per tick, Q0.64 */
    tp_turn  phase;         /* phase at tick 0 */
    int32_t  power;         /* 0..8; 0 counts as 1 */
} tp_wave_exact;

/* The same wave in the form of the evaluation. */
typedef struct {
    int64_t  turns_x, turns_z;  /* k D / 2 pi: turns per metre, Q0.32 */
    uint64_t turns_tick;        /* omega dt / 2 pi: turns per tick, Q0.64, wraps */
    uint64_t turns;             /* k / 2 pi, Q0.32 */
    tp_turn  phase;
    tp_fx    amplitude;         /* A, m */
    tp_fx    orbit_x, orbit_z;  /* QA Dx, QA Dz, m */
    tp_q30   slope_x, slope_z;  /* k A Dx, k A Dz; the amplitude cap keeps both below 1.9 */
    tp_q30   bend_xx, bend_xz, bend_zz; /* QkA Dx^2, QkA Dx Dz, QkA Dz^2 */
    tp_q30   bend;              /* QkA */
    tp_fx    tilt;              /* an upper bound of kA f' */
    int32_t  power;             /* 1..8 */
    int32_t  mean_q24;          /* mean of f [A3] */
} tp_swell;

typedef struct {
    uint32_t count;             /* number of swells; amplitudes of 0 are left out */
    tp_fx    height;            /* bound of |y| of all points, m */
    tp_fx    max_displacement;  /* sum QA: bound of the horizontal displacement, m */
    tp_fx    steepness;         /* sum QkA as configured */
    tp_q30   steepness_sum;     /* sum QkA after the clamp, <= 0.95 */
    tp_fx    cross_term_bound;  /* bound of the slope added by the cross terms of [A10] */
    bool     clamped;           /* true if the sum was above 0.95; all Q are
                                 * scaled down [A11] */
    bool     capped;            /* true if an amplitude was above 0.3 of its length, and
                                 * cut */
    bool     sharpened;         /* true if a power is above 1 */
    bool     crossed;           /* true if normals use the cross terms of [A10] */
    tp_swell swell[TP_WAVES];   /* last field: the memory may end after `count` swells */
} tp_deep_water;

/* Makes deep water from `count` waves; gravity in m/s^2. */
void tp_deep_water_init(tp_deep_water *deep, const tp_wave *waves, uint32_t count,
                        tp_fx gravity);

/* The same in less memory: the struct ends after the last swell of amplitude above 0. */
void tp_deep_water_init_compact(tp_deep_water *deep, const tp_wave *waves, uint32_t count,
                                tp_fx gravity);

/* Appends a wave to the swells of deep water; deep water without waves is all 0.  The
 * amplitude is cut as in tp_deep_water_init.  If the steepness sum would exceed 0.95, the
 * steepness of this wave alone is reduced.  Deep water of TP_WAVES waves takes no more,
 * and a wave without amplitude is ignored. */
void tp_deep_water_append_wave(tp_deep_water *deep, const tp_wave_exact *wave);

/* Returns the phases of all swells, phase - omega t, at `lag` of a tick
 * (0..1) before `tick`. */
void tp_deep_water_phases(const tp_deep_water *deep, uint64_t tick, tp_fx lag,
                          tp_turn phases[TP_WAVES]);

typedef struct {
    tp_vec3 position;           /* displaced point, m */
    tp_fx   slope_x, slope_z;   /* dy/dx and dy/dz at the point, +-7.99 */
} tp_surface_point;

/* Returns the displaced point of the rest point (x0, z0).  Normals are exact [A10] if
 * the deep water is `crossed`: the steepness sum is above 0.3, or the form without cross
 * terms could be 1.5 degrees off.  The form without cross terms is exact for sines and
 * for a single wave.
 *
 * The fixed-point formats turn the normal by at most
 *     hypot(H, B) / (1 - q) + 1.1e-5 radians,
 *     H = sum k A n (n + 1) / 2 e,  B = sum Q k A e,  e = 5e-6 + p,
 * q the sum of Q k A after the clamp, n the wave's power, p the error of the phase as
 * above; an amplitude that was cut adds k 2^-17 to H.  For one wave with Q = 1 [A8] and the
 * steepness S = k A the bound is
 *     (2.5e-6 + S p) / (1 - S) + 1.1e-5:
 * for S = 0.93 0.0027 degrees at the origin.  It reaches 0.02 degrees at |x| + |z| = 430 m
 * for a length of 1.25 m, and at 8.9 km for a length of 60 m. */
tp_surface_point tp_deep_water_displace_point(const tp_deep_water *deep,
                                              const tp_turn phases[TP_WAVES], tp_fx x0,
                                              tp_fx z0);

/* Returns the surface above or below the point (x, z) of the world [E1], inverted with at
 * most 8 evaluations, for any start and all legal waves.  Within 30 km of the origin on
 * each axis the horizontal error is below 0.05 mm, and the vertical error below 0.05 mm
 * times the slope.  Farther out the bound holds until the displacements reach the ends of
 * 16.16, at most 600 m before them.  There the search stays within 16.16, and `position`
 * tells where the search ended.  `rest`, if not NULL, holds the start of the search (any
 * point; the result of the last tick is a good start), and receives the rest point found.
 * The result is tp_deep_water_displace_point of this rest point. */
tp_surface_point tp_deep_water_sample(const tp_deep_water *deep,
                                      const tp_turn phases[TP_WAVES], tp_fx x, tp_fx z,
                                      tp_fx rest[2]);

/* Returns the n-th plain step of [E1] towards the same point, from p0 = (x, z), which is
 * step 0: p0 <- p0 + (p - P(p0)).  The distance left is at most q^n of the first distance,
 * q the sum of steepnesses.  Points are clamped to the range of 16.16. */
tp_surface_point tp_deep_water_sample_iterated(const tp_deep_water *deep,
                                               const tp_turn phases[TP_WAVES], tp_fx x,
                                               tp_fx z, uint32_t steps);

/* Returns Jxx Jzz - Jxz^2 of [A9] at a rest point, 16.16.  Below 1 the water is
 * compressed; at 0 the surface would fold.  `phases` are the phases of the tick. */
tp_fx tp_deep_water_jacobian(const tp_deep_water *deep, const tp_turn phases[TP_WAVES],
                             tp_fx x0, tp_fx z0);

/* -- slopes by central differences --------------------------------------------------- */

/* Slopes and normal of a surface known by heights alone, by central differences [A6].
 * `neighbours` holds the heights at x - spacing, x + spacing, z - spacing and z + spacing.
 * A height missing at a wall is mirrored.  If grid points lie on the wall, the caller
 * passes the height of the opposite neighbour.  If the wall lies half a spacing beyond, the
 * caller passes the height of the middle.  |height| < 8192 m, 0 < spacing < 8192 m; slopes
 * saturate. */
tp_height_slope tp_neighbour_height_slope(tp_fx middle, const tp_fx neighbours[4],
                                          tp_fx spacing);
tp_dir3 tp_neighbour_normal(const tp_fx neighbours[4], tp_fx spacing);

/* -- the sum, for grids -------------------------------------------------------------- */

/* The sum of swells, step by step, for code that evaluates many points: the grid adds one
 * wave at a time, with phases stored per row and column.
 *
 * Deep water states once which terms its points need: tp_deep_water.sharpened and
 * tp_deep_water.crossed.  The functions below take both flags as literals, and plain
 * deep water pays for neither. */

#define TP_SWELL_SLOPE_MAX TP_FX(7.99)

/* Sums of the terms of all swells.  Sines are Q8.24.  |A| <= 2^20 in 16.16, |QA| < 2^25,
 * also summed over all swells, slopes < 2^31 in Q2.30.  Profiles are below 2, their
 * derivatives below 2.5: products have at most 57 bits and sixteen of them 61. */
typedef struct {
    int64_t x, y, z;                    /* displacement, m, Q.40 */
    int64_t hx, hz;                     /* k A D f', Q.54 */
    int64_t bxx, bxz, bzz;              /* QkA D D sin th, Q.54; if not crossed, bxx is the
                                         * sum of QkA sin th and bxz, bzz are 0 */
} tp_swell_sum;

/* Returns k D x / 2 pi in turns: exact modulo a turn [G1]. */
static inline tp_turn tp_swell_turns(int64_t turns_per_metre, tp_fx x)
{
    return (tp_turn)((uint64_t)turns_per_metre * (uint64_t)(int64_t)x >> 16);
}

/* [A3]: returns f - mean and f', Q8.24, of a sine and cosine in Q2.30.  b = (s + 1)/2 and
 * its powers p are at most 2^30, f' = power p c is below 2.48: both products have 62
 * bits. */
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
TP_ALWAYS_INLINE void tp_swell_sum_add_swell(tp_swell_sum *sum, const tp_swell *w,
                                             tp_turn th, int sharpened, int crossed)
{
    const tp_q30 sine = tp_sin(th), cosine = tp_cos(th);
    int32_t s = sine >> 6, c = cosine >> 6, f = s, df = c;

    if (sharpened)
        tp_swell_sharpen(w, sine, cosine, &f, &df);
    sum->x  += (int64_t)w->orbit_x * c;
    sum->z  += (int64_t)w->orbit_z * c;
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

/* Returns the sum of all swells; the phase of each is a[i] + b[i]. */
TP_ALWAYS_INLINE tp_swell_sum tp_swell_sum_all(const tp_deep_water *deep,
                                               const tp_turn *phases_a,
                                               const tp_turn *phases_b, int sharpened,
                                               int crossed)
{
    tp_swell_sum sum = { 0 };

    for (uint32_t i = 0; i < deep->count; i++)
        tp_swell_sum_add_swell(&sum, &deep->swell[i], phases_a[i] + phases_b[i],
                               sharpened, crossed);
    return sum;
}

TP_ALWAYS_INLINE int64_t tp_swell_sum_fade(int64_t x, tp_fx fade)
{
    return fade == TP_FX_ONE ? x : (x >> 16) * fade;
}

/* Returns num / det as a slope.  num is Q.23; `inverse` is 2^62 over det, and det in Q4.28
 * was shifted up to 32 bits.  |num| < 2^7.2: 31 bits, and a product of 62 bits.  det >
 * 0.047: the quotient has 29 bits of Q.17.  One comparison finds the few slopes to
 * clamp. */
TP_ALWAYS_INLINE tp_fx tp_swell_sum_slope(int64_t num, int shift, int32_t inverse)
{
    const int32_t most = TP_SWELL_SLOPE_MAX;
    const int32_t slope = ((int32_t)(num * inverse >> (40 - shift)) + 1) >> 1;

    if ((uint32_t)(slope + most) > 2 * (uint32_t)most)
        return slope < 0 ? -most : most;
    return slope;
}

/* Returns the displaced point of the rest point (x0, z0), with the sum scaled by `fade`
 * (16.16, 0..1).  Slopes follow the head of deep_water.c; without cross terms the slope is
 * h / (1 - sum QkA sin th). */
TP_ALWAYS_INLINE tp_surface_point tp_swell_sum_point_inline(const tp_swell_sum *sum,
                                                            tp_fx x0, tp_fx z0,
                                                            tp_fx fade, int crossed)
{
    const int64_t half = (int64_t)1 << 23;
    const int32_t one = 1 << 28;                                    /* J is Q4.28 */
    int32_t hx = (int32_t)(tp_swell_sum_fade(sum->hx, fade) >> 30);      /* Q8.24 */
    int32_t hz = (int32_t)(tp_swell_sum_fade(sum->hz, fade) >> 30);
    int32_t jxx = one - (int32_t)(tp_swell_sum_fade(sum->bxx, fade) >> 26);
    int32_t jzz = one, bxz = 0, det = jxx;                          /* Jxz = -bxz */

    if (crossed) {
        jzz = one - (int32_t)(tp_swell_sum_fade(sum->bzz, fade) >> 26);
        bxz = (int32_t)(tp_swell_sum_fade(sum->bxz, fade) >> 26);
        det = (int32_t)(((int64_t)jxx * jzz - (int64_t)bxz * bxz) >> 28);
    }
    int     shift = tp_clz((uint32_t)det);
    int32_t inverse = (int32_t)(tp_recip_norm((uint32_t)det << shift) >> 1);
    int64_t nx = ((int64_t)hx + 1) >> 1, nz = ((int64_t)hz + 1) >> 1;

    if (crossed) {
        nx = ((int64_t)hx * jzz + (int64_t)hz * bxz + (1 << 28)) >> 29;
        nz = ((int64_t)hz * jxx + (int64_t)hx * bxz + (1 << 28)) >> 29;
    }
    return (tp_surface_point){
        .position = { tp_fx_add_sat(
                          x0, (tp_fx)((tp_swell_sum_fade(sum->x, fade) + half) >> 24)),
                      (tp_fx)((tp_swell_sum_fade(sum->y, fade) + half) >> 24),
                      tp_fx_add_sat(
                          z0, (tp_fx)((tp_swell_sum_fade(sum->z, fade) + half) >> 24)) },
        .slope_x = tp_swell_sum_slope(nx, shift, inverse),
        .slope_z = tp_swell_sum_slope(nz, shift, inverse),
    };
}

/* Returns the share of a wave that points `share` wavelengths apart hold [V4]: 1 up to 0.3,
 * 0 from 0.5 on. */
static inline tp_fx tp_swell_spacing_weight(int64_t share)
{
    if (share <= TP_FX(0.3))
        return TP_FX_ONE;
    return share >= TP_FX(0.5) ? 0 : tp_smoothstep((tp_fx)((TP_FX(0.5) - share) * 5));
}

/* Returns the gain of a wave for points `share` wavelengths apart, below 0.5.  Linear
 * interpolation between points of the wave lowers the wave by the mean of (k d)^2 / 12; the
 * gain 1 + (k d)^2 / 12 makes up for that.  The rms error of the interpolated wave falls
 * from 0.091 to 0.037 of (k d)^2: piecewise linear interpolation against the best piecewise
 * linear fit. */
static inline tp_fx tp_swell_spacing_gain(int64_t share)
{
    return TP_FX_ONE + (tp_fx)(share * share * 842 >> 24);      /* 256 (2 pi)^2 / 12 */
}

/* The same for a sum that has the cross terms, for any waves. */
tp_surface_point tp_swell_sum_point(const tp_swell_sum *sum, tp_fx x0, tp_fx z0,
                                    tp_fx fade);

/* [A3]: returns the largest A |f - mean|. */
tp_fx   tp_sharp_max_height(tp_fx amplitude, int32_t power);

/* -- rings --------------------------------------------------------------------------- */

/* Rings of droplets: a ring is a single crest that widens, decays and ends, [A4] [A5].
 *
 * With age a, distance rho from the centre and crest radius rc = L/2 + c a,
 *     eta = A0 smoothstep(a / attack) exp(-a / decay) s(rho) W(rho - rc),
 *     W(xi) = (1 + cos(2 pi xi / L)) / 2 for |xi| < L/2, s = 1 / sqrt(1 + rho / spread):
 * a hill of one crest.  The support of W never reaches the centre, and the
 * centre has no cusp. */

/* All fields are 16.16 unless noted. */
typedef struct {
    tp_fx   x, z;           /* centre, m */
    int64_t start;          /* time of impact, ticks x 65536: impacts fall between ticks */
    tp_fx   amplitude;      /* A0, m, 0..4 */
    tp_fx   length;         /* L, m, 0.02..64 */
    tp_fx   speed;          /* c, m/s, 0.01..64 */
    tp_fx   decay;          /* tau, s, 0.05..1000 */
    tp_fx   spread;         /* rho0, m, 0.01..1000 */
    tp_fx   attack;         /* tr, s, 0..8 */
} tp_ring;

/* True if all numbers of the ring are in these ranges. */
bool tp_ring_is_valid(const tp_ring *ring);

/* A ring at one moment, prepared for evaluation at many points. */
typedef struct {
    tp_fx    x, z;
    tp_fx    outer;             /* rc + L/2, m, below 16384 */
    int32_t  gain_q24;          /* A0 smoothstep exp, m: heights of 0.1 mm keep 4 digits */
    int64_t  inner2, outer2;    /* squares of rc - L/2 and rc + L/2, m2, Q32.32 */
    int64_t  rear_q24;          /* rc - L/2, m */
    int64_t  turns_q32;         /* 1 / L: turns per metre */
    uint32_t steep_q22;         /* pi / L */
    uint32_t root_q24;          /* sqrt(rho0) */
    tp_fx    length;            /* L */
    tp_fx    spread;            /* rho0 */
} tp_ring_now;

/* Prepares a ring for the time `now`, ticks x 65536.  Returns false if the ring has not
 * begun, has no height left, or has run 16384 m. */
bool tp_ring_evaluate(const tp_ring *ring, int64_t now, tp_ring_now *at);

/* True if the ring can be removed: its height A0 exp(-a / decay) s(rc) is below
 * 1/65536 m, or its rear is more than `max_distance` metres (16.16) from its centre,
 * or its front has run 16384 m.  A ring that has not begun returns false. */
bool tp_ring_is_spent(const tp_ring *ring, int64_t now, tp_fx max_distance);

/* Returns the sum of `count` rings at the point (x, z) of the world.  A ring with the point
 * in its band costs two reciprocal roots, any other ring a comparison or two; no division.
 * The slope of each ring is clamped to +-7.99. */
tp_height_slope tp_ring_height_slope(const tp_ring_now *rings, uint32_t count, tp_fx x,
                                     tp_fx z);

#endif
