/* SPDX-License-Identifier: MIT */
/* Stability maps: where methods fail, measured by calling the engine's fixed point
 * functions, with the theory in double precision beside.  tests/stability/test_maps.c
 * holds the one to the other.
 *
 *     stability CHART         rows of the sweep, CHART,KEYS,COLUMN,VALUE */
#ifndef STABILITY_H
#define STABILITY_H
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include "wave/wave.h"

#define STABILITY_PI  3.14159265358979323846
#define STABILITY_LSB (1 / 65536.0)

void stability_jacobian(void), stability_breaking(void), stability_buoyancy(void),
     stability_dispersion(void);

/* -- seas of equal shares: stability_seas.c ------------------------------------------ */

#define STABILITY_WAVES 8

/* So many waves, the golden ratio apart in length, 24 m the longest, whose steepnesses
 * add up to `sum`; their headings are spread evenly over `fan` degrees. */
tp_sea stability_sea(int waves, double fan, double sum);

/* The same sea without the clamp of [A11], for a sum up to 1.9; and any waves' sea. */
tp_sea stability_sea_unheld(int waves, double fan, double sum);
tp_sea stability_unheld(const tp_wave *wave, uint32_t count, tp_fx gravity);

/* Sum of QkA as it is. */
double stability_sum(const tp_sea *sea);

/* 1 less the greatest eigenvalue of sum QkA D D^T: where all crests meet [A11]. */
double stability_crests(const tp_sea *sea);

/* -- the Jacobian [A9] [A11] --------------------------------------------------------- */

/* Its smaller eigenvalue, of the engine's sums: least over a sweep of the surface and
 * time, and then downhill from the least of each time. */
double stability_least(const tp_sea *sea);

/* -- breaking [B14] [B15] ------------------------------------------------------------ */

enum { STABILITY_STEEP, STABILITY_DEPTH, STABILITY_MICHE, STABILITY_CRITERIA };
enum { STABILITY_RISES = 57, STABILITY_DEPTHS = 49 };

/* Of the map: H/L and h/L at its points, in equal ratios. */
double stability_rise(int i);
double stability_depth(int j);

/* The engine's flags there. */
uint32_t stability_flags(double rise, double depth);

/* H/L from which a criterion says that a wave breaks. */
double stability_border(int criterion, double h_over_l);

/* -- inversion [E1] ------------------------------------------------------------------ */

typedef enum {
    STABILITY_PLAIN,            /* so many plain steps */
    STABILITY_COLD,             /* tp_sea_sample from the place itself */
    STABILITY_WARM              /* ... from where the last tick's search ended */
} stability_search;

/* How far the point found is from the place asked for, and from the truth's height above
 * it, at the most, over places and times; m. */
typedef struct {
    double along, up;
} stability_off;
stability_off stability_inversion(const tp_sea *sea, stability_search how, uint32_t n);

/* Above which no search ends: of n plain steps q^n of the first distance off; of the
 * engine's the 2 LSB of x and of z with which it is content. */
double stability_bound(const tp_sea *sea, stability_search how, uint32_t n);

/* -- wave numbers [B2]-[B6] ---------------------------------------------------------- */

/* x with x tanh x = y, to 1e-15 of it. */
double stability_kh(double y);

/* An approximation's k over the true one, less 1: by the engine for a wave of so many
 * metres on deep water, and its formula in double precision. */
typedef struct {
    const char *name;
    int64_t (*engine)(int64_t k_inf_q32, tp_fx depth);  /* or NULL: not the engine's */
    double  (*formula)(double y);       /* kh of k_inf h; NULL: it is the truth's own */
} stability_number;
enum { STABILITY_NUMBERS = 7 };
extern const stability_number stability_numbers[STABILITY_NUMBERS];

double stability_number_off(const stability_number *n, double kh, double length);
double stability_formula_off(const stability_number *n, double kh);
#endif
