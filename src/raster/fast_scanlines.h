/* SPDX-License-Identifier: MIT */
/*
 * Water by lines, the fast rung: the idea of raster/raster.h in fewer instructions.
 *
 * Two buffers keep a sample for each column: of the previous line, and of the line being
 * laid.  A line is first laid, then scanned for the columns where it rises above the water
 * in front.  Between two lines s and t follow a parabola that meets the perspective at both
 * lines and half way between them: both lines have a depth of their own, the same in all
 * columns.  With column_bits = 5 a column is two pixels wide and found at its middle.
 *
 * A tile may have keys, if it holds solids or its depths are read, or none.  Without keys
 * the water of a column reaches from the limit down to the lower edge of the tile; a gap
 * breaks this rule and is reported.  Both give the same s, t and slopes.
 *
 * Values along a line count from the segment's first column, values between lines from the
 * upper line, so tile borders are not visible.
 */
#ifndef TP_RASTER_FAST_SCANLINES_H
#define TP_RASTER_FAST_SCANLINES_H
#include "raster/raster.h"

/* True for the rows of water that quality.lines = half fills with means: the odd ones but
 * each sixteenth. */
TP_ALWAYS_INLINE bool tp_is_mean_row(int32_t y)
{
    return (y & 1) && (y & 15) != 15;
}

/* A line at a column. */
typedef struct {
    int32_t  v;                 /* row, 16.16 px, or TP_LINE_NONE */
    uint32_t s, t, n;           /* rest position, 16.16 m; slopes x:z, Q3.12 each */
} tp_line_sample;

#define TP_LINE_NONE (1 << 30)  /* below all lines, by less than 2^31 */

/* Numbers of all points of a line, as if the water were level. */
typedef struct {
    uint32_t zi;                /* near / depth, Q1.31 */
    int32_t  half_s, half_t;    /* change of s and t in half a pixel along the line, m */
} tp_line_scale;

typedef struct {
    const tp_gbuffer *tile;
    int column_bits;            /* log2 of a column's width in 28.4 px: 4 or 5 */
    int32_t  first;             /* column of near[0] and far[0] */
    int32_t  x0, x1;            /* columns to walk, x1 not included */
    int32_t  open;              /* columns not yet covered to the tile's upper edge */
    int32_t  columns;
    tp_line_sample *near, *far; /* the previous line, the line being laid */
    uint32_t *near_zi, *far_zi; /* their depths; NULL: the tile has no keys */
    int32_t  *limit;            /* row of each column, 16.16; lines above it are visible */
    int32_t  laid0, laid1;      /* columns laid of this line; none: laid0 = laid1 */
    bool     solid;             /* true if the tile already has samples */
    bool     oblique;           /* true if depth changes along the lines */
    bool     holes;             /* true: pixels below the water of a column have none */
    bool     means;             /* true: no samples of mean rows are read; the tile has
                                 * sixteen rows */
    int32_t  bend;              /* of the parabola between the lines, Q.31 */
    int32_t  mean_bend;         /* its mean, 1/6 of it, Q.30 */
    int32_t  half_s, half_t;    /* between the lines, see tp_line_scale */
    ptrdiff_t behind;           /* bytes from far[i] to near[i] */
    int32_t  y0;                /* first row of the tile */
    uint8_t *s_plane;           /* s at row 0 of the picture and the tile's first column */
    size_t   stride, plane;     /* bytes from row to row, from plane to plane */
} tp_fast_rows;

/* Returns the scratch for so many columns of pixels. */
size_t tp_fast_rows_bytes(uint32_t columns, int column_bits);

/* Begins a tile.  `memory`: tp_fast_rows_bytes(x1 - x0) bytes, aligned to 4.  `keyed`: the
 * tile's keys are valid and written; otherwise they are not touched. */
void tp_fast_rows_begin(tp_fast_rows *rows, const tp_gbuffer *tile, void *memory,
                        int column_bits, bool keyed);

/* Begins a line, `scale[0]`, behind the previous line, `scale[1]`; NULL: an edge that leads
 * from one line to another. */
void tp_fast_rows_begin_line(tp_fast_rows *rows, const tp_line_scale scale[2]);

/* Lays the segment from a to b; a line's segments come from left to right. */
void tp_fast_rows_lay(tp_fast_rows *rows, const tp_row_point *a, const tp_row_point *b);

/* A point at a multiple of 16 columns of pixels. */
typedef struct {
    int32_t  v;                 /* row, 16.16 px */
    uint32_t n;                 /* slopes x:z, Q3.12 each */
} tp_even_point;

/* A line with points at columns 0, 16, ... to the right of the picture.  s and t are linear
 * along the line, depth is constant. */
typedef struct {
    const tp_even_point *point;
    uint32_t s, t;              /* at column 0, 16.16 m */
    int32_t  step_s, step_t;    /* per pixel, 16.16 m */
    uint32_t zi;
} tp_even_line;

/* Lays a whole line, in columns x0 to x1. */
void tp_fast_rows_lay_even(tp_fast_rows *rows, const tp_even_line *line);

/* Lays the segment between points i and i + 1 of a line whose `point` is not read; segments
 * come from left to right, from the tile's first column to its last. */
void tp_fast_rows_lay_even_segment(tp_fast_rows *rows, const tp_even_line *line, int32_t i,
                                   const tp_even_point pair[2]);

/* Removes the line between two u positions, and the previous line too: the next line starts
 * anew there. */
void tp_fast_rows_remove(tp_fast_rows *rows, int32_t left_28_4, int32_t right_28_4);

/* Kinds of lines: with water down to the previous line; the first line behind a gap, or
 * behind triangles that fill the gap (see tp_rows_restart_line). */
typedef enum { TP_LINE_ON, TP_LINE_BEHIND_GAP, TP_LINE_BEHIND_TRIANGLES } tp_line_kind;

/* Ends a line: draws its visible pixels.  The line is then the previous line. */
void tp_fast_rows_end_line(tp_fast_rows *rows, tp_line_kind kind);

/* Rows of a tile without keys: sky alone above row sky_end, water alone from row
 * water_begin on; between them a pixel is water if tp_fast_rows_is_water. */
typedef struct {
    int32_t sky_end, water_begin;
} tp_water_rows;

tp_water_rows tp_fast_rows_found(const tp_fast_rows *rows);

static inline bool tp_fast_rows_is_water(const tp_fast_rows *rows, int32_t x, int32_t y)
{
    return rows->limit[(x >> (rows->column_bits - 4)) - rows->first]
           <= y * 65536 - 32768;
}

#endif
