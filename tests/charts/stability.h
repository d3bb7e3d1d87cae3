/* SPDX-License-Identifier: MIT */
/* Stability maps: the limits of methods, measured with the engine's fixed-point functions,
 * beside the theory in double precision. tests/stability/test_maps.c compares the two.
 *
 *     stability CHART         prints rows of the sweep, CHART,KEYS,COLUMN,VALUE */
#ifndef TP_TESTS_CHARTS_STABILITY_H
#define TP_TESTS_CHARTS_STABILITY_H
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include "waves/deep_water.h"

#define STABILITY_PI  3.14159265358979323846
#define STABILITY_LSB (1 / 65536.0)

void stability_jacobian(void), stability_breaking(void), stability_buoyancy(void),
     stability_dispersion(void);

/* -- deep water with equal steepnesses: stability_seas.c ----------------------------- */

#define STABILITY_WAVES 8

/* Deep water with that number of waves, their lengths the golden ratio apart, the longest
 * 24 m; their steepnesses add up to `sum`, and their headings are spread evenly over `fan`
 * degrees. */
tp_deep_water stability_sea(int waves, double fan, double sum);

/* The same water without the clamp of [A11], for a sum up to 1.9; and the same for given
 * waves. */
tp_deep_water stability_sea_unheld(int waves, double fan, double sum);
tp_deep_water stability_unheld(const tp_wave *wave, uint32_t count, tp_fx gravity);

/* Sum of QkA without the clamp. */
double stability_sum(const tp_deep_water *deep);

/* 1 minus the greatest eigenvalue of sum QkA D D^T: the Jacobian where all crests meet
 * [A11]. */
double stability_crests(const tp_deep_water *deep);

/* -- Jacobian [A9] [A11] ------------------------------------------------------------- */

/* Least of the Jacobian's smaller eigenvalue, from the engine's sums: over a sweep of the
 * surface and of time, then downhill from the least of each time. */
double stability_least(const tp_deep_water *deep);

/* -- breaking [B14] [B15] ------------------------------------------------------------ */

enum { STABILITY_STEEP, STABILITY_DEPTH, STABILITY_MICHE, STABILITY_CRITERIA };
enum { STABILITY_RISES = 57, STABILITY_DEPTHS = 49 };

/* H/L and h/L of the map's points, in geometric series. */
double stability_rise(int i);
double stability_depth(int j);

/* The engine's flags at a point. */
uint32_t stability_flags(double rise, double depth);

/* Least H/L at which a criterion calls a wave breaking. */
double stability_border(int criterion, double h_over_l);

/* -- inversion [E1] ------------------------------------------------------------------ */

typedef enum {
    STABILITY_PLAIN,            /* a number of plain steps */
    STABILITY_COLD,             /* tp_deep_water_sample from the place itself */
    STABILITY_WARM              /* ... from the end of the last tick's search */
} stability_search;

/* Largest distance of the point found from the place asked for, and from the reference's
 * height above the place, over places and times; m. */
typedef struct {
    double along, up;
} stability_off;
stability_off stability_inversion(const tp_deep_water *deep, stability_search how,
                                  uint32_t n);

/* Upper bound of a search's error: q^n of the first distance for n plain steps; for the
 * engine the 2 LSB of x and z at which the search stops. */
double stability_bound(const tp_deep_water *deep, stability_search how, uint32_t n);

/* -- wave numbers [B2]-[B6] ---------------------------------------------------------- */

/* x with x tanh x = y, with a relative accuracy of 1e-15. */
double stability_kh(double y);

/* An approximation of k: the engine's function, and its formula in double precision. Errors
 * are k over the true k, minus 1, for a wave with a given length on deep water. */
typedef struct {
    const char *name;
    int64_t (*engine)(int64_t k_inf_q32, tp_fx depth);  /* or NULL: not in the engine */
    double  (*formula)(double y);       /* kh of k_inf h; NULL: the exact one */
} stability_number;
enum { STABILITY_NUMBERS = 7 };
extern const stability_number stability_numbers[STABILITY_NUMBERS];

double stability_number_off(const stability_number *n, double kh, double length);
double stability_formula_off(const stability_number *n, double kh);
#endif
