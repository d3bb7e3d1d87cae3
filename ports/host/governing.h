/* SPDX-License-Identifier: MIT */
/* quality.frame_ms held by the clock: feeds the core's governor, says each step. */
#ifndef HOST_GOVERNING_H
#define HOST_GOVERNING_H
#include "scene/plan.h"
#include "stage.h"

typedef struct {
    tp_governor governor;
    tp_frame   *frame;
} governing;

/* Of the stage's canvas as it is now; begin anew after that has changed. */
void governing_begin(governing *g, const stage *s);

/* Frame `number` took so long; the next is drawn accordingly. */
void governing_add(governing *g, uint32_t number, uint64_t us);

/* A rung in words: "half-rate layers". */
const char *governing_word(unsigned kind, tp_rungs rungs);
#endif
