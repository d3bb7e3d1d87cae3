/* SPDX-License-Identifier: MIT */
/* The conditions of a plan: see the header. */
#include "quality/conditions.h"
#include "base/base.h"

int64_t tp_plan_point_price(const tp_plan_conditions *g, const tp_seen_price *seen)
{
    const tp_view_estimate *o = &g->estimate;
    const int64_t wave = (int64_t)seen->wave + (o->sharp ? seen->sharp : 0);
    const tp_fx   coastal = o->floor > 1 ? seen->map
                          : o->floor     ? seen->floor : seen->coastal;

    return seen->vertex + wave * g->culled.left + (int64_t)seen->pool * o->pools
         + (o->coastal ? coastal : 0);
}

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
