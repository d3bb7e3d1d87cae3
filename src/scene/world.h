/* SPDX-License-Identifier: MIT */
/* The layout of a world's block; tidepool/world.h has what programs see of it. */
#ifndef TP_SCENE_WORLD_H
#define TP_SCENE_WORLD_H
#include "scene/clock.h"
#include "tidepool/world.h"
#include "wave/wave.h"

/* The layout of a world's block.  It rises when the head or a chunk changes its meaning;
 * a block of another version is refused. */
enum { TP_WORLD_VERSION = 4 };

/* States of modules lie behind this head as chunks: an id, a length, the bytes. */
typedef struct {
    uint32_t version;           /* TP_WORLD_VERSION */
    uint32_t modules;           /* byte offset of the first chunk; 0: there is none */
    uint32_t bytes;             /* of the whole block */
} tp_world_parts;

typedef struct {
    tp_vec3  place;             /* the mesh's origin; 0 in scenes that name no mesh */
    tp_turn  heading, pitch, roll;
} tp_pose;

/* Where a hull lies: in the plane, and the water over its waterline [E4]: in the middle,
 * of the bow over the stern, of port over starboard. */
typedef struct {
    tp_fx    x, z;
    tp_turn  heading;
    tp_fx    sunk[3];
} tp_hull;

/* How a boat lies: three lengths in Q40 m, the height of its waterline, of its bow over
 * its stern, of its port over its starboard side; and how they change, a tick, if it
 * floats. */
typedef struct { int64_t at[3], speed[3]; } tp_lie;

/* What of a boat moves. */
typedef struct {
    int64_t  sailed_x, sailed_z;    /* Q32 m from the scene's place */
    uint64_t turned;                /* Q64 turn from the scene's heading */
    tp_lie   lie, alone;        /* alone: as if the pool that it stirs were not there */
    tp_fx    rest[4][2];        /* of bow, stern, port and starboard in the water [E1] */
    tp_hull  hull, stirred;     /* now, and when it last stirred the pool [E4] */
    uint32_t laid;              /* 1: it has been laid on the water */
    uint32_t stirs;             /* ticks in which it stirred the pool, so far */
} tp_afloat;

/* Where the camera of a world stands. */
typedef enum {
    TP_ABOARD_NOT,  /* in the world: the scene's camera follows nothing */
    TP_ABOARD_DECK, /* on the boat: its place and angles are of the deck */
    TP_ABOARD_LEFT  /* in the world: tp_world_set_camera ended the following */
} tp_aboard;

struct tp_world {
    uint64_t tick;
    tp_fx    back;              /* 0..1: the picture lies so much of a tick before */
    tp_world_parts parts;
    tp_vec3  eye, last_eye;     /* the camera now and a tick ago, see aboard */
    tp_turn heading, pitch, roll, last_heading, last_pitch, last_roll;
    tp_turn  phases[TP_WAVES];  /* of this tick */
    uint32_t random;            /* of pokes */
    tp_pose  boat, last_boat;
    tp_afloat afloat;           /* the boat's */
    tp_turn  light_heading, light_elevation;    /* as input has moved it, and time */
    tp_turn  last_light_heading, last_light_elevation;
    tp_fx    scene_light[2];    /* heading and elevation of the scene, last looked at */
    tp_fx    exposure, last_exposure;
    tp_clock clock;
    tp_fx    clock_scale;       /* the scene's, when it was last looked at */
    uint32_t aboard;            /* tp_aboard */
    tp_sea sea;                 /* the last, without its swells if the program has none */
};

/* Moves the camera alone, while the water stands. */
void tp_world_move_camera(tp_world *world, const tp_input *input);

/* The middle of a pixel's column or row, 16.16; -32768 <= pixel < 32768. */
static inline tp_fx tp_pixel_middle(int32_t pixel)
{
    return pixel * TP_FX_ONE + TP_FX_ONE / 2;
}

/* The place on the water under a place of a picture of width x height pixels, 1..8192
 * each: x_px and y_px pixels, 16.16, from its upper left corner; see tp_pixel_middle.  The
 * ray through it first meets the surface at *at: waves, rings and pools, these without
 * heights where they bend the light only; from below the surface as well.  It is within
 * 1 px of what is drawn there, but for crests that overhang and for what lies at a mesh's
 * far end, where its waves fade.  A place outside of the picture is one of a larger one.
 * False: the ray does not meet water within 8000 m, or meets land first, or a tank's walls
 * end before. */
bool tp_world_pick(const tp_program *program, const tp_world *world,
                   const tp_scene *scene, uint32_t width, uint32_t height, tp_fx x_px,
                   tp_fx y_px, tp_vec3 *at);
#endif
