/* SPDX-License-Identifier: MIT */
/* Clear water: from above, floor, walls and objects are visible through the surface. */
#include "features/underwater/underwater.h"
#include "frame/frame.h"

bool tp_clear_water_enabled(const tp_want *want)
{
    return want->scene->water.clear > 0 && want->above & TP_MODULE_UNDERWATER;
}

/* Sets the cost traits.  A ray's cost depends on its target: a box, a map or a plane. */
static void set_cost_traits(const tp_want *want, uint8_t trait[TP_TRAIT_COUNT])
{
    const tp_scene *scene = want->scene;
    const bool tank = tp_has_tank(scene) && want->above & TP_MODULE_WALLS;
    const bool floor = !tank && tp_has_floor(scene);
    const bool chart = floor && want->assets && want->assets->floor;

    trait[TP_TRAIT_tank] = tank;
    trait[TP_TRAIT_chart] = chart;
    trait[TP_TRAIT_bed] = floor && !chart;
    trait[TP_TRAIT_dispersion] = scene->water.dispersion > 0;
}

static void *layout(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, 1, sizeof(tp_clear_water));
}

/* Clears the map.  The refraction module, if on, draws its map later. */
static void begin(tp_frame *frame, void *mine)
{
    tp_clear_water *clear = mine;

    (void)frame;
    clear->refraction_map = NULL;
}

/* Adds the stage.  It reads the view vectors and mixes with the lit colour. */
static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    const bool dispersed = frame->scene->water.dispersion > 0;

    if (list->kind == TP_LIST_WATER && tp_shaders_has(list, TP_AT_VIEW))
        tp_shaders_add(list, TP_AT_REFRACT, stage[list->rippled + 2 * dispersed], mine);
}

const tp_module tp_clear_water_module = {
    .name = "clear water", .id = TP_CLEAR_WATER_ID,
    .is = TP_MODULE_EXACT, .trait = TP_TRAIT_behind,
    .enabled = tp_clear_water_enabled, .count = set_cost_traits,
};

const tp_drawing tp_clear_water_drawing = {
    .layout = layout, .begin = begin, .stages = add_stage,
};
