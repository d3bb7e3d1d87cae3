/* SPDX-License-Identifier: MIT */
/* The plan of a loaded scene: within its error budget, or for a board. */
#ifndef TP_APP_SCENE_SCENE_PLAN_H
#define TP_APP_SCENE_SCENE_PLAN_H
#include "loaded_scene.h"

/* Returns the assets by which the plan counts: with all of the boat's faces. */
const tp_assets *scene_plan_assets(const loaded_scene *s);

/* Returns the frame of the scene's own board; runs a second of the scene if it has a board
 * that it had not before. */
board_frame scene_plan_board_frame(const loaded_scene *s);

/* Returns the plan of the scene for pictures of a size; *real_time (NULL: unwanted) tells if
 * the board keeps the time of the frame (boards.h). */
tp_plan scene_plan_make(const loaded_scene *s, const board_frame *frame, uint32_t width,
                        uint32_t height, bool *real_time);

/* Makes the plan of a scene that is being loaded, and loads the boat's mesh again if the
 * plan asks for another one.  Returns an exit code. */
int scene_plan_take(loaded_scene *s, const options *o);

/* Makes the plan again after a change of the scene; the mesh stays. */
tp_plan scene_plan_renew(const loaded_scene *s, uint32_t width, uint32_t height);
#endif
