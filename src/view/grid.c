/* SPDX-License-Identifier: MIT */
/* The water's grid; see the header for the idea. */
#include "view/fan.h"
#include "view/wave_models.h"

void tp_grid_detail_widen(tp_water_detail *to, int64_t length, tp_rectangle by)
{
    const tp_fx most = tp_fx_saturate(length);
    tp_rectangle *sides = &to->sides;

    if (to->length == 0) {
        *to = (tp_water_detail){ .length = most, .sides = by };
        return;
    }
    to->length = most < to->length ? most : to->length;
    sides->x0 = by.x0 < sides->x0 ? by.x0 : sides->x0;
    sides->x1 = by.x1 > sides->x1 ? by.x1 : sides->x1;
    sides->z0 = by.z0 < sides->z0 ? by.z0 : sides->z0;
    sides->z1 = by.z1 > sides->z1 ? by.z1 : sides->z1;
}

/* Allocates all tables except the vertices. */
static void layout_tables(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows,
                          uint32_t waves)
{
    TP_ASSERT(cols >= 2 && rows >= 2 && waves <= TP_WAVES);
    grid->cols = grid->most_cols = cols;
    grid->rows = grid->most_rows = rows;
    grid->blocks = (cols - 2) / TP_GRID_BLOCK + 1;
    grid->column = tp_arena_alloc(arena, cols, sizeof *grid->column);
    grid->row = tp_arena_alloc(arena, rows, sizeof *grid->row);
    grid->columns.line = grid->column;
    for (int axis = 0; axis < 3; axis++)
        grid->columns.rest[axis] = tp_arena_alloc(arena, cols, sizeof(int32_t));
    grid->frame.most = waves;
    grid->columns.turn = tp_arena_alloc(arena, cols * waves, sizeof *grid->columns.turn);
    grid->columns.pair = tp_arena_alloc(arena, cols * waves, sizeof *grid->columns.pair);
    grid->span = tp_arena_alloc(arena, rows - 1, sizeof *grid->span);
    grid->box = tp_arena_alloc(arena, (size_t)(rows - 1) * grid->blocks,
                              sizeof *grid->box);
    grid->sheet[0] = grid->sheet[1] = grid->sheet[2] = NULL;
    grid->dry = NULL;
    grid->fan = NULL;
}

void tp_grid_layout(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows)
{
    layout_tables(grid, arena, cols, rows, TP_WAVES);
    grid->vertex = tp_arena_alloc(arena, (size_t)cols * rows, sizeof *grid->vertex);
    grid->streams = false;
    grid->window = tp_grid_window_init(NULL);
}

void tp_grid_layout_streamed(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows,
                             uint32_t waves)
{
    layout_tables(grid, arena, cols, rows, waves);
    grid->vertex = NULL;
    grid->streams = true;
    grid->window = tp_grid_window_init(
        tp_arena_alloc(arena, 2 * (size_t)cols, sizeof *grid->vertex));
}

void tp_grid_layout_coastal(tp_grid *grid, tp_arena *arena, uint32_t vertices)
{
    for (int k = 0; k < 3; k++)
        grid->sheet[k] = tp_arena_alloc(arena, grid->most_cols, sizeof *grid->sheet[k]);
    grid->dry = tp_arena_alloc(arena, ((size_t)vertices + 31) / 32, sizeof *grid->dry);
}

/* -- visible cells ------------------------------------------------------------------- */

/* Returns an upper bound of the signed distance n . p + d from the plane, for the water of
 * the row of cells z0..z1 at x = 0; n.x x is the rest of the distance at x.  A vertex is
 * displaced by at most `max_displacement` in every direction. */
static int64_t max_plane_distance_at_x0(const tp_plane *p, tp_fx z0, tp_fx z1,
                                        tp_fx max_displacement)
{
    tp_fx z = p->n.z > 0 ? z1 : z0;
    return ((int64_t)p->n.z * z >> 30) + p->d + max_displacement + 2;
}

/* Returns a border column of a row against a plane. n.x > 0: the last column outside,
 * before the row enters the inner side; else: the first column outside, after the row
 * leaves the inner side.  Coordinates of columns increase, so the column is unique.
 * `distance_at_x0`: the row's max_plane_distance_at_x0.  The search starts at the
 * result of the previous row. */
static uint32_t find_side_column(const tp_grid *grid, const tp_plane *plane,
                                 int64_t distance_at_x0, uint32_t start)
{
    const tp_grid_line *column = grid->column;
    uint32_t last = grid->cols - 1;
    int64_t  nx = plane->n.x;

    if (nx > 0) {
        while (start > 0 && (nx * column[start].place >> 30) + distance_at_x0 >= 0)
            start--;
        while (start < last && (nx * column[start + 1].place >> 30) + distance_at_x0 < 0)
            start++;
    } else {
        while (start < last && (nx * column[start].place >> 30) + distance_at_x0 >= 0)
            start++;
        while (start > 0 && (nx * column[start - 1].place >> 30) + distance_at_x0 < 0)
            start--;
    }
    return start;
}

/* Returns the cells of row j that touch the view: the cells between all planes' columns. */
static tp_grid_span seen_cells(const tp_grid *grid, const tp_plane *planes, uint32_t j,
                               tp_fx max_displacement,
                               uint32_t side_column[TP_PROJECTION_PLANES])
{
    uint32_t first = 0, end = grid->cols - 1;

    for (int k = 0; k < TP_PROJECTION_PLANES; k++) {
        int64_t at_x0 = max_plane_distance_at_x0(&planes[k], grid->row[j].place,
                                                 grid->row[j + 1].place, max_displacement);
        side_column[k] = find_side_column(grid, &planes[k], at_x0, side_column[k]);
        if (planes[k].n.x > 0)
            first = side_column[k] > first ? side_column[k] : first;
        else
            end = side_column[k] < end ? side_column[k] : end;
    }
    return (tp_grid_span){ (uint16_t)(first < end ? first : end), (uint16_t)end };
}

/* -- vertices ------------------------------------------------------------------------ */

/* Returns the range of columns that waves move.  The outer columns at both sides, skirts
 * included, have a fade weight of 0 and stay flat. */
static tp_grid_span wave_columns(const tp_grid *grid)
{
    uint32_t first = 0, end = grid->cols;

    while (first < end && grid->column[first].fade == 0)
        first++;
    while (end > first && grid->column[end - 1].fade == 0)
        end--;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* Computes the view coordinates of all columns, and their swell phases for cells of size
 * `cell`. */
static void compute_column_terms(tp_grid *grid, tp_fx cell)
{
    for (uint32_t i = 0; i < grid->cols; i++) {
        int32_t rest[3];
        tp_vertex_x_to_view(&grid->frame, grid->column[i].place, rest);
        for (int axis = 0; axis < 3; axis++)
            grid->columns.rest[axis][i] = rest[axis];
    }
    if (grid->frame.count > 0)
        grid->frame.surface->by->swells->columns(&grid->frame, &grid->columns,
                                                 grid->waves.first, grid->waves.end, cell);
}

static void set_row(const tp_grid *grid, uint32_t j, bool sloped, tp_vertex_row *row)
{
    row->line = grid->row[j];
    tp_vertex_z_to_view(&grid->frame, row->line.place, row->rest);
    if (row->line.fade != 0 && grid->frame.count > 0)
        grid->frame.surface->by->swells->row(&grid->frame, row, sloped);
}

static bool is_vertex_at_rest(const tp_grid *grid, uint32_t i, uint32_t j)
{
    return grid->row[j].fade == 0 || grid->column[i].fade == 0;
}

static tp_view_vertex make_view_vertex(const tp_grid *grid, uint32_t i, uint32_t j)
{
    tp_vertex_row row;

    set_row(grid, j, false, &row);
    return tp_vertex_make_view_vertex(&grid->frame, &grid->columns, &row, i,
                                      is_vertex_at_rest(grid, i, j));
}

void tp_grid_make_view_vertices(const tp_grid *grid, const tp_grid_vertex *row, uint32_t j,
                                uint32_t first, uint32_t end, tp_view_vertex *to)
{
    TP_ASSERT(first <= end && end <= grid->cols && j < grid->rows);
    const tp_wave_models *by = grid->frame.surface->by;
    const bool coastal = tp_grid_is_coastal(grid), fan = grid->fan && !coastal;

    if (fan)
        by->fan->corners(grid, j, first, end, to);
    for (uint32_t i = first; i < end; i++, to++) {
        if (!fan)
            *to = coastal ? by->coastal->corner(grid, i, j) : make_view_vertex(grid, i, j);
        to->n[0] = row[i].slope_x;
        to->n[1] = row[i].slope_z;
    }
}

/* Evaluates the vertices of a row in runs.  A run ends at every TP_VERTEX_BATCH-th column
 * and where waves begin or end. */
static void evaluate_row(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                         tp_grid_vertex *vertex)
{
    tp_vertex_row row;

    if (first >= end)
        return;
    if (grid->fan) {
        grid->frame.surface->by->fan->row(grid, j, first, end, vertex);
        return;
    }
    set_row(grid, j, true, &row);
    for (uint32_t i = first, stop; i < end; i = stop) {
        stop = (i / TP_VERTEX_BATCH + 1) * TP_VERTEX_BATCH;
        stop = stop < end ? stop : end;
        if (i < grid->waves.first && grid->waves.first < stop)
            stop = grid->waves.first;
        if (i < grid->waves.end && grid->waves.end < stop)
            stop = grid->waves.end;
        tp_vertex_evaluate_batch(&grid->frame, &grid->columns, &row, i, stop - i,
                                 is_vertex_at_rest(grid, i, j), vertex + i);
    }
}

/* -- windows ------------------------------------------------------------------------- */

tp_grid_window tp_grid_window_init(void *memory)
{
    return (tp_grid_window){ .memory = memory, .row = { UINT32_MAX, UINT32_MAX } };
}

void tp_grid_window_load(const tp_grid *grid, tp_grid_window *window, uint32_t j,
                         uint32_t first, uint32_t end)
{
    TP_ASSERT(j < grid->rows && end <= grid->cols);
    TP_ASSERT(!grid->streams || window->memory != NULL);
    const uint32_t side = j & 1;
    tp_grid_span *done = &window->done[side];

    if (!grid->streams) {
        window->line[side] = grid->vertex + (size_t)j * grid->cols;
        return;
    }
    tp_grid_vertex *to = window->memory + side * grid->most_cols;
    if (window->row[side] != j)
        *done = (tp_grid_span){ (uint16_t)first, (uint16_t)first };
    window->row[side] = j;
    window->line[side] = to;
    if (first < done->first) {
        evaluate_row(grid, j, first, done->first, to);
        done->first = (uint16_t)first;
    }
    if (end > done->end) {
        evaluate_row(grid, j, done->end, end, to);
        done->end = (uint16_t)end;
    }
}

/* -- bounding boxes ------------------------------------------------------------------ */

static const tp_grid_box everywhere = { INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX };

/* If any vertex needs clipping, its u = TP_GRID_NEEDS_CLIP is the smallest u; the box
 * is then unbounded. */
static tp_grid_box bound_vertices(const tp_grid_vertex *vertex, uint32_t count)
{
    int32_t u0 = INT32_MAX, u1 = INT32_MIN, v0 = INT32_MAX, v1 = INT32_MIN;

    for (; count > 0; count--, vertex++) {
        int32_t u = vertex->u, v = vertex->v;
        u0 = u < u0 ? u : u0;
        u1 = u > u1 ? u : u1;
        v0 = v < v0 ? v : v0;
        v1 = v > v1 ? v : v1;
    }
    if (u0 == TP_GRID_NEEDS_CLIP)
        return everywhere;
    return (tp_grid_box){ (int16_t)(u0 >> 4), (int16_t)(v0 >> 4),
                          (int16_t)(u1 >> 4), (int16_t)(v1 >> 4) };
}

static tp_grid_box box_union(tp_grid_box a, tp_grid_box b)
{
    return (tp_grid_box){ a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0,
                          a.x1 > b.x1 ? a.x1 : b.x1, a.y1 > b.y1 ? a.y1 : b.y1 };
}

/* Extends the boxes of row j - 1 by the vertices of row j and starts the boxes of row j.
 * [first, end) has all vertices that the visible cells need. */
static void merge_row_into_boxes(tp_grid *grid, uint32_t j, uint32_t first, uint32_t end)
{
    const tp_grid_vertex *vertex = grid->window.line[j & 1];

    for (uint32_t b = first / TP_GRID_BLOCK; b * TP_GRID_BLOCK + 1 < end; b++) {
        uint32_t from = b * TP_GRID_BLOCK, to = from + TP_GRID_BLOCK + 1;
        from = from > first ? from : first;
        to = to < end ? to : end;
        tp_grid_box box = bound_vertices(vertex + from, to - from);
        size_t at = (size_t)j * grid->blocks + b;
        if (j > 0)
            grid->box[at - grid->blocks] = box_union(grid->box[at - grid->blocks], box);
        if (j + 1 < grid->rows)
            grid->box[at] = box;
    }
}

/* Returns the vertices of row j that the visible cells on both sides need. */
tp_grid_span tp_grid_needed_vertices(const tp_grid *grid, uint32_t j)
{
    const tp_grid_span none = { 0, 0 };
    tp_grid_span above = j > 0 ? grid->span[j - 1] : none;
    tp_grid_span below = j + 1 < grid->rows ? grid->span[j] : none;
    uint32_t first = grid->cols, end = 0;

    if (above.first < above.end) {
        first = above.first;
        end = above.end + 1u;
    }
    if (below.first < below.end) {
        first = below.first < first ? below.first : first;
        end = below.end + 1u > end ? below.end + 1u : end;
    }
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

static void place_lines(tp_grid *grid, const tp_grid_view *view)
{
    grid->cols = grid->most_cols;
    grid->rows = grid->most_rows;
    tp_grid_lines_place(grid->column, grid->cols, view, false);
    tp_grid_lines_place(grid->row, grid->rows, view, true);
    grid->blocks = (grid->cols - 2) / TP_GRID_BLOCK + 1;
}

void tp_grid_set_lines_and_cells(tp_grid *grid, const tp_grid_view *view)
{
    TP_ASSERT(view->cell > 0);
    if (grid->fan) {
        view->surface->by->fan->place(grid, view);
        return;
    }
    tp_plane planes[TP_PROJECTION_PLANES];
    uint32_t side[TP_PROJECTION_PLANES] = { 0 };
    tp_vertex_frame *frame = &grid->frame;

    place_lines(grid, view);
    tp_projection_planes(view->projection, view->width, view->height, planes);
    frame->projection = view->projection;
    frame->surface = view->surface;
    tp_vertex_begin(frame, grid->column[0].place, grid->column[grid->cols - 1].place,
                    grid->row[0].place, grid->row[grid->rows - 1].place);
    grid->waves = wave_columns(grid);

    grid->window = tp_grid_window_init(grid->window.memory);
    grid->vertices = 0;
    grid->sheets = 0;
    for (uint32_t j = 0; j + 1 < grid->rows; j++)
        grid->span[j] = seen_cells(grid, planes, j, frame->max_displacement, side);
    compute_column_terms(grid, view->cell);
}

void tp_grid_evaluate_row(tp_grid *grid, uint32_t j)
{
    TP_ASSERT(j < grid->rows);
    tp_grid_span needed = tp_grid_needed_vertices(grid, j);

    if (needed.first >= needed.end)
        return;
    if (tp_grid_is_coastal(grid))
        grid->frame.surface->by->coastal->row(grid, j, needed);
    else if (!grid->streams)
        evaluate_row(grid, j, needed.first, needed.end,
                     grid->vertex + (size_t)j * grid->cols);
    tp_grid_window_load(grid, &grid->window, j, needed.first, needed.end);
    grid->vertices += (uint32_t)(needed.end - needed.first);
    merge_row_into_boxes(grid, j, needed.first, needed.end);
}

void tp_grid_evaluate_vertices(tp_grid *grid, const tp_grid_view *view)
{
    tp_grid_set_lines_and_cells(grid, view);
    for (uint32_t j = 0; j < grid->rows; j++)
        tp_grid_evaluate_row(grid, j);
}
