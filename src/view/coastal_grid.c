/* SPDX-License-Identifier: MIT */
/*
 * Grid vertices of coastal water; grid.h has the idea.
 */
#include "view/grid.h"

/* -- displaced vertices ---------------------------------------------------------------- */

static tp_fx vertex_wave_weight(const tp_grid *grid, uint32_t i, uint32_t j)
{
    return tp_fx_mul(grid->column[i].fade, grid->row[j].fade);
}

/* Returns the displaced vertex. *depth: depth of still water at the vertex, m; may be
 * NULL. */
static tp_vec3 displaced_vertex(const tp_grid *grid, uint32_t i, uint32_t j,
                                tp_fx *water_depth)
{
    const tp_surface *surface = grid->frame.surface;
    tp_vec3 rest = { grid->column[i].place, 0, grid->row[j].place };
    tp_fx   fade = vertex_wave_weight(grid, i, j);

    if (fade == 0) {
        if (water_depth)
            *water_depth = tp_coastal_floor(surface->coastal, rest.x, rest.z).depth;
        return rest;
    }
    tp_coastal_point p =
        tp_coastal_displace_point(surface->coastal, surface->phases, rest.x, rest.z);
    tp_vec3 way = tp_vec3_sub(p.position, rest);
    if (water_depth)
        *water_depth = p.depth;
    return (tp_vec3){ rest.x + tp_fx_mul(way.x, fade), rest.y + tp_fx_mul(way.y, fade),
                      rest.z + tp_fx_mul(way.z, fade) };
}

static void set_dry(tp_grid *grid, uint32_t i, uint32_t j, bool dry)
{
    size_t   at = (size_t)j * grid->cols + i;
    uint32_t bit = 1u << at % 32;

    grid->dry[at / 32] = dry ? grid->dry[at / 32] | bit : grid->dry[at / 32] & ~bit;
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

static void displace_row(tp_grid *grid, uint32_t j)
{
    tp_vec3 *sheet = grid->sheet[j % 3];
    tp_grid_span columns = columns_to_displace(grid, j);

    for (uint32_t i = columns.first; i < columns.end; i++) {
        tp_fx depth;
        sheet[i] = displaced_vertex(grid, i, j, &depth);
        set_dry(grid, i, j, depth <= 0);
    }
}

/* -- slopes ---------------------------------------------------------------------------- */

/* Shifts a vector to a length below 2 km, the limit of tp_slopes_from_tangents.  In a
 * grid with cells of kilometres, smaller slopes cannot be told from flat. */
static tp_vec3 shortened(tp_vec3 v, int shift)
{
    return (tp_vec3){ v.x >> shift, v.y >> shift, v.z >> shift };
}

static tp_vec3 add_rings_pools_and_slopes(const tp_vec3 around[4], const tp_grid *grid,
                                          tp_vec3 middle, tp_fx wave_weight,
                                          int16_t slope[3])
{
    const tp_surface *surface = grid->frame.surface;
    tp_vec3 across = tp_vec3_sub(around[1], around[0]);
    tp_vec3 along = tp_vec3_sub(around[3], around[2]);
    int     shift = across.x > 1000 * TP_FX_ONE || along.z > 1000 * TP_FX_ONE ? 5 : 0;
    tp_height_slope sum = { 0, 0, 0 };

    if (wave_weight != 0)
        tp_slopes_from_tangents(shortened(across, shift), shortened(along, shift),
                                &sum.slope_x, &sum.slope_z);
    if (tp_surface_has_rings_or_pools(surface)) {
        tp_height_slope relief =
            tp_rings_pools_sample_faded(surface, middle.x, middle.z, wave_weight);
        middle.y += relief.height;
        sum.slope_x += relief.slope_x;
        sum.slope_z += relief.slope_z;
    }
    slope[0] = (int16_t)tp_clamp((sum.slope_x + 8) >> 4, INT16_MIN, INT16_MAX);
    slope[1] = (int16_t)tp_clamp((sum.slope_z + 8) >> 4, INT16_MIN, INT16_MAX);
    slope[2] = 0;
    return middle;
}

/* -- vertices -------------------------------------------------------------------------- */

static uint32_t previous_clamped(uint32_t k)
{
    return k > 0 ? k - 1 : k;
}

static uint32_t next_clamped(uint32_t k, uint32_t count)
{
    return k + 1 < count ? k + 1 : k;
}

static void project_vertex(const tp_projection *projection, tp_vec3 at,
                           const int16_t slope[3], tp_grid_vertex *to)
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

void tp_coastal_grid_evaluate_row(tp_grid *grid, uint32_t j, tp_grid_span needed)
{
    TP_ASSERT(tp_grid_is_coastal(grid) && j < grid->rows && needed.end <= grid->cols);
    uint32_t near = previous_clamped(j), far = next_clamped(j, grid->rows);

    grid->sheets = grid->sheets > near ? grid->sheets : near;
    for (; grid->sheets <= far; grid->sheets++)
        displace_row(grid, grid->sheets);
    const tp_vec3 *row = grid->sheet[j % 3];
    for (uint32_t i = needed.first; i < needed.end; i++) {
        const tp_vec3 around[4] = { row[previous_clamped(i)],
                                    row[next_clamped(i, grid->cols)],
                                    grid->sheet[near % 3][i], grid->sheet[far % 3][i] };
        int16_t slope[3];
        tp_vec3 at = add_rings_pools_and_slopes(around, grid, row[i],
                                                vertex_wave_weight(grid, i, j), slope);
        project_vertex(grid->frame.projection, at, slope,
                       &grid->vertex[(size_t)j * grid->cols + i]);
    }
}

tp_view_vertex tp_coastal_grid_make_view_vertex(const tp_grid *grid, uint32_t i, uint32_t j)
{
    const tp_surface *surface = grid->frame.surface;
    tp_vec3 at = displaced_vertex(grid, i, j, NULL);
    tp_view_vertex c = { .s = grid->column[i].place, .t = grid->row[j].place };

    if (tp_surface_has_rings_or_pools(surface))
        at.y +=
            tp_rings_pools_sample_faded(surface, at.x, at.z, vertex_wave_weight(grid, i, j))
                .height;
    tp_projection_view_vertex(grid->frame.projection, at, &c);
    return c;
}
