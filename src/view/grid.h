/* SPDX-License-Identifier: MIT */
/*
 * The water's grid: columns and rows of lines; their intersections, the grid vertices,
 * are displaced and projected.
 *
 * The middle of the grid has square cells of equal size.  If the scene asks for water at
 * a larger distance, the outer eighth of the lines at each side (at most TP_GRID_FLANK)
 * forms a flat skirt up to that distance, with steps that grow by a constant ratio.
 * Waves fade out before the skirt, over the last eighth of the middle.  A grid that
 * follows the camera moves by whole cells, so its vertices keep their world positions and
 * nothing swims.
 *
 * Texture coordinates are rest positions, so a column has a constant s and a row a
 * constant t. view/surface.h describes the evaluation of a vertex.
 */
#ifndef TP_VIEW_GRID_H
#define TP_VIEW_GRID_H
#include "base/base.h"
#include "view/surface.h"

#define TP_GRID_FLANK 12
#define TP_GRID_BLOCK 16        /* cells of a row with a common bounding box */

/* Bounding box in whole pixels, x1 and y1 included. */
typedef struct {
    int16_t x0, y0, x1, y1;
} tp_grid_box;

typedef struct {
    uint16_t first, end;        /* visible cells of a row */
} tp_grid_span;

/* Two neighbouring rows of vertices: row j is line[j & 1]. */
typedef struct {
    const tp_grid_vertex *line[2];
    tp_grid_vertex *memory;     /* for a streamed grid: two rows */
    uint32_t        row[2];     /* rows in memory; their evaluated vertices are in `done` */
    tp_grid_span    done[2];
} tp_grid_window;

typedef struct {
    uint32_t cols, rows;        /* number of lines; cells are one fewer */
    uint32_t most_cols, most_rows;      /* number of lines in memory */
    uint32_t blocks;            /* blocks in a row of cells */
    tp_grid_line   *column, *row;
    tp_grid_vertex *vertex;     /* rows x cols; NULL if the grid is streamed */
    bool            streams;
    tp_grid_window  window;     /* for tp_grid_evaluate_row, valid until the next call */
    tp_grid_span   *span;       /* visible cells of each row */
    tp_grid_box    *box;        /* bounding boxes, (rows - 1) x blocks */
    uint32_t vertices;          /* vertices evaluated in the last frame */
    tp_vertex_frame   frame;
    tp_vertex_columns columns;
    tp_grid_span      waves;    /* columns with waves */
    tp_vec3  *sheet[3];         /* displaced vertices of coastal water, three rows */
    uint32_t  sheets;           /* displaced rows; the last is (sheets - 1) % 3 */
    uint32_t *dry;              /* a bit per vertex of coastal water: on land */
    struct tp_fan *fan;         /* view/fan.h; NULL: lines along x and z */
} tp_grid;

void tp_grid_layout(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows);

/* Allocates a grid without stored vertices: a window evaluates its vertices again each
 * time, with the same bits.  Not for coastal water.  Room for `waves` swells; further
 * swells are dropped. */
void tp_grid_layout_streamed(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows,
                             uint32_t waves);

/* Allocates the additional tables of coastal water for a number of vertices. */
void tp_grid_layout_coastal(tp_grid *grid, tp_arena *arena, uint32_t vertices);

/* A horizontal rectangle in world coordinates, m. */
typedef struct {
    tp_fx x0, x1, z0, z1;
} tp_rectangle;

/* Rings and pools of a scene; rows of a fan are dense up to their farthest place.  The
 * numbers depend on the scene alone, so that rows do not jump when a ring begins. */
typedef struct {
    tp_fx length;               /* of the shortest waves to hold, m; 0: neither */
    tp_rectangle sides;         /* around all of them */
    bool  walled;               /* the water ends at these sides */
} tp_water_detail;

/* Adds waves of a length in a rectangle. */
void tp_grid_detail_widen(tp_water_detail *to, int64_t length, tp_rectangle by);

/* The inputs of a grid for a frame. */
typedef struct {
    const tp_projection *projection;
    const tp_surface *surface;
    uint32_t width, height;     /* size of the picture, px */
    tp_fx cell, reach;
    bool  follow;
    uint32_t vertices;          /* budget of a fan; 0: no fan */
    tp_water_detail detail;
} tp_grid_view;

static inline bool tp_grid_vertex_is_dry(const tp_grid *grid, uint32_t i, uint32_t j)
{
    size_t at = (size_t)j * grid->cols + i;
    return grid->dry[at / 32] >> at % 32 & 1;
}

/* True if all four vertices of a visible cell are on land, so the cell has no water. */
static inline bool tp_grid_cell_is_dry(const tp_grid *grid, uint32_t i, uint32_t j)
{
    return grid->dry && grid->frame.surface->coastal && tp_grid_vertex_is_dry(grid, i, j)
           && tp_grid_vertex_is_dry(grid, i + 1, j)
           && tp_grid_vertex_is_dry(grid, i, j + 1)
           && tp_grid_vertex_is_dry(grid, i + 1, j + 1);
}

/* grid_lines.c: sets the positions of the columns, or of the rows along z; returns the
 * number of skirt lines at each side. */
void tp_grid_lines_place(tp_grid_line *line, uint32_t count, const tp_grid_view *view,
                         bool along_z);
uint32_t tp_grid_lines_skirt_count(uint32_t count, const tp_grid_view *view);

/* Extent of the lines along an axis, m: first and last line; `calm`, the interval with
 * waves; `fading`, the width of the fade at the ends of the interval, 0 without a fade. */
typedef struct {
    tp_fx first, last, calm[2], fading;
} tp_grid_extent;

tp_grid_extent tp_grid_lines_extent(uint32_t count, const tp_grid_view *view, bool along_z);

/* Returns the weight of the waves at a position, 0..1, as tp_grid_line.fade. */
tp_fx tp_grid_extent_wave_weight(const tp_grid_extent *extent, tp_fx place);

/* tp_grid_set_lines_and_cells places the lines and finds the visible cells of each row.
 * tp_grid_evaluate_row then evaluates the vertices of row j, in order from 0, and completes
 * the bounding boxes of row j - 1.  tp_grid_evaluate_vertices does both for all rows. */
void tp_grid_evaluate_vertices(tp_grid *grid, const tp_grid_view *view);
void tp_grid_set_lines_and_cells(tp_grid *grid, const tp_grid_view *view);
void tp_grid_evaluate_row(tp_grid *grid, uint32_t j);

/* Returns a window of the caller, so that several threads can read a placed grid.
 * `memory` has TP_GRID_WINDOW(most_cols) bytes; unused if vertices are stored. */
#define TP_GRID_WINDOW(cols) (2 * (size_t)(cols) * sizeof(tp_grid_vertex))
tp_grid_window tp_grid_window_init(void *memory);

/* Makes vertices first to end - 1 of row j available in the window.  They replace row
 * j - 2 or j + 2, and extend vertices of row j already in the window. */
void tp_grid_window_load(const tp_grid *grid, tp_grid_window *window, uint32_t j,
                         uint32_t first, uint32_t end);

/* Evaluates vertices first to end - 1 of row j again, before projection, for visible cells
 * that need clipping: to[0] is vertex `first`.  Projection and surface are those of the last
 * tp_grid_evaluate_vertices; slopes come from the row's vertices, row[0] at column 0. */
void tp_grid_make_view_vertices(const tp_grid *grid, const tp_grid_vertex *row, uint32_t j,
                                uint32_t first, uint32_t end, tp_view_vertex *to);

/* -- coastal water ------------------------------------------------------------------- */

/*
 * Each vertex of coastal water is displaced by the wave model.  Waves may break and
 * overhang, so slopes are differences between the four neighbours of a vertex.  Three
 * displaced rows are kept; each is evaluated once.
 */

static inline bool tp_grid_is_coastal(const tp_grid *grid)
{
    return grid->frame.surface->coastal && grid->dry;
}

/* Returns the vertices of row j, first to end - 1, that the cells on both sides need. */
tp_grid_span tp_grid_needed_vertices(const tp_grid *grid, uint32_t j);

#endif
