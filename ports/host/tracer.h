/* SPDX-License-Identifier: MIT */
/* The reference's picture of one world, drawn in a thread of its own: first with one
 * sample a pixel, then with 4, then with 16; and before them, if it is wanted, with one
 * for each 4x4 pixels, which takes a sixteenth of the time. */
#ifndef HOST_TRACER_H
#define HOST_TRACER_H
#include "stage.h"

typedef struct tracer tracer;

/* Of the stage as it is now, whose canvas has just drawn its world; its scene, world and
 * picture are copied, its assets must outlive this.  NULL: no memory, or no thread. */
tracer  *tracer_begin(const stage *s, bool coarse);

/* Gives up what is being drawn; within some ms.  Takes NULL. */
void     tracer_end(tracer *t);

/* What has been drawn, and what is being drawn. */
typedef enum { TRACER_NONE, TRACER_COARSE, TRACER_1, TRACER_4, TRACER_16 } tracer_pass;

/* The picture that the canvas drew and the reference's by the last pass so far, both
 * 0x00RRGGBB row by row.  NONE: nothing yet, and nothing done. */
tracer_pass tracer_take(tracer *t, uint32_t *ours, uint32_t *theirs);
bool     tracer_has_news(tracer *t);            /* one that was not taken yet */
bool     tracer_is_of(const tracer *t, const tp_world *world);      /* still as it was */

/* The pass that is being drawn, and how much of it; NONE: it is over. */
tracer_pass tracer_draws(tracer *t, uint32_t *percent);
#endif
