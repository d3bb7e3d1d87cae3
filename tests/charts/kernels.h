/* SPDX-License-Identifier: MIT */
/* Small methods for the charts, compared on the same inputs: counted on a Cortex-M4 and on
 * x86-64 (count.sh), and checked in double precision (errors.c). Each chart has one file,
 * kernels_NAME.c, and its reference, errors_NAME.c. */
#ifndef TP_TESTS_CHARTS_KERNELS_H
#define TP_TESTS_CHARTS_KERNELS_H
#include "tidepool/tidepool.h"

enum { KERNEL_UNITS = 1024, KERNEL_WIDTH = 16 };    /* results; numbers of each */

/* A kernel. Inputs lie consecutively, `in` numbers for each unit, and results likewise. The
 * method's cost is all that `run` executes over KERNEL_UNITS, including loads, stores and
 * the loop: a few instructions, equal for all methods of a chart. A row of zeros ends a
 * list. */
typedef struct {
    const char *chart, *point;  /* keys, separated by ';'; no blanks or commas */
    void      (*fill)(int32_t *in);         /* the same numbers on each machine */
    void      (*run)(const int32_t *in, int32_t *out);
    uint32_t    in, out;        /* numbers a unit, up to KERNEL_WIDTH */
    uint32_t    bytes;          /* size of constant tables of this method alone */
} kernel;

extern const kernel *const kernel_lists[];          /* ends with NULL */
extern const kernel kernels_gerstner[], kernels_normals[], kernels_roots[],
                    kernels_normalise[], kernels_sine[], kernels_dispersion[],
                    kernels_fresnel[];

/* The i-th of KERNEL_UNITS evenly spaced values from low to high, ends included. */
static inline int32_t kernel_ramp(uint32_t i, int32_t low, int32_t high)
{
    return low + (int32_t)((int64_t)i * ((int64_t)high - low) / (KERNEL_UNITS - 1));
}

/* The i-th of places from -half to half, spread evenly in no order. */
static inline int32_t kernel_spread(uint32_t i, uint32_t step, int32_t half)
{
    return (int32_t)((int64_t)(int32_t)(i * step) * half >> 31);
}
#define KERNEL_STEP  2654435769u        /* the golden ratio's step, and another */
#define KERNEL_CROSS 1640531527u
#endif
