/* SPDX-License-Identifier: MIT */
/* The weights of quality.geometry = large and largest.  A row keeps a swell as far as the
 * swell moves a vertex in the picture: nothing up to 1/2 px (largest: 1 px) at the row's
 * depth, all of it from twice as much on.  The rest is variance of slopes for water.rough,
 * as what the row's filter leaves out.  The rule reads the frame's view alone: all tiles
 * agree.  Coastal water over a floor, and renderers without a fan, keep all swells.
 *
 * Swells that move no pixel tilt no vertex either.  Slopes alone were measured, in a loop of
 * their own at each vertex: deep-sea's vertices cost 1 % more than with all swells, since
 * the filter leaves out most of such swells, and the pictures are as far from the exact
 * ones: deep-sea 36.9 dB with slopes and 37.0 without, storm 41.5 and 41.4. */
#include "view/fan.h"

static tp_fx row_least(const tp_grid *grid, const tp_fan_row *row)
{
    const tp_projection *p = grid->projection;
    const int32_t half = (int32_t)(grid->cols / 2);
    const int64_t dx = row->x + (int64_t)row->step_x * half - p->eye.x;
    const int64_t dz = row->z + (int64_t)row->step_z * half - p->eye.z;
    const tp_fx depth = tp_fx_saturate(
        (dx * p->ahead.x - (int64_t)p->eye.y * p->ahead.y + dz * p->ahead.z) >> 30);

    return depth <= p->near ? 0 : tp_length_of_px(grid->half_px * (TP_FX_ONE / 2),
                                                  p->focal >> 16, depth);
}

/* The larger displacement counts: up, or along an axis. */
static tp_fx swell_share(tp_fx least, const tp_swell *swell)
{
    const tp_fx x = tp_abs(swell->orbit_x), z = tp_abs(swell->orbit_z);
    const tp_fx aside = x > z ? x : z;

    return tp_fade_in_share(aside > swell->amplitude ? aside : swell->amplitude, least);
}

const struct tp_draw_large_waves tp_draw_large_waves = { row_least, swell_share };
