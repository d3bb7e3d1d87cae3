/* SPDX-License-Identifier: MIT */
/* The world: a scene as it moves, one tick of 1/60 s after the other. */
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

/* The list of what is linked: tidepool/modules.h. */
typedef struct tp_program tp_program;

/* A world lies in the caller's memory, tp_world_bytes() bytes, and holds no pointer: a copy
 * of the block is a snapshot.  Its layout is the library's own.
 *
 * A world goes with one program: what that lacks is not in it, as if the scene did not
 * name it; unless the program refuses such a scene, see tp_world_init. */
typedef struct tp_world tp_world;

#define TP_TICKS_PER_SECOND 60      /* the clock of everything that moves */


/* A hat put into the pool, as wide as pool.poke_size: m above the level, at a place in
 * the world, m.  Of height 0 there is none; outside of the pool it does nothing. */
typedef struct {
    tp_fx   height, x, z;
} tp_push;

#define TP_PUSHES 8             /* that one tick takes */

/* What the port feeds in at each tick; all 0 is no input.  Any numbers are safe: camera
 * and sphere stay within 8000 m of the origin, the boat's speed within 100 m/s and its
 * turn within 360 degrees/s; negative drops are none, those that find no room are
 * counted. */
typedef struct {
    tp_fx   forward, strafe, up;    /* m that the camera moves: along its heading, to its
                                     * right, both level; and upwards */
    int32_t turn, tilt;         /* tp_turn steps of its heading and pitch, signed */
    tp_fx   sphere_x, sphere_z; /* m that the sphere of drops moves */
    int32_t drops;              /* to release, 0..1024 */
    tp_fx   throttle, rudder;   /* of the boat: m/s and degrees/s beside the scene's */
    int32_t slowdown;           /* n: halves the clock's scale n times; -n: doubles it */
    int32_t light_turn, light_tilt;     /* tp_turn steps of the light, signed */
    tp_push push[TP_PUSHES];    /* in their order; a world without a pool takes none */
} tp_input;

/* About 2 KB if the scene has no pool, no floor or wind, no drops, and less by a program
 * without swells; 0 if it cannot be used (tp_world_init says why).  NULL assets are
 * none. */
size_t tp_world_bytes(const tp_program *program, const tp_scene *scene,
                      const tp_assets *assets);

/* The world of `scene` at tick 0, in `bytes` bytes aligned to 8.  Pictures that the
 * assets hold are read now and not kept; NULL assets are none.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few
 *  - as tp_scene_check, if the program has it: err->word is the parameter at fault
 *  - TP_E_PROGRAM: the scene has a module on that the program says it lacks; err->word is
 *    its name, as `tidepool bake --with` takes it.  Fast stages are lacking only if
 *    quality.shading names them: a plan takes exact ones then
 *  - TP_E_ARG: the picture of "floor.map" has a side of 0 or of more than 4096 pixels */
tp_status tp_world_init(const tp_program *program, tp_world *world, size_t bytes,
                        const tp_scene *scene, const tp_assets *assets, tp_error *err);

/* Checks that bytes from outside, such as a file's, are a world that can be stepped and
 * drawn.  `fresh` is a world of the same scene, assets and program, as tp_world_init or
 * tp_world_apply leaves it: version, layout and everything that follows from the scene
 * must be equal; numbers that ticks change must be in the ranges that ticks keep.  `world`
 * has `bytes` bytes, aligned to 8.  TP_E_WORLD: err->word names the part at fault; TP_E_NULL,
 * TP_E_ALIGN: the argument. */
tp_status tp_world_check(const tp_program *program, const tp_world *world, size_t bytes,
                         const tp_world *fresh, tp_error *err);

/* One tick further; `input` may be NULL.  After a change of the scene's numbers call
 * tp_world_apply first. */
void tp_world_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                   const tp_input *input);

/* Pushes the water at (x, z) m of the world, at once; between ticks, as often as wanted.
 *  - In the pool, else in the field: a hat of `height` m, up or down, that moves no volume,
 *    its width `radius` m (at least 1.5 cells).  A push of scene.pool.poke_size into the
 *    pool gives the same bits as that one in tp_input.push of the next tick, unless drops or
 *    a boat feel the pool in that tick: they then feel this push already.
 *  - On open water, where drops raise rings (drops.into = rings): a ring that begins with a
 *    crest of |height| m, 4 m at the most, of the length 4 radii, 16 m of radius at the
 *    most; with foam where the scene has foam.  It is seen from the next tick on.
 * False: no water moves, as there is nothing to take it at this place (no water, a wall,
 * more than 9000 m from the origin), no room for another ring, or a height of 0.  `scene`
 * is the one that the world was made for, or last refreshed by. */
bool tp_world_push(const tp_program *program, tp_world *world, const tp_scene *scene,
                   tp_fx x, tp_fx z, tp_fx radius, tp_fx height);

/* Places the camera in the world: the eye in metres, each axis held within +-8000 m, and
 * three angles of any size, in the order of tp_rotation_of: heading clockwise from -z as
 * seen from above, pitch upwards, roll lowers the picture's right side.  The next picture
 * is seen from there exactly, whatever world->back is; from then on input moves the camera
 * as ever, and tilts it to 89 degrees at the most.
 *
 * In a scene whose camera follows the boat the following ends: the camera stands in the
 * world until tp_world_reset_camera, or until camera.follow has been none in one
 * tp_world_apply and boat in a later one. */
void tp_world_set_camera(tp_world *world, tp_vec3 eye, tp_turn heading, tp_turn pitch,
                         tp_turn roll);

/* Places the camera as the scene does at tick 0, following the boat if the scene does. */
void tp_world_reset_camera(tp_world *world, const tp_scene *scene);

/* The scene as it is now, at the same tick: sea, ocean, boat, what of pools and drops may
 * change while they move.  False, and nothing is done: what sizes the world's block has
 * changed, or the scene cannot be used; tp_world_init makes the world anew, or tells what
 * is wrong.  Until one of them has taken the scene, neither step nor draw by it.
 *
 * Tables that take long to make, the ocean's and those of automatic exposure, keep the
 * numbers that they were made of, and are made again only where these have changed.  So
 * `assets` must hold the pictures that the world was made with. */
bool tp_world_apply(const tp_program *program, tp_world *world, const tp_scene *scene,
                    const tp_assets *assets);

/* Where the picture is seen from, and how: rows right, up and backward. */
typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
} tp_camera;

/* The camera in the world, wherever it stands, between the last two ticks as the clock
 * stands. */
tp_camera tp_world_camera(const tp_world *world);

/* Ticks that the clock asks for until the next picture: step the world so many times.  The
 * picture then lies between the last two ticks, as the clock stands. */
uint32_t tp_world_advance_clock(tp_world *world);

/* Ticks that the world has made. */
uint64_t tp_world_tick(const tp_world *world);

/* The water at a place. */
typedef struct {
    tp_fx height;           /* m above the level of still water */
    tp_fx slope_x, slope_z; /* dy/dx and dy/dz */
    tp_vec3 velocity;       /* m/s, of the surface's point there: see tp_world_sample */
} tp_water;

/* The water above or below (x, z), m of the world, as the last tick left it [E1]: waves,
 * rings and pools together, without what overhangs.  No camera and no picture is asked:
 * any number of places, by any number of threads while the world stands still.
 *
 * Where waves are displaced sideways the place is found by inversion: within 30 km of the
 * origin, each way, and with a steepness sum below 0.9 the point is off by less than 1 mm
 * along and up (see tp_sea_above).  Any x and z are answered; near the ends
 * of 16.16 positions are held there.
 *
 * The velocity is the mean over the last tick, so that of 1/120 s ago: a boat that drifts
 * with the point is carried where waves carry it.  Swells and oceans move a point in all
 * three axes; rings and pools, which are heights, lift it alone.  Roundings are 3 mm/s, and
 * 1 mm/s more for each metre of the waves' amplitudes together. */
tp_water tp_world_sample(const tp_program *program, const tp_world *world, tp_fx x,
                         tp_fx z);

TP_END_C
#endif
