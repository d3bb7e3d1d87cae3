/* SPDX-License-Identifier: MIT */
/* Skies other than the plain gradient; a scene has at most one.  The `begin` of a sky
 * sets shade->env for its stages, for reflections and for haze.  shade/dome.c and cube.c
 * make the tables.
 *
 *     sky_dome_drawing.c       a generated sky: day, dusk, night
 *     sky_dome_stage.c         the visible sky, and its reflection
 *     sky_dome_quick_stage.c   the visible sky by fast shading
 *     sky_cube_drawing.c       a cube map of six textures
 *     sky_cube_stage.c         the visible sky, and its reflection
 *     stars_drawing.c          stars of a night
 *     stars_stage.c            their span stage */
#ifndef TP_SKY_MODULES_H
#define TP_SKY_MODULES_H
#include "scene/light.h"
#include "scene/module.h"

#define TP_SKY_DOME_ID TP_MODULE_ID('s', 'k', 'y', 'd')
#define TP_SKY_CUBE_ID TP_MODULE_ID('s', 'k', 'y', 'c')
#define TP_STARS_ID    TP_MODULE_ID('s', 't', 'a', 'r')
#endif
