/* SPDX-License-Identifier: MIT */
/* Tanks of the engine's pools that run by themselves, for the charts: how far off they
 * are, how they grow, when they rest and how far they drift.  r and damping are set by
 * hand, so tanks may be what nobody can configure.  The program ends if one cannot be
 * made. */
#ifndef POOL_RUNS_H
#define POOL_RUNS_H
#include "tests/charts/pool_rules.h"

typedef struct {
    tp_cells cells;
    uint32_t cols, rows;
    uint32_t r2q, m;                /* 1024 r^2, 0..767; damping 2^-m, 1..10 */
} pool_tank;

/* Still water between walls; cells of 1/4 m, heights within 1 m.  free() it. */
tp_pool *pool_tank_new(const pool_tank *tank);

/* A hat of sigma 4 cells and 100 / 127 m, somewhat off the middle. */
void pool_tank_drop(tp_pool *pool);

/* -- what is measured ---------------------------------------------------------------- */

/* The rms of what a drop's water is off the damped wave equation, of the rms that the
 * water has then, after each of `ticks`; and what the rule without rounding is off. */
void pool_tank_errors(const pool_tank *tank, double r, const uint32_t *ticks, int count,
                      double *off, double *unrounded);

/* From noise, in gear A: what a tick multiplies the water by, measured, and by the rule
 * without rounding from the same start over the same ticks.  Up to von Neumann's line the
 * root of the energy [C3], over GROWTH_TICKS, from a fourth of the range; beyond it,
 * where that is no energy, the rms of heights, from a 32nd of the range until a cell is
 * at half of it: fluxes are held from there on. */
enum { GROWTH_TICKS = 64, GROWTH_SIDE = 32, FULL_TICKS = 500 };
typedef struct {
    double  growth, unrounded;      /* 1 is none */
    double  rms;                    /* of the noise, LSB */
    int32_t full_at;                /* tick at which a height or velocity is at its
                                     * range's end, from a fourth of it; 0: none of
                                     * FULL_TICKS */
} pool_growth;
pool_growth pool_tank_growth(const pool_tank *tank);

/* After a drop, by both gears, until rest or `most` ticks. */
typedef enum { POOL_RESTS, POOL_FLICKERS, POOL_FULL, POOL_MOVES } pool_ending;
typedef struct {
    pool_ending ending;
    uint32_t    ticks;
    bool        full;               /* was at its range's end */
    double      drift, drift_a;     /* largest |mean height|, LSB: ever, before gear B */
    int32_t     residue;            /* highest |height| at the end, LSB */
} pool_rest;
pool_rest pool_tank_rest(const pool_tank *tank, uint32_t most);

/* Ticks until rest by theory.  8 and 16 bits: gear A's time [C11].  32 bits: a flux of
 * amplitude q loses half of 2^-m by damping and 1/pi LSB by the cuts, which take half an
 * LSB each tick like a dry friction: 2^(m+1) ln(1 + pi q / 2^(m+1)), q = r h / sqrt 2 of
 * a start of rms h. */
double pool_rest_ticks(const pool_tank *tank);

#endif
