/* SPDX-License-Identifier: MIT */
/* The cells of the water's grid as triangles.  Cells with a corner that cannot be projected
 * are clipped by the frustum.  Scanline water needs this for clipped cells only. */
#include "frame/frame.h"
#include "frame/renderers.h"
#include "view/fan.h"

static tp_screen_vertex make_corner(const tp_grid *grid, const tp_grid_window *window,
                                    uint32_t i, uint32_t j)
{
    const tp_grid_vertex *vertex = &window->line[j & 1][i];
    return (tp_screen_vertex){
        .u = vertex->u, .v = vertex->v, .zi = vertex->zi,
        .s = tp_grid_s(grid, i, j), .t = tp_grid_t(grid, i, j),
        .n = { vertex->slope_x, vertex->slope_z, 0 },
    };
}

/* Vertex order of a cell: (i, j), (i+1, j), (i+1, j+1), (i, j+1).  Both triangles are
 * front faces when seen from above. */
static const uint8_t halves[2][3] = { { 0, 3, 2 }, { 0, 2, 1 } };

static bool needs_clipping(const tp_grid_window *window, uint32_t i, uint32_t j)
{
    const tp_grid_vertex *a = &window->line[j & 1][i], *b = &window->line[(j + 1) & 1][i];

    return a[0].u == TP_GRID_NEEDS_CLIP || a[1].u == TP_GRID_NEEDS_CLIP
           || b[0].u == TP_GRID_NEEDS_CLIP || b[1].u == TP_GRID_NEEDS_CLIP;
}

/* Cells of a run at most: 8 take 224 bytes more stack, beyond the limit of its gate, and
 * save 0.28 M instructions of the 70 M of storm. */
#define RUN 4

/* A run of neighbouring cells that need clipping, with their corners on both lines. */
typedef struct {
    uint32_t       first, end;          /* cells; end is 0 before the first run */
    tp_view_vertex line[2][RUN + 1];
} clipped_run;

/* Makes the corners of the cells that need clipping from cell i of row j on, if the run does
 * not have them yet; the cells end before cell `stop`.  A wave model sets up a line of
 * vertices once a run. */
static void extend_run(const tp_frame *frame, const tp_grid_window *window, uint32_t i,
                       uint32_t stop, uint32_t j, clipped_run *run)
{
    if (i < run->end)
        return;
    run->first = i;
    run->end = i + 1;
    stop = stop < i + RUN ? stop : i + RUN;
    while (run->end < stop && needs_clipping(window, run->end, j))
        run->end++;
    for (uint32_t k = 0; k < 2; k++)
        tp_grid_make_view_vertices(frame->buffers.grid, window->line[(j + k) & 1], j + k, i,
                                   run->end + 1, run->line[k]);
}

/* Clips one triangle of a cell by the frustum; returns the number of vertices left. */
static int clip_cell_half(const tp_frame *frame, const clipped_run *run, uint32_t i,
                          int half, tp_screen_vertex to[TP_CLIP_VERTICES])
{
    const uint8_t *k = halves[half];
    const tp_view_vertex *a = &run->line[0][i - run->first];
    const tp_view_vertex *b = &run->line[1][i - run->first];
    const tp_view_vertex *const c[4] = { &a[0], &a[1], &b[1], &b[0] };
    const tp_view_vertex in[3] = { *c[k[0]], *c[k[1]], *c[k[2]] };

    return tp_clipped_corners(&frame->projection, NULL, in, to);
}

/* Draws a cell of the run. */
static void draw_clipped_cell(const tp_frame *frame, const tp_gbuffer *tile,
                              const clipped_run *run, uint32_t i)
{
    tp_screen_vertex corner[TP_CLIP_VERTICES];

    for (int half = 0; half < 2; half++) {
        int count = clip_cell_half(frame, run, i, half, corner);
        for (int k = 2; k < count && frame->draw_triangle; k++)
            frame->draw_triangle(tile, &corner[0], &corner[k - 1], &corner[k]);
        *tile->dropped += count > 2 && !frame->draw_triangle;
    }
}

/* The places of vertices beside a tile, 28.4 px: all pixel centres of the tile are right of
 * `left` or less, left of `right` or more, and so on. */
typedef struct {
    int32_t left, right, above, below;
} tile_sides;

static tile_sides tile_sides_make(const tp_gbuffer *tile)
{
    return (tile_sides){ 16 * tile->x0 + 8, 16 * tile->x1 - 7, 16 * tile->y0 + 8,
                         16 * tile->y1 - 7 };
}

/* Returns on which sides of the tile a vertex lies: the sign bits of four differences.  A
 * vertex that needs clipping lies anywhere, so the answer is 0. */
TP_ALWAYS_INLINE uint32_t outside_of_tile(const tile_sides *tile, const tp_grid_vertex *vertex)
{
    const int32_t u = vertex->u, v = vertex->v;

    if (u == TP_GRID_NEEDS_CLIP)
        return 0;
    return (uint32_t)(v - tile->above - 1) >> 31 | (uint32_t)(tile->below - v - 1) >> 31 << 1
           | (uint32_t)(u - tile->left - 1) >> 31 << 2
           | (uint32_t)(tile->right - u - 1) >> 31 << 3;
}

/* The two vertices of a column, on lines j and j + 1. */
typedef struct {
    uint32_t outside;           /* sides of the tile that both lie beyond */
    bool     made;              /* true if the corners are */
    tp_screen_vertex corner[2];
} column;

TP_ALWAYS_INLINE void begin_column(column *to, const tile_sides *tile,
                                   const tp_grid_vertex *above, const tp_grid_vertex *below)
{
    to->outside = outside_of_tile(tile, above) & outside_of_tile(tile, below);
    to->made = false;
}

static void make_corners(column *to, const tp_grid *grid, const tp_grid_window *window,
                         uint32_t i, uint32_t j)
{
    if (to->made)
        return;
    to->corner[0] = make_corner(grid, window, i, j);
    to->corner[1] = make_corner(grid, window, i, j + 1);
    to->made = true;
}

/* Draws cells first to end - 1; the right side of a cell is the left side of the next
 * cell.  Most cells of a block lie above or below the tile. */
static void draw_cells(const tp_frame *frame, const tp_gbuffer *tile,
                       tp_grid_window *window, uint32_t j, uint32_t first, uint32_t end)
{
    TP_ASSERT(first < end && end < frame->buffers.grid->cols);
    TP_ASSERT(j + 1 < frame->buffers.grid->rows);
    const tp_grid *grid = frame->buffers.grid;
    const tile_sides sides = tile_sides_make(tile);
    column side[2];
    clipped_run run;

    tp_grid_window_load(grid, window, j, first, end + 1);
    tp_grid_window_load(grid, window, j + 1, first, end + 1);
    const tp_grid_vertex *above = window->line[j & 1], *below = window->line[(j + 1) & 1];
    begin_column(&side[first & 1], &sides, &above[first], &below[first]);
    run.end = 0;
    for (uint32_t i = first; i < end; i++) {
        column *left = &side[i & 1], *right = &side[(i + 1) & 1];
        begin_column(right, &sides, &above[i + 1], &below[i + 1]);
        if (left->outside & right->outside || tp_grid_cell_is_dry(grid, i, j))
            continue;
        if (needs_clipping(window, i, j)) {
            extend_run(frame, window, i, end, j, &run);
            draw_clipped_cell(frame, tile, &run, i);
            continue;
        }
        make_corners(left, grid, window, i, j);
        make_corners(right, grid, window, i + 1, j);
        const uint32_t exact =
            frame->draw_cell ? frame->draw_cell(tile, left->corner, right->corner)
                             : TP_CELL_WHOLE;
        if (exact && frame->draw_triangle)
            tp_cell_draw_halves(frame->draw_triangle, tile, left->corner, right->corner,
                                exact);
        else
            *tile->dropped += exact != 0;
    }
}

static void draw_row(const tp_frame *frame, const tp_gbuffer *tile, tp_grid_window *window,
                     uint32_t j)
{
    const tp_grid *grid = frame->buffers.grid;
    const tp_grid_box *box = grid->box + (size_t)j * grid->blocks;
    tp_grid_span span = grid->span[j];

    for (uint32_t b = span.first / TP_GRID_BLOCK; b * TP_GRID_BLOCK < span.end; b++) {
        tp_grid_span cells = tp_grid_block_span(span, b);
        if (cells.first < cells.end && tp_box_overlaps_tile(&box[b], tile))
            draw_cells(frame, tile, window, j, cells.first, cells.end);
    }
}

/* -- boxes --------------------------------------------------------------------------- */

static void widen_box_by_clipped_cell(const tp_frame *frame, tp_grid_box *box,
                                      const clipped_run *run, uint32_t i)
{
    tp_screen_vertex corner[TP_CLIP_VERTICES];

    for (int half = 0; half < 2; half++)
        for (int k = clip_cell_half(frame, run, i, half, corner) - 1; k >= 0; k--)
            tp_box_widen(box, corner[k].u, corner[k].v);
}

static tp_grid_box cells_box(tp_frame *frame, uint32_t j, uint32_t first, uint32_t end)
{
    TP_ASSERT(end < frame->buffers.grid->cols && j + 1 < frame->buffers.grid->rows);
    tp_grid *grid = frame->buffers.grid;
    tp_grid_window *window = &grid->window;
    tp_grid_box box = TP_BOX_NONE;
    clipped_run run;

    run.end = 0;
    tp_grid_window_load(grid, window, j, first, end + 1);
    tp_grid_window_load(grid, window, j + 1, first, end + 1);
    for (uint32_t i = first; i < end; i++) {
        if (needs_clipping(window, i, j)) {
            extend_run(frame, window, i, end, j, &run);
            widen_box_by_clipped_cell(frame, &box, &run, i);
            continue;
        }
        for (uint32_t k = 0; k < 4; k++) {
            const tp_grid_vertex *at = &window->line[(j + k / 2) & 1][i + k % 2];
            tp_box_widen(&box, at->u, at->v);
        }
    }
    return box;
}

const struct tp_draw_cells tp_draw_cells = { .draw_row = draw_row, .box = cells_box };

const struct tp_draw_wide_solids tp_draw_wide_solids = { tp_tri_solid_wide };
const struct tp_draw_exact_triangles tp_draw_exact_triangles = { tp_tri_water };
