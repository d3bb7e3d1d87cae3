/* SPDX-License-Identifier: MIT */
/* Spray and bubbles: specks that fly over the water and rise in it.
 *
 *     spray.c           the module: crests, splashes, flight
 *     spray_drawing.c   specks as discs over the picture
 *     spray_stage.c     their colour */
#ifndef TP_SPRAY_MODULE_H
#define TP_SPRAY_MODULE_H
#include "scene/module.h"

#define TP_SPRAY_ID TP_MODULE_ID('s', 'p', 'r', 'y')

/* The module's state in a world, or NULL. */
static inline tp_spray *tp_spray_of_world(const tp_world *world)
{
    return tp_world_part(world, TP_SPRAY_ID);
}

/* A drop has struck water of this level: a crown of specks, and bubbles under it. */
void tp_spray_splash(tp_spray *spray, const tp_scene *scene, const tp_impact *impact,
                     tp_fx level);
#endif
