/* SPDX-License-Identifier: MIT */
/* Ways to look: each tick's input is bent so that the camera goes where the way wants.
 * All goes through tp_input, so that a tape of it replays without knowing of looks. */
#ifndef LIVE_LOOK_H
#define LIVE_LOOK_H
#include "tidepool/world.h"

typedef enum { LOOK_FREE, LOOK_ORBIT, LOOK_TOP, LOOK_BOAT, LOOK_MODES } look_mode;

/* All 0 to begin with, and again for another scene: then the camera is free. */
typedef struct {
    look_mode mode;
    tp_vec3   about;            /* what is looked at */
    tp_fx     away;             /* m from it */
    tp_turn   heading, pitch;
    bool      jump;             /* the next input goes there at once */

    /* private part */
    bool      with_boat;        /* what is looked at goes with the boat ... */
    tp_fx     boat_x, boat_z;   /* ... which was here */
    tp_vec3   free_eye;         /* where the free camera was left */
    tp_turn   free_heading, free_pitch;
} look;

/* False: the scene has no boat, or the like, and nothing changes.  Going round and from
 * above it is what the middle of the picture shows that is looked at: the boat, if it is
 * there, and that goes with it; the water; or a place ahead.  The mode that is on already
 * begins anew.  Then camera.follow has to become what look_follow says, before the next
 * look_steer. */
bool look_begin(look *l, look_mode mode, const tp_world *world, const tp_scene *scene);

/* What camera.follow has to be for it: `boat` on the deck, `none` around things, and
 * where the camera is free what the scene says. */
tp_camera_follow look_follow(const look *l, const tp_scene *filed);

/* Replaces the camera's part of `input`, which is the next that the world takes, by
 * tp_world_step or tp_world_move_camera.  Free and on the deck it stays as it is; going round,
 * turn, tilt and aside go round, ahead comes nearer and up rises; from above, ahead and
 * aside glide over the water, up rises, turn turns the map.  While l->jump is set the
 * input goes there at once instead: best by tp_world_move_camera, so that no picture is drawn
 * halfway. */
void look_steer(look *l, const tp_world *world, const tp_scene *scene, tp_input *input);

const char *look_name(look_mode mode);
#endif
