/* SPDX-License-Identifier: MIT */
/* The quality plan of a loaded scene with the bytes and the names of its rungs, for
 * `tidepool plan` and for the preview's figures. */
#ifndef TP_APP_SCENE_PLAN_SHEET_H
#define TP_APP_SCENE_PLAN_SHEET_H
#include "loaded_scene.h"
#include "quality/plan.h"

typedef struct {
    tp_plan_report report;
    size_t bytes[TP_KINDS][TP_KIND_RUNGS];      /* frame and scratch with the rung, bytes */
} plan_sheet;

/* Makes the plan; takes up to 10 ms. */
plan_sheet plan_sheet_make(const loaded_scene *s);

extern const char *const plan_kind[TP_KINDS];   /* "visibility", "shading", "rate" */
extern const char *const plan_why[];            /* reasons in words, indexed by tp_why */

/* Writes the name of rung 0.. of a kind as in scene files: "rows". */
void plan_word(int kind, int rung, char word[32]);

/* Returns the rung, 0.., of a kind. */
int  plan_rung(tp_rungs rungs, int kind);

/* Writes a number with two decimals, the precision of costs. */
const char *plan_number(tp_fx x, char text[24]);
#endif
