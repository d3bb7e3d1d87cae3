/* SPDX-License-Identifier: MIT */
/*
 * The scanline grid: the grid's lines across the view, ordered from near to far, for
 * raster/scanlines.c.
 *
 * Lines run along the grid axis across the camera's heading.  Row k of cells lies between
 * lines k and k + 1 in the grid's own order; points are numbered in the same order.
 *
 *     scanline_grid.c        the conditions for its use, and its placement
 *     scanline_water.c       walks a tile's lines
 *     fast_scanline_water.c  the same by cheaper rungs
 */
#ifndef TP_FRAME_SCANLINE_GRID_H
#define TP_FRAME_SCANLINE_GRID_H
#include "frame/frame.h"
#include "frame/renderers.h"

/* Kinds of a row of cells, see tp_frame_line.is. */
enum { TP_LINE_CUT = 1, TP_LINE_SIDED = 2, TP_LINE_WIDE = 4 };

/* A row of cells between two neighbouring lines of water, from side to side; see
 * scanline_water.c. */
typedef struct {
    tp_grid_span cells;         /* possibly visible cells */
    tp_grid_box  box;           /* picture box of these cells */
    uint16_t     is;            /* TP_LINE_CUT: drawn as triangles.  TP_LINE_SIDED: an end
                                 * of its lines is inside of the picture.  TP_LINE_WIDE:
                                 * wide cells */
} tp_frame_line;

/* Pixel columns covered by a piece of a line, x1 included. */
typedef struct {
    int16_t x0, x1;
} tp_line_reach;

/* Lines of the grid from far to near, their points from left to right. */
typedef struct tp_frame_lines {
    uint32_t lines, points;
    uint32_t blocks;            /* of a row of cells */
    uint32_t pieces;            /* of a line, of 1 << piece_bits segments each */
    uint8_t  piece_bits;
    const tp_grid_box *box;     /* lines x blocks boxes, in the grid's order */
    tp_frame_line  *line;       /* one for each row of cells, in the grid's order */
    tp_line_reach  *reach;      /* of each piece of each line */
} tp_frame_lines;

/* Numbers of each line, and of level water, for fast rows. */
typedef struct tp_fast_lines {
    tp_line_scale  *scale;      /* one for each line, in the grid's order */
    tp_level_linear zi;         /* near / depth of level water */
} tp_fast_lines;

/* Point m of line k, which the window must hold. */
static inline const tp_grid_vertex *tp_line_vertex(const tp_grid_window *window,
                                                   uint32_t k, uint32_t m)
{
    return &window->line[k & 1][m];
}

/* The land of the grid's rows; NULL: none. */
static inline const struct tp_draw_row_land *tp_line_land(const tp_frame *frame)
{
    return frame->buffers.grid->dry ? frame->program->draw.row_land : NULL;
}

/* True if the cell at point m of row k is dry. */
static inline bool tp_line_cell_is_dry(const tp_frame *frame, uint32_t row,
                                       uint32_t point)
{
    return tp_grid_cell_is_dry(frame->buffers.grid, point, row);
}

/* Returns the cells [first, end) of block b, without cells out of view. */
static inline tp_grid_span tp_line_block_cells(const tp_frame_line *line, uint32_t b)
{
    uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;

    first = first > line->cells.first ? first : line->cells.first;
    end = end < line->cells.end ? end : line->cells.end;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* Returns the segments first to end - 1 of a line that are between visible points. */
static inline tp_grid_span tp_line_segments(tp_grid_span points, uint32_t first,
                                            uint32_t end)
{
    first = first > points.first ? first : points.first;
    end = end < points.end - 1u ? end : points.end - 1u;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* tp_line_points: range of the points of line k that are corners of visible cells.
 * tp_line_point: point m of line k after projection. */
tp_grid_span tp_line_points(const tp_frame *frame, uint32_t k);
tp_row_point tp_line_point(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                           uint32_t m);

/* Returns the first and the last point of tp_line_points(k) in end[0] and end[1],
 * projected, from left to right on the screen.  u of a point that needs clipping is
 * TP_GRID_NEEDS_CLIP. */
void tp_line_ends(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                  tp_row_point end[2]);

/* A range of columns of pixels, x1 not included; empty: x0 >= x1. */
typedef struct {
    int32_t x0, x1;
} tp_column_range;

/* scanline_water.c: walks a tile's lines from near to far.
 * tp_line_columns: the tile's columns where row k does not lie below the tile.
 * tp_line_next_columns: the columns where line k matters for the tile; *columns are those
 * of row k, then those of row k - 1; *columns are empty before the first line.
 * tp_line_reached: the segments of line k from the first piece in these columns to the last;
 * none: first >= end.
 * tp_line_load: makes the window hold the ends of these segments, or all points of line k. */
tp_column_range tp_line_columns(const tp_frame *frame, const tp_gbuffer *tile, uint32_t k);
tp_column_range tp_line_next_columns(const tp_frame *frame, const tp_gbuffer *tile,
                                     uint32_t k, tp_column_range *columns);
tp_grid_span tp_line_reached(const tp_frame *frame, uint32_t k, tp_column_range columns);
void tp_line_load(const tp_frame *frame, tp_grid_window *window, uint32_t k,
                  tp_grid_span segments, bool whole);

/* Lay out the lines' memory if rows can draw, and place the lines of a frame. */
void tp_lines_layout(tp_frame_buffers *buffers, tp_arena *arena, const tp_program *program,
                     const tp_scene *scene, const tp_config *config);
void tp_lines_place(tp_frame *frame);

#endif
