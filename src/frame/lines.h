/* SPDX-License-Identifier: MIT */
/* The grid's lines across the view, from near to far, for raster/rows.h.
 *
 * Of the grid's two ways lines go along the one that the camera looks across.  Row k of
 * cells lies between lines k and k + 1, counted as the grid counts; so do points. */
#ifndef TP_FRAME_LINES_H
#define TP_FRAME_LINES_H
#include "frame/frame.h"
#include "raster/rows.h"

/* A row of cells between two lines of water, from side to side; see rows.c. */
enum { TP_LINE_CUT = 1, TP_LINE_SIDED = 2, TP_LINE_WIDE = 4 };

typedef struct {
    tp_grid_span cells;         /* that may be seen */
    tp_grid_box  box;           /* of them all */
    uint16_t     is;            /* TP_LINE_CUT: drawn as triangles; its nearer line's ends
                                 * and the ones before are TP_LINE_SIDED */
} tp_frame_line;

/* The columns of pixels that a block of a line's segments takes, x1 included. */
typedef struct {
    int16_t x0, x1;
} tp_line_reach;

/* Lines of the grid from near to far, their points from left to right. */
typedef struct tp_frame_lines {
    uint32_t lines, points, blocks;     /* blocks of a row of cells */
    bool     upright;           /* lines are columns of the grid */
    bool     lines_back, points_back;   /* they come from the last to the first */
    const tp_grid_box *box;     /* lines x blocks, as the grid counts them */
    tp_frame_line  *line;       /* in the order of their places */
    tp_grid_box    *line_box;   /* of blocks of upright lines */
    tp_line_reach  *reach;      /* of each block of each line */
} tp_frame_lines;

/* Of a line that the window sees, where lines are rows. */
static inline const tp_grid_vertex *tp_line_vertex(const tp_frame *frame,
                                                   const tp_grid_window *window,
                                                   uint32_t k, uint32_t m)
{
    const tp_grid *grid = frame->parts.grid;
    return frame->parts.lines->upright ? &grid->vertex[(size_t)m * grid->cols + k]
                                       : &window->line[k & 1][m];
}

static inline bool tp_line_is_dry(const tp_frame *frame, uint32_t k, uint32_t m)
{
    return frame->parts.lines->upright ? tp_grid_cell_is_dry(frame->parts.grid, k, m)
                                : tp_grid_cell_is_dry(frame->parts.grid, m, k);
}

/* Cells [first, end) of block b that may be seen. */
static inline tp_grid_span tp_line_block_cells(const tp_frame_line *line, uint32_t b)
{
    uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;

    first = first > line->cells.first ? first : line->cells.first;
    end = end < line->cells.end ? end : line->cells.end;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* Segments of block b of the line. */
static inline tp_grid_span tp_line_block_segments(tp_grid_span points, uint32_t b)
{
    uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;

    first = first > points.first ? first : points.first;
    end = end < points.end - 1u ? end : points.end - 1u;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* Points of line k that the rows at either side have. */
tp_grid_span tp_line_points(const tp_frame *frame, uint32_t k);
tp_row_point tp_line_point(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                           uint32_t m);

/* Both ends of line k, in the order of the screen; the cut ones lie outside of it. */
void tp_line_ends(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                  tp_row_point end[2]);

void tp_lines_carve(tp_frame_parts *parts, tp_arena *arena, const tp_program *program,
                    const tp_scene *scene, const tp_config *config);
void tp_lines_place(tp_frame *frame);
#endif
