/* SPDX-License-Identifier: MIT */
/* Rings of droplets: a ring is a single crest that widens, decays and ends, [A4] [A5].
 *
 * With age a, distance rho from the centre and crest radius rc = L/2 + c a,
 *     eta = A0 smoothstep(a / attack) exp(-a / decay) s(rho) W(rho - rc),
 *     W(xi) = (1 + cos(2 pi xi / L)) / 2 for |xi| < L/2, s = 1 / sqrt(1 + rho / spread):
 * a hill of one crest.  The support of W never reaches the centre, and the
 * centre has no cusp. */
#ifndef TP_WAVES_RING_H
#define TP_WAVES_RING_H
#include <stdbool.h>
#include <stdint.h>
#include "fixed/arithmetic.h"

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
