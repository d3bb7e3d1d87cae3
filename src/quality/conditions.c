/* SPDX-License-Identifier: MIT */
/* The conditions of a plan: see the header. */
#include "quality/conditions.h"
#include "base/base.h"
#include "world/pools.h"

const uint8_t tp_plan_kind_counts[TP_KINDS] = { TP_VISIBILITIES, TP_SHADINGS, TP_RATES };

/* -- prices that apply --------------------------------------------------------------- */

bool tp_plan_is_fit(const tp_plan_conditions *g, int kind, int rung)
{
    return kind == TP_KIND_VISIBILITY ? g->estimate.fits[rung] != 0
         : kind != TP_KIND_SHADING || rung == 0 || g->estimate.quick;
}

tp_error_price tp_plan_rung_error(const tp_plan_conditions *g, int kind, int rung)
{
    const int drawn = tp_plan_is_fit(g, kind, rung) ? rung : 0;

    return g->prices->error[kind][drawn][g->estimate.sea];
}

int tp_plan_drawn_method(const tp_plan_conditions *g, tp_plan_choice c)
{
    const int v = c.of[TP_KIND_VISIBILITY];
    return tp_plan_is_fit(g, TP_KIND_VISIBILITY, v) ? v : 0;
}

const tp_seen_price *tp_plan_seen_price(const tp_plan_conditions *g, tp_plan_choice c)
{
    return &g->prices->seen[tp_plan_drawn_method(g, c)];
}

const tp_shaded_price *tp_plan_shaded_price(const tp_plan_conditions *g, tp_plan_choice c)
{
    const int s = c.of[TP_KIND_SHADING];
    const int drawn = tp_plan_is_fit(g, TP_KIND_SHADING, s) ? s : 0;
    const tp_shaded_price *shaded = g->prices->shaded[drawn];
    return &shaded[shaded[c.of[TP_KIND_RATE]].known ? c.of[TP_KIND_RATE] : 0];
}

int64_t tp_plan_point_price(const tp_plan_conditions *g, const tp_seen_price *seen)
{
    const tp_view_estimate *o = &g->estimate;
    const int64_t wave = (int64_t)seen->wave + (o->sharp ? seen->sharp : 0);
    const tp_fx   coastal = o->floor > 1 ? seen->map
                          : o->floor     ? seen->floor : seen->coastal;

    return seen->vertex + wave * g->faint.left + (int64_t)seen->pool * o->pools
         + (o->coastal ? coastal : 0);
}

/* -- the conditions ------------------------------------------------------------------ */

/* Returns the named rung, or -1. A number out of range counts as open. */
static int8_t named_rung(int32_t rung, int kind)
{
    if (kind == TP_KIND_VISIBILITY && rung == TP_VISIBILITY_WALK)
        return TP_VISIBILITY_TRIANGLES - 1;
    return rung > 0 && rung <= tp_plan_kind_counts[kind] ? (int8_t)(rung - 1) : -1;
}

tp_plan_conditions tp_plan_conditions_make(const tp_prices *prices, const tp_plan_input *in)
{
    TP_ASSERT(in->width > 0 && in->height > 0);
    const tp_scene *scene = in->scene;
    const int32_t asked[TP_KINDS] = { scene->quality.visibility, scene->quality.shading,
                                      scene->quality.rate };
    tp_plan_conditions g = { .prices = prices, .estimate = tp_view_estimate_make(in) };

    tp_wave_cull_limits limits = tp_wave_cull_limits_make(scene, g.estimate.waves,
                                                prices->slope_colour);
    limits.focal = g.estimate.focal;
    limits.near = g.estimate.near;
    g.faint = tp_wave_cull_evaluate(scene, &limits, prices->slope_colour);
    g.left_px = scene->quality.error_px - scene->quality.error_px / TP_WAVE_CULL_SHARE;
    g.left_colour = scene->quality.error_colour
                  - scene->quality.error_colour / TP_WAVE_CULL_SHARE;
    for (int k = 0; k < TP_KINDS; k++) {
        g.named[k] = named_rung(asked[k], k);
        if (g.named[k] >= 0) {
            g.left_px -= tp_plan_rung_error(&g, k, g.named[k]).px;
            g.left_colour -= tp_plan_rung_error(&g, k, g.named[k]).colour;
        }
    }
    g.left_px = g.left_px > 0 ? g.left_px : 0;
    g.left_colour = g.left_colour > 0 ? g.left_colour : 0;
    return g;
}
