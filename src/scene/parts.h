/* SPDX-License-Identifier: MIT */
/* The parts of a world that only some scenes have, behind its head in one block. */
#ifndef TP_SCENE_PARTS_H
#define TP_SCENE_PARTS_H
#include "geom/surface.h"
#include "scene/module.h"
#include "scene/world.h"

/* TP_OK: worlds and frames of this program take this scene; every init, their byte counts
 * and tp_world_apply ask it.  NULL assets are none.
 *  - TP_E_NULL: err->word is the argument
 *  - as tp_scene_check, if the program has it
 *  - TP_E_PROGRAM: the scene has a module on that the program names in its `lacks`;
 *    err->word is that name, as `tidepool bake --with` takes it.  Fast stages are lacking
 *    only if quality.shading names them: a plan takes exact ones then. */
tp_status tp_program_fits(const tp_program *program, const tp_scene *scene,
                          const tp_assets *assets, tp_error *err);

const tp_ocean *tp_world_ocean(const tp_world *world);

#define TP_OCEAN_ID TP_MODULE_ID('o', 'c', 'e', 'a')

/* Where the parts of a scene's world lie, and how large the block is; parts->bytes is 0
 * if the scene cannot be used.  Of a pool that cannot, err->word is the parameter at
 * fault. */
tp_status tp_parts_of(const tp_program *program, tp_world_parts *parts,
                      const tp_scene *scene, const tp_assets *assets, tp_error *err);

/* TP_E_NULL for a missing program or scene, then the program's check of the scene; every
 * init asks it by tp_program_fits. */
tp_status tp_program_check(const tp_program *program, const tp_scene *scene,
                           tp_error *err);

/* TP_E_PROGRAM, which names what the program lacks. */
tp_status tp_program_lacks(const char *what, tp_error *err);

/* The surface of this tick, of the models that the program has; valid until the world moves. */
tp_surface tp_world_surface(const tp_program *program, const tp_world *world);
#endif
