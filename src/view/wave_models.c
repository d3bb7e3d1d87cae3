/* SPDX-License-Identifier: MIT */
/*
 * The wave models of the water surface, as structs that a program names, and their grid
 * vertices where these are not sums of sines: coastal water, sharpened swells, with
 * profiles [A3], and the heights of rings and pools.  Such vertices are evaluated one by
 * one.  grid.h has the idea of the grid.
 */
#include "view/fan.h"
#include "view/surface.h"
#include "view/wave_models.h"
#include "waves/deep_water.h"

/* -- coastal water: displaced vertices ----------------------------------------------- */

static tp_fx coastal_wave_weight(const tp_grid *grid, uint32_t i, uint32_t j)
{
    return grid->fan ? TP_FX_ONE : tp_fx_mul(grid->column[i].fade, grid->row[j].fade);
}

/* Returns the spacing of a row of a fan, set in *room; NULL: no fan. */
static const tp_coastal_spacing *row_spacing(const tp_grid *grid, uint32_t j,
                                             tp_coastal_spacing *room)
{
    if (!grid->fan)
        return NULL;
    *room = tp_fan_row_spacing(grid->fan, &grid->fan->row[j], grid->frame.surface->deep);
    return room;
}

/* Returns the displaced vertex. *depth: depth of still water at the vertex, m; may be
 * NULL. */
static tp_vec3 displaced_vertex(const tp_grid *grid, const tp_coastal_spacing *spacing,
                                uint32_t i, uint32_t j, tp_fx *water_depth)
{
    const tp_surface *surface = grid->frame.surface;
    tp_vec3 rest = { tp_grid_s(grid, i, j), 0, tp_grid_t(grid, i, j) };
    tp_fx   fade = coastal_wave_weight(grid, i, j);

    if (fade == 0) {
        if (water_depth)
            *water_depth = tp_coastal_floor(surface->coastal, rest.x, rest.z).depth;
        return rest;
    }
    tp_coastal_point p =
        spacing ? tp_coastal_displace_filtered(surface->coastal, surface->phases, spacing,
                                               rest.x, rest.z)
                : tp_coastal_displace_point(surface->coastal, surface->phases, rest.x,
                                            rest.z);
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
    tp_coastal_spacing room;
    const tp_coastal_spacing *spacing = row_spacing(grid, j, &room);

    for (uint32_t i = columns.first; i < columns.end; i++) {
        tp_fx depth;
        sheet[i] = displaced_vertex(grid, spacing, i, j, &depth);
        set_dry(grid, i, j, depth <= 0);
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
                                          tp_vec3 middle, tp_fx wave_weight,
                                          int16_t slope[2])
{
    const tp_surface *surface = grid->frame.surface;
    tp_vec3 across = tp_vec3_sub(around[1], around[0]);
    tp_vec3 along = tp_vec3_sub(around[3], around[2]);
    int     shift = longest(across) > 1000 * TP_FX_ONE || longest(along) > 1000 * TP_FX_ONE
                        ? 5 : 0;
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

/* Evaluates a row; rows must be called in order. */
static void coastal_grid_evaluate_row(tp_grid *grid, uint32_t j, tp_grid_span needed)
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
        int16_t slope[2];
        tp_vec3 at = add_rings_pools_and_slopes(around, grid, row[i],
                                                coastal_wave_weight(grid, i, j), slope);
        project_vertex(grid->frame.projection, at, slope,
                       &grid->vertex[(size_t)j * grid->cols + i]);
    }
}

/* Returns a vertex before projection; its slopes stay 0. */
static tp_view_vertex coastal_grid_make_view_vertex(const tp_grid *grid, uint32_t i,
                                                    uint32_t j)
{
    const tp_surface *surface = grid->frame.surface;
    tp_coastal_spacing room;
    tp_vec3 at = displaced_vertex(grid, row_spacing(grid, j, &room), i, j, NULL);
    tp_view_vertex c = { .s = tp_grid_s(grid, i, j), .t = tp_grid_t(grid, i, j) };

    if (tp_surface_has_rings_or_pools(surface))
        at.y += tp_rings_pools_sample_faded(surface, at.x, at.z,
                                            coastal_wave_weight(grid, i, j))
                    .height;
    tp_projection_view_vertex(grid->frame.projection, at, &c);
    return c;
}

/* -- sharpened swells ---------------------------------------------------------------- */

/* Sums over all swells in 64 bits: positions per cosine Q.50 and per f Q.44, h
 * Q.(38 + tilt), bends Q.59.  By the bounds of deep water the sums have 59, 53, 54 and 60
 * bits. */
typedef struct {
    int64_t along[3], rise[2];          /* along: x, y, depth; rise: y, depth */
    int64_t hx, hz, bxx, bxz, bzz;
} sums;

TP_ALWAYS_INLINE tp_vertex_sincos vertex_sincos(const tp_vertex_batch_input *place,
                                                uint32_t i, uint32_t k)
{
    tp_vertex_sincos a = place->columns->turn[(size_t)(place->first + i)
                                             * place->frame->count + k];
    tp_vertex_sincos b = place->row->turn[k];
    return tp_vertex_sincos_add_angles(a, b);
}

static void add_sharp_swell(sums *sum, const tp_vertex_swell *w, const tp_swell *swell,
                            tp_vertex_sincos th)
{
    int32_t f, df;

    tp_swell_sharpen(swell, th.sin, th.cos, &f, &df);
    sum->along[0] += (int64_t)w->x * th.cos;
    sum->along[1] += (int64_t)w->y * th.cos;
    sum->along[2] += (int64_t)w->depth * th.cos;
    sum->rise[0] += (int64_t)w->rise_y * f;
    sum->rise[1] += (int64_t)w->rise_depth * f;
    sum->hx += (int64_t)w->tilt_x * df;
    sum->hz += (int64_t)w->tilt_z * df;
    sum->bxx += (int64_t)w->bend_xx * th.sin;
    sum->bxz += (int64_t)w->bend_xz * th.sin;
    sum->bzz += (int64_t)w->bend_zz * th.sin;
}

/* Returns sum / 2^down, rounded, times the fade weight. */
TP_ALWAYS_INLINE int32_t round_and_fade(int64_t sum, int down, tp_fx fade)
{
    int32_t whole = (int32_t)((sum + ((int64_t)1 << (down - 1))) >> down);
    return fade == TP_FX_ONE ? whole : tp_fx_mul(whole, fade);
}

TP_ALWAYS_INLINE tp_fx vertex_wave_weight(const tp_vertex_batch_input *place, uint32_t i)
{
    return tp_fx_mul(place->row->line.fade, place->columns->line[place->first + i].fade);
}

/* Adds the share of the heights to the right, for a camera with roll.  A separate pass,
 * so other cameras pay nothing. */
static void add_sharp_to_view_x(const tp_vertex_batch_input *place, tp_vertex_batch *run)
{
    const tp_vertex_frame *frame = place->frame;
    const tp_deep_water *deep = frame->surface->deep;

    for (uint32_t i = 0; i < place->count; i++) {
        int64_t rise = 0;
        for (uint32_t k = 0; k < frame->count; k++) {
            const tp_vertex_sincos th = vertex_sincos(place, i, k);
            int32_t f, df;
            tp_swell_sharpen(&deep->swell[k], th.sin, th.cos, &f, &df);
            rise += (int64_t)frame->swell[k].rise_x * f;
        }
        run->at[0][i] += round_and_fade(rise * 64, 34, vertex_wave_weight(place, i));
    }
}

/* Adds sharpened swells to undisplaced vertices, and computes the slopes. */
static void batch_add_sharp_swells(const tp_vertex_batch_input *place, tp_vertex_batch *run,
                                   tp_grid_vertex *vertex)
{
    const tp_vertex_frame *frame = place->frame;
    const tp_deep_water *deep = frame->surface->deep;

    for (uint32_t i = 0; i < place->count; i++) {
        tp_fx fade = tp_fx_mul(place->row->line.fade,
                               place->columns->line[place->first + i].fade);
        sums sum = { 0 };
        for (uint32_t k = 0; k < frame->count; k++)
            add_sharp_swell(&sum, &frame->swell[k], &deep->swell[k],
                            vertex_sincos(place, i, k));
        run->at[0][i] += round_and_fade(sum.along[0], 34, fade);
        run->at[1][i] += round_and_fade(sum.along[1] + sum.rise[0] * 64, 34, fade);
        run->at[2][i] += round_and_fade(sum.along[2] + sum.rise[1] * 64, 34, fade);
        const tp_jacobian j = {
            .hx = round_and_fade(sum.hx, 23, fade),
            .hz = round_and_fade(sum.hz, 23, fade),
            .jxx = TP_JACOBIAN_ONE - round_and_fade(sum.bxx, 29, fade),
            .jzz = TP_JACOBIAN_ONE - round_and_fade(sum.bzz, 29, fade),
            .bxz = round_and_fade(sum.bxz, 29, fade),
        };
        tp_set_slopes(&j, frame->tilt, deep->crossed, &vertex[i]);
    }
    if (frame->projection->lean != 0)
        add_sharp_to_view_x(place, run);
}

/* -- rings and pools ----------------------------------------------------------------- */

/* Computes the world position of a displaced vertex. */
TP_ALWAYS_INLINE void compute_displaced_xz(const tp_vertex_batch_input *place, uint32_t i,
                                           tp_fx *x, tp_fx *z)
{
    const tp_vertex_frame *frame = place->frame;
    const tp_deep_water *deep = frame->surface->deep;
    const tp_grid_line *line = &place->columns->line[place->first + i];
    tp_fx along_x = 0, along_z = 0;

    for (uint32_t k = 0; k < frame->count && !place->at_rest; k++) {
        tp_q30 c = vertex_sincos(place, i, k).cos;
        along_x += tp_q30_mul(deep->swell[k].orbit_x, c);
        along_z += tp_q30_mul(deep->swell[k].orbit_z, c);
    }
    if (deep->sharpened) {           /* other turns have fading included */
        tp_fx fade = tp_fx_mul(place->row->line.fade, line->fade);
        along_x = tp_fx_mul(along_x, fade);
        along_z = tp_fx_mul(along_z, fade);
    }
    *x = line->place + along_x;
    *z = place->row->line.place + along_z;
}

/* Adds the share of rings and pools to the right, for a camera with roll; see
  * add_sharp_to_view_x. */
static void add_rings_pools_to_view_x(const tp_vertex_batch_input *place,
                                      tp_vertex_batch *run)
{
    for (uint32_t i = 0; i < place->count; i++) {
        tp_fx x, z;
        compute_displaced_xz(place, i, &x, &z);
        const tp_height_slope relief = tp_rings_pools_sample_faded(
            place->frame->surface, x, z, vertex_wave_weight(place, i));
        run->at[0][i] += tp_q30_mul(relief.height, place->frame->projection->lean);
    }
}

/* Adds the heights and slopes of rings and pools. */
static void batch_add_rings_and_pools(const tp_vertex_batch_input *place,
                                      tp_vertex_batch *run, tp_grid_vertex *vertex)
{
    const tp_projection *projection = place->frame->projection;

    for (uint32_t i = 0; i < place->count; i++) {
        tp_fx x, z;
        tp_fx fade = tp_fx_mul(place->row->line.fade,
                               place->columns->line[place->first + i].fade);
        compute_displaced_xz(place, i, &x, &z);
        tp_height_slope relief =
            tp_rings_pools_sample_faded(place->frame->surface, x, z, fade);
        run->at[1][i] += tp_q30_mul(relief.height, projection->up.y);
        run->at[2][i] += tp_q30_mul(relief.height, projection->ahead.y);
        vertex[i].slope_x = tp_saturated(vertex[i].slope_x
                                         + ((relief.slope_x + 8) >> 4));
        vertex[i].slope_z = tp_saturated(vertex[i].slope_z
                                         + ((relief.slope_z + 8) >> 4));
    }
    if (projection->lean != 0)
        add_rings_pools_to_view_x(place, run);
}

/* -- the structs --------------------------------------------------------------------- */

const struct tp_water_rings tp_water_rings = { tp_ring_height_slope, tp_ring_evaluate,
                                               batch_add_rings_and_pools };

const struct tp_water_pools tp_water_pools = {
    tp_pool_height_slope, tp_pool_height_bound, batch_add_rings_and_pools,
};

#define SWELLS(init_by) \
    .init = init_by, .above = tp_deep_water_sample, \
    .begin = tp_vertex_set_swells, .columns = tp_vertex_set_columns, \
    .row = tp_vertex_set_row, \
    .displace_axis = tp_batch_displace_axis, .slope = tp_batch_set_slopes, \
    .point = tp_level_sample_surface

const struct tp_water_swells tp_water_swells = { SWELLS(tp_deep_water_init) };

const struct tp_water_swells tp_water_few_swells = {
    SWELLS(tp_deep_water_init_compact), .few = true,
};

const struct tp_water_sharp tp_water_sharp = { batch_add_sharp_swells };

const struct tp_water_coastal tp_water_coastal = {
    .max_displacement = tp_coastal_max_displacement,
    .height = tp_coastal_max_height,
    .above = tp_surface_coastal_sample,
    .smooth = tp_coastal_displace_no_overhang,
    .floor = tp_coastal_floor,
    .layout = tp_grid_layout_coastal,
    .row = coastal_grid_evaluate_row,
    .corner = coastal_grid_make_view_vertex,
};
