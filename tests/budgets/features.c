/* SPDX-License-Identifier: MIT */
/* Kits that grow: the least one, which draws level water with one texture and the sky, or
 * with -DFEATURES=n the first n things more that a program may name.  kits.sh links one
 * program for each, and prints how much text that takes. */
#include "features.h"

#ifndef FEATURES
#define FEATURES 0
#endif

static const tp_use modules[] = {
#if FEATURES >= 16
    TP_USE_WITH(sky_dome, tp_stage_sky_dome, NULL, NULL, tp_stage_reflect_dome),
    TP_USE(stars),
    TP_USE_WITH(haze, tp_stage_haze, tp_stage_haze_dome, NULL),
#else
    TP_USE_WITH(haze, tp_stage_haze, NULL, NULL),
#endif
#if FEATURES >= 7
    TP_USE_WITH(boat, tp_stage_solid, NULL),
#endif
#if FEATURES >= 15
    TP_USE(land),
#endif
#if FEATURES >= 12
    TP_USE(drops),
#endif
#if FEATURES >= 15
    TP_USE_UNSEEN(coastal),
#endif
#if FEATURES >= 7
    TP_USE_UNSEEN(hull),
#endif
#if FEATURES >= 11
    TP_USE_UNSEEN(wake),
    TP_USE_UNSEEN(pokes),
    TP_USE_UNSEEN(main_pool),
    TP_USE_UNSEEN(field),
#endif
#if FEATURES >= 13      /* clear water, seen from above and from in it */
    TP_USE(underwater),
#endif
#if FEATURES >= 14      /* tanks, of stone and glass */
    TP_USE(tank),
    TP_USE(glass),
#endif
#if FEATURES >= 17      /* caustics */
    TP_USE(caustics),
#endif
#if FEATURES >= 7
    TP_USE(lids),
#endif
#if FEATURES >= 8
    TP_USE(mirror),
#endif
#if FEATURES >= 13
    TP_USE(refraction), TP_USE(clear_water),
#endif
#if FEATURES >= 9       /* foam */
    TP_USE(foam),
#endif
#if FEATURES >= 10      /* spray */
    TP_USE(spray),
#endif
    { 0 }
};

/* What each adds: designators may stand in any order, and those of one feature together. */
const tp_kit features_kit = {
    .modules = modules,
    .stage.sky = tp_stage_sky,
    .stage.plain = tp_stage_plain,
    .stage.texture = tp_stage_texture,
    .stage.diffuse = tp_stage_diffuse,
    .store[TP_FORMAT_RGB565] = tp_store_rgb565,
    .method.flat = &tp_method_flat,
#if FEATURES >= 1       /* waves, as triangles */
    .method.triangles = &tp_method_triangles,
    .water.swells = &tp_water_swells,
#endif
#if FEATURES >= 2       /* bilinear texels */
    .stage.texture_linear = tp_stage_texture_linear,
    .stage.texture_tinted = tp_stage_texture_tinted,
    .stage.texture_linear_tinted = tp_stage_texture_linear_tinted,
#endif
#if FEATURES >= 3       /* layers, distorted */
    .draw.layers = &tp_draw_layers,
    .stage.bend = tp_stage_bend,
    .stage.layers = tp_stage_layers,
    .stage.layers_linear = tp_stage_layers_linear,
#endif
#if FEATURES >= 4       /* ripples */
    .draw.ripple = &tp_draw_ripple,
    .stage.diffuse_rippled = tp_stage_diffuse_rippled,
    .stage.ripple = tp_stage_ripple,
    .stage.ripple_gentle = tp_stage_ripple_gentle,
#endif
#if FEATURES >= 5       /* light: Phong, glint */
    .draw.glint = &tp_draw_glint,
    .stage.view = tp_stage_view,
    .stage.light = tp_stage_light,
    .stage.light_rippled = tp_stage_light_rippled,
    .stage.glint = tp_stage_glint,
#endif
#if FEATURES >= 6       /* the sky mirrored */
    .draw.fresnel = &tp_draw_fresnel,
    .stage.mirror = tp_stage_mirror,
#endif
#if FEATURES >= 8       /* objects mirrored */
    .stage.slopes = tp_stage_slopes,
    .stage.reflect_gradient = tp_stage_reflect_gradient,
    .stage.fresnel = tp_stage_fresnel,
#endif
#if FEATURES >= 11      /* pools, stirred by the boat */
    .water.pools = &tp_water_pools,
#endif
#if FEATURES >= 12      /* drops and rings */
    .water.rings = &tp_water_rings,
#endif
#if FEATURES >= 15      /* an ocean over its floor, and land */
    .water.ocean = &tp_water_ocean,
#endif
#if FEATURES >= 16      /* a generated sky, and stars */
#endif
};
