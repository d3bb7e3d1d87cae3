/* SPDX-License-Identifier: MIT */
/* Placement and visible cells of a fan; see the header. */
#include "tidepool/modules.h"
#include "view/fan.h"
#include "view/wave_models.h"
#include "waves/coastal_tables.h"
#include "waves/deep_water.h"

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

/* Returns the visible cells between rows j and j + 1; a vertex is displaced by `room` at
 * the most. */
static tp_grid_span visible_cells(const tp_grid *grid, const tp_plane *planes, uint32_t j,
                                  tp_fx room)
{
    const tp_fan_row *row = &grid->fan->row[j];
    const int32_t last = (int32_t)grid->cols - 1;
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
    const int64_t most = ((int64_t)numbers->high + numbers->aside) * TP_FAN_GAIN >> 16;
    const tp_fx room = tp_fx_saturate(most) + 2;
    tp_fan *fan = grid->fan;
    tp_plane planes[TP_PROJECTION_PLANES];

    fan->detail = numbers->detail;
    fan->end_column = numbers->walls ? fan->law.cols - 1 : UINT32_MAX;
    fan->end = numbers->walls ? fan->law.walls->end(&fan->law, numbers) : 0;
    grid->cols = fan->law.cols;
    grid->rows = fan->law.rows;
    grid->blocks = (grid->cols - 2) / TP_GRID_BLOCK + 1;
    for (uint32_t j = 0; j < grid->rows; j++)
        fan->placed[j] = tp_fan_law_row(&fan->law, numbers, grid->rows - 1 - j);
    tp_projection_planes(view->projection, view->width, view->height, planes);
    for (uint32_t j = 0; j + 1 < grid->rows; j++)
        grid->placed_span[j] = visible_cells(grid, planes, j, room);
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

void tp_fan_place_rows(tp_grid *grid, const tp_grid_view *view)
{
    const tp_surface *surface = view->surface;
    const tp_fan_view numbers = tp_fan_view_make(view);
    tp_fan *fan = grid->fan;

    fan->moved = update_numbers(fan, &numbers);
    if (fan->moved)
        place_rows(grid, view, &numbers);
    for (uint32_t i = 0; surface->coastal && i < surface->deep->count; i++)
        fan->wind[i] = wind_share(surface, i);
}

const struct tp_draw_grid_rows tp_draw_grid_rows = { tp_fan_place_rows };
