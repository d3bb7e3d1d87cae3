/* SPDX-License-Identifier: MIT */
/* A world: the state of a scene that moves, in ticks of 1/60 s.
 *
 *     bytes = tp_world_bytes(NULL, &scene, NULL)
 *     tp_world_init(NULL, world, bytes, &scene, NULL, &err)
 *     for each tick: tp_world_step(NULL, world, &scene, &input)
 *
 * `program` is the list of modules that the world uses, tidepool/modules.h; NULL is the
 * program that is linked.  Every function of one world takes the same program.  `assets` are
 * the pictures and meshes that the scene names; NULL: the scene's built-in ones, or none.
 *
 * One thread at a time may change a world; any number may read it while it stands still.
 * The same scene and inputs give the same world on every machine, to the bit. */
#ifndef TP_WORLD_H
#define TP_WORLD_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/assets.h"
#include "tidepool/fixed.h"
#include "tidepool/scene.h"
#include "tidepool/status.h"

TP_BEGIN_C

typedef struct tp_program tp_program;

/* A world fills one block of tp_world_bytes() bytes and holds no pointer: a copy of the block
 * is a snapshot.  The layout of the block is private. */
typedef struct tp_world tp_world;

#define TP_TICKS_PER_SECOND 60      /* the clock of everything that moves */


/* A push of the pool's water at (x, z): a splash of pool.poke_size, `height` above the level.
 * A height of 0 is no push; a push outside of the pool does nothing. */
typedef struct {
    tp_fx   height, x, z;       /* m */
} tp_push;

#define TP_PUSHES 8             /* in the input of a tick; tp_world_push takes any number */

/* What a person does in one tick; all 0 is no input.  Every number is safe: the camera and
 * the sphere of drops stay within 8000 m of the origin, the boat's speed within 100 m/s and
 * its turn within 360 degrees/s.  Negative drops count as 0; drops without room are left
 * out. */
typedef struct {
    tp_fx   forward, strafe, up;    /* m that the camera moves: along its heading, to its
                                     * right, both level; and upwards */
    int32_t turn, tilt;         /* tp_turn that is added to its heading and pitch */
    tp_fx   sphere_x, sphere_z; /* m that the sphere of drops moves */
    int32_t drops;              /* to release, 0..1024 */
    tp_fx   throttle, rudder;   /* m/s and degrees/s that the boat's numbers gain */
    int32_t slowdown;           /* n: halves the clock's scale n times; -n: doubles it */
    int32_t light_turn, light_tilt;     /* tp_turn that is added to the light's angles */
    tp_push push[TP_PUSHES];    /* in this order; for a world with a pool */
} tp_input;

/* The bytes of a world's block: about 2 KB, and more for pools, floors, wind, drops, foam.
 * 0: the scene cannot be used; tp_world_init says why. */
size_t tp_world_bytes(const tp_program *program, const tp_scene *scene,
                      const tp_assets *assets);

/* Makes the world of `scene` at tick 0 in a block of `bytes` bytes, aligned to 8.  The world
 * reads pictures of the assets now and keeps no pointer to them.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few
 *  - as tp_scene_check, if the program has it: err->word is the parameter at fault
 *  - TP_E_PROGRAM: the scene has a module on that the program says it lacks; err->word is
 *    its name, as `tidepool bake --with` takes it.  Fast stages are lacking only if
 *    quality.shading names them: a plan takes exact ones then
 *  - TP_E_ARG: the picture of "floor.map" has a side of 0 or of more than 4096 pixels */
tp_status tp_world_init(const tp_program *program, tp_world *world, size_t bytes,
                        const tp_scene *scene, const tp_assets *assets, tp_error *err);

/* Checks that `bytes` bytes from outside, such as a file's, aligned to 8, are a world that can
 * be stepped and drawn.  `fresh` is a world of the same scene, assets and program, just made
 * by tp_world_init or changed by tp_world_apply.  Version, layout and all that follows from
 * the scene must be equal; numbers that ticks change must be in the ranges that ticks keep.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument
 *  - TP_E_WORLD: err->word names the part at fault */
tp_status tp_world_check(const tp_program *program, const tp_world *world, size_t bytes,
                         const tp_world *fresh, tp_error *err);

/* Moves the world on by one tick.  `input` may be NULL.  After a change of the scene's
 * numbers call tp_world_apply first. */
void tp_world_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                   const tp_input *input);

/* Pushes the water at (x, z), m, at once.  Call it between ticks, any number of times.
 *  - In the pool, else in the field: a splash `height` m high or deep and `radius` m wide, at
 *    least 1.5 cells, that adds no volume.  A push of pool.poke_size has the same bits as the
 *    same tp_input.push in the next tick, unless drops or a boat feel the pool in that tick.
 *  - On open water, if drops raise rings (drops.into = rings): a ring that begins with a crest
 *    of |height| m, at most 4 m, and a length of 4 radii; a radius is at most 16 m.  The ring
 *    makes foam if the scene has foam, and is seen after the next tick.
 * False: no water moves.  There is no such water at this place, or a wall; the place is more
 * than 9000 m from the origin; no ring is free; or the height is 0.  `scene` is the one that
 * the world was made for, or that was applied last. */
bool tp_world_push(const tp_program *program, tp_world *world, const tp_scene *scene,
                   tp_fx x, tp_fx z, tp_fx radius, tp_fx height);

/* Places the camera in the world: the eye in metres, each axis held within +-8000 m, and
 * three angles of any size: heading clockwise from -z as seen from above, then pitch upwards,
 * then roll, which lowers the picture's right side.  The next picture is seen from exactly
 * there.  From then on input moves the camera as before, and tilts it to 89 degrees at the
 * most.
 *
 * In a scene whose camera follows the boat the following ends: the camera stands in the
 * world until tp_world_reset_camera, or until camera.follow has been none in one
 * tp_world_apply and boat in a later one. */
void tp_world_set_camera(tp_world *world, tp_vec3 eye, tp_turn heading, tp_turn pitch,
                         tp_turn roll);

/* Places the camera as the scene does at tick 0, following the boat if the scene does. */
void tp_world_reset_camera(tp_world *world, const tp_scene *scene);

/* Takes changed numbers of the scene over, at the same tick.  False, and nothing is changed:
 * the scene needs a block of another size, or cannot be used; tp_world_init then makes the
 * world again, or says what is wrong.  Do not step or draw with a scene that was refused.
 *
 * Tables that take long to make (waves over a floor, automatic exposure) are made again only
 * if their own numbers changed.  So `assets` must hold the pictures that the world was made
 * with. */
bool tp_world_apply(const tp_program *program, tp_world *world, const tp_scene *scene,
                    const tp_assets *assets);

/* A camera: the eye, m, and the rotation from world to view, whose rows are the directions
 * right, up and backward. */
typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
} tp_camera;

/* The camera as the next picture is seen from, also if the camera stands on the boat. */
tp_camera tp_world_camera(const tp_world *world);

/* Moves the clock on by one picture, 1/60 s times clock.scale.  Returns the ticks to step
 * before the next picture, 0 in slow motion; the picture is interpolated between the last
 * two ticks. */
uint32_t tp_world_advance_clock(tp_world *world);

/* The ticks since tp_world_init. */
uint64_t tp_world_tick(const tp_world *world);

/* The water at a place. */
typedef struct {
    tp_fx height;           /* m above the level of still water */
    tp_fx slope_x, slope_z; /* dy/dx and dy/dz */
    tp_vec3 velocity;       /* m/s, of the surface's point there: see tp_world_sample */
} tp_water;

/* The water above or below (x, z), m, after the last tick [E1]: waves, rings and pools
 * together, without overhangs.  It needs no picture and no camera.
 *
 * Waves displace points sideways, so the point above (x, z) is found by inversion: within
 * 30 km of the origin and with a steepness sum below 0.9 it is off by less than 1 mm.  Every
 * x and z has an answer; near the ends of 16.16 a position is held there.
 *
 * The velocity is the mean over the last tick, that of 1/120 s ago: what drifts with it goes
 * where the waves carry it.  Waves move a point along all three axes; rings and pools move
 * it up and down.  Roundings are 3 mm/s, and 1 mm/s more for each metre of the sum of the
 * waves' amplitudes. */
tp_water tp_world_sample(const tp_program *program, const tp_world *world, tp_fx x,
                         tp_fx z);

TP_END_C
#endif
