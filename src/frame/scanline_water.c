/* SPDX-License-Identifier: MIT */
/* Scanline water.  A tile walks the grid's lines from near to far and skips rows of cells
 * below the tile, in the columns of the cells' boxes, until the tile is covered.  Rows
 * clipped by the frustum within the picture's columns, few and at its lower edge, are
 * drawn as triangles. */
#include "frame/frame.h"

typedef struct {
    const tp_frame *frame;
    tp_grid_window  window;
    tp_rows         rows;
    int32_t         x0, x1;     /* columns of the current row of cells; empty: x0 >= x1 */
} walk;

static void draw_cells(walk *w, uint32_t k, uint32_t first, uint32_t end)
{
    tp_frame_draw_cells(w->frame, w->rows.tile, &w->window, k, first, end);
}

enum { GAP, JOIN, ON };

static bool is_beside(const tp_grid_box *box, int32_t x0, int32_t x1)
{
    return box->x0 >= x1 || box->x1 < x0;
}

static const tp_grid_box *row_boxes(const tp_frame *frame, uint32_t k)
{
    return frame->buffers.lines->box + (size_t)k * frame->buffers.lines->blocks;
}

/* Returns the tile's columns where row k does not lie below the tile. */
static void find_columns(const walk *w, uint32_t k, int32_t *x0, int32_t *x1)
{
    const tp_gbuffer *tile = w->rows.tile;
    const tp_frame_line *line = &w->frame->buffers.lines->line[k];
    const tp_grid_box *box = row_boxes(w->frame, k);

    *x0 = tile->x1;
    *x1 = tile->x0;
    if (is_beside(&line->box, tile->x0, tile->x1) || line->box.y0 >= tile->y1)
        return;
    for (uint32_t b = line->cells.first / TP_GRID_BLOCK;
         b * TP_GRID_BLOCK < line->cells.end; b++) {
        if (is_beside(&box[b], tile->x0, tile->x1) || box[b].y0 >= tile->y1)
            continue;
        *x0 = box[b].x0 < *x0 ? box[b].x0 : *x0;
        *x1 = box[b].x1 >= *x1 ? box[b].x1 + 1 : *x1;
    }
    *x0 = *x0 > tile->x0 ? *x0 : tile->x0;
    *x1 = *x1 < tile->x1 ? *x1 : tile->x1;
}

static void draw_triangles(walk *w, uint32_t k)
{
    const tp_frame_line *line = &w->frame->buffers.lines->line[k];
    const tp_grid_box *box = row_boxes(w->frame, k);

    for (uint32_t b = line->cells.first / TP_GRID_BLOCK;
         b * TP_GRID_BLOCK < line->cells.end; b++) {
        tp_grid_span cells = tp_line_block_cells(line, b);
        if (cells.first < cells.end && tp_box_overlaps_tile(&box[b], w->rows.tile))
            draw_cells(w, k, cells.first, cells.end);
    }
}

static void lay(walk *w, const tp_row_point *run, uint32_t count, int how)
{
    if (how == ON)
        tp_rows_draw_line(&w->rows, run, count);
    else
        tp_rows_restart_line(&w->rows, run, count, how == JOIN);
}

/* True if segment m of line k has land on both sides. */
static bool is_land(const tp_frame *frame, uint32_t k, uint32_t m)
{
    return frame->buffers.grid->dry && (k == 0 || tp_line_cell_is_dry(frame, k - 1, m))
           && (k + 1 == frame->buffers.lines->lines || tp_line_cell_is_dry(frame, k, m));
}

static bool is_outside_tile(const walk *w, int32_t left, int32_t right)
{
    return left == TP_GRID_NEEDS_CLIP || right == TP_GRID_NEEDS_CLIP
           || right <= 16 * w->rows.x0 || left >= 16 * w->rows.x1;
}

/* Draws the segments of line k from left to right. */
static void lay_segments(walk *w, uint32_t k, tp_grid_span part, int how)
{
    const tp_frame *frame = w->frame;
    const bool land = frame->buffers.grid->dry != NULL;
    int32_t  left = tp_line_vertex(&w->window, k, part.first)->u;
    tp_row_point run[TP_GRID_BLOCK + 1];
    uint32_t count = 0;

    for (uint32_t m = part.first; m < part.end; m++) {
        int32_t from = left;
        left = tp_line_vertex(&w->window, k, m + 1)->u;
        bool out = is_outside_tile(w, from, left);
        if (!out && land && is_land(frame, k, m)) {
            tp_rows_mark_gap(&w->rows, from, left);
            out = true;
        }
        if (out) {
            lay(w, run, count, how);
            count = 0;
            continue;
        }
        if (count == 0)
            run[count++] = tp_line_point(frame, &w->window, k, m);
        run[count++] = tp_line_point(frame, &w->window, k, m + 1);
    }
    TP_ASSERT(count <= TP_GRID_BLOCK + 1);
    lay(w, run, count, how);
}

static bool is_reached(const walk *w, tp_line_reach reach)
{
    return reach.x0 < w->rows.x1 && reach.x1 >= w->rows.x0;
}

/* Makes the window hold the walked part of line k, or all of the line. */
static void see_line(walk *w, uint32_t k, bool whole)
{
    const tp_frame_lines *lines = w->frame->buffers.lines;
    const tp_line_reach *reach = &lines->reach[(size_t)k * lines->blocks];
    tp_grid_span points = tp_line_points(w->frame, k);
    uint32_t first = UINT32_MAX, end = 0;

    for (uint32_t b = 0; b < lines->blocks; b++) {
        tp_grid_span part = tp_line_block_segments(points, b);
        if (part.first >= part.end || !(whole || is_reached(w, reach[b])))
            continue;
        first = part.first < first ? part.first : first;
        end = part.end + 1u;
    }
    if (first < end)
        tp_grid_window_load(w->frame->buffers.grid, &w->window, k, first, end);
}

static void lay_line(walk *w, uint32_t k, int how)
{
    const tp_frame_lines *lines = w->frame->buffers.lines;
    const tp_line_reach *reach = &w->frame->buffers.lines->reach[(size_t)k * lines->blocks];
    tp_grid_span points = tp_line_points(w->frame, k);

    for (uint32_t b = 0; b < lines->blocks; b++) {
        if (is_reached(w, reach[b]))
            lay_segments(w, k, tp_line_block_segments(points, b), how);
    }
}

/* -- middle lines -------------------------------------------------------------------- */

/* Middle of an edge on the screen; world coordinates are perspective-correct. */
static tp_row_point edge_middle(const tp_row_point *a, const tp_row_point *b)
{
    uint32_t sum = (a->zi >> 1) + (b->zi >> 1) + 1;
    int      shift = tp_clz(sum);
    int32_t  share = (int32_t)((uint64_t)(a->zi >> 1) * tp_recip_norm(sum << shift)
                               >> (33 - shift));
    int32_t  nx = ((int32_t)a->n >> 16) + ((int32_t)b->n >> 16);
    int32_t  nz = (int16_t)a->n + (int16_t)b->n;

    return (tp_row_point){
        (a->u + b->u) >> 1, (a->v + b->v) >> 1, (a->zi >> 1) + (b->zi >> 1),
        b->s + (int32_t)(((int64_t)a->s - b->s) * share >> 30),
        b->t + (int32_t)(((int64_t)a->t - b->t) * share >> 30),
        (uint32_t)(nx >> 1) << 16 | (uint16_t)(nz >> 1),
    };
}

/* Middles of three edges of cell m of row k, from left to right: left side, diagonal,
 * right side.  Returns false if a vertex is clipped or the cell is land. */
static bool find_edge_middles(const walk *w, uint32_t k, uint32_t m, tp_row_point to[3])
{
    const tp_frame *frame = w->frame;
    tp_row_point p[4];

    for (uint32_t i = 0; i < 4; i++)
        p[i] = tp_line_point(frame, &w->window, k + i % 2, m + i / 2);
    for (int i = 0; i < 4; i++)
        if (p[i].u == TP_GRID_NEEDS_CLIP)
            return false;
    to[0] = edge_middle(&p[0], &p[1]);
    to[1] = edge_middle(&p[0], &p[3]);
    to[2] = edge_middle(&p[2], &p[3]);
    return !tp_line_cell_is_dry(frame, k, m);
}

static bool is_beside_cell(const walk *w, uint32_t k, uint32_t m)
{
    int32_t  least = INT32_MAX, most = INT32_MIN;

    for (uint32_t i = 0; i < 4; i++) {
        int32_t u = tp_line_vertex(&w->window, k + i % 2, m + i / 2)->u;
        least = u < least ? u : least;
        most = u > most ? u : most;
    }
    return most <= 16 * w->rows.x0 || least >= 16 * w->rows.x1;
}

/* Draws the middle line of row k, for cells large in the picture: the triangles' own
 * points half way. */
static void lay_middles(walk *w, uint32_t k)
{
    const tp_frame *frame = w->frame;
    tp_grid_span cells = frame->buffers.lines->line[k].cells;

    for (uint32_t m = cells.first; m < cells.end; m++) {
        tp_row_point run[3];
        if (!is_beside_cell(w, k, m) && find_edge_middles(w, k, m, run))
            tp_rows_draw_line(&w->rows, run, 3);
    }
}

static void lay_one(walk *w, const tp_row_point *a, const tp_row_point *b)
{
    const tp_row_point run[2] = { *a, *b };
    tp_rows_draw_line(&w->rows, run, 2);
}

/* Draws line k after line k + 1, with the left and right ends of the row of cells between
 * both. */
static void lay_sided(walk *w, uint32_t k)
{
    tp_row_point was[2], now[2];

    tp_line_ends(w->frame, &w->window, k + 1, was);
    tp_line_ends(w->frame, &w->window, k, now);
    bool left = was[0].u != TP_GRID_NEEDS_CLIP && now[0].u != TP_GRID_NEEDS_CLIP;
    bool right = was[1].u != TP_GRID_NEEDS_CLIP && now[1].u != TP_GRID_NEEDS_CLIP;
    if (left)
        tp_rows_restart_side(&w->rows, &now[0], &was[0]);
    if (right)
        tp_rows_restart_side(&w->rows, &was[1], &now[1]);
    if (w->frame->buffers.lines->line[k].is & TP_LINE_WIDE)
        lay_middles(w, k);
    if (left)
        lay_one(w, &was[0], &now[0]);
    lay_line(w, k, ON);
    if (right)
        lay_one(w, &now[1], &was[1]);
}

/* Draws line k, the far end of the current row of cells and the near end of the next. */
static void advance_to_line(walk *w, uint32_t k, int how)
{
    int32_t x0 = w->x0, x1 = w->x1, next0 = 0, next1 = 0;

    if (k > 0)
        find_columns(w, k - 1, &next0, &next1);
    bool before = x0 < x1, behind = next0 < next1;
    w->x0 = next0;
    w->x1 = next1;
    if (!before && !behind)
        return;
    w->rows.x0 = !before || (behind && next0 < x0) ? next0 : x0;
    w->rows.x1 = !before || (behind && next1 > x1) ? next1 : x1;
    uint32_t is = how == ON && before ? w->frame->buffers.lines->line[k].is : 0;
    bool whole = is & (TP_LINE_SIDED | TP_LINE_WIDE);
    if (whole)
        see_line(w, k + 1, true);
    see_line(w, k, whole);
    if (is & TP_LINE_SIDED) {
        lay_sided(w, k);
        return;
    }
    if (is & TP_LINE_WIDE)
        lay_middles(w, k);
    lay_line(w, k, how);
}

static void draw_rows(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    const tp_frame_lines *lines = frame->buffers.lines;
    walk w = { .frame = frame, .window = tp_frame_grid_window(frame, memory) };
    int  how = GAP;

    tile->front_only = frame->cull_water;
    tp_rows_begin(&w.rows, tile, memory, tp_frame_has_solids(frame));
    for (uint32_t k = lines->lines; k-- > 0 && w.rows.open > 0;) {
        advance_to_line(&w, k, how);
        if (k == 0)
            break;
        const tp_frame_line *next = &lines->line[k - 1];
        if (next->cells.first >= next->cells.end) {
            how = GAP;
        } else if (next->is & TP_LINE_CUT) {
            draw_triangles(&w, k - 1);
            w.rows.solid = true;
            how = JOIN;
        } else {
            how = w.x0 < w.x1 ? ON : GAP;
        }
    }
}

const struct tp_water_renderer tp_method_rows = {
    .holds = tp_frame_can_draw_rows, .layout = tp_lines_layout,
    .place = tp_lines_place, .draw = draw_rows,
};
