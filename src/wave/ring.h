/* SPDX-License-Identifier: MIT */
/* Rings of droplets: one crest each that widens, decays and is gone, [A4] [A5].
 *
 * With age a, distance rho from the centre and the crest's radius rc = L/2 + c a,
 *     eta = A0 smoothstep(a / attack) exp(-a / decay) s(rho) W(rho - rc),
 *     W(xi) = (1 + cos(2 pi xi / L)) / 2 for |xi| < L/2, s = 1 / sqrt(1 + rho / spread):
 * a hill of one crest; its support never reaches the centre, so no cusp stands there. */
#ifndef TP_WAVE_RING_H
#define TP_WAVE_RING_H
#include <stdbool.h>
#include <stdint.h>
#include "fx/fx.h"

/* All 16.16 unless said. */
typedef struct {
    tp_fx   x, z;           /* centre, m */
    int64_t start;          /* ticks x 65536: impacts fall between ticks */
    tp_fx   amplitude;      /* A0, m, 0..4 */
    tp_fx   length;         /* L, m, 0.02..64 */
    tp_fx   speed;          /* c, m/s, 0.01..64 */
    tp_fx   decay;          /* tau, s, 0.05..1000 */
    tp_fx   spread;         /* rho0, m, 0.01..1000 */
    tp_fx   attack;         /* tr, s, 0..8 */
} tp_ring;

/* Whether all of its numbers are in these ranges. */
bool tp_ring_is_valid(const tp_ring *ring);

/* A ring at one moment, ready for many places. */
typedef struct {
    tp_fx    x, z;
    tp_fx    outer;             /* rc + L/2, m, below 16384 */
    int32_t  gain_q24;          /* A0 smoothstep exp: heights of 0.1 mm keep 4 digits */
    int64_t  inner2, outer2;    /* squares of rc - L/2 and rc + L/2, Q32.32 */
    int64_t  rear_q24;          /* rc - L/2, m */
    int64_t  turns_q32;         /* 1 / L: turns per metre */
    uint32_t steep_q22;         /* pi / L */
    uint32_t root_q24;          /* sqrt(rho0) */
    tp_fx    length;            /* L */
    tp_fx    spread;            /* rho0 */
} tp_ring_now;

/* `now` ticks x 65536.  False: the ring has not begun, or adds nothing, or has run
 * 16384 m. */
bool tp_ring_at(const tp_ring *ring, int64_t now, tp_ring_now *at);

/* Whether it can be retired: its height A0 exp(-a / decay) s(rc) is below 1/65536 m, or
 * its rear has gone `beyond` metres (16.16) from its centre, or its front 16384 m.  A
 * ring that has not begun is not spent. */
bool tp_ring_spent(const tp_ring *ring, int64_t now, tp_fx beyond);

/* The sum of `count` rings above the world's (x, z).  Two reciprocal roots a ring whose
 * band holds the place, a compare or two for the others; no division.  Each ring's slope
 * is held within +-7.99. */
tp_relief tp_ring_relief(const tp_ring_now *rings, uint32_t count, tp_fx x, tp_fx z);
#endif
