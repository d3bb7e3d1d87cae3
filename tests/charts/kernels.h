/* SPDX-License-Identifier: MIT */
/* Small methods side by side, for the charts: each works through the same inputs, and is
 * counted on a Cortex-M4 and on x86-64 (count.sh) and judged in double precision
 * (errors.c).  One file a chart, kernels_NAME.c, beside its truth, errors_NAME.c. */
#ifndef KERNELS_H
#define KERNELS_H
#include "tidepool/tidepool.h"

enum { KERNEL_UNITS = 1024, KERNEL_WIDTH = 16 };    /* results; numbers of each */

/* Numbers lie one behind the other, `in` of them for each unit, and so do the results.
 * All that `run` executes over KERNEL_UNITS is the method's cost: its loads and stores and
 * its loop too, which are a few instructions, the same for all methods of a chart.  A list
 * ends with a row of zeros. */
typedef struct {
    const char *chart, *point;  /* keys, parted by ';'; without blanks and commas */
    void      (*fill)(int32_t *in);         /* the same numbers on every machine */
    void      (*run)(const int32_t *in, int32_t *out);
    uint32_t    in, out;        /* numbers a unit, up to KERNEL_WIDTH */
    uint32_t    bytes;          /* of constant tables that the method alone needs */
} kernel;

extern const kernel *const kernel_lists[];          /* ends with NULL */
extern const kernel kernels_gerstner[], kernels_normals[], kernels_roots[],
                    kernels_normalise[], kernels_sine[], kernels_dispersion[],
                    kernels_fresnel[];

/* The i-th of KERNEL_UNITS from low to high, evenly, both ends among them. */
static inline int32_t kernel_ramp(uint32_t i, int32_t low, int32_t high)
{
    return low + (int32_t)((int64_t)i * ((int64_t)high - low) / (KERNEL_UNITS - 1));
}

/* The i-th of places from -half to half, spread evenly in no order. */
static inline int32_t kernel_spread(uint32_t i, uint32_t step, int32_t half)
{
    return (int32_t)((int64_t)(int32_t)(i * step) * half >> 31);
}
#define KERNEL_STEP  2654435769u        /* the golden section's, and another */
#define KERNEL_CROSS 1640531527u
#endif
