/* SPDX-License-Identifier: MIT */
/* Foam of a hull: a line around it, and its wake.  Rates are chosen by eye, see
 * foam_sources.c. */
#include "base/base.h"
#include "features/foam/foam_visit.h"
#include "world/module.h"

#define LINE_LEAST TP_FX(0.28)  /* m: half the width of the foam line */
#define LINE_UNITS 28           /* line of a hull at rest */
#define PACE_UNITS 300          /* line of a hull at PACE or faster */
#define PACE       4            /* m/s */
#define FULLER     TP_FX(1.176) /* a hull is longer than its points are apart; with the
                                 * factor the longship's waterline is 1 - alpha^2 within
                                 * 0.1 m */
#define ARM        TP_FX(0.3536)/* tangent of Kelvin's angle, 19.47 degrees */
#define ARM_LONG   5            /* length of the arms, in half hull lengths */

/* Returns a triangular profile: 1 at e = 0, 0 at |e| >= wide. */
static tp_fx triangle_profile(tp_fx e, tp_fx wide)
{
    tp_fx off = tp_abs(e);
    return off < wide ? TP_FX_ONE - tp_fx_div(off, wide) : 0;
}

/* Returns the intensity of the wake, 0..1: two arms from the bow, kept outside of the
 * hull, and turbulent water behind the stern.  `behind`: distance from the bow,
 * `side`: distance from the hull's axis, `hull_half_width`: half width of the hull
 * there; all in m. */
static tp_fx wake_foam_intensity(const tp_foam_hull *h, tp_fx behind, tp_fx side,
                                 tp_fx hull_half_width, tp_fx line_half_width)
{
    tp_fx reach = ARM_LONG * h->length, stern = behind - 2 * h->length;

    if (behind <= 0 || behind >= reach)
        return 0;
    tp_fx off = tp_fx_mul(behind, ARM);
    tp_fx arm = triangle_profile(side - (off > hull_half_width ? off : hull_half_width)
                                     - line_half_width / 2,
                                 line_half_width + behind / 24);
    tp_fx trail = stern > -h->length / 2 && stern < h->length / 2
                ? triangle_profile(side, h->beam / 2 + line_half_width) / 2 : 0;
    tp_fx most = arm > trail ? arm : trail;
    if (most == 0)                          /* most cells: no division */
        return 0;
    tp_fx left = TP_FX_ONE - tp_fx_div(behind, reach);
    return tp_fx_mul(most, tp_fx_mul(left, left));
}

static uint32_t hull_gain(const tp_foam_maker *m, tp_fx x)
{
    const tp_foam_hull *h = &m->hull;
    int64_t dx = (int64_t)x - h->x, dz = (int64_t)m->z - h->z;

    if (dx > h->foam_radius || dx < -h->foam_radius || dz > h->foam_radius
        || dz < -h->foam_radius)
        return 0;
    tp_fx alpha = tp_fx_saturate((dx * h->along[0] + dz * h->along[1]) >> 16);
    tp_fx beta = tp_fx_saturate((dx * h->across[0] + dz * h->across[1]) >> 16);
    tp_fx line = LINE_LEAST > m->foam->cell / 2 ? LINE_LEAST : m->foam->cell / 2;
    tp_fx side = tp_fx_mul(tp_abs(tp_clamp(beta, -TP_FX_MAX, TP_FX_MAX)), h->beam);
    tp_fx pace = tp_abs(h->pace);
    tp_fx wide = 0;
    uint32_t gain = 0;

    if (tp_abs(tp_clamp(alpha, -TP_FX_MAX, TP_FX_MAX)) <= TP_FX_ONE) {
        wide = tp_fx_mul(h->beam, TP_FX_ONE - tp_fx_mul(alpha, alpha));
        tp_fx hugs = triangle_profile(side - wide - line / 2, line);
        gain = tp_foam_scale_gain(hugs, LINE_UNITS)
             + tp_foam_scale_gain(tp_fx_mul(hugs, pace), PACE_UNITS);
    }
    if (pace > 0) {
        int64_t ahead = h->pace > 0 ? alpha : -(int64_t)alpha;
        tp_fx behind = tp_fx_saturate((TP_FX_ONE - ahead) * h->length >> 16);
        tp_fx wake = wake_foam_intensity(h, behind, side, wide, line);
        gain += tp_foam_scale_gain(tp_fx_mul(wake, pace), PACE_UNITS);
    }
    return (uint32_t)((uint64_t)gain * (uint32_t)m->scene->foam.hull >> 16);
}

/* Narrows the cells from..to to those where a value, `at` at the cell `from` and rising by
 * `step` a cell, lies in low..high; a cell more on each side for rounding. */
static void narrow_range(uint32_t *from, uint32_t *to, int64_t at, int64_t step, int64_t low,
                         int64_t high)
{
    const int64_t first = *from, cells = (int64_t)*to - first;

    if (step == 0) {
        *to = at < low || at > high ? *from : *to;
        return;
    }
    const int64_t a = ((step > 0 ? low : high) - at) / step - 1;
    const int64_t b = ((step > 0 ? high : low) - at) / step + 2;
    *from = (uint32_t)(first + (a < 0 ? 0 : a < cells ? a : cells));
    *to = (uint32_t)(first + (b < 0 ? 0 : b < cells ? b : cells));
}

/* Returns half the width of the hull's foam and of its wake, over the hull's half beam. */
static int64_t widest_beta(const tp_foam_maker *m)
{
    const tp_foam_hull *h = &m->hull;
    const int64_t line = LINE_LEAST + m->foam->cell;
    const int64_t reach = h->pace != 0 ? (int64_t)ARM_LONG * h->length : 0;
    const int64_t side = (reach * ARM >> 16) + reach / 24 + 2 * line + h->beam;

    return side * TP_FX_ONE / (h->beam > 0 ? h->beam : 1);
}

#define ROUNDED (TP_FX_ONE / 32)        /* covers the rounding of 256 steps */

/* The cells lie in a box around the hull, and in a box along it, from the bow to the wake's
 * end. */
bool tp_foam_maker_hull_range(const tp_foam_maker *m, tp_fx x, uint32_t *from, uint32_t *to)
{
    const tp_foam_hull *h = &m->hull;
    const int64_t dz = (int64_t)m->z - h->z, cells = m->foam->cells, cell = m->foam->cell;

    if (!m->has_hull || dz > h->foam_radius || dz < -h->foam_radius)
        return false;
    const int64_t low = ((int64_t)h->x - h->foam_radius - x) / cell - 1;
    const int64_t high = ((int64_t)h->x + h->foam_radius - x) / cell + 2;
    *from = (uint32_t)(low < 0 ? 0 : low < cells ? low : cells);
    *to = (uint32_t)(high < 0 ? 0 : high < cells ? high : cells);
    if (*from >= *to)
        return false;
    const int64_t behind = h->pace != 0 ? (ARM_LONG - 1) * TP_FX_ONE : TP_FX_ONE;
    const int64_t wide = widest_beta(m) + ROUNDED;
    int64_t dx = (int64_t)x + *from * cell - h->x;
    narrow_range(from, to, (dx * h->along[0] + dz * h->along[1]) >> 16,
                 cell * h->along[0] >> 16,
                 -(h->pace < 0 ? TP_FX_ONE : behind) - ROUNDED,
                 (h->pace < 0 ? behind : TP_FX_ONE) + ROUNDED);
    dx = (int64_t)x + *from * cell - h->x;
    narrow_range(from, to, (dx * h->across[0] + dz * h->across[1]) >> 16,
                 cell * h->across[0] >> 16, -wide, wide);
    return *from < *to;
}

/* Finds the hull in rest positions.  The rest positions of the hull's four points give
 * its axes, whatever the waves' displacement.  The displacement is at most 600 m, so det
 * is below 2^53. */
static void find_hull(tp_foam_maker *m)
{
    const tp_boat_state *a = &m->world->boat_state;
    const tp_vec3 *now = &m->world->boat.place, *last = &m->world->last_boat.place;
    const tp_fx (*p)[2] = a->rest;
    int64_t ux = ((int64_t)p[0][0] - p[1][0]) / 2, uz = ((int64_t)p[0][1] - p[1][1]) / 2;
    int64_t wx = ((int64_t)p[3][0] - p[2][0]) / 2, wz = ((int64_t)p[3][1] - p[2][1]) / 2;
    int64_t det = ux * wz - uz * wx;
    tp_foam_hull *h = &m->hull;

    m->has_hull = m->scene->boat.mesh[0] && a->placed && m->scene->foam.hull > 0
               && det > 1 << 24;
    if (!m->has_hull)
        return;
    h->x = (tp_fx)(((int64_t)p[0][0] + p[1][0] + p[2][0] + p[3][0]) / 4);
    h->z = (tp_fx)(((int64_t)p[0][1] + p[1][1] + p[2][1] + p[3][1]) / 4);
    ux = ux * FULLER >> 16;
    uz = uz * FULLER >> 16;
    det = (det >> 16) * FULLER + ((det & 0xffff) * FULLER >> 16);
    h->along[0] = tp_fx_saturate(wz * ((int64_t)1 << 32) / det);
    h->along[1] = tp_fx_saturate(-wx * ((int64_t)1 << 32) / det);
    h->across[0] = tp_fx_saturate(-uz * ((int64_t)1 << 32) / det);
    h->across[1] = tp_fx_saturate(ux * ((int64_t)1 << 32) / det);
    h->length = tp_fx_mul(m->scene->boat.length / 2, FULLER);
    h->beam = m->scene->boat.beam / 2;
    int64_t way = (((int64_t)now->x - last->x) * tp_sin(a->hull.heading)
                   - ((int64_t)now->z - last->z) * tp_cos(a->hull.heading)) >> 30;
    h->pace = (tp_fx)tp_clamp_abs(way * TP_TICKS_PER_SECOND / PACE, TP_FX_ONE);
    h->foam_radius = h->pace != 0 ? (ARM_LONG + 1) * h->length : h->length + h->beam;
}

const struct tp_water_foam_hull tp_water_foam_hull = { find_hull, hull_gain };
