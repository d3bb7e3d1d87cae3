/* SPDX-License-Identifier: MIT */
/* The prices of rungs: a rung changes parts of the frame's cost, by a factor, and the
 * picture, by a mean square error.  Factors and errors are measured, and stand in
 * rung_prices.inc (tests/budgets/rung-prices.sh). */
#ifndef TP_QUALITY_RUNG_PRICES_H
#define TP_QUALITY_RUNG_PRICES_H
#include "quality/rung_sets.h"

#define TP_KIND_RUNGS_MOST 4

/* A kind: the parts that its rungs change, the pixels that show them, and the rung of
 * another kind that they need (needs_rung 0: none). */
typedef struct {
    uint64_t parts;             /* bits of TP_PART_ */
    uint8_t  share;             /* TP_SHARE_ */
    uint8_t  needs_kind, needs_rung;
} tp_rung_effect;

extern const tp_rung_effect tp_rung_effects[TP_RUNG_KINDS];

/* True if the kind's rung takes effect: the rung that it needs is in the set, no other rung
 * replaces what it changes, and the view allows it. */
bool tp_rung_takes_effect(const tp_view_costs *view, const tp_rung_set *set, int kind);

/* True if the search may choose the rung: it has a measured price, and the view can show it.
 * Fast light and colours of half rate light every second column, glints too: inside a
 * specular lobe that shows as a comb.  Half of the lines is open there: rows that differ are
 * drawn (frame/half_lines.c). */
bool tp_rung_is_known(const tp_view_costs *view, int kind, uint8_t rung);

/* Measured: a factor of the parts, Q8, instructions more for each pixel of water, and the
 * mean square error of a pixel of the share by class of sea, Q8 of square levels of 255,
 * rounded up; factor 0: not measured, never chosen.  Fast shading has factors of its own
 * (tp_part_factors). */
typedef struct {
    uint16_t factor, more;
    uint32_t square[TP_SEA_CLASSES];
} tp_rung_price;

/* Factors of the parts, Q8: of finding the water by each renderer, and of all other parts;
 * those of TP_PIXEL_PARTS by shading, the others alike. */
extern const uint16_t tp_seen_factors[TP_VISIBILITIES][TP_PARTS_SEEN];
extern const uint16_t tp_part_factors[TP_SHADED_COUNT][TP_PART_COUNT];

extern const tp_rung_price tp_rung_prices[TP_RUNG_KINDS][TP_KIND_RUNGS_MOST];

#endif
