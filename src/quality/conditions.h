/* SPDX-License-Identifier: MIT */
/* The conditions of a plan: the estimate of a view, the waves too faint to be drawn, and the
 * prices that apply. */
#ifndef TP_QUALITY_CONDITIONS_H
#define TP_QUALITY_CONDITIONS_H
#include "quality/prices.h"

typedef struct {
    const tp_prices *prices;
    tp_view_estimate estimate;
    tp_wave_cull     culled;
} tp_plan_conditions;

tp_plan_conditions tp_plan_conditions_make(const tp_prices *prices,
                                           const tp_plan_input *in);

#endif
