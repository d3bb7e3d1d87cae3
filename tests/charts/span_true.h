/* SPDX-License-Identifier: MIT */
/* Water's triangles with places in double precision: what all steps are off from.  Only
 * where there is a C library: elsewhere it draws by `exact`. */
#ifndef CHARTS_SPAN_TRUE_H
#define CHARTS_SPAN_TRUE_H
#include "raster/raster.h"

typedef void span_draw(const tp_samples *tile, const tp_corner *a, const tp_corner *b,
                       const tp_corner *c);

/* Pixels are those of `exact`. */
void span_true(const tp_samples *tile, const tp_corner *a, const tp_corner *b,
               const tp_corner *c, span_draw *exact);
#endif
