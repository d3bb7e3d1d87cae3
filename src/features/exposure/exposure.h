/* SPDX-License-Identifier: MIT */
/*
 * The camera's exposure, fixed or automatic, and its parameters.
 *
 *     exposure_module.c    the light meter, and the adaptation of the exposure
 *     exposure_drawing.c   the module of tone mapping; selects stage or pixel table
 *     exposure_stage.c     the tone mapping curve, and the span stage
 */
#ifndef TP_FEATURES_EXPOSURE_EXPOSURE_H
#define TP_FEATURES_EXPOSURE_EXPOSURE_H
#include "pixel/pixel.h"
#include "shade/shade.h"
#include "tidepool/fixed.h"
#include "tidepool/modules.h"
#include "tidepool/world.h"
#include "world/module.h"

/* Returns the exposure after one tick of adaptation [F8]: towards 0.5 / mean, within
 * 1/8..8, by the share `rate` (0..1) of the difference.  `mean` is the picture's mean
 * brightness, white is 1; values below 1/16 count as 1/16.  The exposure reaches its
 * target exactly.  All numbers are Q16.16. */
tp_fx tp_exposure_step(tp_fx exposure, tp_fx mean, tp_fx rate);

#define TP_EXPOSURE_ID TP_MODULE_ID('e', 'x', 'p', 'o')

/* The table of tones: a channel's tone curve, and the same curve for rgb565 pixels. */
typedef struct {
    tp_entry8 tone[256];
    tp_rgb565_tone_map tone_map;
} tp_tones;

/* Data of the span stage, in tp_run.mine. */
typedef struct {
    const tp_tones *tones;
    int32_t *own;               /* a tp_own_table; NULL: baked */
} tp_exposure;

/* Fills the tone curve of a channel for an exposure of 1/8..8. */
void tp_exposure_make_tone_curve(tp_entry8 tone[256], tp_fx exposure);

/* Returns the exposure of quality.exposure=fast: the nearest of 64 steps from each power of
 * two to the next, within 1/128 of itself.  The tables of several frames are then the same,
 * and a picture depends on no other. */
static inline tp_fx tp_exposure_coarse(tp_fx exposure)
{
    TP_ASSERT(exposure >= 64);
    const tp_fx step = (tp_fx)(0x80000000u >> tp_clz((uint32_t)exposure)) / 64;

    return (exposure + step / 2) & -step;
}

/* True if the exposure is automatic. */
bool tp_world_is_metered(const tp_world *world);

#define TP_METER_ID TP_MODULE_ID('m', 'e', 't', 'r')

/* Returns the mean brightness of the view, white is 1; 0: the world has no meter. */
tp_fx tp_meter_mean(const tp_world *world, const tp_scene *scene);

#define TP_EXPOSURE_ROWS \
    TP_ROW_NUMBER("hdr.share", hdr.share, "", 0, 1, 0, \
        "share of sun and sky light above white; 0: no HDR"), \
    TP_ROW_CHOICE("hdr.exposure", hdr.exposure, "fixed|auto", TP_EXPOSURE_AUTO, \
        TP_EXPOSURE_FIXED, "fixed or automatic exposure of the camera"), \
    TP_ROW_NUMBER("hdr.exposure_factor", hdr.exposure_factor, "", 0.125, 8, 1, \
        "exposure; start value of automatic exposure"), \
    TP_ROW_NUMBER("hdr.rate", hdr.rate, "", 0, 1, 0.03, \
        "automatic exposure: share of the difference made up each tick")

#endif
