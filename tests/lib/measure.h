/* SPDX-License-Identifier: MIT */
/* Error statistics over many inputs, printed as a table; and sweeps over all 32-bit words
 * at an odd stride: with TP_SWEEP=all a sweep takes every word instead of 10^7 words. */
#ifndef TP_TESTS_LIB_MEASURE_H
#define TP_TESTS_LIB_MEASURE_H
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "tests/lib/random.h"

typedef struct {
    const char *what;
    const char *unit;
    uint64_t inputs;
    double   worst;             /* largest magnitude, in `unit` */
    int64_t  at[3];             /* input with the worst error */
} measure;

static inline void measure_add(measure *m, double error, int64_t a, int64_t b, int64_t c)
{
    m->inputs++;
    if (!(fabs(error) <= m->worst)) {       /* true for NaN too */
        m->worst = fabs(error);
        m->at[0] = a;
        m->at[1] = b;
        m->at[2] = c;
    }
}

static inline void measure_print(const measure *m)
{
    printf("    %-18s %10" PRIu64 " inputs, worst %-12.6g %-12s at %" PRId64 " %" PRId64
           " %" PRId64 "\n", m->what, m->inputs, m->worst, m->unit, m->at[0], m->at[1],
           m->at[2]);
}

/* Stride of a sweep.  2^32 / 429 is a little over 10^7; 429 = 3 11 13 hits every residue of
 * the tables. */
static inline uint32_t sweep_stride(void)
{
    const char *const asked = getenv("TP_SWEEP");
    return asked != NULL && strcmp(asked, "all") == 0 ? 1 : 429;
}
#endif
