/* SPDX-License-Identifier: MIT */
/* Holds quality.frame_ms by the clock: feeds the core's governor, draws with the set of its
 * step, and prints each step.  A scene with a board has no governor: its picture is the
 * board's. */
#ifndef TP_APP_SCENE_FRAME_GOVERNOR_H
#define TP_APP_SCENE_FRAME_GOVERNOR_H
#include "loaded_scene.h"
#include "quality/plan.h"

typedef struct {
    tp_governor   governor;
    tp_set_walk   walk;         /* from the plan's set to cheaper ones */
    loaded_scene *scene;
} frame_governor;

/* Begins with the loaded scene's frame renderer; to call again after the frame renderer has
 * changed. */
void frame_governor_begin(frame_governor *g, loaded_scene *s);

/* True if the governor may step. */
bool frame_governor_is_active(const frame_governor *g);

/* Reports the time of frame `number`, us; sets the rungs of the next frame. */
void frame_governor_add_time(frame_governor *g, uint32_t number, uint64_t us);
#endif
