/* SPDX-License-Identifier: MIT */
/* Compares the kernels' results with references in double precision; see kernels.h. */
#ifndef TP_TESTS_CHARTS_ERRORS_H
#define TP_TESTS_CHARTS_ERRORS_H
#include <math.h>
#include <stdio.h>
#include "tests/charts/kernels.h"

/* Prints rows of one kernel's errors. */
typedef void judge(const kernel *k, const int32_t *in, const int32_t *out);
judge judge_gerstner, judge_normals, judge_roots, judge_normalise, judge_sine,
      judge_dispersion, judge_fresnel;

/* Prints a row of the sweep, CHART,KEYS,COLUMN,VALUE, with four significant digits. */
static inline void error_row(const kernel *k, const char *column, double value)
{
    printf("%s,%s,%s,%.4g\n", k->chart, k->point, column, value);
}
#endif
