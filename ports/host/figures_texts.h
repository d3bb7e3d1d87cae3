/* SPDX-License-Identifier: MIT */
/* What the preview's figures say of a stage: memory, plan, state. */
#ifndef HOST_FIGURES_TEXTS_H
#define HOST_FIGURES_TEXTS_H
#include "figures.h"
#include "governing.h"
#include "plan_sheet.h"

/* The last plan, and what it is of: it takes up to 10 ms, and changes with the scene and
 * the picture's size alone.  All 0 at first. */
typedef struct {
    bool       made;
    uint32_t   width, height;
    tp_scene   scene;
    plan_sheet sheet;
} figures_plan;

/* Memory by use; the plan with the rungs that are drawn by at this moment, and the line
 * of the graph, which is the governor's if it holds one.  A few times a second. */
void figures_stage(figures *f, figures_plan *kept, const stage *s, const governing *g);

/* Tick, clock and camera; `more` is put after it, "" nothing. */
void figures_world(figures *f, const stage *s, const char *more);
#endif
