/* SPDX-License-Identifier: MIT */
/* Layout, placement and visible cells of a fan; see the header. */
#include "view/fan.h"
#include "view/wave_models.h"
#include "waves/coastal_tables.h"
#include "waves/deep_water.h"

/* -- layout -------------------------------------------------------------------------- */

static void layout_fan(tp_grid *grid, tp_arena *arena, uint32_t vertices, uint32_t swells,
                       bool streams)
{
    const uint32_t cols = tp_fan_most_cols(vertices), rows = tp_fan_most_rows(vertices);
    tp_fan *fan = tp_arena_alloc(arena, 1, sizeof *fan);
    tp_fan_row *row = tp_arena_alloc(arena, rows, sizeof *row);
    tp_fan_swell *swell = tp_arena_alloc(arena, swells, sizeof *swell);

    memset(grid, 0, sizeof *grid);
    grid->most_cols = cols;
    grid->most_rows = rows;
    grid->streams = streams;
    grid->span = tp_arena_alloc(arena, rows, sizeof *grid->span);
    grid->box = tp_arena_alloc(arena, TP_FAN_BLOCKS(vertices, rows), sizeof *grid->box);
    tp_grid_vertex *vertex =
        tp_arena_alloc(arena, streams ? 2 * cols : vertices, sizeof *vertex);
    grid->vertex = streams ? NULL : vertex;
    grid->window = tp_grid_window_init(streams ? vertex : NULL);
    grid->fan = fan;
    if (fan)
        *fan = (tp_fan){ .row = row, .vertices = vertices, .filtered_for = swell,
                         .most_swells = swells };
}

/* -- visible cells ------------------------------------------------------------------- */

/* Columns; none if first > last. */
typedef struct {
    int32_t first, last;
} columns;

static int64_t plane_distance(const tp_plane *p, int64_t x, int64_t z, tp_fx room)
{
    return ((p->n.x * x + p->n.z * z) >> 30) + p->d + room;
}

/* Returns the columns of a row inside a plane, with the first outside at either end. */
static columns inside_columns(const tp_fan_row *row, const tp_plane *p, int32_t last,
                              tp_fx room)
{
    const int64_t x = row->x + (int64_t)row->step_x * last;
    const int64_t z = row->z + (int64_t)row->step_z * last;
    const int64_t a = plane_distance(p, row->x, row->z, room);
    const int64_t b = plane_distance(p, x, z, room);

    if (a < 0 && b < 0)
        return (columns){ last, 0 };
    if (a >= 0 && b >= 0)
        return (columns){ 0, last };
    const int32_t cut = (int32_t)(last * a / (a - b));
    return a < 0 ? (columns){ cut, last } : (columns){ 0, cut < last ? cut + 1 : last };
}

/* Returns the visible cells between rows j and j + 1. */
static tp_grid_span visible_cells(const tp_grid *grid, const tp_plane *planes, uint32_t j)
{
    const tp_fan_row *row = &grid->fan->row[j];
    const int32_t last = (int32_t)grid->cols - 1;
    const tp_fx room = grid->frame.max_displacement + 2;
    columns seen = { 0, last };

    for (int k = 0; k < TP_PROJECTION_PLANES; k++) {
        const columns a = inside_columns(&row[0], &planes[k], last, room);
        const columns b = inside_columns(&row[1], &planes[k], last, room);
        const int32_t first = a.first < b.first ? a.first : b.first;
        const int32_t end = a.last > b.last ? a.last : b.last;
        seen.first = first > seen.first ? first : seen.first;
        seen.last = end < seen.last ? end : seen.last;
    }
    if (seen.first >= seen.last)
        return (tp_grid_span){ 0, 0 };
    return (tp_grid_span){ (uint16_t)seen.first, (uint16_t)seen.last };
}

/* -- placement ----------------------------------------------------------------------- */

/* Returns the share of a wave's horizontal motion that coastal water keeps: under wind all
 * orbits are narrowed by one factor. */
static tp_fx wind_share(const tp_surface *surface, uint32_t i)
{
    const tp_swell *w = &surface->deep->swell[i];
    const tp_fx along =
        tp_coastal_tables(surface->coastal)[i].depth[TP_COASTAL_DEPTHS - 1].along;
    const int64_t x = w->orbit_x, z = w->orbit_z;
    const int64_t reach = tp_isqrt64((uint64_t)(x * x + z * z));

    return reach > along ? (tp_fx)(((int64_t)along << 16) / reach) : TP_FX_ONE;
}

/* Places rows and visible cells by the law. */
static void place_rows(tp_grid *grid, const tp_grid_view *view, const tp_fan_view *numbers)
{
    tp_fan *fan = grid->fan;
    tp_plane planes[TP_PROJECTION_PLANES];

    fan->detail = numbers->detail;
    fan->end_column = numbers->walled ? fan->law.cols - 1 : UINT32_MAX;
    fan->end = numbers->walled ? tp_fan_tank_end(&fan->law, numbers) : 0;
    grid->cols = fan->law.cols;
    grid->rows = fan->law.rows;
    grid->blocks = (grid->cols - 2) / TP_GRID_BLOCK + 1;
    for (uint32_t j = 0; j < grid->rows; j++)
        fan->row[j] = tp_fan_law_row(&fan->law, numbers, grid->rows - 1 - j);
    grid->frame.max_displacement = tp_fx_saturate(
        ((int64_t)numbers->high + numbers->aside) * TP_FAN_GAIN >> 16);
    tp_projection_planes(view->projection, view->width, view->height, planes);
    for (uint32_t j = 0; j + 1 < grid->rows; j++)
        grid->span[j] = visible_cells(grid, planes, j);
}

/* Updates the law and the numbers of the rows beyond those; true if one has changed. */
static bool update_numbers(tp_fan *fan, const tp_fan_view *numbers)
{
    const tp_projection *p = numbers->projection;
    const tp_fx rows_for[] = { p->eye.x, p->eye.z, p->near };
    const bool solved = tp_fan_law_update(&fan->law, fan->law_for, numbers,
                                           fan->vertices);
    const bool moved = memcmp(rows_for, fan->rows_for, sizeof rows_for) != 0;

    memcpy(fan->rows_for, rows_for, sizeof rows_for);
    return solved || moved;
}

static void place_fan(tp_grid *grid, const tp_grid_view *view)
{
    const tp_surface *surface = view->surface;
    const tp_fan_view numbers = tp_fan_view_make(view);
    tp_fan *fan = grid->fan;

    fan->moved = update_numbers(fan, &numbers);
    if (fan->moved)
        place_rows(grid, view, &numbers);
    for (uint32_t i = 0; surface->coastal && i < surface->deep->count; i++)
        fan->wind[i] = wind_share(surface, i);
    grid->frame.projection = view->projection;
    grid->frame.surface = surface;
    grid->window = tp_grid_window_init(grid->window.memory);
    grid->vertices = 0;
    grid->sheets = 0;
}

/* -- level water --------------------------------------------------------------------- */

static void fan_extents(tp_fan_kept_law *kept, const tp_grid_view *view,
                        tp_grid_extent extent[2])
{
    const tp_fan_view numbers = tp_fan_view_make(view);
    const tp_vec3 eye = view->projection->eye;

    tp_fan_law_update(&kept->law, kept->made_for, &numbers, view->vertices);
    const tp_fan_law *law = &kept->law;
    const tp_fx far = law->farthest, calm = law->waves_end < far ? law->waves_end : far;
    for (int axis = 0; axis < 2; axis++) {
        const int64_t at = axis ? eye.z : eye.x;
        extent[axis] = (tp_grid_extent){ tp_fx_saturate(at - far), tp_fx_saturate(at + far),
                                         { tp_fx_saturate(at - calm),
                                           tp_fx_saturate(at + calm) }, calm / 8 };
    }
}

const struct tp_water_fan tp_water_fan = { layout_fan, place_fan, tp_fan_evaluate_row,
                                           tp_fan_make_view_vertices, tp_fan_fill_variance,
                                           fan_extents };
