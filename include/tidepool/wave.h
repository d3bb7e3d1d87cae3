/* SPDX-License-Identifier: MIT */
/* Swells of the open sea: sines, sharpened sines and Gerstner waves in any mixture,
 * [A1]-[A3] and [A7]-[A11] of the models.
 *
 * A point of still water at rest (x0, z0) moves to
 *     x = x0 + sum QA Dx cos th,  y = sum A (f - mean),  z = z0 + sum QA Dz cos th,
 *     th = k (D . p0) - omega t + phase,  f = 2 ((sin th + 1) / 2)^power,
 * D the direction of travel, `mean` that of f over a turn; with power 1 f - mean is
 * sin th.  `steepness` is Q k A, so the sharpness of a crest is set apart from its
 * height.
 *
 * Any place that 16.16 names has an answer.  Its height and slopes are the place's own
 * everywhere; a position that waves would carry beyond 16.16 is held at its ends.  Against
 * exact arithmetic the phase of a wave is off by up to (|x| + |z|) (1.5e-9 + 1e-8 k)
 * radians, and its height by A times that: 0.3 mm at (30 km, 30 km) for A = 1 m and a
 * length of 20 m. */
#ifndef TP_WAVE_H
#define TP_WAVE_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/fx.h"
#include "tidepool/language.h"

TP_BEGIN_C

#define TP_WAVES 16
#define TP_TICKS_PER_SECOND 60      /* the clock of everything that moves */

/* A wave as a person gives it. */
typedef struct {
    tp_fx amplitude;        /* m, 0..16: half the height from trough to crest */
    tp_fx length;           /* m, 0.25..2000 */
    tp_fx steepness;        /* Q k A, 0..1; 0 is a plain sine */
    tp_fx heading;          /* degrees, clockwise from -z: where the wave travels to */
    tp_fx phase;            /* degrees at tick 0 */
    tp_fx speed;            /* of its natural speed sqrt(g/k); 0 stands still */
    int32_t power;          /* 1..8: 1 is a sine, more sharpen its crests [A3]; 0 is 1 */
} tp_wave;

/* A wave in the models' own letters, with all the bits that the core keeps. */
typedef struct {
    uint64_t turns;         /* k / 2 pi: turns per metre, Q0.32; 1/2000 to 4 of them */
    tp_q30   dx, dz;        /* D, a unit vector */
    tp_fx    amplitude;     /* m, A, 0..16 */
    tp_q30   steepness;     /* Q k A, 0..1 */
    uint64_t turns_tick;    /* omega dt / 2 pi: turns per tick, Q0.64 */
    tp_turn  phase;         /* at tick 0 */
    int32_t  power;         /* 0..8, 0 is 1 */
} tp_wave_exact;

/* The same as the core evaluates it. */
typedef struct {
    int64_t  turns_x, turns_z;  /* k D / 2 pi: turns per metre, Q0.32 */
    uint64_t turns_tick;        /* omega dt / 2 pi: turns per tick, Q0.64, wraps */
    uint64_t turns;             /* k / 2 pi, Q0.32 */
    tp_turn  phase;
    tp_fx    amplitude;         /* A */
    tp_fx    reach_x, reach_z;  /* QA Dx, QA Dz */
    tp_q30   slope_x, slope_z;  /* k A Dx, k A Dz; the cap keeps them below 1.9 */
    tp_q30   bend_xx, bend_xz, bend_zz; /* QkA Dx^2, QkA Dx Dz, QkA Dz^2 */
    tp_q30   bend;              /* QkA */
    tp_fx    tilt;              /* no less than kA f' */
    int32_t  power;             /* 1..8 */
    int32_t  mean_q24;          /* of f [A3] */
} tp_swell;

typedef struct {
    uint32_t count;             /* waves of amplitude 0 are left out */
    tp_fx    height;            /* no point is higher or lower */
    tp_fx    reach;             /* sum QA: no point is farther from its rest */
    tp_fx    steepness;         /* sum QkA as asked for */
    tp_q30   bend;              /* sum QkA as it is, <= 0.95 */
    tp_fx    twist;             /* bounds what the cross terms of [A10] add to a slope */
    bool     clamped;           /* it was above 0.95 and every Q was scaled down [A11] */
    bool     capped;            /* some amplitude was above 0.3 of its length, and cut */
    bool     sharpened;         /* some power is above 1 */
    bool     crossed;           /* normals are made with the cross terms of [A10] */
    tp_swell swell[TP_WAVES];   /* the last: worlds without swells end before it */
} tp_sea;

/* gravity in m/s^2. */
void tp_sea_init(tp_sea *sea, const tp_wave *waves, uint32_t count, tp_fx gravity);

/* The same of a sea that ends after as many swells as there are amplitudes above 0. */
void tp_sea_init_few(tp_sea *sea, const tp_wave *waves, uint32_t count, tp_fx gravity);

/* Adds a wave to a sea, at first one that is all 0.  Amplitudes are cut as in
 * tp_sea_init; what the sum of steepnesses would have above 0.95 is taken from this wave
 * alone.  Beyond TP_WAVES waves, or without amplitude, nothing is added. */
void tp_sea_add(tp_sea *sea, const tp_wave_exact *wave);

/* The phases of all swells, phase - omega t, `back` of a tick (0..1) before one. */
void tp_sea_phases(const tp_sea *sea, uint64_t tick, tp_fx back,
                   tp_turn phases[TP_WAVES]);

typedef struct {
    tp_vec3 position;           /* of the displaced point, m */
    tp_fx   slope_x, slope_z;   /* dy/dx and dy/dz there, +-7.99 */
} tp_sea_point;

/* The point whose place at rest is (x0, z0).  Normals are exact [A10] where the sea is
 * `crossed`: with a steepness sum above 0.3, or where the form without cross terms could
 * be 1.5 degrees off.  It is exact for sines and for one wave alone.
 *
 * The formats turn the normal by at most
 *     hypot(H, B) / (1 - q) + 1.1e-5 radians,
 *     H = sum k A n (n + 1) / 2 e,  B = sum Q k A e,  e = 5e-6 + p,
 * q the sum of Q k A as it is, n the wave's power, p the phase's error as above; an
 * amplitude that was cut adds k 2^-17 to H.  One wave with Q = 1 [A8] and the steepness
 * S = k A keeps
 *     (2.5e-6 + S p) / (1 - S) + 1.1e-5:
 * for S = 0.93 0.0027 degrees at the origin, and 0.02 degrees from |x| + |z| = 430 m on
 * where the length is 1.25 m, from 8.9 km on where it is 60 m. */
tp_sea_point tp_sea_at_rest(const tp_sea *sea, const tp_turn phases[TP_WAVES],
                            tp_fx x0, tp_fx z0);

/* The surface above or below the world's (x, z) [E1], inverted with at most 8
 * evaluations, from anywhere and on every legal sea: within 30 km of the origin, each way,
 * along within 0.05 mm, so up within that times the slope.  Farther out that holds until
 * the place's waves reach the ends of 16.16, 600 m before them at the most; there the
 * search stays within 16.16, and `position` tells where it ended.  `rest`, if not NULL, is
 * where the search begins (any place; the last tick's is good) and then the place that it
 * found, whose point by tp_sea_at_rest this is. */
tp_sea_point tp_sea_above(const tp_sea *sea, const tp_turn phases[TP_WAVES],
                          tp_fx x, tp_fx z, tp_fx rest[2]);

/* The n-th plain step of [E1] towards the same, from p0 = (x, z), which is step 0:
 * p0 <- p0 + (p - P(p0)).  It is q^n of the first distance off at the most, q the sum of
 * steepnesses.  Places are held at the ends of 16.16. */
tp_sea_point tp_sea_iterate(const tp_sea *sea, const tp_turn phases[TP_WAVES],
                            tp_fx x, tp_fx z, uint32_t n);

/* A surface known by heights alone, [A6]: `around` holds those at x - spacing,
 * x + spacing, z - spacing and z + spacing.  One that is missing at a wall is mirrored in
 * it: the opposite neighbour's where grid points lie on the wall, the middle's own where
 * the wall lies half a spacing beyond.  |height| < 8192 m, 0 < spacing < 8192 m; slopes
 * saturate. */
tp_relief tp_five_heights(tp_fx middle, const tp_fx around[4], tp_fx spacing);
tp_dir3   tp_five_normal(const tp_fx around[4], tp_fx spacing);

TP_END_C
#endif
