/* SPDX-License-Identifier: MIT */
/* Seas of the waves that a table gives, for tidepool check, and how far the bounds of
 * wave/wave.h let their points be off. */
#ifndef HOST_CHECK_SEA_H
#define HOST_CHECK_SEA_H
#include "check.h"
#include "wave/wave.h"

/* A wave in the models' letters; power 1 is a sine, q is Q k A. */
typedef struct {
    double k, dx, dz, amplitude, q;
    int    power;
} check_wave;

/* With all the bits of a tp_wave_exact: a tp_wave's heading and length would round to
 * 16.16, which far from the origin shows more than the core's arithmetic. */
tp_sea check_sea_of(const check_wave *waves, unsigned count);

/* Bounds for the point whose place at rest is (x, z). */
typedef struct {
    double up, along;           /* of its position, m */
    double turn;                /* of its normal, rad */
    double step;                /* of a height after plain steps of [E1], m */
} check_bound;
check_bound check_sea_bound(const check_wave *waves, unsigned count, double x, double z);

/* Of the normal of one wave with Q = 1 [A8], rad. */
double check_trochoid_bound(const check_wave *wave, double x, double z);
#endif
