/* SPDX-License-Identifier: MIT */
/* What the kit holds of each part of a world that only some scenes have.  A part that the
 * kit lacks is not in the world.  An `input` of NULL is one that is all 0. */
#ifndef TP_SCENE_MOVES_H
#define TP_SCENE_MOVES_H
#include "geom/waters.h"
#include "scene/boat.h"
#include "scene/light.h"
#include "scene/parts.h"
#include "tidepool/arena.h"

struct tp_move_boat {
    void (*init)(const tp_kit *kit, tp_world *world, const tp_scene *scene);
    void (*step)(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                 const tp_input *input);
};

struct tp_move_wake {
    void (*step)(tp_world *world, const tp_scene *scene);
};
#endif
