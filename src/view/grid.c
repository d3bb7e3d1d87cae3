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

void tp_grid_layout_vertices(tp_grid *grid, tp_arena *arena, uint32_t vertices,
                             bool streams)
{
    const uint32_t cols = tp_fan_most_cols(vertices), rows = tp_fan_most_rows(vertices);
    tp_fan *fan = tp_arena_alloc(arena, 1, sizeof *fan);

    memset(grid, 0, sizeof *grid);
    grid->most_cols = cols;
    grid->streams = streams;
    grid->box = tp_arena_alloc(arena, TP_FAN_BLOCKS(vertices, rows), sizeof *grid->box);
    tp_grid_vertex *vertex =
        tp_arena_alloc(arena, streams ? 2 * cols : vertices, sizeof *vertex);
    grid->vertex = streams ? NULL : vertex;
    grid->window.memory = streams ? vertex : NULL;
    grid->fan = fan;
    if (fan)
        *fan = (tp_fan){ .vertices = vertices };
}

void tp_grid_layout_rows(tp_grid *grid, tp_arena *arena, uint32_t vertices, uint32_t swells)
{
    const uint32_t rows = tp_fan_most_rows(vertices);
    tp_fan_row *row = tp_arena_alloc(arena, rows, sizeof *row);
    tp_fan_swell *swell = tp_arena_alloc(arena, swells, sizeof *swell);

    grid->span = grid->placed_span = tp_arena_alloc(arena, rows, sizeof *grid->span);
    if (grid->fan) {
        grid->fan->row = grid->fan->placed = row;
        grid->fan->filtered_for = swell;
        grid->fan->most_swells = swells;
    }
}

void tp_grid_layout(tp_grid *grid, tp_arena *arena, uint32_t vertices, uint32_t swells,
                    bool streams)
{
    tp_grid_layout_vertices(grid, arena, vertices, streams);
    tp_grid_layout_rows(grid, arena, vertices, swells);
}

void tp_grid_layout_coastal(tp_grid *grid, tp_arena *arena, uint32_t vertices)
{
    tp_grid_window *own = &grid->window;

    for (int k = 0; k < 3; k++)
        own->sheet[k].at =
            tp_arena_alloc(arena, grid->most_cols, sizeof *own->sheet[k].at);
    grid->dry = tp_arena_alloc(arena, ((size_t)vertices + 31) / 32, sizeof *grid->dry);
    own->dry = grid->dry;
}

/* -- vertices ------------------------------------------------------------------------ */

void tp_fan_evaluate_row(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                         tp_grid_vertex *vertex)
{
    TP_ASSERT(first <= end && end <= grid->cols && j < grid->rows);
    if (grid->waves)
        grid->waves->evaluate_row(grid, j, first, end, vertex);
    else if (grid->exact_waves)
        grid->exact_waves->evaluate_row(grid, j, first, end, vertex);
    else
        memset(vertex + first, 0, (end - first) * sizeof *vertex);
}

void tp_fan_make_view_vertices(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                               tp_view_vertex *to)
{
    if (grid->waves)
        grid->waves->make_view_vertices(grid, j, first, end, to);
    else if (grid->exact_corners)
        grid->exact_corners->make_view_vertices(grid, j, first, end, to);
    else
        memset(to, 0, (end - first) * sizeof *to);
}

void tp_grid_make_view_vertices(const tp_grid *grid, const tp_grid_vertex *row, uint32_t j,
                                uint32_t first, uint32_t end, tp_view_vertex *to)
{
    TP_ASSERT(first <= end && end <= grid->cols && j < grid->rows);
    const bool coastal = tp_grid_is_coastal(grid);

    if (!coastal)
        tp_fan_make_view_vertices(grid, j, first, end, to);
    for (uint32_t i = first; i < end; i++, to++) {
        if (coastal)
            *to = grid->surface->by->coastal->corner(grid, i, j);
        to->n[0] = row[i].slope_x;
        to->n[1] = row[i].slope_z;
    }
}

/* -- windows ------------------------------------------------------------------------- */

/* Empties the window. */
static void forget_rows(tp_grid_window *window)
{
    window->row[0] = window->row[1] = UINT32_MAX;
    for (int k = 0; k < 3; k++)
        window->sheet[k].row = UINT32_MAX;
}

tp_grid_window tp_grid_window_init(const tp_grid *grid, void *memory)
{
    TP_ASSERT(!grid->streams || memory != NULL);
    tp_grid_window window = { .memory = memory };
    const uint32_t cols = grid->most_cols;

    for (uint32_t k = 0; grid->streams && grid->dry && k < 3; k++)
        window.sheet[k].at = (tp_vec3 *)(window.memory + 2 * cols) + k * cols;
    forget_rows(&window);
    return window;
}

/* Evaluates vertices first to end - 1 of row j into vertex[first] and on. */
static void evaluate_vertices(const tp_grid *grid, tp_grid_window *window, uint32_t j,
                              uint32_t first, uint32_t end, tp_grid_vertex *vertex)
{
    if (tp_grid_is_coastal(grid))
        grid->surface->by->coastal->row(
            grid, window, j, (tp_grid_span){ (uint16_t)first, (uint16_t)end }, vertex);
    else
        tp_fan_evaluate_row(grid, j, first, end, vertex);
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
    bool known = window->row[side] == j;
    tp_grid_kept_row *kept =
        window->kept ? window->keep->find(window->kept, j, &known) : NULL;
    if (kept) {
        to = kept->vertex;
        done = &kept->done;
    } else {
        window->row[side] = j;
    }
    if (!known)
        *done = (tp_grid_span){ (uint16_t)first, (uint16_t)first };
    window->line[side] = to;
    if (first < done->first) {
        evaluate_vertices(grid, window, j, first, done->first, to);
        done->first = (uint16_t)first;
    }
    if (end > done->end) {
        evaluate_vertices(grid, window, j, done->end, end, to);
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

void tp_grid_begin(tp_grid *grid, const tp_grid_view *view)
{
    grid->projection = view->projection;
    grid->surface = view->surface;
    forget_rows(&grid->window);
    grid->vertices = 0;
}

void tp_grid_place_rows(tp_grid *grid, const tp_grid_view *view)
{
    tp_grid_begin(grid, view);
    tp_fan_place_rows(grid, view);
}

void tp_grid_evaluate_row(tp_grid *grid, uint32_t j)
{
    TP_ASSERT(j < grid->rows);
    tp_grid_span needed = tp_grid_needed_vertices(grid, j);

    if (needed.first >= needed.end)
        return;
    if (!grid->streams)
        evaluate_vertices(grid, &grid->window, j, needed.first, needed.end,
                          grid->vertex + (size_t)j * grid->cols);
    tp_grid_window_load(grid, &grid->window, j, needed.first, needed.end);
    grid->vertices += (uint32_t)(needed.end - needed.first);
    merge_row_into_boxes(grid, j, needed.first, needed.end);
}

void tp_grid_evaluate_vertices(tp_grid *grid, const tp_grid_view *view)
{
    tp_grid_place_rows(grid, view);
    for (uint32_t j = 0; j < grid->rows; j++)
        tp_grid_evaluate_row(grid, j);
}
