/* SPDX-License-Identifier: MIT */
/* The module of coastal water: swells that react to a floor or a wind.  Its state is the
 * tables of waves/coastal_water.h, made from the world's deep water, or the place of baked
 * tables.  The tables follow from the scene; no tick changes them. */
#include "base/base.h"
#include "view/wave_models.h"
#include "waves/coastal_tables.h"
#include "world/module.h"
#include "world/pools.h"

static tp_coastal_config make_coastal_config(const tp_scene *scene, const tp_assets *assets)
{
    return (tp_coastal_config){
        .floor = {
            .depth = scene->floor.depth, .slope = scene->floor.slope,
            .heading = scene->floor.heading, .map = assets ? assets->floor : NULL,
            .map_x = scene->floor.map_x, .map_z = scene->floor.map_z,
            .map_size = scene->floor.map_size, .map_low = scene->floor.map_low,
            .map_high = scene->floor.map_high,
        },
        .wind = scene->wind.strength, .wind_heading = scene->wind.heading,
        .k0 = scene->surf.tilt_decay, .kx = scene->surf.widening_decay,
        .ky = scene->surf.flattening_decay,
        .stretch = scene->surf.stretch, .irregular = scene->surf.irregular,
    };
}

bool tp_coastal_enabled(const tp_module_conditions *conditions)
{
    const tp_wave_models *water = conditions->water;

    return (tp_has_floor(conditions->scene) || conditions->scene->wind.strength > 0)
           && (!water || (water->coastal && water->swells));
}

/* Returns the size of the state; 0: the floor's map cannot be used. */
static size_t bytes(const tp_module_conditions *conditions)
{
    const tp_scene *scene = conditions->scene;
    const tp_assets *assets = conditions->assets;
    const tp_coastal_config config = make_coastal_config(scene, assets);
    tp_deep_water deep;

    tp_deep_water_init(&deep, scene->wave, TP_WAVES, scene->water.gravity);
    if (assets && assets->coastal
        && tp_coastal_is_current(assets->coastal, &config, &deep, scene->wave, TP_WAVES))
        return sizeof(tp_coastal_baked);
    return tp_coastal_bytes(&config, &deep);
}

static bool is_baked(const void *mine)
{
    return tp_coastal_state_tables(mine) != mine;
}

static tp_status check(const tp_module_conditions *conditions, tp_error *err)
{
    return bytes(conditions) > 0
         ? TP_OK : tp_error_add_word(err, TP_FAIL(err, TP_E_ARG, 0, 0, 0), "floor.map");
}

static tp_status init(void *mine, tp_world *world, const tp_module_conditions *conditions,
                      tp_error *err)
{
    const tp_coastal_config config =
        make_coastal_config(conditions->scene, conditions->assets);
    if (is_baked(mine)) {
        *(tp_coastal_baked *)mine = (tp_coastal_baked){ conditions->assets->coastal };
        return TP_OK;
    }
    return tp_coastal_init(mine, &config, &world->deep, conditions->scene->wave, TP_WAVES,
                           err);
}

/* Recomputes the tables whose inputs have changed; baked tables fit the scene. */
static bool refresh(void *mine, tp_world *world, const tp_module_conditions *conditions)
{
    const tp_coastal_config config =
        make_coastal_config(conditions->scene, conditions->assets);
    return is_baked(mine)
           || tp_coastal_refresh(mine, &config, &world->deep, conditions->scene->wave,
                                 TP_WAVES, NULL)
                  == TP_OK;
}

static bool is_valid(const void *mine, const void *fresh, const tp_world *world)
{
    (void)world;
    return memcmp(mine, fresh, tp_module_state_bytes(fresh)) == 0;
}

static void add_surface(const void *mine, tp_surface *to)
{
    to->coastal = to->by->coastal && to->by->swells ? tp_coastal_state_tables(mine) : NULL;
}

const tp_module tp_coastal_module = {
    .name = "coastal", .id = TP_COASTAL_ID, .is = TP_MODULE_COASTAL,
    .enabled = tp_coastal_enabled,
    .check = check,
    .bytes = bytes,
    .init = init,
    .refresh = refresh,
    .surface = add_surface,
    .is_valid = is_valid,
};
