/* SPDX-License-Identifier: MIT */
/* Vertices of a fan: the waves that a row keeps, summed at each vertex. */
#include "view/fan.h"
#include "view/wave_models.h"
#include "waves/coastal_tables.h"
#include "waves/deep_water.h"

/* -- waves of a row ------------------------------------------------------------------ */

/* A wave of a row: phase of column 0 and step of the phase; numbers of the swell by the
 * row's weight, without wind. */
typedef struct tp_fan_wave {
    const tp_swell *swell;
    tp_turn first, step;
    tp_fx   weight;             /* with gain */
    int32_t orbit_x, orbit_z, amplitude, slope_x, slope_z, bend_xx, bend_xz, bend_zz;
    tp_q30  push;               /* shift of the phase by the wind [B10] */
    int32_t iterations;
    tp_fx   along;              /* weight of the horizontal motion in a wind */
} row_wave;

typedef struct tp_fan_waves {
    const tp_fan *fan;
    const tp_fan_row *row;
    const tp_surface *surface;
    const struct tp_fan_relief *relief; /* NULL: neither rings nor pools */
    tp_fx     detail;           /* weight of rings and pools; 0: none */
    uint32_t  count;
    row_wave  wave[TP_WAVES];
} row_waves;

void tp_fan_set_wind(row_wave *to, const tp_coastal_water *coastal, tp_fx share, uint32_t i)
{
    const tp_fx up = tp_coastal_tables(coastal)[i].depth[TP_COASTAL_DEPTHS - 1].up;

    to->push = coastal->wave[i].lambda
                   ? tp_wind_phase_shift(coastal->wave[i].lambda, up) : 0;
    to->along = tp_fx_mul(tp_fan_share(to->weight), share);
    to->iterations = coastal->wave[i].iterations;
}

static void set_numbers(row_wave *to)
{
    const tp_swell *w = to->swell;
    const tp_fx weight = to->weight, share = tp_fan_share(weight);
    const tp_fx tilt = tp_fan_slope_weight(w, weight);

    to->orbit_x = tp_fx_mul(w->orbit_x, weight);
    to->orbit_z = tp_fx_mul(w->orbit_z, weight);
    to->amplitude = tp_fx_mul(w->amplitude, weight);
    to->slope_x = tp_fx_mul(w->slope_x, tilt);
    to->slope_z = tp_fx_mul(w->slope_z, tilt);
    to->bend_xx = tp_fx_mul(w->bend_xx, share);
    to->bend_xz = tp_fx_mul(w->bend_xz, share);
    to->bend_zz = tp_fx_mul(w->bend_zz, share);
}

/* Begins a row that keeps no waves yet. */
static void begin_row(const tp_grid *grid, const tp_fan_row *row, row_waves *to)
{
    const tp_surface *surface = grid->surface;

    to->fan = grid->fan;
    to->row = row;
    to->surface = surface;
    to->relief = !tp_surface_has_rings_or_pools(surface) ? NULL
               : surface->by->rings ? surface->by->rings->relief
                                    : surface->by->pools->relief;
    to->detail = to->relief ? to->relief->weight(grid->fan, row) : 0;
    to->count = 0;
}

/* Lists the waves that a row keeps. */
static void list_waves(const tp_grid *grid, const tp_fan_row *row, row_waves *to)
{
    const tp_surface *surface = grid->surface;
    const tp_deep_water *deep = surface->deep;
    const tp_fx least = tp_fan_row_least(grid, row);

    begin_row(grid, row, to);
    for (uint32_t i = 0; i < deep->count && surface->by->swells; i++) {
        const tp_swell *w = &deep->swell[i];
        row_wave *at = &to->wave[to->count];
        *at = (row_wave){ .swell = w,
                          .weight = tp_fan_row_large_weight(grid, row, least, w) };
        if (at->weight == 0)
            continue;
        at->first = surface->phases[i] + tp_swell_turns(w->turns_x, row->x)
                    + tp_swell_turns(w->turns_z, row->z);
        at->step = tp_swell_turns(w->turns_x, row->step_x)
                   + tp_swell_turns(w->turns_z, row->step_z);
        if (surface->coastal)
            surface->by->coastal->set_wind(at, surface->coastal, grid->fan->wind[i], i);
        else
            set_numbers(at);
        to->count++;
    }
}

/* -- the sum of waves ---------------------------------------------------------------- */

/* Returns d th / d phase, 1 / (1 + push cos th), 16.16. */
static int64_t phase_rate(tp_q30 push, tp_q30 cosine)
{
    const uint32_t n = (uint32_t)(TP_Q30_ONE + tp_q30_mul(push, cosine));
    const int zeros = tp_clz(n);

    return (int64_t)tp_recip_norm(n << zeros) >> (17 - zeros);
}

/* Adds a wave in a wind, a trochoid whose phase is moved by the push. */
static void add_wind_wave(tp_swell_sum *sum, const row_wave *wave, tp_turn phase)
{
    const tp_swell *w = wave->swell;
    const tp_turn quarter = 1u << 30;
    const tp_turn th = wave->push ? tp_wind_phase(phase + quarter, wave->push,
                                                  wave->iterations) - quarter : phase;
    const int64_t s = tp_sin(th) >> 6, c = tp_cos(th) >> 6;
    const int64_t rate = wave->push ? phase_rate(wave->push, (tp_q30)(c * 64))
                                    : TP_FX_ONE;
    const int64_t level = c * wave->along >> 16, up = s * tp_fan_share(wave->weight) >> 16;
    const int64_t tilt = (c * tp_fan_share(wave->weight) >> 16) * rate >> 16;
    const int64_t bend = (s * wave->along >> 16) * rate >> 16;

    sum->x += w->orbit_x * level;
    sum->z += w->orbit_z * level;
    sum->y += w->amplitude * up;
    sum->hx += w->slope_x * tilt;
    sum->hz += w->slope_z * tilt;
    sum->bxx += w->bend_xx * bend;
    sum->bxz += w->bend_xz * bend;
    sum->bzz += w->bend_zz * bend;
}

static void add_wave(tp_swell_sum *sum, const row_wave *wave, tp_turn phase)
{
    const tp_swell *w = wave->swell;
    const tp_q30 sine = tp_sin(phase), cosine = tp_cos(phase);
    int32_t s = sine >> 6, c = cosine >> 6, f = s, df = c;

    if (w->power > 1)
        tp_swell_sharpen(w, sine, cosine, &f, &df);
    sum->x += (int64_t)wave->orbit_x * c;
    sum->z += (int64_t)wave->orbit_z * c;
    sum->y += (int64_t)wave->amplitude * f;
    sum->hx += (int64_t)wave->slope_x * df;
    sum->hz += (int64_t)wave->slope_z * df;
    sum->bxx += (int64_t)wave->bend_xx * s;
    sum->bxz += (int64_t)wave->bend_xz * s;
    sum->bzz += (int64_t)wave->bend_zz * s;
}

/* True if the rows of the Jacobian do not fold, so that a slope has a bound. */
static bool is_unfolded(const tp_swell_sum *sum)
{
    const int64_t one = 1 << 28, xx = one - (sum->bxx >> 26), zz = one - (sum->bzz >> 26);
    const int64_t xz = sum->bxz >> 26;

    return xx > 0 && (xx * zz - xz * xz) >> 28 > one / 16;
}

/* Returns the point of a sum of waves in a wind; their rate may fold the Jacobian. */
static tp_surface_point point_of_wind_sum(const tp_swell_sum *sum, tp_fx x, tp_fx z)
{
    if (is_unfolded(sum))
        return tp_swell_sum_point(sum, x, z, TP_FX_ONE);
    const tp_vec3 along_x = { TP_FX_ONE - (tp_fx)(sum->bxx >> 38), (tp_fx)(sum->hx >> 38),
                              -(tp_fx)(sum->bxz >> 38) };
    const tp_vec3 along_z = { -(tp_fx)(sum->bxz >> 38), (tp_fx)(sum->hz >> 38),
                              TP_FX_ONE - (tp_fx)(sum->bzz >> 38) };
    tp_surface_point at = {
        .position = { tp_fx_add_sat(x, (tp_fx)(sum->x >> 24)), (tp_fx)(sum->y >> 24),
                      tp_fx_add_sat(z, (tp_fx)(sum->z >> 24)) },
    };

    tp_slopes_from_tangents(along_x, along_z, &at.slope_x, &at.slope_z);
    return at;
}

tp_surface_point tp_fan_wind_point(const row_waves *waves, uint32_t i, tp_fx x, tp_fx z)
{
    tp_swell_sum sum = { 0 };

    for (uint32_t k = 0; k < waves->count; k++)
        add_wind_wave(&sum, &waves->wave[k],
                      waves->wave[k].first + i * waves->wave[k].step);
    return point_of_wind_sum(&sum, x, z);
}

static tp_surface_point still_point(const row_waves *waves, uint32_t i, tp_fx x, tp_fx z)
{
    tp_swell_sum sum;

    sum.x = sum.y = sum.z = sum.hx = sum.hz = sum.bxx = sum.bxz = sum.bzz = 0;
    for (uint32_t k = 0; k < waves->count; k++)
        add_wave(&sum, &waves->wave[k], waves->wave[k].first + i * waves->wave[k].step);
    return tp_swell_sum_point(&sum, x, z, TP_FX_ONE);
}

/* Returns a point of a row, without swells if it keeps none. */
TP_ALWAYS_INLINE tp_surface_point sample(const row_waves *waves, uint32_t i, bool level)
{
    const tp_fan_row *row = waves->row;
    const tp_surface *surface = waves->surface;
    const tp_fx x = tp_fan_x(waves->fan, row, i), z = tp_fan_z(waves->fan, row, i);
    tp_surface_point at = { .position = { x, 0, z } };

    if (!level && waves->count > 0)
        at = surface->coastal ? surface->by->coastal->wind_point(waves, i, x, z)
                              : still_point(waves, i, x, z);
    if (waves->detail != 0) {
        const tp_height_slope more = waves->relief->sample(
            surface, at.position.x, at.position.z, waves->detail);
        at.position.y += more.height;
        at.slope_x += more.slope_x;
        at.slope_z += more.slope_z;
    }
    return at;
}

TP_NEVER_INLINE tp_surface_point sample_swells(const row_waves *waves, uint32_t i)
{
    return sample(waves, i, false);
}

TP_NEVER_INLINE tp_surface_point sample_level(const row_waves *waves, uint32_t i)
{
    return sample(waves, i, true);
}

/* -- vertices ------------------------------------------------------------------------ */

static int16_t packed_slope(tp_fx slope)
{
    return (int16_t)tp_clamp((slope + 8) >> 4, INT16_MIN, INT16_MAX);
}

/* Evaluate vertices of a row as tp_draw_fast_waves; `level`, a literal: there are no
 * swells. */
TP_ALWAYS_INLINE void evaluate_vertices(const tp_grid *grid, const row_waves *waves,
                                        uint32_t first, uint32_t end, bool level,
                                        tp_grid_vertex *vertex)
{
    const tp_projection *projection = grid->projection;

    for (uint32_t i = first; i < end; i++) {
        const tp_surface_point at =
            level ? sample_level(waves, i) : sample_swells(waves, i);
        tp_grid_vertex *to = &vertex[i];
        tp_view_vertex c;
        tp_projection_view_vertex(projection, at.position, &c);
        to->slope_x = packed_slope(at.slope_x);
        to->slope_z = packed_slope(at.slope_z);
        if (tp_projection_can_project(projection, &c))
            tp_projection_project(projection, &c, &to->u, &to->v, &to->zi);
        else
            to->u = TP_GRID_NEEDS_CLIP;
    }
}

TP_ALWAYS_INLINE void make_corners(const tp_grid *grid, const row_waves *waves, uint32_t j,
                                   uint32_t first, uint32_t end, bool level,
                                   tp_view_vertex *to)
{
    for (uint32_t i = first; i < end; i++, to++) {
        const tp_surface_point at =
            level ? sample_level(waves, i) : sample_swells(waves, i);
        *to = (tp_view_vertex){ .s = tp_grid_s(grid, i, j), .t = tp_grid_t(grid, i, j) };
        tp_projection_view_vertex(grid->projection, at.position, to);
    }
}

static void evaluate_exact_row(const tp_grid *grid, uint32_t j, uint32_t first,
                               uint32_t end, tp_grid_vertex *vertex)
{
    row_waves waves;

    list_waves(grid, &grid->fan->row[j], &waves);
    evaluate_vertices(grid, &waves, first, end, false, vertex);
}

static void make_exact_view_vertices(const tp_grid *grid, uint32_t j, uint32_t first,
                                     uint32_t end, tp_view_vertex *to)
{
    row_waves waves;

    list_waves(grid, &grid->fan->row[j], &waves);
    make_corners(grid, &waves, j, first, end, false, to);
}

static void evaluate_level_row(const tp_grid *grid, uint32_t j, uint32_t first,
                               uint32_t end, tp_grid_vertex *vertex)
{
    row_waves waves;

    begin_row(grid, &grid->fan->row[j], &waves);
    evaluate_vertices(grid, &waves, first, end, true, vertex);
}

static void make_level_view_vertices(const tp_grid *grid, uint32_t j, uint32_t first,
                                     uint32_t end, tp_view_vertex *to)
{
    row_waves waves;

    begin_row(grid, &grid->fan->row[j], &waves);
    make_corners(grid, &waves, j, first, end, true, to);
}

const struct tp_draw_exact_waves tp_draw_exact_waves = { evaluate_exact_row };
const struct tp_draw_exact_corners tp_draw_exact_corners = { make_exact_view_vertices };
const struct tp_draw_level_waves tp_draw_level_waves = {{ evaluate_level_row,
                                                          make_level_view_vertices }};
