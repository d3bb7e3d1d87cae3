/* SPDX-License-Identifier: MIT */
/* Rasterizes water as a height field, without triangles.  Lines of points are drawn from
 * near to far.  Each line is a polyline on the screen, and every column of pixels stores
 * its covered height.  Where a line rises above the covered height, the pixels between
 * are interpolated between the previous line and this line; elsewhere a nearer crest
 * hides the line.  Each pixel is written at most once, and only the depth of solids is
 * read.
 *
 * All values are linear in absolute x and y between the points of two lines, so tile
 * borders are not visible.
 *
 * The method is valid if the points of a line go from left to right and the lines are
 * ordered along every ray; frame/visibility.c has the conditions. */
#ifndef TP_RASTER_SCANLINES_H
#define TP_RASTER_SCANLINES_H
#include "raster/raster.h"

/* A projected point of a line. */
typedef struct {
    int32_t  u, v;              /* 28.4 px, anywhere in the guard band */
    uint32_t zi;                /* near / depth, Q1.31 */
    int32_t  s, t;              /* rest position, 16.16 m */
    uint32_t n;                 /* slopes x:z, Q3.12 each */
} tp_row_point;

/* A line at a column of pixels. */
typedef struct {
    int32_t  v;                 /* row, 16.16 px, or TP_ROW_NONE */
    uint32_t zi;
    int32_t  s, t;
    uint32_t n;
} tp_row_sample;

/* State of a column: covered height and last line. */
typedef struct {
    int32_t  limit;             /* row, 16.16 px; lines at or above this row are visible */
    tp_row_sample line;
} tp_row_column;

#define TP_ROW_NONE (-(1 << 30))  /* below all lines, by less than 2^31 */

typedef struct {
    const tp_gbuffer *tile;
    tp_row_column    *column;   /* a state for each column of the tile */
    int32_t x0, x1;             /* columns to walk, x1 not included */
    int32_t open;               /* columns of the tile not yet covered to its upper edge */
    bool    solid;              /* true if the tile already has other samples */
} tp_rows;

size_t tp_rows_bytes(uint32_t columns);         /* size of the columns' states */

/* Begins a tile.  `memory`: tp_rows_bytes(x1 - x0) bytes, aligned to 4.  `solid`: the
 * tile may already have samples.  Of the lines below the tile only the last is needed,
 * and only in columns where the next line is not below: limit x0 and x1 accordingly. */
void tp_rows_begin(tp_rows *rows, const tp_gbuffer *tile, void *memory, bool solid);

/* Draws the next line, farther than the previous line, with water between both; the first
 * line starts the water. u must increase from point to point; points that break the order
 * are skipped. */
void tp_rows_draw_line(tp_rows *rows, const tp_row_point *point, uint32_t count);

/* Same, for a line behind a gap: nothing is drawn between the previous line and this
 * line, and the gap hides everything behind.  `joined`: triangles lie in front of the
 * line.  Triangles assign pixels at an edge by another rule, so the pixel at the line is
 * drawn again. */
void tp_rows_restart_line(tp_rows *rows, const tp_row_point *point, uint32_t count,
                          bool joined);

/* Used before a line that reaches farther to a side than the previous line: the edge of
 * the side, from left to right, replaces the previous line there. */
void tp_rows_start_side_segment(tp_rows *rows, const tp_row_point *from,
                                const tp_row_point *to);

/* Marks columns without a line between two u positions; the next line starts anew there. */
void tp_rows_mark_gap(tp_rows *rows, int32_t left_28_4, int32_t right_28_4);
#endif
