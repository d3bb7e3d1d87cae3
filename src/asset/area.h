/* SPDX-License-Identifier: MIT */
/* Exact area vectors: a vector along the normal of a triangle, of twice its area, in
 * units of 2^-32 m2.
 *
 * Coordinates lie within +-(2^30 - 1): edges have 31 bits and a sign, products are
 * below 2^62, and each component is below 2^63.  Sums add vectors divided by 2^shift.
 * The shift depends on the extent and on the number of triangles; it is 0 below 32 m
 * and 2^19 triangles. */
#ifndef TP_ASSET_AREA_H
#define TP_ASSET_AREA_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/fixed.h"

typedef struct { int64_t x, y, z; } tp_area;

/* Returns a x b, for edges a and b. */
tp_area tp_area_cross(tp_vec3 a, tp_vec3 b);

/* Returns a p - b q, exact under the same bounds. */
static inline int64_t tp_area_product_difference(int32_t a, int32_t p, int32_t b, int32_t q)
{
    return (int64_t)a * p - (int64_t)b * q;
}

static inline bool tp_area_is_none(tp_area a) { return (a.x | a.y | a.z) == 0; }

/* Returns the shift that keeps the sum of `count` vectors, or of their lengths, in 63 bits,
 * if no component of an edge is longer than `extent`. */
uint32_t tp_area_sum_shift(uint32_t extent, uint32_t count);

tp_area tp_area_divide_pow2(tp_area a,
                            uint32_t shift);        /* towards 0: favours no direction */
uint64_t tp_area_length(tp_area a);                 /* relative error < 2^-29 */
tp_dir3  tp_area_direction(tp_area a);              /* (0, 1, 0) for zero area */
#endif
