/* SPDX-License-Identifier: MIT */
/* The numbers behind grid vertices: constants of the frame, tables of columns, numbers of
 * a row. */
#include "view/wave_models.h"
#include "waves/deep_water.h"

/* -- the frame ----------------------------------------------------------------------- */

/* Returns a x + b z in Q.20, rounded, from 16.16 times Q2.30: a horizontal displacement
 * along a view axis, or an amplitude times the y of an axis. */
static int32_t dot_horizontal_q20(tp_fx a, tp_q30 x, tp_fx b, tp_q30 z)
{
    return (int32_t)(((int64_t)a * x + (int64_t)b * z + (1 << 25)) >> 26);
}

/* Converts a slope from Q2.30 to Q.(14 + tilt). */
static int32_t convert_slope_bits(tp_q30 slope, int slope_bits)
{
    return (int32_t)(((int64_t)slope * (1 << slope_bits) + (1 << 15)) >> 16);
}

static tp_vertex_swell project_swell(const tp_vertex_frame *frame, const tp_swell *w)
{
    const tp_projection *projection = frame->projection;
    bool crossed = frame->surface->deep->crossed;

    return (tp_vertex_swell){
        .x = dot_horizontal_q20(w->orbit_x, projection->right.x, w->orbit_z,
                                projection->right.z),
        .y = dot_horizontal_q20(w->orbit_x, projection->up.x, w->orbit_z,
                                projection->up.z),
        .depth = dot_horizontal_q20(w->orbit_x, projection->ahead.x, w->orbit_z,
                                    projection->ahead.z),
        .rise_x = dot_horizontal_q20(w->amplitude, projection->lean, 0, 0),
        .rise_y = dot_horizontal_q20(w->amplitude, projection->up.y, 0, 0),
        .rise_depth = dot_horizontal_q20(w->amplitude, projection->ahead.y, 0, 0),
        .tilt_x = convert_slope_bits(w->slope_x, frame->tilt),
        .tilt_z = convert_slope_bits(w->slope_z, frame->tilt),
        .bend_xx = ((crossed ? w->bend_xx : w->bend) + 1) >> 1,
        .bend_xz = (w->bend_xz + 1) >> 1,
        .bend_zz = (w->bend_zz + 1) >> 1,
    };
}

/* Returns the number of fraction bits for slopes.  Each number of a row stays below 32000
 * in Q.tilt, to fit half of a pair.  The sum over all swells stays below 64000; it bounds
 * every sum of products with a sine and a cosine in Q.15, so the sum stays below 2^31. */
static int choose_tilt_bits(const tp_deep_water *deep)
{
    int64_t sum = 0, most = 0;
    int     tilt = 19;

    for (uint32_t i = 0; i < deep->count; i++) {
        sum += deep->swell[i].tilt;
        most = deep->swell[i].tilt > most ? deep->swell[i].tilt : most;
    }
    most = 2 * most > sum ? 2 * most : sum;
    while (tilt > 9 && most * (1 << tilt) > (int64_t)64000 * TP_FX_ONE)
        tilt--;
    return tilt;
}

/* -- rest positions ------------------------------------------------------------------ */

/* Computes the view coordinates of a vector.  Rows of the projection are no longer
 * than 1.42, and the eye is at most 24 km from water. */
static void transform_to_view(const tp_vertex_frame *frame, tp_vec3 d, int32_t rest[3])
{
    const tp_projection *projection = frame->projection;
    const tp_dir3 axis[3] = { projection->right, projection->up, projection->ahead };
    int down = frame->wide ? 32 : 30;

    for (int i = 0; i < 3; i++) {
        int64_t way = (int64_t)d.x * axis[i].x + (int64_t)d.y * axis[i].y
                    + (int64_t)d.z * axis[i].z;
        TP_ASSERT(way >> down == (int32_t)(way >> down));
        rest[i] = (int32_t)((way + ((int64_t)1 << (down - 1))) >> down);
    }
}

void tp_vertex_x_to_view(const tp_vertex_frame *frame, tp_fx x, int32_t view_part[3])
{
    transform_to_view(frame, (tp_vec3){ x - frame->projection->eye.x, 0, 0 }, view_part);
}

void tp_vertex_z_to_view(const tp_vertex_frame *frame, tp_fx z, int32_t view_part[3])
{
    const tp_vec3 *eye = &frame->projection->eye;
    transform_to_view(frame, (tp_vec3){ 0, -eye->y, z - eye->z }, view_part);
}

/* True if view coordinates may exceed 16.16.  View coordinates are linear over columns
 * and rows, so the corners have the extremes. */
static bool needs_wide_coordinates(tp_vertex_frame *frame, const tp_fx x[2],
                                   const tp_fx z[2])
{
    bool wide = false;

    frame->wide = true;         /* 18.14, so that parts fit */
    for (int k = 0; k < 4; k++) {
        int32_t a[3], b[3];
        tp_vertex_x_to_view(frame, x[k & 1], a);
        tp_vertex_z_to_view(frame, z[k >> 1], b);
        for (int axis = 0; axis < 3; axis++) {
            int64_t most = 4 * ((int64_t)tp_abs(a[axis]) + tp_abs(b[axis]) + 2);
            wide = wide || most + frame->margin > TP_FX_MAX;
        }
    }
    return wide;
}

void tp_vertex_begin(tp_vertex_frame *frame, tp_fx x0, tp_fx x1, tp_fx z0, tp_fx z1)
{
    TP_ASSERT(frame->most <= TP_WAVES && x0 <= x1 && z0 <= z1);
    const tp_deep_water *deep = frame->surface->deep;
    const tp_fx x[2] = { x0, x1 }, z[2] = { z0, z1 };

    frame->count = deep->count < frame->most ? deep->count : frame->most;
    if (!frame->surface->by->swells)
        frame->count = 0;
    frame->max_displacement = tp_surface_height_bound(frame->surface)
                              + tp_surface_displacement_bound(frame->surface);
    frame->margin = frame->max_displacement + frame->max_displacement / 2 + 4;
    frame->far = 1 << (6 + frame->projection->m);
    if (frame->far < frame->projection->near)
        frame->far = frame->projection->near;
    frame->wide = needs_wide_coordinates(frame, x, z);
    if (frame->count > 0)
        frame->surface->by->swells->begin(frame);
}

void tp_vertex_set_swells(tp_vertex_frame *frame)
{
    const tp_deep_water *deep = frame->surface->deep;

    frame->tilt = choose_tilt_bits(deep);
    for (uint32_t i = 0; i < deep->count; i++)
        frame->swell[i] = project_swell(frame, &deep->swell[i]);
}

/* -- phases -------------------------------------------------------------------------- */

/* Starts at the nearest of 1024 angles with an exact sine and adds the rest
 * d <= 2 pi / 2048:
 *     sin(a + d) = sin a + d cos a - d^2/2 sin a,  less d^3/6 < 5e-9.
 * d is Q.38 and below 2^30, d^2/2 is Q.45. */
tp_vertex_sincos tp_vertex_sincos_from_angle(tp_turn angle)
{
    const int32_t two_pi = 1686629713;                      /* 2 pi, Q.28 */
    tp_turn whole = (angle + (1u << 21)) & ~((1u << 22) - 1);
    int32_t d = tp_mul_upper((int32_t)(angle - whole) * 1024, two_pi);
    int32_t half = tp_mul_upper(d, d);
    int32_t s = tp_sin(whole), c = tp_cos(whole);

    return (tp_vertex_sincos){
        .sin = s + ((tp_mul_upper(c, d) - (tp_mul_upper(s, half) >> 7) + 32) >> 6),
        .cos = c - ((tp_mul_upper(s, d) + (tp_mul_upper(c, half) >> 7) + 32) >> 6),
    };
}

static uint32_t pack_pair(int32_t low, int32_t high)
{
    low = tp_clamp(low, -INT16_MAX, INT16_MAX);
    high = tp_clamp(high, -INT16_MAX, INT16_MAX);
    return ((uint32_t)low & 0xffff) | (uint32_t)high << 16;
}

/* Returns sine and cosine times a weight: the amplitude fades, the phase stays. */
static tp_vertex_sincos scale_sin_cos(tp_vertex_sincos phase, tp_fx weight)
{
    return (tp_vertex_sincos){ tp_fx_mul(phase.sin, weight), tp_fx_mul(phase.cos, weight) };
}

/* Returns sine and cosine as two Q.15: the sine low, the cosine high. */
static uint32_t pack_sin_cos(tp_vertex_sincos phase)
{
    return pack_pair((phase.sin + (1 << 14)) >> 15, (phase.cos + (1 << 14)) >> 15);
}

/* Same as scale_sin_cos; a weight of 1 costs no multiplication. */
static tp_vertex_sincos fade_sin_cos(tp_vertex_sincos phase, tp_fx weight)
{
    return weight == TP_FX_ONE ? phase : scale_sin_cos(phase, weight);
}

/* Fills the columns' tables of a swell.  Within a run the phase advances by a rotation
 * per cell, with an error of 2^-31 each; every run starts with a fresh phase. */
static void set_column_phases(const tp_vertex_frame *frame,
                              const tp_vertex_columns *columns, uint32_t k,
                              uint32_t first, uint32_t end, tp_fx cell)
{
    const int64_t turns_x = frame->surface->deep->swell[k].turns_x;
    const bool fading = !frame->surface->deep->sharpened;
    tp_vertex_sincos step = tp_vertex_sincos_from_angle(tp_swell_turns(turns_x, cell));
    tp_vertex_sincos now = { 0, 0 };

    for (uint32_t i = first; i < end; i++) {
        const tp_grid_line *line = &columns->line[i];
        size_t at = (size_t)i * frame->count + k;
        if ((i - first) % TP_VERTEX_BATCH == 0 || line->place - line[-1].place != cell)
            now = tp_vertex_sincos_from_angle(tp_swell_turns(turns_x, line->place));
        else
            now = tp_vertex_sincos_add_angles(now, step);
        tp_vertex_sincos phase = fading ? fade_sin_cos(now, line->fade) : now;
        columns->turn[at] = phase;
        columns->pair[at] = pack_sin_cos(phase);
    }
}

void tp_vertex_set_columns(const tp_vertex_frame *frame, const tp_vertex_columns *columns,
                           uint32_t first, uint32_t end, tp_fx cell)
{
    for (uint32_t k = 0; k < frame->count; k++)
        set_column_phases(frame, columns, k, first, end, cell);
}

/* -- rows ---------------------------------------------------------------------------- */

/* Splits C cos + S sin of the whole phase into factors of the column's sine and cosine. */
static tp_vertex_sincos rotate_amplitudes_by_row(int32_t cos_amplitude,
                                                 int32_t sin_amplitude,
                                                 tp_vertex_sincos row_phase)
{
    const int64_t half = (int64_t)1 << 31;
    return (tp_vertex_sincos){
        tp_upper((int64_t)sin_amplitude * row_phase.cos
                 - (int64_t)cos_amplitude * row_phase.sin + half),
        tp_upper((int64_t)cos_amplitude * row_phase.cos
                 + (int64_t)sin_amplitude * row_phase.sin + half),
    };
}

/* Packs two products as 16-bit halves.  The numbers have 14 extra bits, and Q2.30 removes
 * 2. */
static inline uint32_t pack_two_products(int32_t sine, int32_t cosine, int32_t a, int32_t b)
{
    int32_t low = tp_mul_upper(sine, a) + (1 << 11);
    int32_t high = tp_mul_upper(cosine, b) + (1 << 11);
    return (uint32_t)low << 4 >> 16 | ((uint32_t)high << 4 & 0xffff0000);
}

static void set_position_factors(const tp_vertex_frame *frame, tp_vertex_row *row)
{
    const tp_surface *surface = frame->surface;

    for (uint32_t k = 0; k < frame->count; k++) {
        const tp_vertex_swell *w = &frame->swell[k];
        const int64_t turns_z = surface->deep->swell[k].turns_z;
        tp_vertex_sincos b = tp_vertex_sincos_from_angle(surface->phases[k]
                                             + tp_swell_turns(turns_z, row->line.place));
        if (!surface->deep->sharpened)
            b = fade_sin_cos(b, row->line.fade);
        row->turn[k] = b;
        row->place[0][k] = rotate_amplitudes_by_row(w->x, w->rise_x, b);
        row->place[1][k] = rotate_amplitudes_by_row(w->y, w->rise_y, b);
        row->place[2][k] = rotate_amplitudes_by_row(w->depth, w->rise_depth, b);
    }
}

static void set_slope_factors(const tp_vertex_frame *frame, tp_vertex_row *row)
{
    for (uint32_t k = 0; k < frame->count; k++) {
        const tp_vertex_swell *w = &frame->swell[k];
        tp_vertex_sincos b = row->turn[k];
        row->tilt[k] = (tp_vertex_tilt){
            .tilt_x = pack_two_products(-w->tilt_x, w->tilt_x, b.sin, b.cos),
            .tilt_z = pack_two_products(-w->tilt_z, w->tilt_z, b.sin, b.cos),
            .bend_xx = pack_two_products(-w->bend_xx, -w->bend_xx, b.cos, b.sin),
            .bend_xz = pack_two_products(w->bend_xz, w->bend_xz, b.cos, b.sin),
            .bend_zz = pack_two_products(-w->bend_zz, -w->bend_zz, b.cos, b.sin),
        };
    }
}

void tp_vertex_set_row(const tp_vertex_frame *frame, tp_vertex_row *row, bool sloped)
{
    set_position_factors(frame, row);
    if (sloped)
        set_slope_factors(frame, row);
}
