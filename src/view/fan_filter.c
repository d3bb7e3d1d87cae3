/* SPDX-License-Identifier: MIT */
/* The filter of a fan's rows: the weight by which a row keeps a wave, and the slope variance
 * that the row does not show. */
#include "view/fan.h"
#include "waves/deep_water.h"

/* Returns the wavelengths in a spacing, 16.16. */
static int64_t spacing_share(tp_fx spacing, int64_t turns)
{
    return ((turns < 0 ? -turns : turns) >> 8) * spacing >> 24;
}

tp_fx tp_fan_wave_weight(tp_fx spacing, int64_t turns)
{
    const int64_t share = spacing_share(spacing, turns);
    const tp_fx weight = tp_swell_spacing_weight(share);

    return weight == 0 ? 0 : tp_fx_mul(weight, tp_swell_spacing_gain(share));
}

tp_coastal_spacing tp_fan_row_spacing(const tp_fan *fan, const tp_fan_row *row,
                                      const tp_deep_water *deep)
{
    const int64_t rx = fan->law.right.x >> 14, rz = fan->law.right.z >> 14;
    tp_coastal_spacing to;

    for (uint32_t i = 0; i < deep->count; i++) {
        const int64_t x = deep->swell[i].turns_x, z = deep->swell[i].turns_z;
        to.along[i] = tp_fx_saturate(spacing_share(row->along, (x * rz - z * rx) >> 16));
        to.across[i] = tp_fx_saturate(spacing_share(row->across, (x * rx + z * rz) >> 16));
    }
    return to;
}

tp_fx tp_fan_row_weight(const tp_fan *fan, const tp_fan_row *row, const tp_swell *swell)
{
    const int64_t rx = fan->law.right.x >> 14, rz = fan->law.right.z >> 14;
    const int64_t x = swell->turns_x, z = swell->turns_z;
    const tp_fx along = tp_fan_wave_weight(row->along, (x * rz - z * rx) >> 16);

    return along == 0 ? 0 : tp_fx_mul(along, tp_fan_wave_weight(row->across,
                                                                (x * rx + z * rz) >> 16));
}

tp_fx tp_fan_row_detail_weight(const tp_fan *fan, const tp_fan_row *row)
{
    if (fan->detail == 0)
        return TP_FX_ONE;
    const int64_t share = TP_FX_ONE;
    const int64_t along = tp_quotient(row->along * share, fan->detail);
    const int64_t across = tp_quotient(row->across * share, fan->detail);

    return tp_fx_mul(tp_swell_spacing_weight(along), tp_swell_spacing_weight(across));
}

/* Returns the share of a wave's mean square, Q16, that linear interpolation over a spacing
 * keeps: (2 + cos k d) / 3.  share: wavelengths in the spacing, 16.16, at most 1/2 where a
 * row keeps the wave. */
static int64_t interpolation_share(int64_t share)
{
    const tp_q30 c = tp_cos((tp_turn)((uint64_t)share << 16));
    return ((((int64_t)2 << 30) + c) / 3 + (1 << 13)) >> 14;
}

/* Returns the share of a wave's mean square, Q16, that a row's interpolation keeps. */
static uint64_t row_interpolation_share(const tp_fan *fan, const tp_fan_row *row,
                                        const tp_swell *swell)
{
    const int64_t rx = fan->law.right.x >> 14, rz = fan->law.right.z >> 14;
    const int64_t x = swell->turns_x, z = swell->turns_z;
    const int64_t along =
        interpolation_share(spacing_share(row->along, (x * rz - z * rx) >> 16));

    return (uint64_t)(along * interpolation_share(spacing_share(row->across,
                                                   (x * rx + z * rz) >> 16)) >> 16);
}

static uint32_t limited(uint64_t variance)
{
    return variance < TP_ROUGH_ONE ? (uint32_t)variance : TP_ROUGH_ONE;
}

tp_slope_variance tp_fan_row_variance(const tp_grid *grid, const tp_fan_row *row,
                                      tp_fx unseen)
{
    const tp_fan *fan = grid->fan;
    const tp_surface *surface = grid->surface;
    const tp_fx least = tp_fan_row_least(grid, row);
    const int64_t rx = fan->law.right.x >> 14, rz = fan->law.right.z >> 14;
    const uint64_t whole = (uint64_t)1 << 32;
    uint64_t along = 0, across = 0, left = 0;

    for (uint32_t i = 0; i < surface->deep->count; i++) {
        const tp_swell *w = &surface->deep->swell[i];
        const uint64_t weight = (uint32_t)tp_fan_row_large_weight(grid, row, least, w);
        const uint64_t share = (uint32_t)tp_fan_share((tp_fx)weight);
        const uint64_t flat = (65536 - row_interpolation_share(fan, row, w))
                            * (uint32_t)unseen >> 16;
        const uint64_t shown = (weight * weight >> 16) * (65536 - flat);    /* Q32 */
        const uint64_t lost = shown < whole ? whole - shown : 0;
        const int64_t a = ((int64_t)w->slope_x * rz - (int64_t)w->slope_z * rx) >> 24;
        const int64_t b = ((int64_t)w->slope_x * rx + (int64_t)w->slope_z * rz) >> 24;
        along += ((uint64_t)(a * a) >> 21) * lost >> 32;        /* half of Q23 */
        across += ((uint64_t)(b * b) >> 21) * lost >> 32;
        left += ((uint64_t)(a * a + b * b) >> 21) * (whole - share * share) >> 32;
    }
    return (tp_slope_variance){ limited(along), limited(across), limited(left) };
}

/* Returns the share of a row's spacing that a pixel covers at a depth, up to 1: a pixel
 * covers depth^2 / (height focal) of level water. */
static tp_fx row_unseen_share(const tp_projection *p, const tp_fan_row *row, int64_t depth)
{
    const int64_t above = p->eye.y > TP_FX_ONE ? p->eye.y : TP_FX_ONE;
    const int64_t far = depth < 8192 * (int64_t)TP_FX_ONE ? depth
                                                          : 8192 * (int64_t)TP_FX_ONE;
    const int64_t area = above * (row->along > 0 ? row->along : 1) >> 16;
    const int64_t share = (far * far >> 16) * TP_FX_ONE
                        / ((area * (p->focal >> 8) >> 8) + 1);

    return share < TP_FX_ONE ? (tp_fx)share : TP_FX_ONE;
}

/* Sets the swells that the variance is filled for; true if a number has changed, or if there
 * is no room for all swells. */
static bool set_filtered_swells(tp_fan *fan, const tp_deep_water *deep)
{
    bool changed = fan->swells != deep->count;

    if (deep->count > fan->most_swells)
        return true;
    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        tp_fan_swell *at = &fan->filtered_for[i];
        changed = changed || at->turns_x != w->turns_x || at->turns_z != w->turns_z
                  || at->slope_x != w->slope_x || at->slope_z != w->slope_z;
        *at = (tp_fan_swell){ w->turns_x, w->turns_z, w->slope_x, w->slope_z };
    }
    fan->swells = deep->count;
    return changed;
}

void tp_fan_fill_variance(const tp_grid *grid, tp_filtered_waves *filtered)
{
    if (!set_filtered_swells(grid->fan, grid->surface->deep) && !grid->fan->moved
        && filtered->has_row)
        return;
    const tp_projection *p = grid->projection;
    const tp_fan *fan = grid->fan;
    const int64_t x = p->ahead.x, y = p->ahead.y, z = p->ahead.z;
    const tp_vec3 eye = p->eye;

    tp_filtered_waves_clear(filtered);
    for (uint32_t j = grid->rows; j-- > 0;) {
        const tp_fan_row *row = &fan->row[j];
        const int32_t half = (int32_t)(grid->cols / 2);
        const int64_t dx = row->x + (int64_t)row->step_x * half - eye.x;
        const int64_t dz = row->z + (int64_t)row->step_z * half - eye.z;
        const int64_t depth = (dx * x - eye.y * y + dz * z) >> 30;
        if (depth <= 0)
            continue;
        const tp_fx unseen = row_unseen_share(p, row, depth);
        tp_filtered_waves_add_row(filtered, tp_fx_saturate(depth),
                                  tp_fan_row_variance(grid, row, unseen));
    }
    tp_filtered_waves_finish(filtered);
}

const struct tp_draw_row_variance tp_draw_row_variance = { tp_fan_fill_variance };
