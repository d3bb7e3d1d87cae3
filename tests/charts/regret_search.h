/* SPDX-License-Identifier: MIT */
/* Searches of the sets of rungs of one view: the cheapest one within a budget, exactly, and
 * improvements of a set. */
#ifndef TP_TESTS_CHARTS_REGRET_SEARCH_H
#define TP_TESTS_CHARTS_REGRET_SEARCH_H
#include "quality/rung_sets.h"

typedef struct {
    const tp_view_costs *costs;
    uint32_t open;              /* bits of the kinds that may change */
    uint64_t most;              /* budget: mean square error, Q16 */
} regret_view;

/* Returns the cheapest set within the budget; kinds that are not open are those of `from`. */
tp_rung_set regret_cheapest(const regret_view *v, const tp_rung_set *from);

/* Changes one kind of a set at a time, each time by the change that saves most within the
 * budget, until no change saves. */
void regret_improve(const regret_view *v, tp_rung_set *set);
#endif
