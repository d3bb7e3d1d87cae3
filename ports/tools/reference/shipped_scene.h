/* SPDX-License-Identifier: MIT */
/* Loads a shipped scene at a tick, for both the reference and the engine. */
#ifndef TP_TOOLS_REFERENCE_SHIPPED_SCENE_H
#define TP_TOOLS_REFERENCE_SHIPPED_SCENE_H
#include "app/scene/assets.h"
#include "app/scene/scene_file.h"

typedef struct {
    scene_file file;
    asset_set  assets;
    tp_world  *world;
} ref_stand;

/* Opens a scene with settings as "name=value". Returns an exit code; prints the reason of a
 * failure. Close the stand in either case. */
int  ref_stand_open(ref_stand *stand, const char *name, const char *const *settings,
                    uint32_t count, uint32_t ticks);
void ref_stand_close(ref_stand *stand);
#endif
