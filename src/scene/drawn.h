/* SPDX-License-Identifier: MIT */
/* The world as a picture shows it: world->back of a tick before the last tick.  Phases
 * are evaluated there; what was stepped is interpolated between its last two ticks. */
#ifndef TP_SCENE_DRAWN_H
#define TP_SCENE_DRAWN_H
#include "scene/world.h"

typedef struct {
    tp_camera camera;           /* in the world, also if it goes with the boat */
    tp_turn phases[TP_WAVES];
    tp_pose boat;
    tp_turn light_heading, light_elevation;
    tp_fx   exposure;
    int64_t time;               /* ticks x 65536 */
} tp_drawn;

tp_drawn tp_world_drawn(const tp_world *world);

/* The camera `back` of a tick before the last one, in the world. */
tp_camera tp_camera_between(const tp_world *world, tp_fx back);

/* Whether the camera of a world whose bytes come from outside is where a camera can be;
 * in world.c. */
bool tp_camera_is_valid(const tp_world *world);

/* `back` of the way from b to a. */
static inline tp_fx tp_between(tp_fx a, tp_fx b, tp_fx back)
{
    return b + (tp_fx)(((int64_t)a - b) * back >> 16);
}

static inline tp_vec3 tp_place_between(tp_vec3 a, tp_vec3 b, tp_fx back)
{
    return (tp_vec3){ tp_between(a.x, b.x, back), tp_between(a.y, b.y, back),
                      tp_between(a.z, b.z, back) };
}
#endif
