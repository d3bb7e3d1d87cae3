/* SPDX-License-Identifier: MIT */
/*
 * The layout of a world's block; tidepool/world.h has the public part.  The clock comes
 * first, then the head of the block, then the state of the world at the time of a frame.
 */
#ifndef TP_WORLD_WORLD_H
#define TP_WORLD_WORLD_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/fixed.h"
#include "tidepool/world.h"
#include "waves/deep_water.h"

/* -- the clock ----------------------------------------------------------------------- */

/* Slow motion and fast forward; the time scale changes continuously [D6].
 *
 * Each frame advances the clock by `scale` ticks, and the scale approaches its target: s
 * += (s* - s)(1 - exp(-dt / tau)), tau = 0.4 s, dt = 1/60 s.  The simulation steps whole
 * ticks only, so a recorded input replays bit for bit.  The fraction of a tick is used
 * for interpolation when drawing. */

#define TP_CLOCK_SLOWEST (TP_FX_ONE / 8)
#define TP_CLOCK_FASTEST (4 * TP_FX_ONE)

typedef struct {
    int64_t  scale_q40;     /* s; 40 fraction bits keep small steps */
    uint64_t ticks;         /* whole ticks in the sum of s */
    int64_t  fraction_q40;  /* fraction of the sum, 0..1 */
    tp_fx    target;        /* s*, clamped to 1/8..4 */
    int32_t  zero;          /* padding; equal clocks are equal byte by byte */
} tp_clock;

/* Starts at tick 0; clamps scale and target to TP_CLOCK_SLOWEST..TP_CLOCK_FASTEST. */
void tp_clock_init(tp_clock *clock, tp_fx scale);
void tp_clock_set_target(tp_clock *clock, tp_fx target);       /* clamps `target` */

/* Moves the target by `halvings` along the scales 1/8, 1/4 .. 4: +1 halves the target, -1
 * doubles the target. */
void tp_clock_shift_target(tp_clock *clock, int32_t halvings);

/* True if scale, target and part are in their ranges.  Use: the bytes of `clock` come
 * from outside the program. */
bool tp_clock_is_valid(const tp_clock *clock);

/* Advances by one frame: first updates the scale, then adds the scale to the time. */
void tp_clock_advance(tp_clock *clock);

tp_fx    tp_clock_scale(const tp_clock *clock);     /* s: ticks per frame */
uint64_t tp_clock_ticks(const tp_clock *clock);     /* whole ticks so far */
tp_fx    tp_clock_fraction(const tp_clock *clock);  /* rest of a tick, 0 <= f < 1 */

/* -- the block ----------------------------------------------------------------------- */

/* Version of the layout.  The version increases when the head or a chunk changes its
 * meaning; a block with another version is refused. */
enum { TP_WORLD_VERSION = 6 };

/* Module states follow this head as chunks: an id, a length, the bytes. */
typedef struct {
    uint32_t version;           /* TP_WORLD_VERSION */
    uint32_t modules;           /* byte offset of the first chunk; 0: no chunk */
    uint32_t bytes;             /* size of the whole block in bytes */
} tp_world_layout;

typedef struct {
    tp_vec3  place;             /* position of the mesh's origin, m; 0 without a mesh */
    tp_turn  heading, pitch, roll;
} tp_pose;

/* Hull pose in the plane, and immersion relative to the waterline [E4], m: amidships, bow
 * minus stern, port minus starboard. */
typedef struct {
    tp_fx    x, z;
    tp_turn  heading;
    tp_fx    immersion[3];
} tp_hull;

/* Boat attitude, three lengths in Q40 m: height of the waterline, bow minus stern, port
 * minus starboard; and for a floating boat their change per tick. */
typedef struct { int64_t at[3], speed[3]; } tp_boat_attitude;

/* The moving state of a boat. */
typedef struct {
    int64_t  sailed_x, sailed_z;    /* distance from the scene's position, Q32 m */
    uint64_t turned;                /* turn from the scene's heading, Q64 turn */
    tp_boat_attitude attitude,
        without_pool;           /* alone: attitude without the pool that the boat stirs */
    tp_fx    rest[4][2];        /* rest positions of bow, stern, port, starboard [E1] */
    tp_hull  hull, wake_hull; /* hull now, and at its last disturbance of the pool [E4] */
    uint32_t placed;         /* 1: the boat has been placed on the water */
    uint32_t wake_ticks;     /* number of ticks so far that disturbed the pool */
} tp_boat_state;

/* The frame of reference of a world's camera. */
typedef enum {
    TP_ABOARD_NOT,  /* world axes: the scene's camera follows nothing */
    TP_ABOARD_DECK, /* on the boat: position and angles are relative to the deck */
    TP_ABOARD_LEFT  /* world axes: tp_world_set_camera ended the following */
} tp_aboard;

struct tp_world {
    uint64_t tick;
    tp_fx    lag;               /* time of the picture before the last tick, 0..1 tick */
    tp_world_layout layout;
    tp_vec3  eye, last_eye;     /* camera position now and a tick ago; axes by `aboard` */
    tp_turn  heading, pitch, roll, last_heading, last_pitch, last_roll;
    tp_turn  phases[TP_WAVES];  /* phases of the waves at this tick; phases between ticks
                                 * are computed from the time (tp_drawn) */
    uint32_t random;            /* random state of the pokes */
    tp_pose  boat, last_boat;
    tp_boat_state boat_state;   /* state of the boat */
    tp_turn  light_heading, light_elevation;    /* light as moved by input and time */
    tp_turn  last_light_heading, last_light_elevation;
    tp_fx    scene_light[2];    /* last seen heading and elevation of the scene */
    tp_fx    exposure, last_exposure;
    tp_clock clock;
    tp_fx    clock_scale;       /* last seen scale of the scene */
    uint32_t aboard;            /* a tp_aboard */
    tp_deep_water deep;         /* last member; without swells if the program has none */
};

/* Moves the camera only; the water does not move. */
void tp_world_move_camera(tp_world *world, const tp_input *input);

/* Returns the centre of a pixel's column or row, Q16.16 px; -32768 <= pixel < 32768. */
static inline tp_fx tp_pixel_middle(int32_t pixel)
{
    return pixel * TP_FX_ONE + TP_FX_ONE / 2;
}

/* Finds the water surface under a point of a picture of width x height pixels, 1..8192
 * each. x_px and y_px: px, Q16.16, from the upper left corner; see tp_pixel_middle. *at:
 * first intersection of the ray with the surface, including waves, rings and pools, also
 * from below the surface; at the side of a pool it may lie on the step between two
 * heights.  Pools drawn as slopes have no height here.  The result is
 * within 1 px of the drawn picture, except at overhanging crests and at the far end of a
 * mesh, where its waves fade.  A point outside the picture counts as a point of a larger
 * picture.  False: the ray does not meet water within 8000 m, meets land first, or leaves
 * the walls of the tank first. */
bool tp_world_pick(const tp_program *program, const tp_world *world,
                   const tp_scene *scene, uint32_t width, uint32_t height, tp_fx x_px,
                   tp_fx y_px, tp_vec3 *at);

/* -- the drawn moment ---------------------------------------------------------------- */

/* The state of the world at the time of a frame: world->lag of a tick before the last
 * tick.  Wave phases are evaluated at that time; stepped quantities are interpolated
 * between the last two ticks. */

typedef struct {
    tp_camera camera;           /* in world axes, even if the camera moves with the boat */
    tp_turn phases[TP_WAVES];
    tp_pose boat;
    tp_turn light_heading, light_elevation;
    tp_fx   exposure;
    int64_t time;               /* time in ticks x 65536 */
} tp_drawn;

tp_drawn tp_world_interpolate(const tp_world *world);

/* The same for a picture by a program, whose module `hull` carries the camera of a deck. */
tp_drawn tp_program_interpolate(const tp_program *program, const tp_world *world);
void tp_camera_carry(const tp_world *world, tp_fx lag, tp_camera *camera);

/* Moves the camera and the clock by the input of a tick. */
struct tp_steering {
    void (*steer)(tp_world *world, const tp_input *input);
};

/* Returns the camera in world axes at `lag` of a tick before the last tick. */
tp_camera tp_camera_interpolate(const tp_world *world, tp_fx lag);

/* True if the camera of a world is at a valid position.  Use: the bytes of `world` come
 * from outside the program.  Defined in world.c. */
bool tp_camera_is_valid(const tp_world *world);

/* Interpolates linearly: returns `now` for lag = 0, `last` for lag = 1. */
static inline tp_fx tp_interpolate(tp_fx last, tp_fx now, tp_fx lag)
{
    return now + (tp_fx)(((int64_t)last - now) * lag >> 16);
}

static inline tp_vec3 tp_position_interpolate(tp_vec3 last, tp_vec3 now, tp_fx lag)
{
    return (tp_vec3){ tp_interpolate(last.x, now.x, lag),
                      tp_interpolate(last.y, now.y, lag),
                      tp_interpolate(last.z, now.z, lag) };
}

#endif
