/* SPDX-License-Identifier: MIT */
/* Scanline grid: the grid's lines across the view, ordered from near to far, for
 * raster/scanlines.h.
 *
 * Lines run along the grid axis across the camera's heading.  Row k of cells lies between
 * lines k and k + 1 in the grid's own order; points are numbered in the same order. */
#ifndef TP_FRAME_SCANLINE_GRID_H
#define TP_FRAME_SCANLINE_GRID_H
#include "frame/frame.h"
#include "raster/scanlines.h"

/* A row of cells between two neighbouring lines of water, from side to side; see
 * scanline_water.c. */
enum { TP_LINE_CUT = 1, TP_LINE_SIDED = 2, TP_LINE_WIDE = 4 };

typedef struct {
    tp_grid_span cells;         /* possibly visible cells */
    tp_grid_box  box;           /* picture box of these cells */
    uint16_t     is;            /* TP_LINE_CUT: drawn as triangles.  TP_LINE_SIDED: an end
                                 * of its lines is inside of the picture.  TP_LINE_WIDE:
                                 * wide cells */
} tp_frame_line;

/* Pixel columns covered by a block of a line's segments, x1 included. */
typedef struct {
    int16_t x0, x1;
} tp_line_reach;

/* Lines of the grid from near to far, their points from left to right. */
typedef struct tp_frame_lines {
    uint32_t lines, points, blocks;     /* blocks per row of cells */
    bool     upright;           /* true: lines are columns of the grid */
    bool     lines_back, points_back;   /* true: traversed in descending order */
    const tp_grid_box *box;     /* lines x blocks boxes, in the grid's order */
    tp_frame_line  *line;       /* one for each row of cells, in the grid's order */
    tp_grid_box    *line_box;   /* boxes of blocks of upright lines */
    tp_line_reach  *reach;      /* of each block of each line */
} tp_frame_lines;

/* Point m of line k.  Where lines are rows of the grid, the window must hold line k. */
static inline const tp_grid_vertex *tp_line_vertex(const tp_frame *frame,
                                                   const tp_grid_window *window,
                                                   uint32_t k, uint32_t m)
{
    const tp_grid *grid = frame->buffers.grid;
    return frame->buffers.lines->upright ? &grid->vertex[(size_t)m * grid->cols + k]
                                         : &window->line[k & 1][m];
}

static inline bool tp_line_is_dry(const tp_frame *frame, uint32_t k, uint32_t m)
{
    return frame->buffers.lines->upright ? tp_grid_cell_is_dry(frame->buffers.grid, k, m)
                                         : tp_grid_cell_is_dry(frame->buffers.grid, m, k);
}

/* Returns the cells [first, end) of block b, without cells out of view. */
static inline tp_grid_span tp_line_block_cells(const tp_frame_line *line, uint32_t b)
{
    uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;

    first = first > line->cells.first ? first : line->cells.first;
    end = end < line->cells.end ? end : line->cells.end;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* Returns the segments of block b of the line. */
static inline tp_grid_span tp_line_block_segments(tp_grid_span points, uint32_t b)
{
    uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;

    first = first > points.first ? first : points.first;
    end = end < points.end - 1u ? end : points.end - 1u;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* tp_line_points: the points of line k used by visible cells on either side;
 * tp_line_point: one point of the line. */
tp_grid_span tp_line_points(const tp_frame *frame, uint32_t k);
tp_row_point tp_line_point(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                           uint32_t m);

/* Both ends of line k, from left to right on the screen; clipped points are marked
 * TP_GRID_NEEDS_CLIP. */
void tp_line_ends(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                  tp_row_point end[2]);

void tp_lines_layout(tp_frame_buffers *buffers, tp_arena *arena, const tp_program *program,
                    const tp_scene *scene, const tp_config *config);
void tp_lines_place(tp_frame *frame);
#endif
