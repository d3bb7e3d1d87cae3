/* SPDX-License-Identifier: MIT */
/* Differences of colours in levels of 255: the largest difference and the root mean
 * square. */
#ifndef TP_TESTS_TALLY_H
#define TP_TESTS_TALLY_H
#include "../reference/shading.h"
#include "measure.h"

typedef struct {
    const char *what;
    uint64_t    count;
    double      largest, squares;
} tally;

static inline void tally_add(tally *l, uint32_t got, ref_colour want)
{
    const ref_colour g = ref_colour_of(got);

    for (int k = 0; k < 3; k++) {
        const double off = fabs(g.c[k] - want.c[k]);
        l->count++;
        l->squares += off * off;
        l->largest = fmax(l->largest, off);
    }
}

static inline double tally_rms(const tally *l)
{
    return sqrt(l->squares / (double)l->count);
}

static inline void tally_print(const tally *l)
{
    printf("    %-18s %10" PRIu64 " channels, largest %-6.2f rms %.3f levels\n", l->what,
           l->count, l->largest, tally_rms(l));
}
#endif
