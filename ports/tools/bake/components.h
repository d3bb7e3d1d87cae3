/* SPDX-License-Identifier: MIT */
/* The components of a program list, named as in the lists of tidepool/modules.h, and a
 * program list made from a set of components. */
#ifndef TP_TOOLS_BAKE_COMPONENTS_H
#define TP_TOOLS_BAKE_COMPONENTS_H
#include <stdbool.h>
#include <stdio.h>
#include "tidepool/modules.h"

typedef enum {
    COMPONENT_STAGE, COMPONENT_WATER, COMPONENT_DRAW, COMPONENT_METHOD,
    COMPONENT_MODULE,               /* a use; its drawing and stages, if any, follow it */
    COMPONENT_DRAWING, COMPONENT_MODULE_STAGE
} component_kind;

typedef struct {
    const char *name;           /* "sky", "swells", "foam" */
    component_kind  kind;
} component;

#define COMPONENTS_MOST 320

extern const component  components[];
extern const size_t component_count;        /* up to COMPONENTS_MOST */

/* A set of components, by their indices. */
typedef struct {
    bool has[COMPONENTS_MOST];
} component_set;

/* Settings of a list beside its components. */
typedef struct {
    tp_format format;           /* pixel format */
    bool      streams;          /* grid vertices are not stored: tp_method_streamed */
    bool      few;              /* room for the scene's waves only: tp_water_few_swells */
    bool      checks;           /* scenes are checked: tp_scene_check */
    bool      world;            /* as text: the world is NAME_world */
    bool      steers;           /* input moves the camera: tp_world_steering */
} component_terms;

/* A list in memory; `program` points into the struct. */
typedef struct {
    tp_program program;
    tp_use use[COMPONENTS_MOST];
    tp_stage stage[COMPONENTS_MOST]; /* tables of stages of modules, one after another */
} component_list;

/* Makes a list.  Drawings and stages of a module that is not in the set are left out too.
 * The list refuses no scene. */
void components_list(component_list *to, const component_set *of,
                     const component_terms *terms);

/* The same with stages that note when they run.  components_have_run: true if a stage
 * has run since components_forget.  Several threads may draw. */
void components_list_traced(component_list *to, const component_set *of,
                            const component_terms *terms);
void components_forget(void);
bool components_have_run(size_t i);

/* Adds all components with a name, a module with its drawing and stages; false: no such
 * name. */
bool components_add_named(component_set *to, const char *name, size_t length);

/* Adds the wave models of the water that modules of the set need. */
void components_add_models(component_set *set);

/* True if a component belongs to the world: a wave model or a module. */
bool component_is_in_world(size_t i);

/* True if a component may change a world: a wave model, or a module with a state or a
 * step. */
bool component_moves(size_t i);

static inline bool component_is_stage(size_t i)
{
    return components[i].kind == COMPONENT_STAGE
           || components[i].kind == COMPONENT_MODULE_STAGE;
}

/* Returns all components but those of `out`. */
component_set components_without(const component_set *out);

/* Returns the kind in words: "stage" of "stage sky", "module" of "module foam". */
const char *component_kind_name(size_t i);

/* True if the scene switches the module on, with the set's other components in the
 * program. */
bool component_is_active(size_t i, const component_set *of, const component_terms *terms,
                         const tp_scene *scene, const tp_assets *assets);

/* Writes the name of a component in the library, as "tp_stage_sky". */
void component_symbol(size_t i, const component_terms *terms, char *symbol, size_t bytes);

/* Writes the list as C text: NAME_program, preceded by its tables.  The program refuses
 * scenes with a module of `lacks` by the module's name. */
void components_write(FILE *out, const char *name, const component_set *of,
                      const component_set *lacks, const component_terms *terms);
#endif
