/* SPDX-License-Identifier: MIT */
/* Programs that grow: the least one, which draws level water with one texture and the sky, or
 * with -DFEATURES=n the first n things more that a program may name.  programs.sh links one
 * program for each, and prints how much text that takes. */
#include "features.h"

#ifndef FEATURES
#define FEATURES 0
#endif

static const tp_use modules[] = {
#if FEATURES >= 16      /* a generated sky, and stars */
    TP_USE_WITH(sky_dome, tp_stage_sky_dome, NULL, NULL, tp_stage_reflect_dome),
    TP_USE(stars),
    TP_USE_WITH(haze, tp_stage_haze, tp_stage_haze_dome, NULL),
#else
    TP_USE_WITH(haze, tp_stage_haze, NULL, NULL),
#endif
#if FEATURES >= 7       /* a boat */
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
#if FEATURES >= 2       /* bilinear texels */
    TP_USE_WITH(base_layer, tp_stage_texture, tp_stage_texture_tinted,
                tp_stage_texture_linear, tp_stage_texture_linear_tinted, NULL, NULL),
#else
    TP_USE_WITH(base_layer, tp_stage_texture, NULL, NULL, NULL, NULL, NULL),
#endif
#if FEATURES >= 3       /* layers, distorted */
    TP_USE(layers),
#endif
#if FEATURES >= 4       /* ripples */
    TP_USE_WITH(ripple, tp_stage_ripple, tp_stage_ripple_gentle, NULL),
#endif
#if FEATURES >= 5       /* light: Phong, glint */
    TP_USE_WITH(lighting, tp_stage_light, tp_stage_light_rippled, NULL, NULL),
#endif
#if FEATURES >= 4
    TP_USE_WITH(diffuse, tp_stage_diffuse, tp_stage_diffuse_rippled),
#else
    TP_USE_WITH(diffuse, tp_stage_diffuse, NULL),
#endif
#if FEATURES >= 6       /* the sky mirrored */
#if FEATURES >= 8
    TP_USE_WITH(reflectance, tp_stage_mirror, tp_stage_slopes, tp_stage_reflect_gradient,
                tp_stage_fresnel, NULL),
#else
    TP_USE_WITH(reflectance, tp_stage_mirror, NULL, NULL, NULL, NULL),
#endif
#endif
#if FEATURES >= 5
    TP_USE(glint),
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
#if FEATURES >= 8       /* objects mirrored */
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
const tp_program features_program = {
    .modules = modules,
    .stage.sky = tp_stage_sky,
    .stage.plain = tp_stage_plain,
    .store[TP_FORMAT_RGB565] = tp_store_rgb565,
    .method.flat = &tp_method_flat,
#if FEATURES >= 1       /* waves, as triangles */
    .method.triangles = &tp_method_triangles,
    .water.swells = &tp_water_swells,
#endif
#if FEATURES >= 5
    .stage.view = tp_stage_view,
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
};
