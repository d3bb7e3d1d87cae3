/* SPDX-License-Identifier: MIT */
/* The boat: its course, its pose on the waves, its wake in a pool, its picture.  A scene
 * without a mesh has none.  Place and pose lie in tp_world: a camera aboard follows them.
 *
 *     boat.c           the module hull: the course
 *     float.c          the pose on the water
 *     wake.c           the module wake
 *     boat_drawing.c   the modules boat, its mesh, and lids
 *     boat_stage.c     the light on its materials */
#ifndef TP_BOAT_MODULE_H
#define TP_BOAT_MODULE_H
#include "pool/pool.h"
#include "scene/module.h"
#include "scene/world.h"
#include "shade/shade.h"

#define TP_BOAT_ID TP_MODULE_ID('b', 'o', 'a', 't')

#define TP_BOAT_MATERIALS 192   /* more share the last mark */

/* A vertex of the mesh, projected; boat_drawing.c has the values of u that mark a vertex
 * as not projected. */
typedef struct {
    int32_t  u, v;
    uint32_t zi;
} tp_boat_vertex;

/* Its stages' data, first in tp_run.mine. */
typedef struct {
    const tp_mesh  *mesh;
    const tp_solid *solid;      /* of each material */
    tp_view_axes    axes;       /* the view and the light in the mesh's own frame */
} tp_boat_look;

/* Lays the boat on the water at tick 0, and after a change of the scene's numbers: it
 * stays as far from the scene's place and heading as it has sailed, and a boat that
 * floats by its weight or follows slowly goes on from where it lay. */
void tp_boat_init(const tp_program *program, tp_world *world, const tp_scene *scene);

/* One tick, after the water's; the caller has copied the last pose to world->last_boat. */
void tp_boat_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                  const tp_input *input);

/* True if the boat of a world from outside is in the ranges that steps keep. */
bool tp_boat_is_valid(const tp_world *world);

/* Stirs the water of tp_boat_pool by the hull [E4]; after tp_boat_step. */
void tp_boat_wake(tp_world *world, const tp_scene *scene);

/* The pool that the hull stirs: [pool], else [field], else NULL. */
tp_pool *tp_boat_pool(tp_world *world);

/* -- float.c ------------------------------------------------------------------------ */

typedef enum { TP_BOW, TP_STERN, TP_PORT, TP_STARBOARD } tp_hull_point;

/* Lays the boat on water of these heights under the four points, within +-2048 m. */
void tp_boat_lay(tp_lie *lie, const tp_fx water[4]);

/* Moves the boat for one tick towards the pose of tp_boat_lay, as the scene says. */
void tp_boat_float(tp_lie *lie, const tp_scene *scene, const tp_fx water[4]);

/* Sets the hull's `sunk`. */
void tp_boat_sink(tp_hull *hull, const tp_lie *lie, const tp_fx water[4]);

/* True if all numbers are in the ranges that the three functions above keep. */
bool tp_boat_lie_is_valid(const tp_lie *lie);
bool tp_boat_hull_is_valid(const tp_hull *hull);

static inline tp_fx tp_fx_of_q40(int64_t x)
{
    return (tp_fx)((x + (1 << 23)) >> 24);
}
#endif
