/* SPDX-License-Identifier: MIT */
/* What was: worlds of every so many pictures and the inputs between them, so that any
 * picture of the last minutes can be had again, bit for bit, by replaying from the
 * snapshot before it.  Within a budget of bytes: older snapshots are thinned first. */
#ifndef HOST_PAST_H
#define HOST_PAST_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/world.h"

typedef struct past past;

past *past_begin(size_t budget);        /* NULL: no memory */
void  past_end(past *p);                /* NULL is taken */

/* Before the ticks of a picture are made: the world and scene they start from, and the
 * input that the first of them takes.  `changed`: the scene has changed since the last
 * picture, or the world moved without a tick (a look while it stands).  Pictures rise
 * by one; a lower number cuts off that picture and what came after it, one that leaves
 * some out all there was. */
void  past_add(past *p, uint32_t picture, const tp_world *world, size_t bytes,
               const tp_scene *scene, const tp_input *input, bool changed);

/* The world and scene at the latest snapshot that is not after `picture`; *from is its
 * number.  False: there is none that old, or its world has not `bytes`. */
bool  past_take(const past *p, uint32_t picture, tp_world *world, size_t bytes,
                tp_scene *scene, uint32_t *from);

/* The input of a picture, for replaying; NULL: not kept. */
const tp_input *past_input(const past *p, uint32_t picture);

uint32_t past_oldest(const past *p);    /* picture that can be had; UINT32_MAX: none */
size_t past_world_bytes(const past *p, uint32_t picture);   /* that past_take wants; 0 */
size_t past_bytes(const past *p);       /* held now, within the budget */
void  past_forget(past *p);             /* the scene's files have changed */
#endif
