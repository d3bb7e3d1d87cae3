/* SPDX-License-Identifier: MIT */
/* The quality plan: checks the scene and chooses by the measured prices. */
#include "quality/plan.h"
#include "base/base.h"
#include "world/module.h"

#define DRAWN_KINDS ~(1u << TP_KIND_mesh)

static bool can_plan(const tp_plan_input *in)
{
    return in->width >= TP_PICTURE_SIDE_MIN && in->width <= TP_PICTURE_SIDE_MAX
        && in->height >= TP_PICTURE_SIDE_MIN && in->height <= TP_PICTURE_SIDE_MAX
        && tp_scene_check(in->scene, NULL) == TP_OK;
}

bool tp_plan_view(tp_view_costs *view, const tp_scene *scene, const tp_assets *assets,
                  uint32_t width, uint32_t height)
{
    static const tp_assets none;
    const tp_plan_input in = { tp_program_all.modules, scene, assets ? assets : &none, width,
                               height };

    if (!can_plan(&in)) {
        *view = (tp_view_costs){ .water = 0 };
        return false;
    }
    tp_view_costs_make(view, &tp_prices_measured, &in);
    return true;
}

/* Returns the budget of mean square error, Q16: omitted waves have their share. */
static uint64_t square_budget(const tp_scene *scene, const tp_view_costs *view)
{
    const int64_t all = scene->quality.error_colour, waves = view->culled.colour;
    const int64_t square = all * all - waves * waves;

    return square > 0 ? (uint64_t)square >> 16 : 0;
}

tp_plan tp_plan_make(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                     uint32_t height)
{
    tp_plan plan = { .open = 0 };
    tp_view_costs view;

    if (!tp_plan_view(&view, scene, assets, width, height))
        return plan;
    plan.set = tp_rung_set_named(scene, false, &plan.open);
    plan.open &= DRAWN_KINDS;
    tp_set_choose(&view, &plan.set, plan.open, square_budget(scene, &view));
    plan.price = tp_set_price_estimate(&view, &plan.set);
    return plan;
}
