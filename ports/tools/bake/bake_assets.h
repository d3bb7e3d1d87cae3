/* SPDX-License-Identifier: MIT */
/* The textures, grey maps and baked layers of a baked file. */
#ifndef TP_TOOLS_BAKE_BAKE_ASSETS_H
#define TP_TOOLS_BAKE_BAKE_ASSETS_H
#include "app/cli/args.h"
#include "bake.h"
#include "features/water/water.h"

enum { BAKE_PICTURES = 20, BAKE_GREYS = 3 };

/* A member of tp_assets in C, part of its baked name, and its offset. */
typedef struct {
    const char *member, *part;
    size_t      offset;
} bake_member;

extern const bake_member bake_members[], bake_greys[];

const tp_texture *bake_nth_texture(const tp_assets *names, int i);
const tp_grey *bake_nth_grey(const tp_assets *names, int i);

/* Makes the list b->pictures, which the caller frees.  Returns an exit code. */
int bake_list_pictures(bake *b, const tp_assets *names);

/* Adds baked layers to *names, and removes the textures that nothing reads after baking.
 * `memory` and `made` hold the layers; the caller frees memory.  Returns an exit code. */
int bake_prepare(tp_assets *names, const tp_scene *scene, const options *o,
                 void *memory[TP_BAKED_LAYERS], tp_texture made[TP_BAKED_LAYERS]);
#endif
