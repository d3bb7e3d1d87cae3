/* SPDX-License-Identifier: MIT */
/* Automatic exposure of the camera, one tick at a time [F8].  Adaptation runs in fixed
 * ticks, not in wall time, so a recorded input gives the same pictures again. */
#include "features/exposure/exposure.h"

#define LEAST      (TP_FX_ONE / 8)
#define MOST       (8 * TP_FX_ONE)
#define MEAN_LEAST (TP_FX_ONE / 16)

/* A share of a difference of a few LSB may round to zero.  The exposure then moves by one
 * LSB, so the target is reached exactly.  The difference is below 2^19, the product below
 * 2^36. */
tp_fx tp_exposure_step(tp_fx exposure, tp_fx mean, tp_fx rate)
{
    const tp_fx floored = mean < MEAN_LEAST ? MEAN_LEAST : mean;
    const tp_fx target = tp_clamp(tp_fx_div(TP_FX_ONE / 2, floored), LEAST, MOST);
    const tp_fx from = tp_clamp(exposure, LEAST, MOST), way = target - from;
    const tp_fx share = tp_clamp(rate, 0, TP_FX_ONE), step = tp_fx_mul(way, share);

    if (step == 0 && share > 0)
        return from + (way > 0) - (way < 0);
    return from + step;
}
