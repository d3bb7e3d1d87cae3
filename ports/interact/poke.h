/* SPDX-License-Identifier: MIT */
/* Pokes and stirs of the pool.  A scene without a pool pokes its field at the same
 * points, but no world accepts such an input yet (tidepool/scene.h).
 *
 * No poke is lost while the queue has room.  A tick takes up to TP_PUSHES pokes in
 * order; the others wait for later ticks.  A stir is the path of a mouse or a finger.
 * The strength of a stir per tick, a third of a poke, is divided among the points since
 * the last tick: a device with more reports per second stirs no more. */
#ifndef TP_INTERACT_POKE_H
#define TP_INTERACT_POKE_H
#include "tidepool/world.h"

#define POKE_POINTS 6           /* fixed points for pokes: two rows of three, the layout of
                                 * the Czech report */
#define POKE_WAITS  64          /* most waiting pokes */
#define POKE_PATH   32          /* most points of a path */

/* Returns a poke at fixed point 0..5 of the scene's pool (or field): 0 far left ... 5 near
 * right, seen from the scene's south, at a quarter of a side from the edges.  The height is
 * 0 for another number, or for a scene without pool and field. */
tp_push poke_point(const tp_scene *scene, uint32_t number);

/* Returns a poke at (x, z), m; height 0 without pool and field. */
tp_push poke_make_push(const tp_scene *scene, tp_fx x, tp_fx z);

/* Adds a poke to an input.  Returns false if the input has no free place. */
bool poke_put(tp_input *input, const tp_push *push);

/* Starts as all 0. */
typedef struct {
    tp_push  waits[POKE_WAITS];         /* a ring: waits[(first + i) % POKE_WAITS] */
    uint32_t first, count;
    struct { tp_fx x, z; } path[POKE_PATH];
    uint32_t places;
} poke_queue;

/* Queues a poke.  Returns false if the queue is full; the poke is then lost. */
bool poke_add(poke_queue *queue, const tp_push *push);

/* Adds a point to the path.  If the path is full, its last point is replaced. */
void poke_stir(poke_queue *queue, tp_fx x, tp_fx z);

/* Moves pokes, then the path, to a tick's input, as far as there is room. */
void poke_take(poke_queue *queue, const tp_scene *scene, tp_input *input);
#endif
