/* SPDX-License-Identifier: MIT */
/* Water triangles with places in double precision: the reference of all steps. Needs a C
 * library; without a C library draws by `exact`. */
#ifndef TP_TESTS_CHARTS_SPAN_TRUE_H
#define TP_TESTS_CHARTS_SPAN_TRUE_H
#include "raster/raster.h"

typedef void span_draw(const tp_gbuffer *tile, const tp_screen_vertex *a,
                       const tp_screen_vertex *b, const tp_screen_vertex *c);

/* Draws the pixels that `exact` draws. */
void span_true(const tp_gbuffer *tile, const tp_screen_vertex *a, const tp_screen_vertex *b,
               const tp_screen_vertex *c, span_draw *exact);
#endif
