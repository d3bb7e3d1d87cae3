/* SPDX-License-Identifier: MIT */
/* Error statistics over many inputs, printed as a table; and the inputs: a sweep over all
 * 32-bit words at an odd stride, or random words from a seed that is printed.
 *
 *     TP_SEED=n       repeats the random inputs of a run
 *     TP_SWEEP=all    sweeps take every word instead of 10^7 words */
#ifndef TP_TESTS_MEASURE_H
#define TP_TESTS_MEASURE_H
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

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

static inline uint64_t random_seed(void)
{
    const char *const given = getenv("TP_SEED");
    const uint64_t seed = given != NULL ? strtoull(given, NULL, 0) : (uint64_t)time(NULL);
    printf("TP_SEED=%" PRIu64 "\n", seed);
    return seed;
}

/* splitmix64 */
static inline uint64_t random_next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static inline uint32_t random_below(uint64_t *state, uint32_t end)
{
    return (uint32_t)((random_next(state) >> 32) * end >> 32);
}

/* A signed number of random bit length, 0 to 31, so that small numbers are frequent. */
static inline int32_t random_number(uint64_t *state)
{
    const uint64_t word = random_next(state);
    return (int32_t)(uint32_t)word >> (word >> 59);
}
#endif
