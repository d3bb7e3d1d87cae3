/* SPDX-License-Identifier: MIT */
/* Vertices of a fan in 32 bits, for quality.waves = fast: the waves of fan_vertices.c, each
 * term by the upper word of a product.
 *
 * Places are within 6 / 65536 m of the exact vertices', slopes up to 1 within 4 / 4096: measured
 * 4 and 2.  Where waves in a wind nearly fold, the Jacobian counts as 1/32; slopes end at 8.
 *
 * Bits: displacements are below 2^9 m, and have 18 bits of fraction; heights are below 2^9
 * m: 20.  A slope has 24, a bend 28. */
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
} fast_wave;

typedef struct {
    const tp_grid *grid;
    const tp_fan_row *row;
    tp_fx     detail;           /* weight of rings and pools; 0: none */
    uint32_t  count;
    fast_wave wave[TP_WAVES];
} fast_waves;

/* Returns n weight 2^bits, saturated. */
static int32_t weighed(int32_t n, tp_fx weight, int bits)
{
    const int64_t to = (int64_t)n * weight >> (16 - bits);
    return (int32_t)tp_clamp_abs(to, INT32_MAX);
}

/* Sets the factors; a wave in a wind has slopes and heights without gain. */
static void set_factors(fast_wave *to, tp_fx weight, tp_fx level, int wind)
{
    const tp_swell *w = to->swell;
    const tp_fx share = tp_fan_share(weight), up = wind ? share : weight;
    const tp_fx bend = wind ? level : share, tilt = tp_fan_slope_weight(w, up);

    to->orbit_x = weighed(w->orbit_x, level, 4);
    to->orbit_z = weighed(w->orbit_z, level, 4);
    to->amplitude = weighed(w->amplitude, up, 7);
    to->slope_x = weighed(w->slope_x, tilt, -2);
    to->slope_z = weighed(w->slope_z, tilt, -2);
    to->bend_xx = weighed(w->bend_xx, bend, 1);
    to->bend_xz = weighed(w->bend_xz, bend, 1);
    to->bend_zz = weighed(w->bend_zz, bend, 1);
}

static void set_wave(const tp_grid *grid, fast_wave *to, tp_fx weight, uint32_t i)
{
    const tp_coastal_water *coastal = grid->surface->coastal;

    to->turns = to->push = to->iterations = 0;
    if (!coastal) {
        set_factors(to, weight, weight, 0);
        return;
    }
    const tp_fx up = tp_coastal_tables(coastal)[i].depth[TP_COASTAL_DEPTHS - 1].up;
    set_factors(to, weight, tp_fx_mul(tp_fan_share(weight), grid->fan->wind[i]), 1);
    if (coastal->wave[i].lambda == 0)
        return;
    to->push = tp_wind_phase_shift(coastal->wave[i].lambda, up);
    to->turns = tp_q30_mul(TP_OVER_TWO_PI_Q32, to->push);
    to->iterations = coastal->wave[i].iterations;
}

/* Lists the waves that a row keeps. */
static void list_waves(const tp_grid *grid, const tp_fan_row *row, fast_waves *to)
{
    const tp_surface *surface = grid->surface;
    const uint32_t count = surface->by->swells ? surface->deep->count : 0;

    to->grid = grid;
    to->row = row;
    to->detail = tp_surface_has_rings_or_pools(surface)
                     ? tp_fan_row_detail_weight(grid->fan, row) : 0;
    to->count = 0;
    for (uint32_t i = 0; i < count; i++) {
        const tp_swell *w = &surface->deep->swell[i];
        const tp_fx weight = tp_fan_row_weight(grid->fan, row, w);
        if (weight == 0)
            continue;
        fast_wave *at = &to->wave[to->count++];
        at->swell = w;
        at->first = surface->phases[i] + tp_swell_turns(w->turns_x, row->x)
                    + tp_swell_turns(w->turns_z, row->z);
        at->step = tp_swell_turns(w->turns_x, row->step_x)
                   + tp_swell_turns(w->turns_z, row->step_z);
        set_wave(grid, at, weight, i);
    }
}

/* -- the sum of waves ---------------------------------------------------------------- */

typedef struct {
    int32_t x, z, y;            /* displacement, m: Q18, Q18, Q20 */
    int32_t hx, hz;             /* slopes before the Jacobian, Q24 */
    int32_t bxx, bxz, bzz;      /* 1 minus the Jacobian, Q28 */
} fast_sum;

/* Adds a wave: sine and cosine, Q30; profile, its slope and the bend, Q29, Q28 and Q29. */
TP_ALWAYS_INLINE void add_terms(fast_sum *sum, const fast_wave *w, int32_t level,
                                int32_t profile, int32_t tilt, int32_t bend)
{
    sum->x += tp_mul_upper(w->orbit_x, level);
    sum->z += tp_mul_upper(w->orbit_z, level);
    sum->y += tp_mul_upper(w->amplitude, profile);
    sum->hx += tp_mul_upper(w->slope_x, tilt);
    sum->hz += tp_mul_upper(w->slope_z, tilt);
    sum->bxx += tp_mul_upper(w->bend_xx, bend);
    sum->bxz += tp_mul_upper(w->bend_xz, bend);
    sum->bzz += tp_mul_upper(w->bend_zz, bend);
}

TP_ALWAYS_INLINE void add_wave(fast_sum *sum, const fast_wave *w, tp_turn phase)
{
    const tp_q30 s = tp_sin(phase), c = tp_cos(phase);
    int32_t f = s >> 6, df = c >> 6;

    if (w->swell->power > 1) {
        tp_swell_sharpen(w->swell, s, c, &f, &df);
        add_terms(sum, w, c, f * 32, df * 16, s >> 1);
    } else {
        add_terms(sum, w, c, s >> 1, c >> 2, s >> 1);
    }
}

/* Adds a wave in a wind: the phase th and its rate 1 / (1 + push cos th), Q14, 2/3..2. */
static void add_wind_wave(fast_sum *sum, const fast_wave *w, tp_turn phase)
{
    tp_turn th = phase;

    for (int32_t n = 0; n < w->iterations; n++)
        th = phase - (tp_turn)tp_q30_mul(w->turns, tp_sin(th));
    const tp_q30 s = tp_sin(th), c = tp_cos(th);
    const int32_t one = TP_Q30_ONE + tp_mul_upper(w->push, c) * 4;
    const int32_t rate = (1 << 30) / (one >> 14);
    add_terms(sum, w, c, s >> 1, (c >> 16) * rate, (s >> 15) * rate);
}

/* Returns n / d as a slope, Q3.12; n: Q20, d: Q15, 2^10 at least. */
static int32_t divided(int32_t n, int32_t d)
{
    const int32_t most = (1 << 24) - 1;
    return tp_clamp(tp_clamp(n, -most, most) * (1 << 7) / d, INT16_MIN, INT16_MAX);
}

typedef struct {
    tp_vec3 position;
    int32_t slope_x, slope_z;   /* Q3.12 */
} fast_point;

static void set_point(fast_point *to, const fast_sum *sum, tp_fx x, tp_fx z)
{
    const int32_t one = 1 << 28, jxx = one - sum->bxx, jzz = one - sum->bzz;
    const int32_t folded = tp_upper((int64_t)jxx * jzz - (int64_t)sum->bxz * sum->bxz);
    const int32_t det = folded > one >> 9 ? folded >> 9 : one >> 18;    /* of Q24 to Q15 */
    const int32_t nx = tp_mul_upper(sum->hx, jzz) + tp_mul_upper(sum->hz, sum->bxz);
    const int32_t nz = tp_mul_upper(sum->hz, jxx) + tp_mul_upper(sum->hx, sum->bxz);

    to->position = (tp_vec3){ tp_fx_add_sat(x, (sum->x + 2) >> 2), (sum->y + 8) >> 4,
                              tp_fx_add_sat(z, (sum->z + 2) >> 2) };
    to->slope_x = divided(nx, det);
    to->slope_z = divided(nz, det);
}

static void add_detail(const fast_waves *waves, fast_point *to)
{
    const tp_height_slope more = tp_rings_pools_sample_faded(
        waves->grid->surface, to->position.x, to->position.z, waves->detail);

    to->position.y += more.height;
    to->slope_x = tp_clamp(to->slope_x + (more.slope_x >> 4), INT16_MIN, INT16_MAX);
    to->slope_z = tp_clamp(to->slope_z + (more.slope_z >> 4), INT16_MIN, INT16_MAX);
}

static fast_point sample(const fast_waves *waves, uint32_t i)
{
    const tp_fan *fan = waves->grid->fan;
    const bool wind = waves->grid->surface->coastal != NULL;
    const fast_wave *w = waves->wave, *end = w + waves->count;
    fast_sum sum = { 0 };
    fast_point at;

    for (; w < end; w++) {
        const tp_turn phase = w->first + i * w->step;
        if (wind)
            add_wind_wave(&sum, w, phase);
        else
            add_wave(&sum, w, phase);
    }
    set_point(&at, &sum, tp_fan_x(fan, waves->row, i), tp_fan_z(fan, waves->row, i));
    if (waves->detail != 0)
        add_detail(waves, &at);
    return at;
}

/* -- vertices ------------------------------------------------------------------------ */

static void evaluate_row(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                         tp_grid_vertex *vertex)
{
    const tp_projection *projection = grid->projection;
    fast_waves waves;

    list_waves(grid, &grid->fan->row[j], &waves);
    for (uint32_t i = first; i < end; i++) {
        const fast_point at = sample(&waves, i);
        tp_grid_vertex *to = &vertex[i];
        tp_view_vertex c;
        tp_projection_view_vertex(projection, at.position, &c);
        to->slope_x = (int16_t)at.slope_x;
        to->slope_z = (int16_t)at.slope_z;
        if (tp_projection_can_project(projection, &c))
            tp_projection_project(projection, &c, &to->u, &to->v, &to->zi);
        else
            to->u = TP_GRID_NEEDS_CLIP;
    }
}

static void make_view_vertices(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                               tp_view_vertex *to)
{
    fast_waves waves;

    list_waves(grid, &grid->fan->row[j], &waves);
    for (uint32_t i = first; i < end; i++, to++) {
        *to = (tp_view_vertex){ .s = tp_grid_s(grid, i, j), .t = tp_grid_t(grid, i, j) };
        tp_projection_view_vertex(grid->projection, sample(&waves, i).position, to);
    }
}

const struct tp_draw_fast_waves tp_draw_fast_waves = { evaluate_row, make_view_vertices };
