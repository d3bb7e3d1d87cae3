/* SPDX-License-Identifier: MIT */
/* The camera's exposure, fixed or automatic.
 *
 *     exposure_drawing.c   the module; selects the stage or the pixel table
 *     exposure_stage.c     the tone mapping curve, and the span stage
 *     meter.c              the module of automatic exposure; see meter.h */
#ifndef TP_EXPOSURE_MODULE_H
#define TP_EXPOSURE_MODULE_H
#include "pixel/toned.h"
#include "scene/module.h"
#include "shade/wide.h"
#include "tidepool/fixed.h"

/* Returns the exposure after one tick of adaptation [F8]: towards 0.5 / mean, within
 * 1/8..8, by the share `rate` (0..1) of the difference.  `mean` is the picture's mean
 * brightness, white is 1; values below 1/16 count as 1/16.  The exposure reaches its
 * target exactly.  All numbers are Q16.16. */
tp_fx tp_exposure_step(tp_fx exposure, tp_fx mean, tp_fx rate);

#define TP_EXPOSURE_ID TP_MODULE_ID('e', 'x', 'p', 'o')

/* Data of the span stage, in tp_run.mine. */
typedef struct {
    tp_entry8 tone[256];        /* tone curve of a channel */
    tp_rgb565_tone_map  tone_map;            /* the same curve for rgb565 pixels */
    tp_fx     made_for;         /* exposure of the tables; 0: none */
} tp_exposure;

/* Fills the tone curve of a channel for an exposure of 1/8..8. */
void tp_exposure_make_tone_curve(tp_entry8 tone[256], tp_fx exposure);
#endif
