/* SPDX-License-Identifier: MIT */
/* The flash of a baked program on a Cortex-M4, without the port's own code, before anything
 * is linked.  Code and constants are those of the list that bake finds, by a table measured
 * with the linker; the scene's tables are those that bake writes. */
#ifndef TP_TOOLS_BAKE_FLASH_H
#define TP_TOOLS_BAKE_FLASH_H
#include "app/scene/loaded_scene.h"
#include "component_search.h"

/* Sets *bytes to the flash of a loaded scene whose rungs are named, as baked in RGB565 for a
 * program without a user; o: size of the picture and tiles.  worlds: kept between steps of a
 * ladder; the caller closes worlds->run.  Returns an exit code. */
int flash_estimate(size_t *bytes, const loaded_scene *s, const options *o,
                   component_search_worlds *worlds);

/* Returns the code and constants that a program with a list links. */
size_t flash_code_bytes(const component_set *of, const component_terms *terms);
#endif
