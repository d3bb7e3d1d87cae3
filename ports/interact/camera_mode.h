/* SPDX-License-Identifier: MIT */
/* Camera modes.  Each tick's input is changed to move the camera as the mode demands.
 * All motion goes through tp_input, so a recorded tape replays without knowledge of the
 * modes. */
#ifndef TP_INTERACT_CAMERA_MODE_H
#define TP_INTERACT_CAMERA_MODE_H
#include "tidepool/world.h"

typedef enum {
    CAMERA_FREE,
    CAMERA_ORBIT,
    CAMERA_TOP,
    CAMERA_BOAT,
    CAMERA_MODES
} camera_mode_kind;

/* All 0 at first and after a change of scene: the mode is then free. */
typedef struct {
    camera_mode_kind mode;
    tp_vec3   about;            /* target of the camera */
    tp_fx     away;             /* distance from the target, m */
    tp_turn   heading, pitch;
    bool      jump;             /* the next input moves there at once */

    /* private part */
    bool      with_boat;        /* the target moves with the boat */
    tp_fx     boat_x, boat_z;   /* the boat's last position, m */
    tp_vec3   free_eye;         /* last pose of the free camera */
    tp_turn   free_heading, free_pitch;
} camera_mode;

/* Begins a mode.  Returns false for an unknown mode, or without a boat for
 * CAMERA_BOAT; nothing then changes.  The target of orbit and top is at the middle of
 * the picture: the boat, if visible there, and then the target follows the boat; else
 * the water; else a point ahead.  Selecting the active mode starts it again.  Before
 * the next camera_mode_steer the caller must set camera.follow to the value of
 * camera_mode_follow. */
bool camera_mode_begin(camera_mode *l, camera_mode_kind mode, const tp_world *world,
                       const tp_scene *scene);

/* Returns the camera.follow needed by the mode: `boat` on the deck, `none` for orbit and
 * top, and for the free camera the value of the scene's file. */
tp_camera_follow camera_mode_follow(const camera_mode *l, const tp_scene *filed);

/* Replaces the camera's part of `input`, the next input of tp_world_step or
 * tp_world_move_camera.  Free and deck leave the input unchanged.  In orbit, turn, tilt
 * and aside move around the target, ahead moves nearer, up raises the target.  In top,
 * ahead and aside glide over the water, up rises, turn turns the map.  While l->jump is
 * set, the input moves to the mode's pose at once: use tp_world_move_camera then, so
 * that no frame is drawn on the way. */
void camera_mode_steer(camera_mode *l, const tp_world *world, const tp_scene *scene,
                       tp_input *input);

const char *camera_mode_name(camera_mode_kind mode);
#endif
