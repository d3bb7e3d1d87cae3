/* SPDX-License-Identifier: MIT */
/* Vertices of a fan in 32 bits, for quality.waves = fast: the waves of fan_vertices.c, each
 * term by the upper word of a product.
 *
 * Places are within 6 / 65536 m of the exact vertices', slopes up to 1 within 4 / 4096: measured
 * 4 and 2.  Where waves in a wind nearly fold, the Jacobian counts as 1/32; slopes end at 8. */
#include "view/fan_fast.h"

/* Factors times sines of 30 bits, of which the upper word is taken. */
static const tp_fast_bits bits = { .orbit = 4, .height = 7, .slope = -2, .bend = 1 };

/* Adds a wave: sine and cosine, Q30; profile, its slope and the bend, Q29, Q28 and Q29. */
TP_ALWAYS_INLINE void add_terms(tp_fast_sum *sum, const tp_fast_wave *w, int32_t level,
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

TP_ALWAYS_INLINE void add_wave(tp_fast_sum *sum, const tp_fast_wave *w, tp_turn phase)
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
static void add_wind_wave(tp_fast_sum *sum, const tp_fast_wave *w, tp_turn phase)
{
    tp_turn th = phase;

    for (int32_t n = 0; n < w->iterations; n++)
        th = phase - (tp_turn)tp_q30_mul(w->turns, tp_sin(th));
    const tp_q30 s = tp_sin(th), c = tp_cos(th);
    const int32_t one = TP_Q30_ONE + tp_mul_upper(w->push, c) * 4;
    const int32_t rate = (1 << 30) / (one >> 14);
    add_terms(sum, w, c, s >> 1, (c >> 16) * rate, (s >> 15) * rate);
}

static tp_fast_point sample(const tp_fast_waves *waves, uint32_t i)
{
    const tp_fan *fan = waves->grid->fan;
    const bool wind = waves->grid->surface->coastal != NULL;
    const tp_fast_wave *w = waves->wave, *end = w + waves->count;
    tp_fast_sum sum = { 0 };
    tp_fast_point at;

    for (; w < end; w++) {
        const tp_turn phase = w->first + i * w->step;
        if (wind)
            add_wind_wave(&sum, w, phase);
        else
            add_wave(&sum, w, phase);
    }
    at.position = tp_fast_position(&sum, tp_fan_x(fan, waves->row, i),
                                   tp_fan_z(fan, waves->row, i));
    tp_fast_set_slopes(&at, &sum);
    if (waves->detail != 0)
        tp_fast_add_detail(waves, &at);
    return at;
}

/* -- vertices ------------------------------------------------------------------------ */

static void evaluate_row(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                         tp_grid_vertex *vertex)
{
    const tp_projection *projection = grid->projection;
    tp_fast_waves waves;

    tp_fast_list_waves(grid, &grid->fan->row[j], &waves, bits);
    for (uint32_t i = first; i < end; i++) {
        const tp_fast_point at = sample(&waves, i);
        tp_grid_vertex *to = &vertex[i];
        tp_view_vertex c;
        tp_projection_view_vertex(projection, at.position, &c);
        tp_fast_store_vertex(projection, &c, &at, to);
    }
}

static void make_view_vertices(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                               tp_view_vertex *to)
{
    tp_fast_waves waves;

    tp_fast_list_waves(grid, &grid->fan->row[j], &waves, bits);
    for (uint32_t i = first; i < end; i++, to++) {
        *to = (tp_view_vertex){ .s = tp_grid_s(grid, i, j), .t = tp_grid_t(grid, i, j) };
        tp_projection_view_vertex(grid->projection, sample(&waves, i).position, to);
    }
}

const struct tp_draw_fast_waves tp_draw_fast_waves = { evaluate_row, make_view_vertices };
