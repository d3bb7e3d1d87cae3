/* SPDX-License-Identifier: MIT */
/* Foam: a field of cover, a byte a cell, over the places at rest: so it goes with the water
 * that waves displace.  Its cells lie on an endless lattice that drifts as the scene says;
 * the field is a window on it, cells x cells, around the pool or the eye, and is stored as a
 * torus: cell (i, j) of the lattice lies at column i mod cells, row j mod cells, wherever
 * the window is.
 *
 *     foam.c          the module: when it is on, its window, fading and drift
 *     foam_sources.c  what makes foam in a tick
 *     foam_drawing.c  the numbers of a picture
 *     foam_stage.c    its span stages */
#ifndef TP_FOAM_MODULE_H
#define TP_FOAM_MODULE_H
#include "pool/pool.h"
#include "scene/module.h"
#include "wave/ocean.h"

#define TP_FOAM_TICKS 4         /* a quarter of the rows is looked after in each tick */

/* Plain data without pointers; the cells' bytes follow this head, row by row. */
typedef struct {
    uint32_t cells;             /* of a side, 1..256 */
    tp_fx    cell;              /* m */
    int64_t  drift_x, drift_z;  /* Q32 m, 0 to a side: of the lattice's origin */
    int32_t  first_x, first_z;  /* the window's lowest lattice cell */
    int32_t  seen[TP_FOAM_TICKS][2];    /* the same when a quarter was last visited */
    uint32_t visits;            /* ticks so far */
    uint32_t work;              /* byte offset of a row's places, 0: none */
} tp_foam;

/* Cover 0..255 at a place at rest, bilinear between cells' centres; 0 outside. */
uint8_t tp_foam_at(const tp_foam *foam, tp_fx x, tp_fx z);

const tp_foam  *tp_world_foam(const tp_world *world);

#define TP_FOAM_ID TP_MODULE_ID('f', 'o', 'a', 'm')

/* The module's state in a world, or NULL. */
static inline tp_foam *tp_foam_of_world(const tp_world *world)
{
    return tp_world_part(world, TP_FOAM_ID);
}

/* One tick, after all else has moved. */
void tp_foam_step(tp_foam *foam, const tp_world *world, const tp_scene *scene);

/* Adds a blob of `radius` m around a place: `cover` 0..255 in its middle. */
void tp_foam_blob(tp_foam *foam, tp_fx x, tp_fx z, tp_fx radius, uint32_t cover);

static inline uint8_t *tp_foam_cover(tp_foam *foam)
{
    return (uint8_t *)(foam + 1);
}

/* i mod n of any sign. */
static inline uint32_t tp_foam_mod(int32_t i, uint32_t n)
{
    int32_t m = i % (int32_t)n;
    return (uint32_t)(m < 0 ? m + (int32_t)n : m);
}

/* -- foam_sources.c ------------------------------------------------------------------ */

/* A boat's hull over places at rest: alpha from stern -1 to bow 1, beta to starboard. */
typedef struct {
    tp_fx x, z, reach;          /* its middle; no foam of it lies farther */
    tp_fx along[2], across[2];  /* alpha and beta a metre */
    tp_fx length, beam;         /* half of them */
    tp_fx pace;                 /* -1..1: how fast it goes ahead */
} tp_foam_hull;

/* The sources of foam in this tick, and the row that is asked for. */
typedef struct {
    const tp_world *world;
    const tp_scene *scene;
    const tp_ocean *ocean;
    const tp_pool  *pool;       /* with walls that count */
    tp_foam *foam;
    tp_fx    z;                 /* of the row, by the caller */
    tp_vec3  left;              /* ocean: place of the last cell asked for */
    tp_fx    per_cell, per_shore, deep, per_deep;
    int64_t  per_lsb;           /* m/s of a pool's LSB, Q32 */
    bool     has_hull;
    tp_foam_hull hull;
} tp_foam_maker;

#define TP_FOAM_DRY UINT32_MAX

void tp_foam_maker_begin(tp_foam_maker *m, tp_foam *foam, const tp_world *world,
                         const tp_scene *scene);

/* Over an ocean: call it for each cell of the row at m->z before that row is asked for,
 * unless the row before was its neighbour at z - cell. */
void tp_foam_maker_above(tp_foam_maker *m, uint32_t col, tp_fx x);

/* The cover that the cell at x gains in TP_FOAM_TICKS ticks, 1/256 of a byte's units, below
 * 2^16; TP_FOAM_DRY: the cell is dry.  Ask for cells of a row in order of columns; `joined`:
 * the last cell was the neighbour at x - cell. */
uint32_t tp_foam_maker_gain(tp_foam_maker *m, uint32_t col, tp_fx x, bool joined);
#endif
