/* SPDX-License-Identifier: MIT */
/* The state of the world at the time of a frame: world->back of a tick before the last
 * tick.  Wave phases are evaluated at that time; stepped quantities are interpolated
 * between the last two ticks. */
#ifndef TP_SCENE_DRAWN_H
#define TP_SCENE_DRAWN_H
#include "scene/world.h"

typedef struct {
    tp_camera camera;           /* in world axes, even if the camera moves with the boat */
    tp_turn phases[TP_WAVES];
    tp_pose boat;
    tp_turn light_heading, light_elevation;
    tp_fx   exposure;
    int64_t time;               /* time in ticks x 65536 */
} tp_drawn;

tp_drawn tp_world_interpolate(const tp_world *world);

/* Returns the camera in world axes at `back` of a tick before the last tick. */
tp_camera tp_camera_interpolate(const tp_world *world, tp_fx lag);

/* True if the camera of a world is at a valid position.  Use: the bytes of `world` come
 * from outside the program.  Defined in world.c. */
bool tp_camera_is_valid(const tp_world *world);

/* Interpolates linearly: b for back = 0, a for back = 1. */
static inline tp_fx tp_interpolate(tp_fx a, tp_fx b, tp_fx lag)
{
    return b + (tp_fx)(((int64_t)a - b) * lag >> 16);
}

static inline tp_vec3 tp_place_interpolate(tp_vec3 a, tp_vec3 b, tp_fx lag)
{
    return (tp_vec3){ tp_interpolate(a.x, b.x, lag), tp_interpolate(a.y, b.y, lag),
                      tp_interpolate(a.z, b.z, lag) };
}
#endif
