/* SPDX-License-Identifier: MIT */
/* Holds quality.frame_ms by the clock: feeds the core's governor and prints each step. */
#ifndef TP_APP_SCENE_FRAME_GOVERNOR_H
#define TP_APP_SCENE_FRAME_GOVERNOR_H
#include "loaded_scene.h"
#include "quality/plan.h"

typedef struct {
    tp_governor governor;
    tp_frame   *frame;
} frame_governor;

/* Begins with the loaded scene's frame renderer; to call again after the frame renderer has
 * changed. */
void frame_governor_begin(frame_governor *g, const loaded_scene *s);

/* Reports the time of frame `number`, us; sets the rungs of the next frame. */
void frame_governor_add_time(frame_governor *g, uint32_t number, uint64_t us);

/* Returns a rung in words: "half-rate layers". */
const char *frame_governor_rung_name(unsigned kind, tp_rungs rungs);
#endif
