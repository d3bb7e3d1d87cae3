/* SPDX-License-Identifier: MIT */
/* The conditions of a plan: the estimate of a view, the rungs that the scene names, and the
 * budget that is left for the open kinds, with the prices that apply to them.  Shared by
 * the choice of rungs (rungs.c) and by sets of rungs (view_costs.c). */
#ifndef TP_QUALITY_CONDITIONS_H
#define TP_QUALITY_CONDITIONS_H
#include "quality/prices.h"

/* A rung of each kind, counted from 0. */
typedef struct {
    uint8_t of[TP_KINDS];
} tp_plan_choice;

typedef struct {
    const tp_prices *prices;
    tp_view_estimate estimate;
    tp_wave_cull faint;
    int8_t     named[TP_KINDS];         /* rung named by the scene; -1: open */
    tp_fx      left_px, left_colour;    /* budget left for the open kinds */
    int64_t    works;                   /* fixed cost, instructions, Q16 */
    uint32_t   hidden;                  /* water pixels behind solid objects */
} tp_plan_conditions;

/* Number of rungs of each kind. */
extern const uint8_t tp_plan_kind_counts[TP_KINDS];

tp_plan_conditions tp_plan_conditions_make(const tp_prices *prices,
                                           const tp_plan_input *in);

/* True if the rung can draw this view.  Otherwise the frame draws with the exact rung of
 * the kind. */
bool tp_plan_is_fit(const tp_plan_conditions *g, int kind, int rung);

tp_error_price tp_plan_rung_error(const tp_plan_conditions *g, int kind, int rung);

/* Returns the index of the water renderer that draws the choice. */
int tp_plan_drawn_method(const tp_plan_conditions *g, tp_plan_choice c);

/* Returns the cost of finding the water. */
const tp_seen_price *tp_plan_seen_price(const tp_plan_conditions *g, tp_plan_choice c);

/* Returns the cost of shading.  A measured rate that changes nothing has no cost of its
 * own and is not `known`: the cost of the full rate applies. */
const tp_shaded_price *tp_plan_shaded_price(const tp_plan_conditions *g, tp_plan_choice c);

/* Returns the cost of an evaluated point, Q16 instructions. */
int64_t tp_plan_point_price(const tp_plan_conditions *g, const tp_seen_price *seen);

#endif
