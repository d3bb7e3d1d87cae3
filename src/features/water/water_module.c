/* SPDX-License-Identifier: MIT */
/* The water's modules: their conditions, and their cost traits for the plan's estimate. */
#include "features/water/water.h"
#include "shade/env.h"
#include "world/pools.h"

/* -- layers -------------------------------------------------------------------------- */

/* True if layer k was loaded, or baked for fast shading. */
static bool has_layer(const tp_module_conditions *conditions, int k)
{
    return conditions->assets
           && (conditions->assets->layer[k] || conditions->assets->baked_layer[k]);
}

static uint8_t added_layer_count(const tp_module_conditions *conditions)
{
    return (uint8_t)(has_layer(conditions, 1) + has_layer(conditions, 2));
}

/* True if a distortion moves a layer; without any layer the distortion is off. */
static bool bends_layers(const tp_module_conditions *conditions)
{
    return conditions->assets
           && (conditions->assets->distortion || conditions->assets->baked_offset)
           && conditions->scene->distortion.strength > 0
           && (has_layer(conditions, 0) || added_layer_count(conditions) > 0);
}

static bool is_linear(const tp_module_conditions *conditions)
{
    return conditions->scene->water.filter == TP_FILTER_LINEAR;
}

bool tp_base_layer_enabled(const tp_module_conditions *conditions)
{
    return has_layer(conditions, 0);
}

static void set_base_layer_traits(const tp_module_conditions *conditions,
                                  uint8_t trait[TP_TRAIT_COUNT])
{
    trait[TP_TRAIT_texture] = 1;
    trait[TP_TRAIT_linear] = is_linear(conditions);
}

bool tp_layers_enabled(const tp_module_conditions *conditions)
{
    return added_layer_count(conditions) > 0 || bends_layers(conditions);
}

static void set_layer_traits(const tp_module_conditions *conditions,
                             uint8_t trait[TP_TRAIT_COUNT])
{
    trait[TP_TRAIT_bend] = bends_layers(conditions);
    trait[is_linear(conditions) ? TP_TRAIT_lined : TP_TRAIT_layer] =
        added_layer_count(conditions);
}

/* -- slopes -------------------------------------------------------------------------- */

static uint8_t pool_bump_count(const tp_module_conditions *conditions)
{
    const tp_scene *scene = conditions->scene;

    return scene->water.pool_normal_strength > 0
               ? (uint8_t)((scene->pool.cols > 0) + (scene->field.cols > 0)) : 0;
}

bool tp_bumps_enabled(const tp_module_conditions *conditions)
{
    return pool_bump_count(conditions) > 0;
}

static void set_bump_traits(const tp_module_conditions *conditions,
                            uint8_t trait[TP_TRAIT_COUNT])
{
    trait[TP_TRAIT_bump] = pool_bump_count(conditions);
}

bool tp_ripple_enabled(const tp_module_conditions *conditions)
{
    return conditions->assets
           && (conditions->assets->ripple || conditions->assets->baked_slope)
           && conditions->scene->ripple.bump > 0;
}

/* -- light --------------------------------------------------------------------------- */

/* True for water with glitter, reflection or clarity, whose look depends on the view. */
bool tp_lighting_enabled(const tp_module_conditions *conditions)
{
    const tp_scene *scene = conditions->scene;

    return scene->water.specular > 0 || scene->water.reflection > 0
        || scene->water.clarity > 0;
}

static void set_lighting_traits(const tp_module_conditions *conditions,
                                uint8_t trait[TP_TRAIT_COUNT])
{
    trait[TP_TRAIT_rough] = conditions->scene->water.rough != 0;
}

/* True if diffuse light has an effect: light with full ambient share changes no colour. */
bool tp_diffuse_enabled(const tp_module_conditions *conditions)
{
    return !(conditions->above & TP_MODULE_LIGHT)
           && conditions->scene->light.ambient < TP_FX_ONE;
}

bool tp_glint_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->water.specular > 0;
}

/* True if the sky is reflected, or for Schlick's law, whose table the module sets.  The
 * exact law needs no module. */
bool tp_reflectance_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->water.reflection > 0
           || conditions->scene->water.fresnel == TP_FRESNEL_SCHLICK;
}

static void set_reflectance_traits(const tp_module_conditions *conditions,
                                   uint8_t trait[TP_TRAIT_COUNT])
{
    trait[TP_TRAIT_mirror] = conditions->scene->water.reflection > 0;
}

/* -- fast shading -------------------------------------------------------------------- */

/* True if no module needs exact stages.  The exact view into clear water is one. */
static bool has_fast_stages(const tp_module_conditions *conditions)
{
    return !(conditions->above & TP_MODULE_EXACT)
           && (!(conditions->above & TP_MODULE_CLEAR)
               || conditions->scene->quality.refraction == TP_RUNG_FAST);
}

/* True if fast shading can draw the water, and the frame may use it. */
bool tp_fast_water_enabled(const tp_module_conditions *conditions)
{
    return (conditions->shadings >> TP_SHADING_QUICK & 1) && has_fast_stages(conditions);
}

/* -- the modules --------------------------------------------------------------------- */

const tp_module tp_bumps_module = {
    .name = "bumps", .id = TP_BUMPS_ID,
    .is = TP_MODULE_SLOPES,
    .enabled = tp_bumps_enabled, .count = set_bump_traits,
};

const tp_module tp_base_layer_module = {
    .name = "base layer", .id = TP_MODULE_ID('b', 'a', 's', 'e'),
    .enabled = tp_base_layer_enabled, .count = set_base_layer_traits,
};

const tp_module tp_layers_module = {
    .name = "layers", .id = TP_MODULE_ID('l', 'a', 'y', 'r'),
    .enabled = tp_layers_enabled,
    .count = set_layer_traits,
};

const tp_module tp_ripple_module = {
    .name = "ripple", .id = TP_RIPPLE_ID, .trait = TP_TRAIT_ripple,
    .enabled = tp_ripple_enabled,
};

const tp_module tp_lighting_module = {
    .name = "lighting", .id = TP_MODULE_ID('l', 'i', 'g', 't'), .is = TP_MODULE_LIGHT,
    .trait = TP_TRAIT_look, .enabled = tp_lighting_enabled,
    .count = set_lighting_traits,
};

const tp_module tp_diffuse_module = {
    .name = "diffuse", .id = TP_MODULE_ID('d', 'i', 'f', 'f'), .trait = TP_TRAIT_diffuse,
    .enabled = tp_diffuse_enabled,
};

const tp_module tp_reflectance_module = {
    .name = "reflectance", .id = TP_MODULE_ID('r', 'f', 'l', 'c'),
    .enabled = tp_reflectance_enabled, .count = set_reflectance_traits,
};

const tp_module tp_glint_module = {
    .name = "glint", .id = TP_MODULE_ID('g', 'l', 'n', 't'), .trait = TP_TRAIT_glint,
    .enabled = tp_glint_enabled,
};

const tp_module tp_fast_water_module = {
    .name = "fast water", .id = TP_MODULE_ID('f', 'a', 's', 't'), .is = TP_MODULE_FAST,
    .enabled = tp_fast_water_enabled,
};
