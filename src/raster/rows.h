/* SPDX-License-Identifier: MIT */
/* Water as a height field, without triangles: lines of its points come near to far, each
 * a polyline on the screen, and every column of pixels remembers how high it is covered.
 * Where a line rises above that, the pixels between are filled with what lies between the
 * line before and this one; where it does not, a nearer crest hides it.  Each pixel is
 * written at most once, and no depth is read but that of solids.
 *
 * Everything is linear in absolute x and y between the points of two lines, so how the
 * picture is cut into tiles never shows.
 *
 * It holds while points of a line come left to right and lines stay ordered along every
 * ray: see frame/visibility.c for the border. */
#ifndef TP_RASTER_ROWS_H
#define TP_RASTER_ROWS_H
#include "raster/raster.h"

/* A point of a line, projected. */
typedef struct {
    int32_t  u, v;              /* 28.4, anywhere in the guard band */
    uint32_t zi;                /* Q1.31 */
    int32_t  s, t;              /* rest place, 16.16 m */
    uint32_t n;                 /* slopes x:z, Q3.12 each */
} tp_row_point;

typedef struct tp_row_column tp_row_column;     /* what a column of pixels remembers */

typedef struct {
    const tp_samples *tile;
    tp_row_column    *column;   /* one for each of the tile's columns */
} tp_rows;

size_t tp_rows_bytes(uint32_t columns);         /* of what they remember */

/* Begins a tile; `memory` is tp_rows_bytes(x1 - x0), aligned to 8. */
void tp_rows_begin(tp_rows *rows, const tp_samples *tile, void *memory);

/* The next line, farther than the last: u grows from point to point.  Columns that it
 * does not reach forget what was before, so a gap stays a gap. */
void tp_rows_line(tp_rows *rows, const tp_row_point *point, uint32_t count);
#endif
