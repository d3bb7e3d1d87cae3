/* SPDX-License-Identifier: MIT */
/* Ways to look: each tick's input is bent so that the camera goes where the way wants.
 * All goes through tp_input, so that a tape of it replays without knowing of looks. */
#ifndef LIVE_LOOK_H
#define LIVE_LOOK_H
#include "tidepool/scene.h"

typedef enum { LOOK_FREE, LOOK_ORBIT, LOOK_TOP, LOOK_BOAT, LOOK_MODES } look_mode;

typedef struct {
    look_mode mode;
    tp_vec3   about;            /* what is looked at */
    tp_fx     away;             /* m from it */
    tp_turn   heading, pitch;
    bool      jump;             /* the next input goes there at once */
    tp_input  still;            /* private part ... */
} look;

/* False: the scene has no boat, or the like, and nothing changes.  LOOK_BOAT wants
 * camera.follow = boat, and the others want what the scene says: the caller sets that
 * (look_follow) before the next look_steer. */
bool look_begin(look *l, look_mode mode, const tp_world *world, const tp_scene *scene);

/* What camera.follow has to be for it. */
tp_camera_follow look_follow(const look *l, const tp_scene *filed);

/* Replaces the camera's part of `input`: free, it stays as it is; going round, turn and
 * tilt go round, ahead and up come nearer and rise; from above, ahead and aside glide over
 * the water, up rises, turn turns the map. */
void look_steer(look *l, const tp_world *world, const tp_scene *scene, tp_input *input);

const char *look_name(look_mode mode);
#endif
