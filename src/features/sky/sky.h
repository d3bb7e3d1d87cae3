/* SPDX-License-Identifier: MIT */
/* Skies beside the plain gradient, one of which a scene may have.  Each one's `begin` sets
 * shade->env, which its stages, mirrors and haze look into; shade/dome.c and cube.c make
 * the tables.
 *
 *     sky_dome_drawing.c       a generated sky: day, dusk, night
 *     sky_dome_stage.c         its empty view, and what water mirrors of it
 *     sky_dome_quick_stage.c   the empty view, quickly
 *     sky_cube_drawing.c       six pictures
 *     sky_cube_stage.c         the same two of them
 *     stars_drawing.c          over a night
 *     stars_stage.c */
#ifndef TP_SKY_MODULES_H
#define TP_SKY_MODULES_H
#include "scene/light.h"
#include "scene/module.h"

#define TP_SKY_DOME_ID TP_MODULE_ID('s', 'k', 'y', 'd')
#define TP_SKY_CUBE_ID TP_MODULE_ID('s', 'k', 'y', 'c')
#define TP_STARS_ID    TP_MODULE_ID('s', 't', 'a', 'r')
#endif
