/* SPDX-License-Identifier: MIT */
/* A parameter changed while the world moves: the change is made, the world asked to take
 * it, and what it needs is told.
 *
 * The frame is the caller's.  It must be made anew after a change of what setting_is_grid
 * tells, before the next tp_frame_begin; it shows what setting_is_wall tells only when it
 * is; and it draws others in part (tidepool/frame.h) where tp_frame_bytes has risen,
 * until it is. */
#ifndef LIVE_SETTING_H
#define LIVE_SETTING_H
#include "tidepool/world.h"

typedef enum {
    SETTING_DONE,               /* the world goes on with it */
    SETTING_ANEW,               /* the scene has it; its world must be made anew, by
                                   tp_world_init in tp_world_bytes() */
    SETTING_LOAD,               /* the scene has it, a name of a file: assets must be
                                   loaded, then world and frame made anew */
    SETTING_REFUSED             /* nothing has changed; *err tells: the text is no value,
                                   as tp_param_set says, or no world can be made of it */
} setting_result;

/* Until it is made anew a world goes on as it was; to take back what is ANEW or LOAD, put
 * the old text.  A number of the camera's moves the camera.  `world` NULL: there is none
 * yet, and every number is ANEW or REFUSED. */
setting_result setting_put(const tp_program *program, tp_scene *scene, tp_world *world,
                           const tp_assets *assets, const tp_param *param,
                           const char *text, size_t bytes, tp_error *err);

/* The same of a value that the scene has already; what is refused stays in it. */
setting_result setting_take(const tp_program *program, const tp_scene *scene,
                            tp_world *world, const tp_assets *assets,
                            const tp_param *param, tp_error *err);

/* Whether it is the number of the mesh's lines, one way or the other. */
bool setting_is_grid(const tp_param *param);

/* Whether it moves walls inside the pool, which a frame keeps where they were when it
 * first drew them. */
bool setting_is_wall(const tp_param *param, const tp_assets *assets);

/* The camera of `from` in a world that was made anew; time and light go on likewise, and
 * a boat sails on.  Pools, drops, rings, foam and spray begin anew.  Where the scene has
 * another light, or the camera another frame of reference (the deck is gone), `to` keeps
 * its own.  `from` need not be the same scene's. */
void setting_carry(tp_world *to, const tp_world *from);
#endif
