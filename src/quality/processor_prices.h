/* SPDX-License-Identifier: MIT */
/* Costs of a set by its parts, and the instructions of other processors than a Cortex-M4:
 * a factor for each part, measured (tests/budgets/processor-prices.sh). */
#ifndef TP_QUALITY_PROCESSOR_PRICES_H
#define TP_QUALITY_PROCESSOR_PRICES_H
#include "quality/rung_sets.h"

/* Instructions of a Cortex-M0+ for one of a Cortex-M4, by the set's shading and by part,
 * Q8. */
extern const uint16_t tp_m0plus_factors[TP_SHADED_COUNT][TP_PART_COUNT];

/* Sets the costs of a set's parts for the view's processor, and returns the set's mean
 * square error, as tp_set_price. */
uint64_t tp_set_part_costs(const tp_view_costs *view, const tp_rung_set *set,
                           uint64_t cost[TP_PART_COUNT]);
#endif
