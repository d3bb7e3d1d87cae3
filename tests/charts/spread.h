/* SPDX-License-Identifier: MIT */
/* Error of a method over many more inputs than the counted run has: runs the kernel block
 * after block, and keeps the largest and the rms error. */
#ifndef TP_TESTS_CHARTS_SPREAD_H
#define TP_TESTS_CHARTS_SPREAD_H
#include <string.h>
#include "tests/charts/errors.h"

typedef struct {
    double   most, squares;
    uint32_t count;
} spread;

static inline void spread_add(spread *s, double error)
{
    s->most = fmax(s->most, fabs(error));
    s->squares += error * error;
    s->count++;
}

static inline double spread_rms(const spread *s)
{
    return sqrt(s->squares / s->count);
}

/* Prints the columns error_max and error_rms. */
static inline void spread_rows(const kernel *k, const spread *s)
{
    error_row(k, "error_max", s->most);
    error_row(k, "error_rms", spread_rms(s));
}

/* Method of a point "task;method". */
static inline const char *method_of(const kernel *k)
{
    const char *parted = strrchr(k->point, ';');
    return parted ? parted + 1 : k->point;
}

static inline bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}
#endif
