/* SPDX-License-Identifier: MIT */
/* A parameter changed while the world moves: the change is made, the world asked to take
 * it, and what it needs is told. */
#ifndef LIVE_SETTING_H
#define LIVE_SETTING_H
#include "tidepool/scene.h"

typedef enum {
    SETTING_DONE,               /* the world goes on with it */
    SETTING_ANEW,               /* the scene has it; its world must be made anew, by
                                   tp_world_init in tp_world_bytes() */
    SETTING_LOAD,               /* a name of a file: assets must be loaded, then anew */
    SETTING_REFUSED             /* nothing has changed; *err tells */
} setting_result;

setting_result setting_put(const tp_kit *kit, tp_scene *scene, tp_world *world,
                           const tp_assets *assets, const tp_param *param,
                           const char *text, size_t bytes, tp_error *err);

/* Whether it names a file. */
bool setting_is_name(const tp_param *param);

/* The camera of `from` in a world that was made anew; time and light go on likewise. */
void setting_carry(tp_world *to, const tp_world *from);
#endif
