/* SPDX-License-Identifier: MIT */
/* Vertices of a fan by packed sines: sine and cosine share a word, 13 bits of fraction each,
 * and a term is a factor of 32 bits times one of the halves, one instruction of Cortex-M4.
 * Without rings, pools and tank walls a vertex is placed in view space by steps from the
 * row's first column.  A file that includes this one may define TP_PACKED_PAIR, a macro that
 * returns sine (low half) and cosine of a phase.
 *
 * quality.normals = fast: a normal has one bend for both directions, N = (-hx, 1 - sum QkA
 * sin th, -hz) [A9]: two products a wave and the determinant fewer.  On a Cortex-M4, at the
 * cheapest rungs, vertices of deep-sea fall from 2.51 to 2.22 M instructions a frame, of
 * storm from 1.80 to 1.54.  Without any slope in the loop they would be 1.80 and 1.31 M: 42
 * instructions a vertex of storm, and about 30 more for the quotients.  Central differences
 * of the neighbours' places take 195 (assets/charts/normals.csv), need the rows before and
 * after, which is three times the waves where rows are streamed, and halve the slope of a
 * wave that the filter is about to drop: sin(kd) / kd is 0.5 at 0.3 wavelengths.  So they
 * are no rung. */
#ifndef TP_VIEW_PACKED_VERTICES_H
#define TP_VIEW_PACKED_VERTICES_H
#include "base/dsp.h"
#include "view/fan_fast.h"

#ifndef TP_PACKED_PAIR
#define TP_PACKED_PAIR(phase) packed_pair(phase)

static inline uint32_t packed_pair(tp_turn phase)
{
    return tp_pair16((tp_cos(phase) + (1 << 16)) >> 17, (tp_sin(phase) + (1 << 16)) >> 17);
}
#endif

static const tp_fast_bits packed_bits = { .orbit = 5, .height = 7, .slope = -3, .bend = 1 };

/* -- the sum of waves ---------------------------------------------------------------- */

/* The pairs of a wave, low half and high half: of the circle, sine and cosine; of height and
 * slope, the profile and its slope; of the bend, sine by the rate of the phase. */
typedef struct {
    uint32_t circle, height, tilt, bend;
} packed_pairs;

/* Returns f and f' of a sharpened wave [A3], Q13; f' is below 2.48. */
static inline uint32_t sharpened_pair(const tp_swell *w, uint32_t circle)
{
    int32_t f, df;

    tp_swell_sharpen(w, tp_low16(circle) * (1 << 17), tp_high16(circle) * (1 << 17), &f,
                     &df);
    return tp_pair16(df >> 11, f >> 11);
}

/* Returns the pairs of a wave in a wind: the phase th and its rate 1 / (1 + push cos th),
 * Q14, 2/3..2. */
TP_ALWAYS_INLINE packed_pairs wind_pairs(const tp_fast_wave *w, tp_turn phase)
{
    tp_turn th = phase;

    for (int32_t n = 0; n < w->iterations; n++)
        th = phase - (tp_turn)tp_smulwb(w->turns, TP_PACKED_PAIR(th)) * 8;
    const uint32_t circle = TP_PACKED_PAIR(th);
    const int32_t one = TP_Q30_ONE + tp_smulwt(w->push, circle) * 8;
    const int32_t rate = (1 << 30) / (one >> 14);
    const uint32_t rated = tp_pair16(tp_high16(circle) * rate >> 14,
                                     tp_low16(circle) * rate >> 14);
    return (packed_pairs){ circle, circle, rated, rated };
}

TP_ALWAYS_INLINE packed_pairs wave_pairs(const tp_fast_wave *w, tp_turn phase)
{
    const uint32_t circle = TP_PACKED_PAIR(phase);
    if (w->swell->power <= 1)
        return (packed_pairs){ circle, circle, circle, circle };
    const uint32_t profile = sharpened_pair(w->swell, circle);
    return (packed_pairs){ circle, profile, profile, circle };
}

/* Sums the waves of vertex i that move it; `wind` and `plain` are literals. */
TP_ALWAYS_INLINE void add_waves(tp_fast_sum *to, const tp_fast_waves *waves, uint32_t i,
                                bool wind, bool plain)
{
    tp_fast_sum sum = { 0 };

    for (const tp_fast_wave *w = waves->wave, *end = w + waves->count; w < end; w++) {
        const tp_turn phase = w->first + i * w->step;
        const packed_pairs p = wind ? wind_pairs(w, phase) : wave_pairs(w, phase);
        sum.x = tp_smlawt(w->orbit_x, p.circle, sum.x);
        sum.z = tp_smlawt(w->orbit_z, p.circle, sum.z);
        sum.y = tp_smlawb(w->amplitude, p.height, sum.y);
        sum.hx = tp_smlawt(w->slope_x, p.tilt, sum.hx);
        sum.hz = tp_smlawt(w->slope_z, p.tilt, sum.hz);
        sum.bxx = tp_smlawb(w->bend_xx, p.bend, sum.bxx);
        if (plain)
            continue;
        sum.bxz = tp_smlawb(w->bend_xz, p.bend, sum.bxz);
        sum.bzz = tp_smlawb(w->bend_zz, p.bend, sum.bzz);
    }
    *to = sum;
}

/* The sums have functions of their own: their registers. */
#define SUM(name, wind, plain) \
    TP_NEVER_INLINE void name(tp_fast_sum *to, const tp_fast_waves *waves, uint32_t i) \
    { add_waves(to, waves, i, wind, plain); }
SUM(sum_deep, false, false)
SUM(sum_deep_plain, false, true)
SUM(sum_wind, true, false)
SUM(sum_wind_plain, true, true)

typedef void packed_sum(tp_fast_sum *to, const tp_fast_waves *waves, uint32_t i);

static packed_sum *choose_sum(const tp_grid *grid)
{
    return grid->surface->coastal ? grid->plain_normals ? sum_wind_plain : sum_wind
                                  : grid->plain_normals ? sum_deep_plain : sum_deep;
}

/* Returns n / d as a slope, Q3.12; n: Q24, d: Q15, 2^10 at least. */
TP_ALWAYS_INLINE int32_t packed_slope(int32_t n, int32_t d)
{
    return tp_ssat(tp_ssat(n, 4, 25) * (1 << 7) / d, 0, 16);
}

/* Sets slopes by the sum of bends alone: N = (-hx, 1 - sum QkA sin th, -hz) [A9]. */
TP_ALWAYS_INLINE void set_plain_slopes(tp_fast_point *to, const tp_fast_sum *sum)
{
    const int32_t one = 1 << 28, rest = one - sum->bxx, least = one >> 5;
    const int32_t det = (rest > least ? rest : least) >> 13;

    to->slope_x = packed_slope(sum->hx, det);
    to->slope_z = packed_slope(sum->hz, det);
}

/* -- places -------------------------------------------------------------------------- */

/* A row: its waves, and the view coordinates of column 0 at rest and their steps.  Rows of a
 * tank, of rings and of pools have no steps: their vertices need places of the world. */
typedef struct {
    tp_fast_waves waves;
    packed_sum *sum;
    bool     plain, stepped;
    uint32_t x, y, depth, step_x, step_y, step_depth;
} packed_row;

static void place_row(packed_row *to, const tp_grid *grid, uint32_t j)
{
    const tp_fan_row *row = &grid->fan->row[j];
    const tp_projection *p = grid->projection;
    const tp_vec3 step = { row->step_x, 0, row->step_z };
    tp_view_vertex first;

    tp_fast_list_waves(grid, row, &to->waves, packed_bits);
    to->sum = choose_sum(grid);
    to->plain = grid->plain_normals;
    for (uint32_t i = 0; grid->plain_normals && i < to->waves.count; i++)
        to->waves.wave[i].bend_xx += to->waves.wave[i].bend_zz;
    to->stepped = to->waves.detail == 0 && grid->fan->end_column == UINT32_MAX;
    tp_projection_view_vertex(p, (tp_vec3){ row->x, 0, row->z }, &first);
    to->x = (uint32_t)first.x;
    to->y = (uint32_t)first.y;
    to->depth = (uint32_t)first.depth;
    to->step_x = (uint32_t)tp_dot_dir_clamped(step, p->right);
    to->step_y = (uint32_t)tp_dot_dir_clamped(step, p->up);
    to->step_depth = (uint32_t)tp_dot_dir_clamped(step, p->ahead);
}

/* Returns a displacement along a direction, 16.16. */
TP_ALWAYS_INLINE uint32_t along(const tp_fast_sum *sum, tp_dir3 axis)
{
    return (uint32_t)(tp_mul_upper(sum->x, axis.x) + tp_mul_upper(sum->y >> 2, axis.y)
                      + tp_mul_upper(sum->z, axis.z));
}

/* Sets view coordinates of vertex i by the row's steps: within 1/2 LSB a column. */
TP_ALWAYS_INLINE void set_stepped_view(tp_view_vertex *c, const packed_row *row,
                                       const tp_fast_sum *sum, uint32_t i)
{
    const tp_projection *p = row->waves.grid->projection;

    c->x = (int32_t)(row->x + i * row->step_x + along(sum, p->right));
    c->y = (int32_t)(row->y + i * row->step_y + along(sum, p->up));
    c->depth = (int32_t)(row->depth + i * row->step_depth + along(sum, p->ahead));
}

/* Sets view coordinates of vertex i by its place in the world, with rings and pools. */
TP_NEVER_INLINE void set_placed_view(tp_view_vertex *c, const tp_fast_waves *waves,
                                     const tp_fast_sum *sum, uint32_t i, tp_fast_point *at)
{
    const tp_fan *fan = waves->grid->fan;

    at->position = tp_fast_position(sum, tp_fan_x(fan, waves->row, i),
                                    tp_fan_z(fan, waves->row, i));
    if (waves->detail != 0)
        tp_fast_add_detail(waves, at);
    tp_projection_view_vertex(waves->grid->projection, at->position, c);
}

/* Sets the view coordinates and slopes of vertex i. */
TP_ALWAYS_INLINE void place_vertex(const packed_row *row, uint32_t i, tp_view_vertex *c,
                                   tp_fast_point *at)
{
    const tp_fast_waves *waves = &row->waves;
    tp_fast_sum sum;

    row->sum(&sum, waves, i);
    if (row->plain)
        set_plain_slopes(at, &sum);
    else
        tp_fast_set_slopes(at, &sum);
    if (row->stepped)
        set_stepped_view(c, row, &sum, i);
    else
        set_placed_view(c, waves, &sum, i, at);
}

/* -- rows ---------------------------------------------------------------------------- */

static void evaluate_row(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                         tp_grid_vertex *vertex)
{
    packed_row row;

    place_row(&row, grid, j);
    for (uint32_t i = first; i < end; i++) {
        tp_view_vertex c;
        tp_fast_point at;
        place_vertex(&row, i, &c, &at);
        tp_fast_store_vertex(grid->projection, &c, &at, &vertex[i]);
    }
}

static void make_view_vertices(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                               tp_view_vertex *to)
{
    packed_row row;

    place_row(&row, grid, j);
    for (uint32_t i = first; i < end; i++, to++) {
        tp_fast_point at;
        *to = (tp_view_vertex){ .s = tp_grid_s(grid, i, j), .t = tp_grid_t(grid, i, j) };
        place_vertex(&row, i, to, &at);
    }
}

#endif
