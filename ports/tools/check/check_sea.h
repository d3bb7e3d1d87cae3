/* SPDX-License-Identifier: MIT */
/* Seas made from the waves of a table, for tidepool check, and bounds of the errors of
 * their points, from the bounds in waves/deep_water.h. */
#ifndef TP_TOOLS_CHECK_CHECK_SEA_H
#define TP_TOOLS_CHECK_CHECK_SEA_H
#include "check.h"
#include "waves/deep_water.h"

/* A wave in the letters of MODELS; power 1: sine; q = Q k A. */
typedef struct {
    double k, dx, dz, amplitude, q;
    int    power;
} check_wave;

/* Makes a sea at the full precision of tp_wave_exact.  Heading and length of a tp_wave
 * would be rounded to 16.16; far from the origin that rounding exceeds the errors of the
 * core. */
tp_deep_water check_sea_make(const check_wave *waves, unsigned count);

/* Error bounds for the point with the rest position (x, z). */
typedef struct {
    double up, along;           /* of the position: vertical and horizontal, m */
    double turn;                /* of the normal, rad */
    double step;                /* of a height after fixed-point steps of [E1], m */
} check_bound;
check_bound check_sea_bound(const check_wave *waves, unsigned count, double x, double z);

/* Returns the error bound of the normal of one wave with Q = 1 [A8], rad. */
double check_trochoid_bound(const check_wave *wave, double x, double z);
#endif
