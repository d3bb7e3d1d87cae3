/* SPDX-License-Identifier: MIT */
/* The preview's texts about a loaded scene: memory, plan, state. */
#ifndef TP_APP_SESSION_PERFORMANCE_TEXTS_H
#define TP_APP_SESSION_PERFORMANCE_TEXTS_H
#include "app/scene/frame_governor.h"
#include "app/scene/plan_sheet.h"
#include "performance.h"

/* The last plan, and the scene and size for which it was made.  A plan takes up to 10 ms,
 * and depends only on the scene and the size of the picture.  Initially all 0. */
typedef struct {
    bool       made;
    uint32_t   width, height;
    tp_scene   scene;
    plan_sheet sheet;
} performance_plan;

/* Updates the memory by use, the plan with the rungs drawn now, and the line of the graph,
 * which is the governor's limit if there is one.  To call a few times a second. */
void performance_describe_scene(performance *f, performance_plan *kept,
                                const loaded_scene *s, const frame_governor *g);

/* Updates tick, clock and camera; `more` is appended, "": nothing. */
void performance_describe_world(performance *f, const loaded_scene *s, const char *more);
#endif
