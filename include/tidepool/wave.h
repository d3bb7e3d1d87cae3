/* SPDX-License-Identifier: MIT */
/* Gerstner waves: the surface as a sum of swells, [A7]-[A11] of the models.
 *
 * A point of still water at rest (x0, z0) moves to
 *     x = x0 + sum QA Dx cos th,  y = sum A sin th,  z = z0 + sum QA Dz cos th,
 *     th = k (D . p0) - omega t + phase,
 * D the direction of travel.  `steepness` is Q k A, so the sharpness of a crest is set
 * apart from its height. */
#ifndef TP_WAVE_H
#define TP_WAVE_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/fx.h"

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
} tp_wave;

/* The same as the core evaluates it. */
typedef struct {
    int64_t  turns_x, turns_z;  /* k D / 2 pi: turns per metre, Q0.32 */
    uint64_t turns_tick;        /* omega dt / 2 pi: turns per tick, Q0.64, wraps */
    tp_turn  phase;
    tp_fx    amplitude;         /* A */
    tp_fx    reach_x, reach_z;  /* QA Dx, QA Dz */
    tp_q30   slope_x, slope_z;  /* k A Dx, k A Dz; the cap keeps them below 1.9 */
    tp_q30   bend_xx, bend_xz, bend_zz; /* QkA Dx^2, QkA Dx Dz, QkA Dz^2 */
} tp_swell;

typedef struct {
    tp_swell swell[TP_WAVES];
    uint32_t count;             /* waves of amplitude 0 are left out */
    tp_fx    height;            /* sum A: no point is higher or lower */
    tp_fx    reach;             /* sum QA: no point is farther from its rest */
    tp_fx    steepness;         /* sum QkA as asked for */
    bool     clamped;           /* it was above 0.95 and every Q was scaled down [A11] */
    bool     capped;            /* some amplitude was above 0.3 of its length, and cut */
} tp_sea;

/* gravity in m/s^2. */
void tp_sea_init(tp_sea *sea, const tp_wave *waves, uint32_t count, tp_fx gravity);

/* The phases of all swells at a tick: phase - omega t. */
void tp_sea_phases(const tp_sea *sea, uint64_t tick, tp_turn phases[TP_WAVES]);

typedef struct {
    tp_vec3 position;           /* of the displaced point, m */
    tp_fx   slope_x, slope_z;   /* dy/dx and dy/dz there, exact [A10], +-7.99 */
} tp_sea_point;

/* The point whose place at rest is (x0, z0). */
tp_sea_point tp_sea_at_rest(const tp_sea *sea, const tp_turn phases[TP_WAVES],
                            tp_fx x0, tp_fx z0);

/* The surface above or below the world's (x, z) [E1]: inverted by fixed-point steps.
 * Error of the place <= q^n / (1 - q) of the displacement, q the steepness sum, n = 8. */
tp_sea_point tp_sea_above(const tp_sea *sea, const tp_turn phases[TP_WAVES],
                          tp_fx x, tp_fx z);
#endif
