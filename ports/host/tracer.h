/* SPDX-License-Identifier: MIT */
/* The reference's picture of one world, drawn in a thread of its own: first with one
 * sample a pixel, so that something is seen soon, then with 4, then with 16. */
#ifndef HOST_TRACER_H
#define HOST_TRACER_H
#include "stage.h"

typedef struct tracer tracer;

/* Of the stage as it is now, whose canvas has just drawn its world; its scene, world and
 * picture are copied, its assets must outlive this.  NULL: no memory, or no thread. */
tracer  *tracer_begin(const stage *s);

/* Gives up what is being drawn; within some ms.  Takes NULL. */
void     tracer_end(tracer *t);

/* The picture that the canvas drew and the reference's with most samples so far, both
 * 0x00RRGGBB row by row.  Returns how many samples a pixel, 0: none yet, nothing done. */
uint32_t tracer_take(tracer *t, uint32_t *ours, uint32_t *theirs);
bool     tracer_has_news(tracer *t);            /* one that was not taken yet */
bool     tracer_is_of(const tracer *t, const tp_world *world);      /* still as it was */

/* The samples a pixel of the one that is being drawn, and how much of it; 0: it is over. */
uint32_t tracer_draws(tracer *t, uint32_t *percent);
#endif
