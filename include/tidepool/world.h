/* SPDX-License-Identifier: MIT */
/* A world: the moving state of a scene, in ticks of 1/60 s.
 *
 *     bytes = tp_world_bytes(NULL, &scene, NULL)
 *     tp_world_init(NULL, world, bytes, &scene, NULL, &err)
 *     for each tick: tp_world_step(NULL, world, &scene, &input)
 *
 * `program` is the list of modules that the world uses, tidepool/modules.h; NULL: the
 * linked program.  Every function of one world takes the same program.  `assets` are the
 * pictures and meshes that the scene names; NULL: the scene's built-in ones, or none.
 *
 * One thread at a time may change a world; any number of threads may read a world that
 * does not change.  The same scene and inputs give the same world on every machine, to the
 * bit. */
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

/* A world fills one block of tp_world_bytes() bytes and holds no pointer: a copy of
 * the block is a snapshot.  The layout of the block is private. */
typedef struct tp_world tp_world;

#define TP_TICKS_PER_SECOND 60      /* clock of all simulation */

/* A push of the pool's water at (x, z): a splash of pool.splash_width, `height` above the
 * level.  A height of 0 is no push; a push outside of the pool has no effect. */
typedef struct {
    tp_fx   height, x, z;       /* m */
} tp_push;

#define TP_PUSHES 8             /* per tick in tp_input; tp_world_push takes any number */

/* Input of one tick; all zero is no input.  Every number is safe: the camera and the
 * sphere of drops stay within 8000 m of the origin, the boat's speed within 100 m/s and
 * its turn rate within 360 degrees/s.  Negative drops count as 0; drops without room are
 * left out. */
typedef struct {
    tp_fx   forward, strafe, up;    /* camera motion, m: along its heading, to its right
                                     * (both level), and upwards */
    int32_t turn, tilt;         /* tp_turn added to the camera's heading and pitch */
    tp_fx   sphere_x, sphere_z; /* motion of the sphere of drops, m */
    int32_t drops;              /* drops to release, 0..1024 */
    tp_fx   throttle, rudder;   /* added to the boat's speed and turn: m/s, degrees/s */
    int32_t slowdown;           /* n: halves the clock's scale n times; -n: doubles it */
    int32_t light_turn, light_tilt;     /* tp_turn added to the light's angles */
    tp_push push[TP_PUSHES];    /* applied in this order; for a world with a pool */
} tp_input;

/* Returns the bytes of a world's block: about 2 KB, and more for pools, floors, wind,
 * drops, foam.  0: the scene cannot be used; tp_world_init tells why. */
size_t tp_world_bytes(const tp_program *program, const tp_scene *scene,
                      const tp_assets *assets);

/* Makes the world of `scene` at tick 0 in a block of `bytes` bytes, aligned to 8.  The
 * world reads the pictures of the assets now and keeps no pointer to them.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few
 *  - as tp_scene_check, if the program has it: err->word is the parameter at fault
 *  - TP_E_PROGRAM: the scene has a module on that the program lists as lacking; err->word
 *    is its name, as `tidepool bake --with` takes it.  Fast stages count only if
 *    quality.shading names them: otherwise exact stages are used
 *  - TP_E_ARG: the picture of "floor.map" has a side of 0 or of more than 4096 pixels */
tp_status tp_world_init(const tp_program *program, tp_world *world, size_t bytes,
                        const tp_scene *scene, const tp_assets *assets, tp_error *err);

/* True if a world has the layout of the machines that bake: 64-bit numbers aligned to 8, low
 * byte first. */
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
struct tp_world_number { char byte; int64_t number; };
#define TP_WORLD_IS_BAKED (offsetof(struct tp_world_number, number) == 8)
#else
#define TP_WORLD_IS_BAKED 0
#endif

/* The world of a scene at tick 0 as a constant, made by `tidepool bake`.  NAME_world_init of
 * a baked file copies it, without the code that makes worlds; so does tp_world_init. */
typedef struct {
    const tp_scene *scene;
    const uint32_t *words;
    size_t          bytes;
} tp_baked_world;

/* Checks `bytes` bytes from outside, for example from a file, aligned to 8: can they be
 * stepped and drawn as a world?  `fresh` is a world of the same scene, assets and program,
 * just made by tp_world_init or changed by tp_world_apply.  Version, layout and all values
 * that follow from the scene must be equal; values that ticks change must be within the
 * ranges of a stepped world.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument
 *  - TP_E_WORLD: err->word names the part at fault */
tp_status tp_world_check(const tp_program *program, const tp_world *world, size_t bytes,
                         const tp_world *fresh, tp_error *err);

/* Advances the world by one tick.  `input` may be NULL.  After a change of the scene's
 * numbers call tp_world_apply first.  Returns the name of a part that the input needs and
 * the program lacks: "steering" if the input moves the camera or the clock; then they stay.
 * NULL: the program lacks none. */
const char *tp_world_step(const tp_program *program, tp_world *world,
                          const tp_scene *scene, const tp_input *input);

/* Pushes the water at (x, z), m, at once.  Call between ticks, any number of times.
 *  - In the pool, else in the field: a splash `height` m high or deep and `radius` m
 *    wide, at least 1.5 cells, that adds no volume.  A push of pool.splash_width has the
 *    same bits as the same tp_input.push in the next tick, unless drops or a boat affect
 *    the pool in that tick.
 *  - On open water, if drops raise rings (drops.target = rings): a ring that begins with a
 *  crest
 *    of |height| m, at most 4 m, and a length of 4 radii; a radius is at most 16 m.  The
 *    ring makes foam if the scene has foam, and is visible after the next tick.
 * Returns false if no water moves: neither pool nor rings exist at this position, or a
 * wall stands there; the position is more than 9000 m from the origin; no ring is free; or
 * the height is 0.  `scene` is the scene that the world was made for, or that was applied
 * last. */
bool tp_world_push(const tp_program *program, tp_world *world, const tp_scene *scene,
                   tp_fx x, tp_fx z, tp_fx radius, tp_fx height);

/* Places the camera in the world: the eye in metres, each axis clamped to +-8000 m, and
 * three angles of any size: heading clockwise from -z as seen from above, pitch upwards,
 * and roll, which lowers the picture's right side.  The next picture uses exactly this
 * camera.  Afterwards input moves the camera as before, and tilts it to 89 degrees at most.
 *
 * In a scene whose camera follows the boat, following ends: the camera stays in the world
 * until tp_world_reset_camera, or until camera.follow was none in one tp_world_apply and
 * is boat in a later call. */
void tp_world_set_camera(tp_world *world, tp_vec3 eye, tp_turn heading, tp_turn pitch,
                         tp_turn roll);

/* Places the camera as the scene does at tick 0, following the boat if the scene does. */
void tp_world_reset_camera(tp_world *world, const tp_scene *scene);

/* Applies changed numbers of the scene, at the same tick.  Returns false and changes
 * nothing if the scene needs a block of another size or cannot be used; call tp_world_init
 * to make the world again or to learn the fault.  Do not step or draw with a refused
 * scene.
 *
 * Tables that take long to compute (waves over a floor, automatic exposure) are computed
 * again only if their own numbers changed.  Hence `assets` must hold the pictures that the
 * world was made with. */
bool tp_world_apply(const tp_program *program, tp_world *world, const tp_scene *scene,
                    const tp_assets *assets);

/* A camera: the eye, m, and the rotation from world to view.  The rows are the directions
 * right, up and backward. */
typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
} tp_camera;

/* Returns the camera of the next picture, also if the camera stands on the boat. */
tp_camera tp_world_camera(const tp_world *world);

/* Advances the clock by one picture, 1/60 s times clock.scale.  Returns the number of
 * ticks to step before the next picture, 0 in slow motion; the picture is interpolated
 * between the last two ticks. */
uint32_t tp_world_advance_clock(tp_world *world);

/* Returns the number of ticks since tp_world_init. */
uint64_t tp_world_tick(const tp_world *world);

/* The water at a position. */
typedef struct {
    tp_fx height;           /* m above the level of still water */
    tp_fx slope_x, slope_z; /* dy/dx and dy/dz */
    tp_vec3 velocity;       /* velocity of the surface point, m/s: see tp_world_sample */
} tp_water;

/* Samples the water above or below (x, z), m, after the last tick [E1]: waves, rings and
 * pools together, without overhangs.  No picture and no camera is needed.
 *
 * Waves displace points sideways: the point above (x, z) is found by inversion.  Within 30
 * km of the origin and with a steepness sum below 0.9 the error is below 1 mm.  Every x
 * and z has a result; near the ends of 16.16 a position is clamped.
 *
 * The velocity is the mean over the last tick, the velocity of 1/120 s ago: a drifting
 * object that uses it follows the waves.  Waves move a point along all three axes; rings
 * and pools move it up and down.  Rounding errors are 3 mm/s, and 1 mm/s more for each
 * metre of the sum of the waves' amplitudes. */
tp_water tp_world_sample(const tp_program *program, const tp_world *world, tp_fx x,
                         tp_fx z);

TP_END_C
#endif
