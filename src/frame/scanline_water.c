/* SPDX-License-Identifier: MIT */
/* Scanline water.  A tile walks the grid's lines from near to far and skips rows of cells
 * below the tile, in the columns of the cells' boxes, until the tile is covered.  Rows
 * clipped by the frustum within the picture's columns, few and at its lower edge, are
 * drawn as triangles. */
#include "frame/scanline_grid.h"

typedef struct tp_row_walk {
    const tp_frame *frame;
    tp_grid_window  window;
    tp_rows         rows;
    tp_column_range      columns;    /* of the current row of cells; empty: x0 >= x1 */
} walk;

enum { GAP, JOIN, ON };

static bool is_beside(const tp_grid_box *box, int32_t x0, int32_t x1)
{
    return box->x0 >= x1 || box->x1 < x0;
}

static const tp_grid_box *row_boxes(const tp_frame *frame, uint32_t k)
{
    return frame->buffers.lines->box + (size_t)k * frame->buffers.lines->blocks;
}

tp_column_range tp_line_columns(const tp_frame *frame, const tp_gbuffer *tile, uint32_t k)
{
    const tp_frame_line *line = &frame->buffers.lines->line[k];
    const tp_grid_box *box = row_boxes(frame, k);
    tp_column_range c = { tile->x1, tile->x0 };

    if (is_beside(&line->box, tile->x0, tile->x1) || line->box.y0 >= tile->y1)
        return c;
    for (uint32_t b = line->cells.first / TP_GRID_BLOCK;
         b * TP_GRID_BLOCK < line->cells.end; b++) {
        if (is_beside(&box[b], tile->x0, tile->x1) || box[b].y0 >= tile->y1)
            continue;
        c.x0 = box[b].x0 < c.x0 ? box[b].x0 : c.x0;
        c.x1 = box[b].x1 >= c.x1 ? box[b].x1 + 1 : c.x1;
    }
    c.x0 = c.x0 > tile->x0 ? c.x0 : tile->x0;
    c.x1 = c.x1 < tile->x1 ? c.x1 : tile->x1;
    return c;
}

static void lay(walk *w, const tp_row_point *run, uint32_t count, int how)
{
    if (how == ON)
        tp_rows_draw_line(&w->rows, run, count);
    else
        tp_rows_restart_line(&w->rows, run, count, how == JOIN);
}

static bool is_land(const tp_frame *frame, uint32_t k, uint32_t m)
{
    return frame->buffers.grid->dry && (k == 0 || tp_line_cell_is_dry(frame, k - 1, m))
           && (k + 1 == frame->buffers.lines->lines || tp_line_cell_is_dry(frame, k, m));
}

const struct tp_draw_row_land tp_draw_row_land = { is_land, tp_rows_mark_gap };

static bool is_outside_tile(const walk *w, int32_t left, int32_t right)
{
    return left == TP_GRID_NEEDS_CLIP || right == TP_GRID_NEEDS_CLIP
           || right <= 16 * w->rows.x0 || left >= 16 * w->rows.x1;
}

enum { RUN = TP_GRID_BLOCK };   /* segments laid at a time */

/* Draws segments of line k, RUN at the most, from left to right. */
static void lay_run(walk *w, uint32_t k, tp_grid_span part, int how)
{
    const tp_frame *frame = w->frame;
    const struct tp_draw_row_land *land = tp_line_land(frame);
    int32_t  left = tp_line_vertex(&w->window, k, part.first)->u;
    tp_row_point run[RUN + 1];
    uint32_t count = 0;

    for (uint32_t m = part.first; m < part.end; m++) {
        int32_t from = left;
        left = tp_line_vertex(&w->window, k, m + 1)->u;
        bool out = is_outside_tile(w, from, left);
        if (!out && land && land->is_land(frame, k, m)) {
            land->mark_gap(&w->rows, from, left);
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
    TP_ASSERT(count <= RUN + 1);
    lay(w, run, count, how);
}

static bool is_reached(tp_line_reach reach, tp_column_range columns)
{
    return reach.x0 < columns.x1 && reach.x1 >= columns.x0;
}

tp_grid_span tp_line_reached(const tp_frame *frame, uint32_t k, tp_column_range columns)
{
    const tp_frame_lines *lines = frame->buffers.lines;
    const tp_line_reach *reach = &lines->reach[(size_t)k * lines->pieces];
    uint32_t first = 0, end = lines->pieces;

    while (first < end && !is_reached(reach[first], columns))
        first++;
    while (first < end && !is_reached(reach[end - 1], columns))
        end--;
    return tp_line_segments(tp_line_points(frame, k), first << lines->piece_bits,
                            end << lines->piece_bits);
}

void tp_line_load(const tp_frame *frame, tp_grid_window *window, uint32_t k,
                  tp_grid_span segments, bool whole)
{
    const tp_grid_span points = tp_line_points(frame, k);

    if (whole)
        segments = tp_line_segments(points, points.first, points.end);
    TP_ASSERT(segments.first >= points.first || segments.first >= segments.end);
    if (segments.first < segments.end)
        tp_grid_window_load(frame->buffers.grid, window, k, segments.first,
                            segments.end + 1u);
}

/* Draws segments of line k from left to right. */
static void lay_line(walk *w, uint32_t k, tp_grid_span segments, int how)
{
    for (uint32_t first = segments.first; first < segments.end; first += RUN) {
        const uint32_t end = first + RUN < segments.end ? first + RUN : segments.end;
        lay_run(w, k, (tp_grid_span){ (uint16_t)first, (uint16_t)end }, how);
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
static void lay_sided(walk *w, uint32_t k, tp_grid_span segments)
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
        w->frame->program->draw.row_middles->lay(w, k);
    if (left)
        lay_one(w, &was[0], &now[0]);
    lay_line(w, k, segments, ON);
    if (right)
        lay_one(w, &now[1], &was[1]);
}

tp_column_range tp_line_next_columns(const tp_frame *frame, const tp_gbuffer *tile, uint32_t k,
                           tp_column_range *columns)
{
    const tp_column_range was = *columns, none = { 0, 0 };
    const tp_column_range next = k > 0 ? tp_line_columns(frame, tile, k - 1) : none;
    const bool before = was.x0 < was.x1, behind = next.x0 < next.x1;

    *columns = next;
    if (!before && !behind)
        return none;
    return (tp_column_range){ !before || (behind && next.x0 < was.x0) ? next.x0 : was.x0,
                         !before || (behind && next.x1 > was.x1) ? next.x1 : was.x1 };
}

/* Draws line k, the far end of the current row of cells and the near end of the next. */
static void advance_to_line(walk *w, uint32_t k, int how)
{
    const bool before = w->columns.x0 < w->columns.x1;
    const tp_column_range walked = tp_line_next_columns(w->frame, w->rows.tile, k, &w->columns);

    if (walked.x0 >= walked.x1)
        return;
    w->rows.x0 = walked.x0;
    w->rows.x1 = walked.x1;
    const tp_grid_span segments = tp_line_reached(w->frame, k, walked);
    uint32_t is = how == ON && before ? w->frame->buffers.lines->line[k].is : 0;
    bool whole = is & (TP_LINE_SIDED | TP_LINE_WIDE);
    if (whole)
        tp_line_load(w->frame, &w->window, k + 1, segments, true);
    tp_line_load(w->frame, &w->window, k, segments, whole);
    if (is & TP_LINE_SIDED) {
        w->frame->program->draw.row_sides->lay(w, k, segments);
        return;
    }
    if (is & TP_LINE_WIDE)
        w->frame->program->draw.row_middles->lay(w, k);
    lay_line(w, k, segments, how);
}

static void draw_rows(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    const tp_frame_lines *lines = frame->buffers.lines;
    walk w = { .frame = frame, .window = tp_frame_grid_window(frame, tile, memory) };
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
            if (frame->program->draw.cells)
                frame->program->draw.cells->draw_row(frame, tile, &w.window, k - 1);
            w.rows.solid = true;
            how = JOIN;
        } else {
            how = w.columns.x0 < w.columns.x1 ? ON : GAP;
        }
    }
}

const struct tp_draw_row_sides tp_draw_row_sides = { lay_sided };

const struct tp_draw_row_middles tp_draw_row_middles = { lay_middles };

const struct tp_water_renderer tp_method_rows = {
    .holds = tp_frame_can_draw_rows, .layout = tp_lines_layout,
    .place = tp_lines_place, .draw = draw_rows,
};
