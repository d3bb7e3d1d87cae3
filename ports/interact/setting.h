/* SPDX-License-Identifier: MIT */
/* Changing a parameter while the world runs: the change is made, the world takes it if
 * possible, and the result tells the caller's part of the work.
 *
 * The caller owns the frame.  Make a new frame before the next tp_frame_begin if
 * setting_is_grid is true for the parameter.  If setting_is_wall is true, the frame
 * shows the change only after being made anew.  If tp_frame_bytes has risen, the frame
 * draws a reduced picture until made anew (tidepool/frame.h). */
#ifndef TP_INTERACT_SETTING_H
#define TP_INTERACT_SETTING_H
#include "tidepool/world.h"

typedef enum {
    SETTING_DONE,               /* the world has taken the change */
    SETTING_ANEW,               /* the scene is changed; make a new world: tp_world_init
                                 * in tp_world_bytes() */
    SETTING_LOAD,               /* the scene is changed (a file name): load assets, make
                                 * world and frame anew */
    SETTING_REFUSED             /* nothing is changed, *err has the reason: not a value
                                 * (tp_param_set), or no possible world */
} setting_result;

/* Sets a parameter.  After ANEW or LOAD the old world stays valid until made anew; to
 * undo, set the old text.  A number of camera.* moves the camera.  `world` NULL: there
 * is no world yet; a number then gives ANEW or REFUSED. */
setting_result setting_put(const tp_program *program, tp_scene *scene, tp_world *world,
                           const tp_assets *assets, const tp_param *param,
                           const char *text, size_t bytes, tp_error *err);

/* The same for a value already in the scene; a refused value stays in the scene. */
setting_result setting_take(const tp_program *program, const tp_scene *scene,
                            tp_world *world, const tp_assets *assets,
                            const tp_param *param, tp_error *err);

/* True if the parameter is the number of grid lines, in either direction. */
bool setting_is_grid(const tp_param *param);

/* True if the parameter is a file name, or chooses among files: a program loads them. */
bool setting_names_files(const tp_param *param);

/* True if the parameter moves walls inside the pool; a frame keeps walls at the position
 * of their first drawing. */
bool setting_is_wall(const tp_param *param, const tp_assets *assets);

/* Copies the state of an old world to a new one: camera, time, light and boat.  Pools,
 * drops, rings, foam and spray start anew.  `to` keeps its own light if the scene's
 * light differs, and its own camera if the frame of reference differs (deck or not).
 * `from` may be of another scene. */
void setting_carry(tp_world *to, const tp_world *from);
#endif
