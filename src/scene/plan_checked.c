/* SPDX-License-Identifier: MIT */
/* The plan as programs ask for it: checked, and by the measured prices.  Frames ask
 * rungs.c, as tp_frame_init has checked their scene. */
#include "scene/parts.h"
#include "scene/prices.h"

/* Every scene can be drawn by these. */
static const tp_rungs exact = {
    TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL, TP_LOD_OFF
};

static bool can_plan(const tp_scene *scene, uint32_t width, uint32_t height)
{
    return width >= TP_PICTURE_SIDE_MIN && width <= TP_PICTURE_SIDE_MAX
        && height >= TP_PICTURE_SIDE_MIN && height <= TP_PICTURE_SIDE_MAX
        && tp_scene_check(scene, NULL) == TP_OK;
}

static const tp_assets *given(const tp_assets *assets)
{
    static const tp_assets none;

    return assets != NULL ? assets : &none;
}

tp_rungs tp_rungs_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                     uint32_t height)
{
    return !can_plan(scene, width, height) ? exact
         : tp_rungs_by(&tp_prices_measured, tp_kit_all.modules, scene, given(assets),
                       width, height);
}

tp_plan_report tp_plan_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                          uint32_t height)
{
    return !can_plan(scene, width, height) ? (tp_plan_report){ .rungs = exact }
         : tp_plan_by(&tp_prices_measured, tp_kit_all.modules, scene, given(assets),
                      width, height);
}

tp_ladder tp_ladder_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                       uint32_t height)
{
    return !can_plan(scene, width, height) ? (tp_ladder){ .rung = { exact }, .count = 1 }
         : tp_ladder_by(&tp_prices_measured, tp_kit_all.modules, scene, given(assets),
                        width, height);
}
