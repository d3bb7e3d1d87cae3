/* SPDX-License-Identifier: MIT */
/* The reference's picture of one world, drawn on a thread of its own: with 1 sample per
 * pixel, then with 4, then with 16.  Optionally preceded by a pass with 1 sample per 4x4
 * pixels, in a sixteenth of the time. */
#ifndef HOST_TRACER_H
#define HOST_TRACER_H
#include "stage.h"

typedef struct tracer tracer;

/* Begins with the current stage, whose canvas has just drawn its world.  Scene, world and
 * picture are copied; the assets must outlive the tracer.  NULL: no memory, or no
 * thread. */
tracer  *tracer_begin(const stage *s, bool coarse);

/* Stops drawing and ends the thread within some ms.  Accepts NULL. */
void     tracer_end(tracer *t);

/* Passes of the reference, in order. */
typedef enum { TRACER_NONE, TRACER_COARSE, TRACER_1, TRACER_4, TRACER_16 } tracer_pass;

/* Copies the canvas's picture and the reference's picture of the last finished pass, both
 * 0x00RRGGBB row by row.  Returns the pass; TRACER_NONE: none finished, nothing copied. */
tracer_pass tracer_take(tracer *t, uint32_t *ours, uint32_t *theirs);
bool     tracer_has_news(tracer *t);            /* true if a picture is not taken yet */
bool tracer_has_same_world(const tracer *t, const tp_world *world); /* true if equal */

/* Returns the pass in progress, and its percentage; TRACER_NONE: all passes are
 * finished. */
tracer_pass tracer_draws(tracer *t, uint32_t *percent);
#endif
