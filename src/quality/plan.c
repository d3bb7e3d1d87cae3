/* SPDX-License-Identifier: MIT */
/* The quality plan for callers of the library: checks the scene and uses the measured
 * costs.  Frames call rungs.c directly, because tp_frame_init has already checked their
 * scene. */
#include "quality/prices.h"
#include "world/module.h"

/* The exact rungs can draw every scene. */
static const tp_rungs exact = {
    TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL
};

static bool can_plan(const tp_plan_input *in)
{
    return in->width >= TP_PICTURE_SIDE_MIN && in->width <= TP_PICTURE_SIDE_MAX
        && in->height >= TP_PICTURE_SIDE_MIN && in->height <= TP_PICTURE_SIDE_MAX
        && tp_scene_check(in->scene, NULL) == TP_OK;
}

/* Returns the input of a plan with the modules of tp_program_all; NULL assets: none. */
static tp_plan_input make_input(const tp_scene *scene, const tp_assets *assets,
                                uint32_t width, uint32_t height)
{
    static const tp_assets none;

    return (tp_plan_input){ tp_program_all.modules, scene, assets ? assets : &none, width,
                            height };
}

tp_rungs tp_rungs_choose(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                         uint32_t height)
{
    const tp_plan_input in = make_input(scene, assets, width, height);

    return can_plan(&in) ? tp_rungs_choose_priced(&tp_prices_measured, &in) : exact;
}

tp_plan_report tp_plan_make(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                            uint32_t height)
{
    const tp_plan_input in = make_input(scene, assets, width, height);

    return can_plan(&in) ? tp_plan_make_priced(&tp_prices_measured, &in)
                         : (tp_plan_report){ .rungs = exact };
}

tp_ladder tp_ladder_make(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                         uint32_t height)
{
    const tp_plan_input in = make_input(scene, assets, width, height);

    return can_plan(&in) ? tp_ladder_make_priced(&tp_prices_measured, &in)
                         : (tp_ladder){ .rung = { exact }, .count = 1 };
}
