/* SPDX-License-Identifier: MIT */
/* Water between reflecting walls as the damped wave equation has it, in double precision:
 *
 *     h_tt + 2 g h_t = c^2 (h_xx + h_zz),     in cells and ticks: c = r, e^-g = sqrt(rho)
 *
 * with rho = 1 - delta, [C6] of the models.  A field that is known at the cells' centres
 * is the sum of the tank's standing modes, a cosine transform of it; each mode has a
 * closed form in time, so the field is known at any moment and anywhere between cells. */
#ifndef POOL_TRUTH_H
#define POOL_TRUTH_H
#include <stdint.h>

/* Height at time t of a mode of frequency omega that has `height` and `speed` at 0. */
double pool_truth_mode(double omega, double gamma, double height, double speed, double t);

/* The speed at 0 of the mode that has `height` at 0 and had `before` at -1. */
double pool_truth_speed(double omega, double gamma, double height, double before);

typedef struct {
    uint32_t cols, rows;
    double   r, gamma;
    double  *height, *speed;        /* of each mode, rows x cols */
} pool_truth;

/* From heights at tick 0 and the tick before, cells row by row; NULL: at rest at 0. */
void pool_truth_init(pool_truth *truth, uint32_t cols, uint32_t rows, double r,
                     double rho, const double *now, const double *before);
void pool_truth_free(pool_truth *truth);

/* Heights at tick t, at the centres of cells that are `finer` times as small:
 * finer^2 x rows x cols of them. */
void pool_truth_at(const pool_truth *truth, double t, uint32_t finer, double *to);
#endif
