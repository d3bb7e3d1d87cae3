/* SPDX-License-Identifier: MIT */
/* Scenes with each kind of sky for the reference's own checks. */
#ifndef TP_TESTS_ACCURACY_SKIES_H
#define TP_TESTS_ACCURACY_SKIES_H
#include "sights.h"

static inline tp_scene scene_sky(uint64_t *state, int32_t kind)
{
    tp_scene s = scene_level();

    s.sky.kind = kind;
    s.camera.heading = chance_fx(state, -180, 180);
    s.camera.pitch = chance_fx(state, -40, 80);
    s.camera.fov = 90 * TP_FX_ONE;
    s.light.heading = chance_fx(state, -180, 180);
    s.light.elevation = chance_fx(state, 1, 90);
    s.light.colour = chance_int(state, 0, 0xffffff);
    s.light.ambient = TP_FX_ONE;
    s.water.colour = 0x102840;
    return s;
}

/* Moves the camera to a place without water below; water far away may stay visible. */
static inline void go_ashore(tp_scene *s)
{
    s->camera.x = 4000 * TP_FX_ONE;
    s->grid.follow = 0;
    s->grid.reach = 0;
}
#endif
