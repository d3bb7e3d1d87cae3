/* SPDX-License-Identifier: MIT */
/* The conditions of a plan: see the header. */
#include "quality/conditions.h"
#include "base/base.h"

tp_plan_conditions tp_plan_conditions_make(const tp_prices *prices, const tp_plan_input *in)
{
    TP_ASSERT(in->width > 0 && in->height > 0);
    tp_plan_conditions g = { .prices = prices, .estimate = tp_view_estimate_make(in) };

    tp_wave_cull_limits limits = tp_wave_cull_limits_make(in->scene, g.estimate.waves,
                                                          prices->slope_colour);
    limits.focal = g.estimate.focal;
    limits.near = g.estimate.near;
    g.culled = tp_wave_cull_evaluate(in->scene, &limits, prices->slope_colour);
    return g;
}

bool tp_plan_culls_waves(const tp_plan_input *in)
{
    const tp_plan_conditions g = tp_plan_conditions_make(&tp_prices_measured, in);
    return g.culled.any && !g.estimate.coastal;
}
