/* SPDX-License-Identifier: MIT */
/*
 * Positions of the grid's lines: equal steps in the middle, growing steps in the skirts.
 * Waves fade to 0 at the last line of the middle, so the skirts are flat.
 */
#include "view/grid.h"

/* Returns cell (g + g^2 + ... + g^n), saturated. */
static int64_t geometric_sum(tp_fx cell, int64_t ratio, uint32_t n)
{
    int64_t step = cell, sum = 0;

    for (uint32_t i = 0; i < n && sum < (int64_t)1 << 40; i++) {
        step = step * ratio >> 16;
        sum += step;
    }
    return sum;
}

/* Returns the ratio, 16.16, for n growing steps over the distance `way`; at least 1. */
static int64_t solve_ratio(tp_fx cell, int64_t way, uint32_t n)
{
    int64_t low = TP_FX_ONE, high = 256 * TP_FX_ONE;

    while (high - low > 1) {
        int64_t middle = (low + high) / 2;
        if (geometric_sum(cell, middle, n) <= way)
            low = middle;
        else
            high = middle;
    }
    return low;
}

uint32_t tp_grid_lines_skirt_count(uint32_t count, const tp_grid_view *view)
{
    uint32_t flank = view->reach > 0 ? count / 8 : 0;
    return flank < TP_GRID_FLANK ? flank : TP_GRID_FLANK;
}

/* Returns the ratio of the skirts' steps.  A skirt ends at the scene's reach, or at 16000
 * m from the centre. */
static int64_t skirt_growth_ratio(uint32_t count, const tp_grid_view *view)
{
    TP_ASSERT(count >= 2 && view->cell > 0);
    uint32_t flank = tp_grid_lines_skirt_count(count, view);
    tp_fx half = (tp_fx)((int64_t)view->cell * (count - 2 * flank - 1) / 2);
    int64_t most = 16000 * TP_FX_ONE - half;
    int64_t way = view->reach < most ? view->reach : most;

    return flank ? solve_ratio(view->cell, way, flank) : 0;
}

/* Returns the centre of the grid, in whole cells.  The grid lies ahead of the eye; the
 * eye is a tenth of the middle away from the rear edge. */
static tp_fx grid_centre(tp_fx eye, tp_q30 ahead, uint32_t count, const tp_grid_view *view)
{
    if (!view->follow)
        return 0;
    int64_t core = (int64_t)view->cell * (count - 2 * (count / 8)) * 2 / 5;
    int64_t centre = eye + (core * ahead >> 30);
    int64_t cells = centre / view->cell;
    return (tp_fx)(cells * view->cell);
}

static tp_fx axis_centre(uint32_t count, const tp_grid_view *view, bool along_z)
{
    const tp_projection *projection = view->projection;
    return along_z ? grid_centre(projection->eye.z, projection->ahead.z, count, view)
                   : grid_centre(projection->eye.x, projection->ahead.x, count, view);
}

void tp_grid_lines_place(tp_grid_line *line, uint32_t count, const tp_grid_view *view,
                         bool along_z)
{
    uint32_t flank = tp_grid_lines_skirt_count(count, view);
    uint32_t core = count - 2 * flank, last = flank + core - 1;
    tp_fx centre = axis_centre(count, view, along_z);
    tp_fx half = (tp_fx)((int64_t)view->cell * (core - 1) / 2);
    int64_t ratio = skirt_growth_ratio(count, view), step = view->cell;
    uint32_t fading = flank ? core / 8 + 1 : 0;

    for (uint32_t k = flank; k <= last; k++) {
        uint32_t from_edge = k - flank < last - k ? k - flank : last - k;
        line[k].place = centre - half + (tp_fx)(k - flank) * view->cell;
        line[k].fade = fading == 0 ? TP_FX_ONE
                     : tp_smoothstep((tp_fx)((from_edge << 16) / fading));
    }
    for (uint32_t k = 1; k <= flank; k++) {
        step = step * ratio >> 16;
        line[last + k].place = line[last + k - 1].place + (tp_fx)step;
        line[flank - k].place = line[flank - k + 1].place - (tp_fx)step;
        line[last + k].fade = line[flank - k].fade = 0;
    }
}

tp_grid_extent tp_grid_lines_extent(uint32_t count, const tp_grid_view *view, bool along_z)
{
    uint32_t flank = tp_grid_lines_skirt_count(count, view), core = count - 2 * flank;
    tp_fx centre = axis_centre(count, view, along_z);
    tp_fx half = (tp_fx)((int64_t)view->cell * (core - 1) / 2);
    tp_fx low = centre - half, high = low + (tp_fx)(core - 1) * view->cell;
    int64_t ratio = skirt_growth_ratio(count, view), step = view->cell;
    tp_grid_extent extent = {
        low, high, { low, high }, flank ? view->cell * (tp_fx)(core / 8 + 1) : 0,
    };

    for (uint32_t k = 0; k < flank; k++) {
        step = step * ratio >> 16;
        extent.first -= (tp_fx)step;
        extent.last += (tp_fx)step;
    }
    return extent;
}

tp_fx tp_grid_extent_wave_weight(const tp_grid_extent *extent, tp_fx place)
{
    TP_ASSERT(extent->fading >= 0);
    int64_t low = (int64_t)place - extent->calm[0];
    int64_t high = (int64_t)extent->calm[1] - place;
    int64_t from_edge = low < high ? low : high;

    if (extent->fading == 0 || from_edge >= extent->fading)
        return TP_FX_ONE;
    return from_edge <= 0 ? 0 : tp_smoothstep(tp_fx_div((tp_fx)from_edge, extent->fading));
}
