/* SPDX-License-Identifier: MIT */
/* The world of a scene at tick 0, and its tables of coastal water, as constants. */
#ifndef TP_TOOLS_BAKE_BAKE_WORLD_H
#define TP_TOOLS_BAKE_BAKE_WORLD_H
#include <stdio.h>
#include "bake.h"
#include "bake_program.h"

/* True if the program's world is a constant: it is smaller than the code that makes it. */
bool bake_world_is_copied(const bake_program *p, const tp_assets *assets);

/* Returns the bytes of the program's world. */
size_t bake_world_bytes(const bake_program *p, const tp_assets *assets);

/* Makes a world of the program's scene and adds its tables of coastal water to the assets: the
 * scene of a program without --with keeps its numbers.  Returns NULL if there are none, or no
 * memory; the caller frees the world. */
tp_world *bake_find_coastal(bake *b, const options *o, tp_assets *assets);

/* Writes NAME_world_bytes, and NAME_world if the world is a constant.  Returns an exit
 * code. */
int bake_put_world(const bake_program *p, const tp_assets *assets, FILE *out,
                   const char *name);

/* Writes NAME_world_init, which copies that world or calls tp_world_init; after the
 * program. */
void bake_put_world_init(const bake_program *p, const tp_assets *assets, FILE *out,
                         const char *name);
#endif
