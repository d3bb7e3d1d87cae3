/* SPDX-License-Identifier: MIT */
/*
 * The wave models of the water surface, as structs that a program names, and the grid
 * vertices of coastal water, which need their neighbours' positions for their slopes.
 */
#include "view/fan.h"
#include "view/surface.h"
#include "view/wave_models.h"
#include "waves/deep_water.h"

/* -- coastal water: displaced vertices ----------------------------------------------- */

static tp_coastal_spacing row_spacing(const tp_grid *grid, uint32_t j)
{
    return tp_fan_row_spacing(grid->fan, &grid->fan->row[j], grid->surface->deep);
}

static tp_coastal_point displaced_vertex(const tp_grid *grid,
                                         const tp_coastal_spacing *spacing, uint32_t i,
                                         uint32_t j)
{
    return tp_coastal_displace_filtered(grid->surface->coastal, grid->surface->phases,
                                        spacing, tp_grid_s(grid, i, j),
                                        tp_grid_t(grid, i, j));
}

static void set_dry(const tp_grid *grid, uint32_t *bits, uint32_t i, uint32_t j, bool dry)
{
    size_t   at = (size_t)j * grid->cols + i;
    uint32_t bit = 1u << at % 32;

    bits[at / 32] = dry ? bits[at / 32] | bit : bits[at / 32] & ~bit;
}

/* Returns the columns of row j with a needed position: its own needed vertices and their
 * neighbours on all four sides. */
static tp_grid_span columns_to_displace(const tp_grid *grid, uint32_t j)
{
    uint32_t first = grid->cols, end = 0;

    for (uint32_t k = j > 0 ? j - 1 : 0; k <= j + 1 && k < grid->rows; k++) {
        tp_grid_span needed = tp_grid_needed_vertices(grid, k);
        if (needed.first >= needed.end)
            continue;
        first = needed.first < first ? needed.first : first;
        end = needed.end > end ? needed.end : end;
    }
    if (first >= end)
        return (tp_grid_span){ 0, 0 };
    first = first > 0 ? first - 1 : 0;
    end = end < grid->cols ? end + 1 : end;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

static void displace_columns(const tp_grid *grid, const tp_grid_window *window,
                             tp_grid_sheet *sheet, uint32_t first, uint32_t end)
{
    const uint32_t j = sheet->row;
    const tp_coastal_spacing spacing = row_spacing(grid, j);

    for (uint32_t i = first; i < end; i++) {
        const tp_coastal_point p = displaced_vertex(grid, &spacing, i, j);
        sheet->at[i] = p.position;
        if (window->dry)
            set_dry(grid, window->dry, i, j, p.depth <= 0);
    }
}

/* Displaces the vertices of row j in the window, unless it has them. */
static void displace_row(const tp_grid *grid, tp_grid_window *window, uint32_t j,
                         tp_grid_span columns)
{
    TP_ASSERT(columns.first <= columns.end && columns.end <= grid->cols);
    tp_grid_sheet *sheet = &window->sheet[j % 3];
    tp_grid_span *done = &sheet->done;

    if (sheet->row != j)
        *done = (tp_grid_span){ columns.first, columns.first };
    sheet->row = j;
    if (columns.first < done->first) {
        displace_columns(grid, window, sheet, columns.first, done->first);
        done->first = columns.first;
    }
    if (columns.end > done->end) {
        displace_columns(grid, window, sheet, done->end, columns.end);
        done->end = columns.end;
    }
}

/* -- coastal water: slopes ----------------------------------------------------------- */

/* Shifts a vector to a length below 2 km, the limit of tp_slopes_from_tangents.  In a
 * grid with cells of kilometres, smaller slopes cannot be told from flat. */
static tp_vec3 shortened(tp_vec3 v, int shift)
{
    return (tp_vec3){ v.x >> shift, v.y >> shift, v.z >> shift };
}

static tp_fx longest(tp_vec3 v)
{
    return tp_abs(v.x) > tp_abs(v.z) ? tp_abs(v.x) : tp_abs(v.z);
}

static tp_vec3 add_rings_pools_and_slopes(const tp_vec3 around[4], const tp_grid *grid,
                                          tp_vec3 middle, int16_t slope[2])
{
    const tp_surface *surface = grid->surface;
    tp_vec3 across = tp_vec3_sub(around[1], around[0]);
    tp_vec3 along = tp_vec3_sub(around[3], around[2]);
    int     shift = longest(across) > 1000 * TP_FX_ONE || longest(along) > 1000 * TP_FX_ONE
                        ? 5 : 0;
    tp_height_slope sum = { 0, 0, 0 };

    tp_slopes_from_tangents(shortened(across, shift), shortened(along, shift), &sum.slope_x,
                            &sum.slope_z);
    if (tp_surface_has_rings_or_pools(surface)) {
        const tp_height_slope relief = tp_rings_pools_sample(surface, middle.x, middle.z);
        middle.y += relief.height;
        sum.slope_x += relief.slope_x;
        sum.slope_z += relief.slope_z;
    }
    slope[0] = (int16_t)tp_clamp((sum.slope_x + 8) >> 4, INT16_MIN, INT16_MAX);
    slope[1] = (int16_t)tp_clamp((sum.slope_z + 8) >> 4, INT16_MIN, INT16_MAX);
    return middle;
}

/* -- coastal water: vertices --------------------------------------------------------- */

static uint32_t previous_clamped(uint32_t k)
{
    return k > 0 ? k - 1 : k;
}

static uint32_t next_clamped(uint32_t k, uint32_t count)
{
    return k + 1 < count ? k + 1 : k;
}

static void project_vertex(const tp_projection *projection, tp_vec3 at,
                           const int16_t slope[2], tp_grid_vertex *to)
{
    tp_view_vertex c;

    tp_projection_view_vertex(projection, at, &c);
    to->slope_x = slope[0];
    to->slope_z = slope[1];
    if (tp_projection_can_project(projection, &c))
        tp_projection_project(projection, &c, &to->u, &to->v, &to->zi);
    else
        to->u = TP_GRID_NEEDS_CLIP;
}

/* Returns the columns of row j to displace for the vertices `needed` of a row beside it, or
 * of the row itself.  The grid's own window has all that are needed of a row at once; others
 * take the neighbours' columns. */
static tp_grid_span window_columns(const tp_grid *grid, const tp_grid_window *window,
                                   uint32_t j, tp_grid_span needed)
{
    if (window->dry)
        return columns_to_displace(grid, j);
    return (tp_grid_span){ (uint16_t)previous_clamped(needed.first),
                           (uint16_t)(needed.end < grid->cols ? needed.end + 1 : needed.end) };
}

static void coastal_grid_evaluate_row(const tp_grid *grid, tp_grid_window *window, uint32_t j,
                                      tp_grid_span needed, tp_grid_vertex *vertex)
{
    TP_ASSERT(tp_grid_is_coastal(grid) && j < grid->rows && needed.end <= grid->cols);
    const uint32_t near = previous_clamped(j), far = next_clamped(j, grid->rows);

    for (uint32_t k = near; k <= far; k++)
        displace_row(grid, window, k, window_columns(grid, window, k, needed));
    const tp_vec3 *row = window->sheet[j % 3].at, *above = window->sheet[near % 3].at,
                  *below = window->sheet[far % 3].at;
    for (uint32_t i = needed.first; i < needed.end; i++) {
        const tp_vec3 around[4] = { row[previous_clamped(i)],
                                    row[next_clamped(i, grid->cols)], above[i], below[i] };
        int16_t slope[2];
        tp_vec3 at = add_rings_pools_and_slopes(around, grid, row[i], slope);
        project_vertex(grid->projection, at, slope, &vertex[i]);
    }
}

/* Returns a vertex before projection; its slopes stay 0. */
static tp_view_vertex coastal_grid_make_view_vertex(const tp_grid *grid, uint32_t i,
                                                    uint32_t j)
{
    const tp_surface *surface = grid->surface;
    const tp_coastal_spacing spacing = row_spacing(grid, j);
    tp_vec3 at = displaced_vertex(grid, &spacing, i, j).position;
    tp_view_vertex c = { .s = tp_grid_s(grid, i, j), .t = tp_grid_t(grid, i, j) };

    if (tp_surface_has_rings_or_pools(surface))
        at.y += tp_rings_pools_sample(surface, at.x, at.z).height;
    tp_projection_view_vertex(grid->projection, at, &c);
    return c;
}

/* -- the structs --------------------------------------------------------------------- */

static const struct tp_fan_relief relief = {
    tp_fan_row_detail_weight, tp_rings_pools_sample_faded,
};

const struct tp_water_rings tp_water_rings = { tp_ring_height_slope, tp_ring_evaluate,
                                               &relief };

const tp_pool_kind *tp_models_numbered_kind(const tp_wave_models *by, uint32_t number)
{
    switch (number) {
#define X(name) \
    case TP_POOL_KIND_##name: return by->pool_##name ? by->pool_##name->kind : NULL;
        TP_POOL_KINDS(X)
#undef X
    default: return NULL;
    }
}

const struct tp_water_pools tp_water_pools = { tp_pool_sample, tp_pool_height_bound, &relief };

#define X(name) const struct tp_water_pool_##name tp_water_pool_##name = { &tp_pool_##name };
TP_POOL_KINDS(X)
#undef X

const struct tp_water_pool_splashes tp_water_pool_splashes = {
    tp_pool_add_splash, tp_pool_splash_if_quiet,
};

const struct tp_water_swells tp_water_swells = { .init = tp_deep_water_init };

const struct tp_water_swells tp_water_few_swells = {
    .init = tp_deep_water_init_compact, .few = true,
};

const struct tp_water_swells tp_water_baked_swells = { .few = true };

const struct tp_water_samples tp_water_samples = {
    tp_deep_water_sample, tp_deep_water_displace_point,
};

const struct tp_water_points tp_water_points = { tp_level_sample_surface };

const struct tp_water_coastal tp_water_coastal = {
    .max_displacement = tp_coastal_max_displacement,
    .height = tp_coastal_max_height,
    .breaking = tp_coastal_displace_point,
    .above = tp_surface_coastal_sample,
    .smooth = tp_coastal_displace_no_overhang,
    .near = tp_surface_coastal_near,
    .floor = tp_coastal_floor,
    .layout = tp_grid_layout_coastal,
    .row = coastal_grid_evaluate_row,
    .corner = coastal_grid_make_view_vertex,
    .set_wind = tp_fan_set_wind,
    .wind_point = tp_fan_wind_point,
    .widen_land = tp_fan_widen_to_floor,
};
