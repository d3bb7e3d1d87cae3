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

/* A line at a column of pixels. */
typedef struct {
    int32_t  v;                 /* 16.16 rows, or TP_ROW_NONE */
    uint32_t zi;
    int32_t  s, t;
    uint32_t n;
} tp_row_sample;

/* What a column remembers: how high it is covered, and the last line there. */
typedef struct {
    int32_t  limit;             /* what rises to it covers more: 16.16 rows */
    tp_row_sample line;
} tp_row_column;

#define TP_ROW_NONE (-(1 << 30))  /* below all lines by less than 2^31 */

typedef struct {
    const tp_samples *tile;
    tp_row_column    *column;   /* one for each of the tile's columns */
    int32_t x0, x1;             /* columns that lines are walked in, x1 not included */
    int32_t open;               /* of all: not covered up to the tile's upper edge */
    bool    solid;              /* something else is drawn in the tile already */
} tp_rows;

size_t tp_rows_bytes(uint32_t columns);         /* of what they remember */

/* Begins a tile; `memory` is tp_rows_bytes(x1 - x0), aligned to 4.  `solid`: samples may
 * be in it already.  Of lines below the tile the last is enough, and only in columns where
 * the next is not: set x0 and x1. */
void tp_rows_begin(tp_rows *rows, const tp_samples *tile, void *memory, bool solid);

/* The next line, farther than the last: u grows from point to point, what does not is
 * left out.  Between the last line and this one is water; the first begins it. */
void tp_rows_line(tp_rows *rows, const tp_row_point *point, uint32_t count);

/* The same behind a gap: nothing is drawn between the last line and this one, nor is what
 * lies behind seen there.  `joined`: before it lie triangles.  Which of two pixels an edge
 * goes between they tell in another way, so the pixel at the line is drawn once more. */
void tp_rows_start(tp_rows *rows, const tp_row_point *point, uint32_t count, bool joined);

/* Where the next line reaches farther to a side than the last: the side's edge, from left
 * to right, stands for the last line there. */
void tp_rows_side(tp_rows *rows, const tp_row_point *left, const tp_row_point *right);

/* No line was there between two places: what comes next begins anew. */
void tp_rows_gap(tp_rows *rows, int32_t left_28_4, int32_t right_28_4);
#endif
