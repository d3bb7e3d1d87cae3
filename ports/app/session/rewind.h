/* SPDX-License-Identifier: MIT */
/* Rewinding: worlds of some pictures and the inputs between them.  Any picture of the last
 * minutes can be restored bit for bit by replaying from the snapshot before it.  Memory is
 * bounded by a budget: older snapshots are thinned first. */
#ifndef TP_APP_SESSION_REWIND_H
#define TP_APP_SESSION_REWIND_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/world.h"

typedef struct rewind_history rewind_history;

rewind_history *rewind_begin(size_t budget);        /* NULL: no memory */
void  rewind_end(rewind_history *p);                /* accepts NULL */

/* To call before the ticks of a picture, with the world and scene at the start and the
 * input of the first tick.  changed: the scene has changed since the last picture, or the
 * world moved without a tick (a look while the water stands still).  Picture numbers
 * increase by one.  A lower number discards that picture and all later ones; a gap discards
 * everything. */
void  rewind_add(rewind_history *p, uint32_t picture, const tp_world *world, size_t bytes,
                 const tp_scene *scene, const tp_input *input, bool changed);

/* Copies the world and scene of the latest snapshot at or before `picture`; *from: number
 * of its picture.  False: no snapshot is that old, or its world has another size. */
bool  rewind_take(const rewind_history *p, uint32_t picture, tp_world *world, size_t bytes,
                  tp_scene *scene, uint32_t *from);

/* Returns the input of a picture, for replay; NULL: not kept. */
const tp_input *rewind_input(const rewind_history *p, uint32_t picture);

/* oldest that can be restored; UINT32_MAX: none */
uint32_t rewind_oldest(const rewind_history *p);
/* for rewind_take; 0: none */
size_t rewind_world_bytes(const rewind_history *p, uint32_t picture);
size_t rewind_bytes(const rewind_history *p);       /* bytes in use, within the budget */
/* to call after the scene's files have changed */
void  rewind_forget(rewind_history *p);
#endif
