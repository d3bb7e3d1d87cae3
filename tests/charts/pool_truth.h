/* SPDX-License-Identifier: MIT */
/* Water between reflecting walls by the damped wave equation in double precision:
 *
 *     h_tt + 2 g h_t = c^2 (h_xx + h_zz),     in cells and ticks: c = r, e^-g = sqrt(rho)
 *
 * with rho = 1 - delta, [C6] of the models. A field given at the cells' centres is the sum
 * of the tank's standing modes, by a cosine transform. Each mode has a closed form in time,
 * so the field is known at any moment and at any place between cells. */
#ifndef TP_TESTS_CHARTS_POOL_TRUTH_H
#define TP_TESTS_CHARTS_POOL_TRUTH_H
#include <stdint.h>

/* Height at time t of a mode with frequency omega, and `height` and `speed` at time 0. */
double pool_truth_mode(double omega, double gamma, double height, double speed, double t);

/* Speed at time 0 of a mode with `height` at 0 and `before` at -1. */
double pool_truth_speed(double omega, double gamma, double height, double before);

typedef struct {
    uint32_t cols, rows;
    double   r, gamma;
    double  *height, *speed;        /* of each mode, rows x cols */
} pool_truth;

/* Starts from heights at tick 0 and at the tick before, cells row by row; NULL: at rest at
 * tick 0. */
void pool_truth_init(pool_truth *truth, uint32_t cols, uint32_t rows, double r,
                     double rho, const double *now, const double *before);
void pool_truth_free(pool_truth *truth);

/* Heights at tick t at the centres of cells `finer` times as small: finer^2 x rows x cols
 * values. */
void pool_truth_at(const pool_truth *truth, double t, uint32_t finer, double *to);
#endif
