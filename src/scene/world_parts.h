/* SPDX-License-Identifier: MIT */
/* The variable part of a world: states that only some scenes need, after the head in the
 * same block. */
#ifndef TP_SCENE_WORLD_PARTS_H
#define TP_SCENE_WORLD_PARTS_H
#include "geom/surface.h"
#include "scene/module.h"
#include "scene/world.h"

/* Returns TP_OK if worlds and frames of this program accept this scene.  All init
 * functions, their byte counts and tp_world_apply call this check.  NULL assets: none.
 *  - TP_E_NULL: an argument is NULL; err->word names the argument
 *  - errors of tp_scene_check, if the program links the check
 *  - TP_E_PROGRAM: the scene enables a module that the program names in its `lacks`;
 *    err->word is the module's name, as `tidepool bake --with` takes it.  Fast stages
 *    count as lacking only if quality.shading names them; otherwise the plan takes the
 *    exact stages. */
tp_status tp_program_check_all(const tp_program *program, const tp_scene *scene,
                               const tp_assets *assets, tp_error *err);

const tp_coastal_water *tp_world_coastal(const tp_world *world);

#define TP_COASTAL_ID TP_MODULE_ID('o', 'c', 'e', 'a')

/* Computes the layout of a scene's world and the size of the block; parts->bytes is 0 if
 * the scene is refused.  If a pool is invalid, err->word is the parameter at fault. */
tp_status tp_world_layout_measure(const tp_program *program, tp_world_layout *layout,
                           const tp_scene *scene, const tp_assets *assets, tp_error *err);

/* Returns TP_E_NULL for a NULL scene, else the result of the program's own check of the
 * scene.  All init functions call this check through tp_program_check_all. */
tp_status tp_program_check(const tp_program *program, const tp_scene *scene,
                           tp_error *err);

/* Returns TP_E_PROGRAM; err->word names the missing module. */
tp_status tp_program_fail_lacking(const char *what, tp_error *err);

/* Returns the water surface of this tick, from the wave models of the program; valid
 * until the next step. */
tp_surface tp_world_surface(const tp_program *program, const tp_world *world);
#endif
