/* SPDX-License-Identifier: MIT */
/* Tanks of the engine's pools that run alone, for the charts: error, growth, time until
 * rest and drift. r and damping are set directly, so tanks may have values that cannot be
 * configured. The program ends if a tank cannot be made. */
#ifndef TP_TESTS_CHARTS_POOL_RUNS_H
#define TP_TESTS_CHARTS_POOL_RUNS_H
#include "tests/charts/pool_rules.h"

typedef struct {
    tp_cells cells;
    uint32_t cols, rows;
    uint32_t courant_sq_q10, m; /* 1024 r^2, 0..767; damping 2^-m, m = 1..10 */
} pool_tank;

/* Makes still water as configured. The caller calls free(). */
tp_pool *pool_new(const tp_pool_config *config);

/* Makes still water between walls; cells of 1/4 m, heights within 1 m. The caller calls
 * free(). */
tp_pool *pool_tank_new(const pool_tank *tank);

/* Adds a splash of sigma 4 cells and 100 / 127 m, slightly off the middle. */
void pool_tank_drop(tp_pool *pool);

/* -- measurements -------------------------------------------------------------------- */

/* After each of `ticks`: rms error of a splash's water against the damped wave equation,
 * relative to the rms of the water at that tick; and the same error of the rule without
 * rounding. */
void pool_tank_errors(const pool_tank *tank, double r, const uint32_t *ticks, int count,
                      double *off, double *unrounded);

/* Growth per tick from noise in gear A: measured, and by the rule without rounding from the
 * same start over the same ticks. Up to von Neumann's bound: the root of the energy [C3],
 * over GROWTH_TICKS, from a fourth of the range. Beyond the bound the energy is not
 * defined: the rms of heights, from a 32nd of the range until a cell reaches half the
 * range, where fluxes begin to be clamped. */
enum { GROWTH_TICKS = 64, GROWTH_SIDE = 32, FULL_TICKS = 500 };
typedef struct {
    double  growth, unrounded;      /* 1: no growth */
    double  rms;                    /* rms of the noise, LSB */
    int32_t full_at;                /* tick at which a height or velocity reaches the end of
                                     * the range, from a fourth of the range; 0: not in
                                     * FULL_TICKS */
} pool_growth;
pool_growth pool_tank_growth(const pool_tank *tank);

/* Run after a splash, in both gears, until rest or `most` ticks. */
typedef enum { POOL_RESTS, POOL_FLICKERS, POOL_FULL, POOL_MOVES } pool_ending;
typedef struct {
    pool_ending ending;
    uint32_t    ticks;
    bool        full;               /* a cell has reached the end of the range */
    double      drift, drift_a;     /* largest |mean height|, LSB: all, before gear B */
    int32_t     residue;            /* highest |height| at the end, LSB */
} pool_rest;
pool_rest pool_tank_rest(const pool_tank *tank, uint32_t most);

/* Ticks until rest by theory. 8 and 16 bits: gear A's time [C11]. 32 bits: a flux of
 * amplitude q loses half of 2^-m by damping and 1/pi LSB by truncation, which removes half
 * an LSB each tick like dry friction: 2^(m+1) ln(1 + pi q / 2^(m+1)), q = r h / sqrt 2 for
 * a start of rms h. */
double pool_rest_ticks(const pool_tank *tank);

#endif
