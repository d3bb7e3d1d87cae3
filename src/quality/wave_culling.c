/* SPDX-License-Identifier: MIT */
/* Wave culling: omits waves with no visible effect.  A wave is visible by its height,
 * against the sky or another crest, and by its slope, because the slope turns the
 * reflection.  If both effects are below their share of the error budget, the wave is
 * omitted and each vertex costs less.  Waves of different lengths are independent: the
 * squares of their errors add up, so each wave gets the share divided by the square root
 * of the number of waves. */
#include "base/base.h"
#include "quality/prices.h"
#include "view/projection.h"

#define TWO_PI_Q16 411775

tp_wave_cull_limits tp_wave_cull_limits_make(const tp_scene *scene, uint32_t waves,
                                             tp_fx slope_colour)
{
    const tp_fx root = tp_fx_sqrt((tp_fx)(waves > 0 ? waves : 1) * TP_FX_ONE);
    const tp_fx colour = tp_fx_div(scene->quality.error_colour / TP_WAVE_CULL_SHARE, root);
    tp_wave_cull_limits limits = {
        .px = tp_fx_div(scene->quality.error_px / TP_WAVE_CULL_SHARE, root),
        .focal = 1, .near = TP_FX_ONE,
    };

    if (slope_colour > 0)                   /* rms of a sine = amplitude / sqrt(2) */
        limits.slope = tp_fx_div((tp_fx)((int64_t)colour * 92682 >> 16), slope_colour);
    return limits;
}

/* A camera at or below the crests gets 1 LSB, the smallest distance.  If the point
 * straight below the camera is in view, the distance is the height.  The point straight
 * below is in view if its angle to the view axis is below half of the field of view. */
tp_fx tp_nearest_water_distance(tp_fx height, const tp_rotation *turn, tp_fx fov)
{
    const tp_dir3 half = tp_rotation_from_angles(tp_turn_of_degrees(fov) / 2, 0, 0).x;
    const tp_q30 down = tp_q30_mul(turn->z.y, half.x) + tp_q30_mul(turn->y.y, half.z);

    if (height <= 0)
        return 1;
    if ((int64_t)tp_abs(turn->y.y) * half.x <= (int64_t)turn->z.y * half.z)
        return height;
    if (down <= 0)
        return TP_FX_MAX;
    return tp_fx_saturate(((int64_t)height * (1 << 30)) / down);
}

static int64_t amplitude_px(const tp_wave_cull_limits *limits, tp_fx amplitude)
{
    return tp_length_px(amplitude, limits->focal, limits->near);
}

tp_fx tp_wave_cull_weight(const tp_wave_cull_limits *limits, tp_fx amplitude, tp_fx slope)
{
    if (limits->px <= 0 || limits->slope <= 0)
        return TP_FX_ONE;
    const tp_fx high = tp_fade_in_share(amplitude_px(limits, amplitude), limits->px);
    const tp_fx steep = tp_fade_in_share(slope, limits->slope);
    return high > steep ? high : steep;
}

tp_wave_cull tp_wave_cull_evaluate(const tp_scene *scene, const tp_wave_cull_limits *limits,
                                   tp_fx slope_colour)
{
    tp_wave_cull culled = { .left = 0 };
    uint64_t px = 0, slopes = 0;

    for (int i = 0; i < TP_WAVES; i++) {
        const tp_wave *w = &scene->wave[i];
        if (w->amplitude <= 0 || w->length <= 0)
            continue;
        const tp_fx slope = tp_fx_saturate((int64_t)w->amplitude * TWO_PI_Q16 / w->length);
        const tp_fx weight = tp_wave_cull_weight(limits, w->amplitude, slope);
        culled.left += weight > 0;
        culled.any = culled.any || weight < TP_FX_ONE;
        if (weight == TP_FX_ONE)
            continue;
        const uint64_t p =
            (uint64_t)(amplitude_px(limits, w->amplitude) * (TP_FX_ONE - weight));
        const uint64_t s = (uint64_t)slope * (uint64_t)(TP_FX_ONE - weight);
        px += (p >> 16) * (p >> 16);
        slopes += (s >> 16) * (s >> 16);
    }
    culled.px = (tp_fx)tp_isqrt64(px);
    culled.colour = (tp_fx)((int64_t)tp_isqrt64(slopes / 2) * slope_colour >> 16);
    return culled;
}

/* Scales a swell's height. Each listed field is linear in the height at constant Q. */
static tp_swell scale_swell_height(const tp_swell *swell, tp_fx weight)
{
    tp_swell w = *swell;
    int32_t *const part[] = { &w.amplitude, &w.orbit_x, &w.orbit_z, &w.slope_x,
                              &w.slope_z, &w.bend_xx, &w.bend_xz, &w.bend_zz, &w.bend,
                              &w.tilt };

    for (int i = 0; weight < TP_FX_ONE && i < 10; i++)
        *part[i] = tp_fx_mul(*part[i], weight);
    return w;
}

bool tp_wave_cull_deep_water(tp_deep_water *culled, tp_turn culled_phases[TP_WAVES],
                             const tp_deep_water *whole, const tp_turn phases[TP_WAVES],
                             const tp_wave_cull_limits *limits)
{
    TP_ASSERT(whole->count <= TP_WAVES);
    tp_fx weight[TP_WAVES];
    bool  any = false;

    for (uint32_t i = 0; i < whole->count; i++) {
        const tp_swell *w = &whole->swell[i];
        weight[i] = tp_wave_cull_weight(limits, w->amplitude, w->tilt);
        any = any || weight[i] < TP_FX_ONE;
    }
    if (!any)
        return false;
    *culled = *whole;
    culled->count = 0;
    for (uint32_t i = 0; i < whole->count; i++) {
        if (weight[i] == 0)
            continue;
        culled->swell[culled->count] = scale_swell_height(&whole->swell[i], weight[i]);
        culled_phases[culled->count++] = phases[i];
    }
    for (uint32_t i = culled->count; i < TP_WAVES; i++) {
        culled->swell[i] = (tp_swell){ .power = 0 };
        culled_phases[i] = 0;
    }
    return true;
}

tp_wave_cull tp_plan_wave_cull(const tp_scene *scene, const tp_view_estimate *estimate,
                               const tp_prices *prices)
{
    tp_wave_cull_limits limits =
        tp_wave_cull_limits_make(scene, estimate->waves, prices->slope_colour);

    limits.focal = estimate->focal;
    limits.near = estimate->near;
    return tp_wave_cull_evaluate(scene, &limits, prices->slope_colour);
}

bool tp_plan_culls_waves(const tp_plan_input *in)
{
    const tp_view_estimate estimate = tp_view_estimate_make(in);

    return !estimate.coastal
        && tp_plan_wave_cull(in->scene, &estimate, &tp_prices_measured).any;
}
