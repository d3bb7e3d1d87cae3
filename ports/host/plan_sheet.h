/* SPDX-License-Identifier: MIT */
/* The plan of a stage with the bytes and the words of its rungs, for `tidepool plan` and
 * for the preview's figures. */
#ifndef HOST_PLAN_SHEET_H
#define HOST_PLAN_SHEET_H
#include "scene/plan.h"
#include "stage.h"

typedef struct {
    tp_plan_report report;
    size_t bytes[TP_KINDS][TP_KIND_RUNGS];      /* frame and scratch, with that rung */
} plan_sheet;

/* Takes up to 10 ms. */
plan_sheet plan_sheet_of(const stage *s);

extern const char *const plan_kind[TP_KINDS];   /* "visibility" */
extern const char *const plan_why[];            /* by tp_why */

/* Of rung 0.. of a kind, as scene files have it: "rows". */
void plan_word(int kind, int rung, char word[32]);

/* Rung 0.. of a kind. */
int  plan_rung(tp_rungs rungs, int kind);

/* To two decimals, which is what prices are good for. */
const char *plan_number(tp_fx x, char text[24]);
#endif
