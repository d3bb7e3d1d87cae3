/* SPDX-License-Identifier: MIT */
/* The parts that vertices of a fan in 32 bits share: the waves of a row with the factors of
 * their terms, and the point of a sum.  fan_fast_vertices.c, packed_vertices.h.
 *
 * Bits: displacements are below 2^9 m, and have 18 bits of fraction; heights are below 2^9
 * m: 20.  A slope has 24, a bend 28. */
#ifndef TP_VIEW_FAN_FAST_H
#define TP_VIEW_FAN_FAST_H
#include "view/fan.h"
#include "view/wave_models.h"
#include "waves/coastal_tables.h"
#include "waves/deep_water.h"
#include "waves/softfloat.h"

/* -- waves of a row ------------------------------------------------------------------ */

/* A wave of a row: phase of column 0, step of the phase, and the factors of its terms. */
typedef struct {
    const tp_swell *swell;
    tp_turn first, step;
    int32_t turns;              /* shift of the phase by the wind, turns, Q0.32 */
    int32_t iterations;
    tp_q30  push;               /* the same shift in radians */
    int32_t orbit_x, orbit_z, amplitude, slope_x, slope_z, bend_xx, bend_xz, bend_zz;
} tp_fast_wave;

typedef struct {
    const tp_grid *grid;
    const tp_fan_row *row;
    tp_fx    detail;            /* weight of rings and pools; 0: none */
    uint32_t count;
    tp_fast_wave wave[TP_WAVES];
} tp_fast_waves;

/* Bits that factors have beyond their numbers: a length has 16, a slope or bend 30. */
typedef struct {
    int orbit, height, slope, bend;
} tp_fast_bits;

/* Returns n weight 2^bits, saturated. */
static inline int32_t tp_fast_weighed(int32_t n, tp_fx weight, int bits)
{
    const int64_t to = (int64_t)n * weight >> (16 - bits);
    return (int32_t)tp_clamp_abs(to, INT32_MAX);
}

/* Sets the factors; a wave in a wind has slopes and heights without gain. */
static inline void tp_fast_set_factors(tp_fast_wave *to, tp_fx weight, tp_fx level,
                                       bool wind, tp_fast_bits bits)
{
    const tp_swell *w = to->swell;
    const tp_fx share = tp_fan_share(weight), up = wind ? share : weight;
    const tp_fx bend = wind ? level : share, tilt = tp_fan_slope_weight(w, up);

    to->orbit_x = tp_fast_weighed(w->orbit_x, level, bits.orbit);
    to->orbit_z = tp_fast_weighed(w->orbit_z, level, bits.orbit);
    to->amplitude = tp_fast_weighed(w->amplitude, up, bits.height);
    to->slope_x = tp_fast_weighed(w->slope_x, tilt, bits.slope);
    to->slope_z = tp_fast_weighed(w->slope_z, tilt, bits.slope);
    to->bend_xx = tp_fast_weighed(w->bend_xx, bend, bits.bend);
    to->bend_xz = tp_fast_weighed(w->bend_xz, bend, bits.bend);
    to->bend_zz = tp_fast_weighed(w->bend_zz, bend, bits.bend);
}

/* Sets factors and shift of wave i. */
static inline void tp_fast_set_wave(const tp_grid *grid, tp_fast_wave *to, tp_fx weight,
                                    uint32_t i, tp_fast_bits bits)
{
    const tp_coastal_water *coastal = grid->surface->coastal;

    to->turns = to->push = to->iterations = 0;
    if (!coastal) {
        tp_fast_set_factors(to, weight, weight, false, bits);
        return;
    }
    const tp_fx up = tp_coastal_tables(coastal)[i].depth[TP_COASTAL_DEPTHS - 1].up;
    const tp_fx level = tp_fx_mul(tp_fan_share(weight), grid->fan->wind[i]);
    tp_fast_set_factors(to, weight, level, true, bits);
    if (coastal->wave[i].lambda == 0)
        return;
    to->push = tp_wind_phase_shift(coastal->wave[i].lambda, up);
    to->turns = tp_q30_mul(TP_OVER_TWO_PI_Q32, to->push);
    to->iterations = coastal->wave[i].iterations;
}

/* Lists the waves that a row keeps. */
static inline void tp_fast_list_waves(const tp_grid *grid, const tp_fan_row *row,
                                      tp_fast_waves *to, tp_fast_bits bits)
{
    const tp_surface *surface = grid->surface;
    const uint32_t count = surface->by->swells ? surface->deep->count : 0;
    const tp_fx least = tp_fan_row_least(grid, row);

    to->grid = grid;
    to->row = row;
    to->detail = tp_surface_has_rings_or_pools(surface)
                     ? tp_fan_row_detail_weight(grid->fan, row) : 0;
    to->count = 0;
    for (uint32_t i = 0; i < count; i++) {
        const tp_swell *w = &surface->deep->swell[i];
        const tp_fx weight = tp_fan_row_large_weight(grid, row, least, w);
        if (weight == 0)
            continue;
        tp_fast_wave *at = &to->wave[to->count++];
        at->swell = w;
        at->first = surface->phases[i] + tp_swell_turns(w->turns_x, row->x)
                    + tp_swell_turns(w->turns_z, row->z);
        at->step = tp_swell_turns(w->turns_x, row->step_x)
                   + tp_swell_turns(w->turns_z, row->step_z);
        tp_fast_set_wave(grid, at, weight, i, bits);
    }
}

/* -- the point of a sum -------------------------------------------------------------- */

typedef struct {
    int32_t x, z, y;            /* displacement, m: Q18, Q18, Q20 */
    int32_t hx, hz;             /* slopes before the Jacobian, Q24 */
    int32_t bxx, bxz, bzz;      /* 1 minus the Jacobian, Q28 */
} tp_fast_sum;

typedef struct {
    tp_vec3 position;
    int32_t slope_x, slope_z;   /* Q3.12 */
} tp_fast_point;

/* Returns n / d as a slope, Q3.12; n: Q20, d: Q15, 2^10 at least. */
static inline int32_t tp_fast_slope(int32_t n, int32_t d)
{
    const int32_t most = (1 << 24) - 1;
    return tp_clamp(tp_clamp(n, -most, most) * (1 << 7) / d, INT16_MIN, INT16_MAX);
}

TP_ALWAYS_INLINE tp_vec3 tp_fast_position(const tp_fast_sum *sum, tp_fx x, tp_fx z)
{
    return (tp_vec3){ tp_fx_add_sat(x, (sum->x + 2) >> 2), (sum->y + 8) >> 4,
                      tp_fx_add_sat(z, (sum->z + 2) >> 2) };
}

/* Sets slopes by the whole Jacobian [A10]. */
TP_ALWAYS_INLINE void tp_fast_set_slopes(tp_fast_point *to, const tp_fast_sum *sum)
{
    const int32_t one = 1 << 28, jxx = one - sum->bxx, jzz = one - sum->bzz;
    const int32_t folded = tp_upper((int64_t)jxx * jzz - (int64_t)sum->bxz * sum->bxz);
    const int32_t det = folded > one >> 9 ? folded >> 9 : one >> 18;    /* of Q24 to Q15 */
    const int32_t nx = tp_mul_upper(sum->hx, jzz) + tp_mul_upper(sum->hz, sum->bxz);
    const int32_t nz = tp_mul_upper(sum->hz, jxx) + tp_mul_upper(sum->hx, sum->bxz);

    to->slope_x = tp_fast_slope(nx, det);
    to->slope_z = tp_fast_slope(nz, det);
}

static inline void tp_fast_add_detail(const tp_fast_waves *waves, tp_fast_point *to)
{
    const tp_height_slope more = tp_rings_pools_sample_faded(
        waves->grid->surface, to->position.x, to->position.z, waves->detail);

    to->position.y += more.height;
    to->slope_x = tp_clamp(to->slope_x + (more.slope_x >> 4), INT16_MIN, INT16_MAX);
    to->slope_z = tp_clamp(to->slope_z + (more.slope_z >> 4), INT16_MIN, INT16_MAX);
}

/* Stores the vertex of a point; c: its position in the view. */
TP_ALWAYS_INLINE void tp_fast_store_vertex(const tp_projection *projection,
                                           const tp_view_vertex *c,
                                           const tp_fast_point *at, tp_grid_vertex *to)
{
    to->slope_x = (int16_t)at->slope_x;
    to->slope_z = (int16_t)at->slope_z;
    if (tp_projection_can_project(projection, c))
        tp_projection_project(projection, c, &to->u, &to->v, &to->zi);
    else
        to->u = TP_GRID_NEEDS_CLIP;
}

#endif
