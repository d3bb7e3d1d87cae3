/* SPDX-License-Identifier: MIT */
/* Intersections of an edge with the rows of pixels. */
#ifndef TP_RASTER_EDGE_H
#define TP_RASTER_EDGE_H
#include "base/base.h"

/* Returns the first row with its centre at or below v: ceil(v - 1/2).  The same holds for
 * columns. */
TP_ALWAYS_INLINE int32_t tp_first_centre(int32_t v_28_4)
{
    return (v_28_4 + 7) >> 4;
}

/* State of an edge on a row: the first pixel centre at or right of the crossing.  The
 * crossing is a multiple of 1 / (16 dv) px and is stored exactly, as in Bresenham's
 * algorithm.  Two edges through a common point therefore never pass each other, a
 * condition for "each pixel exactly once" between slivers. */
typedef struct {
    int32_t row, pixel;
    int32_t over;               /* distance from crossing to centre, 0..one-1 */
    int32_t whole, part;        /* step per row: pixels, and the remainder 0..one-1 */
    int32_t one;                /* a pixel in these units: 16 dv, at most 2^22 */
} tp_edge;

/* Returns the edge from the upper end (u0, v0) to the lower end (u1, v1), v0 < v1, on its
 * first row.  `along` is in 1/16 px; `left` is the remainder in units of the edge.
 * `left` is below 30 dv, so the loop adds at most two pixels. */
TP_ALWAYS_INLINE tp_edge tp_edge_begin(int32_t u0, int32_t v0, int32_t u1, int32_t v1)
{
    TP_ASSERT(v0 < v1);
    int32_t dv = v1 - v0, whole = (u1 - u0) / dv, part = (u1 - u0) % dv;
    int32_t row = tp_first_centre(v0), down = 16 * row + 8 - v0;

    if (part < 0) {
        part += dv;
        whole--;
    }
    int32_t along = u0 - 8 + whole * down;
    int32_t left = (along & 15) * dv + part * down;
    tp_edge e = { row, along >> 4, 0, whole, 16 * part, 16 * dv };

    for (; left > 0; left -= e.one)
        e.pixel++;
    e.over = -left;
    return e;
}

TP_ALWAYS_INLINE void tp_edge_step(tp_edge *e)
{
    e->pixel += e->whole;
    e->over -= e->part;
    if (e->over < 0) {
        e->over += e->one;
        e->pixel++;
    }
}

/* Advances to row y >= e->row, 256 rows at a time, so that products stay within 31 bits. */
TP_ALWAYS_INLINE void tp_edge_advance(tp_edge *e, int32_t y)
{
    TP_ASSERT(y >= e->row);
    for (int32_t n = y - e->row; n > 0; n -= 256) {
        int32_t rows = n < 256 ? n : 256;
        int32_t over = rows * e->part - e->over;
        int32_t pixels = over > 0 ? (over + e->one - 1) / e->one : 0;

        e->pixel += rows * e->whole + pixels;
        e->over = pixels * e->one - over;
    }
    e->row = y;
}
#endif
