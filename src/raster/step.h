/* SPDX-License-Identifier: MIT */
/* Distance in px between perspective-exact s and t along a row; between exact positions s
 * and t are linear.  A power of two up to 32, or 0: s and t are affine in all triangles.
 * The charts compare the values; pictures depend on the choice. */
#ifndef TP_RASTER_STEP_H
#define TP_RASTER_STEP_H
#include <stdint.h>

#ifndef TP_SPAN_STEP
#define TP_SPAN_STEP 16
#endif
_Static_assert(TP_SPAN_STEP >= 0 && TP_SPAN_STEP <= 32
               && (TP_SPAN_STEP & (TP_SPAN_STEP - 1)) == 0, "a power of two, or 0");

/* 65536 / n, n: pixels between two exact positions. */
#if TP_SPAN_STEP > 16
static const uint32_t tp_span_over[33] = {
    0, 65536, 32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461, 5041,
    4681, 4369, 4096, 3855, 3641, 3449, 3277, 3121, 2979, 2849, 2731, 2621, 2521, 2427,
    2341, 2260, 2185, 2114, 2048,
};
#else
static const uint32_t tp_span_over[17] = {
    0, 65536, 32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461, 5041,
    4681, 4369, 4096,
};
#endif
#endif
