/* SPDX-License-Identifier: MIT */
/* The camera's exposure, fixed or automatic.
 *
 *     exposure_drawing.c   the module, and when pixels are exposed
 *     exposure_stage.c     its tones, and the span stage
 *     meter.c              the module of automatic exposure; see meter.h */
#ifndef TP_EXPOSURE_MODULE_H
#define TP_EXPOSURE_MODULE_H
#include "pixel/toned.h"
#include "scene/module.h"
#include "shade/wide.h"
#include "tidepool/fixed.h"

/* One tick of the camera's adaptation [F8]: towards 0.5 / mean, within 1/8..8, by `rate`
 * (0..1) of the way.  `mean` is the picture's mean brightness, 1 being white; below 1/16
 * it counts as that.  Never stops short of the target; all 16.16. */
tp_fx tp_exposure_step(tp_fx exposure, tp_fx mean, tp_fx rate);

#define TP_EXPOSURE_ID TP_MODULE_ID('e', 'x', 'p', 'o')

/* Data of the stage, in tp_run.mine. */
typedef struct {
    tp_entry8 tone[256];        /* of a channel */
    tp_toned  toned;            /* the same of pixels */
    tp_fx     made_for;         /* exposure; 0: not made yet */
} tp_exposure;

/* The channels' tones by an exposure, 1/8..8. */
void tp_exposure_tone(tp_entry8 tone[256], tp_fx exposure);
#endif
