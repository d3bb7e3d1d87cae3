/* SPDX-License-Identifier: MIT */
/* Pokes and stirs of the pool.  Without a pool, of the field: that is where it would be
 * poked, but no world takes such an input yet (tidepool/scene.h).
 *
 * Every poke acts.  A tick takes TP_PUSHES of them in their order; the others wait for the
 * next ticks in a queue, as do all while no tick is made.  A stir is the path of a mouse or
 * a finger: what it puts into a tick, a third of a poke, is shared among the places that
 * the path has passed since the last one, so that a device that reports more often stirs
 * no more. */
#ifndef LIVE_POKE_H
#define LIVE_POKE_H
#include "tidepool/world.h"

#define POKE_POINTS 6           /* of the Czech report: two rows of three */
#define POKE_WAITS  64          /* pokes that may wait */
#define POKE_PATH   32          /* places of a path that are kept */

/* Poke number 0..5 of the scene's pool (or field): far left ... near right, as seen from
 * the scene's south, a quarter of a side from the edges.  Of another number, or a scene
 * without either, the height is 0. */
tp_push poke_point(const tp_scene *scene, uint32_t number);

/* A poke at a place, likewise. */
tp_push poke_at(const tp_scene *scene, tp_fx x, tp_fx z);

/* Into the first free place of an input; false: it has none, and nothing is done. */
bool poke_put(tp_input *input, const tp_push *push);

/* Begins all 0. */
typedef struct {
    tp_push  waits[POKE_WAITS];         /* a ring: waits[(first + i) % POKE_WAITS] */
    uint32_t first, count;
    struct { tp_fx x, z; } path[POKE_PATH];
    uint32_t places;
} poke_queue;

/* False: so many wait already that it is lost. */
bool poke_add(poke_queue *queue, const tp_push *push);

/* One place farther on the path; of one that is longer than is kept the end moves on. */
void poke_stir(poke_queue *queue, tp_fx x, tp_fx z);

/* Moves to the input of a tick what it has room for: pokes first, then the path. */
void poke_take(poke_queue *queue, const tp_scene *scene, tp_input *input);
#endif
