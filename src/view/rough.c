/* SPDX-License-Identifier: MIT */
/* The slope variance of filtered waves, by depth. */
#include "view/rough.h"

void tp_filtered_waves_clear(tp_filtered_waves *waves)
{
    *waves = (tp_filtered_waves){ .filled = 0 };
}

/* Returns log2 of a depth in m, Q8, within 1/12. */
static int32_t log_depth(tp_fx depth)
{
    const uint32_t n = depth > 0 ? (uint32_t)depth : 1;
    const int shift = tp_clz(n);

    return (15 - shift) * 256 + (int32_t)((n << shift) >> 23 & 0xff);
}

static int32_t entry_log(uint32_t entry)
{
    return TP_ROUGH_FIRST + TP_ROUGH_STEP * (int32_t)entry;
}

static uint32_t mix(uint32_t a, uint32_t b, int32_t part, int32_t whole)
{
    return (uint32_t)(a + ((int64_t)b - a) * part / whole);
}

static tp_slope_variance mix_rows(const tp_filtered_waves *waves, tp_slope_variance next,
                                  int32_t part, int32_t whole)
{
    return (tp_slope_variance){ mix(waves->last.along, next.along, part, whole),
                                mix(waves->last.across, next.across, part, whole),
                                mix(waves->last.left, next.left, part, whole) };
}

void tp_filtered_waves_add_row(tp_filtered_waves *waves, tp_fx depth,
                               tp_slope_variance variance)
{
    TP_ASSERT(variance.along <= TP_ROUGH_ONE && variance.across <= TP_ROUGH_ONE);
    const int32_t log = log_depth(depth), whole = log - waves->last_log;

    for (; waves->filled <= TP_ROUGH_STEPS && entry_log(waves->filled) <= log;
         waves->filled++) {
        const int32_t part = entry_log(waves->filled) - waves->last_log;
        const bool between = waves->has_row && whole > 0;
        waves->at[waves->filled] = between ? mix_rows(waves, variance, part, whole)
                                           : variance;
    }
    waves->last = variance;
    waves->last_log = log;
    waves->has_row = true;
}

void tp_filtered_waves_finish(tp_filtered_waves *waves)
{
    for (; waves->filled <= TP_ROUGH_STEPS; waves->filled++)
        waves->at[waves->filled] = waves->last;
}
