/* SPDX-License-Identifier: MIT */
/*
 * The wave models of the water surface, as structs that a program names, and their grid
 * vertices where these are not sums of sines: sharpened swells, with profiles [A3], and
 * the heights of rings and pools.  Such vertices are evaluated one by one.
 */
#include "view/grid_vertex.h"
#include "view/wave_models.h"
#include "waves/deep_water.h"

/* -- sharpened swells ------------------------------------------------------------------ */

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
static void add_sharp_roll_shift(const tp_vertex_batch_input *place, tp_vertex_batch *run)
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

void tp_batch_add_sharp_swells(const tp_vertex_batch_input *place, tp_vertex_batch *run,
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
        add_sharp_roll_shift(place, run);
}

/* -- rings and pools ------------------------------------------------------------------- */

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
 * add_sharp_roll_shift. */
static void add_rings_pools_roll_shift(const tp_vertex_batch_input *place,
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

void tp_batch_add_rings_and_pools(const tp_vertex_batch_input *place, tp_vertex_batch *run,
                       tp_grid_vertex *vertex)
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
        add_rings_pools_roll_shift(place, run);
}

/* -- the structs --------------------------------------------------------------------- */

const struct tp_water_rings tp_water_rings = { tp_ring_height_slope, tp_ring_evaluate,
                                               tp_batch_add_rings_and_pools };

const struct tp_water_pools tp_water_pools = {
    tp_pool_height_slope, tp_pool_height_bound, tp_batch_add_rings_and_pools,
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

const struct tp_water_sharp tp_water_sharp = { tp_batch_add_sharp_swells };

const struct tp_water_coastal tp_water_coastal = {
    .max_displacement = tp_coastal_max_displacement,
    .height = tp_coastal_max_height,
    .above = tp_surface_coastal_sample,
    .smooth = tp_coastal_displace_no_overhang,
    .floor = tp_coastal_floor,
    .layout = tp_grid_layout_coastal,
    .row = tp_coastal_grid_evaluate_row,
    .corner = tp_coastal_grid_make_view_vertex,
};

const struct tp_water_lod tp_water_lod = {
    tp_lod_layout, tp_lod_thin, tp_lod_step, tp_lod_swell_share,
};
