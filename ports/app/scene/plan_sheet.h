/* SPDX-License-Identifier: MIT */
/* The quality plan of a loaded scene with its reasons, and the steps below it, for
 * `tidepool plan` and for the preview's figures. */
#ifndef TP_APP_SCENE_PLAN_SHEET_H
#define TP_APP_SCENE_PLAN_SHEET_H
#include "loaded_scene.h"
#include "quality/plan.h"

#define WORD_BYTES 32

typedef struct {
    tp_plan      plan;
    bool         real_time;     /* the board keeps the time of the frame, if one is named */
    tp_set_price exact;         /* of the picture with exact rungs only */
    tp_view_costs view;
    tp_set_walk  walk;          /* from the plan's set to cheaper ones */
} plan_sheet;

/* A kind's part in a plan. */
typedef struct {
    char   word[WORD_BYTES];    /* the rung, as in scene files: "nearest" */
    bool   named;               /* by the scene, not chosen by the plan */
    double saves;               /* instructions beside the kind's exact rung */
    double adds;                /* error beyond that rung, rms of 255 */
} plan_kind;

/* Makes the plan of the scene as it is drawn; takes up to 10 ms. */
void plan_sheet_make(plan_sheet *p, const loaded_scene *s);

/* Makes the walk of sets from a scene's plan to cheaper ones; the mesh stays. */
void plan_sheet_make_walk(tp_set_walk *walk, const loaded_scene *s);

plan_kind plan_sheet_kind(const plan_sheet *p, const tp_scene *scene, int kind);

/* Returns the error of a price, rms of 255. */
double plan_error(tp_set_price price);

/* Writes the rows by which two sets differ, as "quality.foam=fast mirror.size=quarter". */
void plan_write_changes(const tp_scene *scene, const tp_rung_set *from,
                        const tp_rung_set *to, char *text, size_t bytes);
#endif
