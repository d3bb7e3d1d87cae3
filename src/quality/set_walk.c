/* SPDX-License-Identifier: MIT */
/* Walks from one set of rungs to cheaper ones, along the lower edge of all sets by cost and
 * error.
 *
 * Costs of parts multiply and errors add, so the set with the least error for its cost
 * differs from its neighbour by one kind, or by one kind and the rung that it needs: the
 * walk compares all of these changes at every step and takes the one that adds the least
 * error per instruction saved. */
#include "quality/rung_sets.h"
#include "base/base.h"
#include "quality/rung_prices.h"

static bool lights_half_the_columns(int kind, uint8_t rung)
{
    return (kind == TP_KIND_light && rung)
        || (kind == TP_KIND_RATE && rung == TP_RATE_COLOUR - TP_RATE_FULL);
}

bool tp_rung_is_known(const tp_view_costs *view, int kind, uint8_t rung)
{
    const tp_rung_effect *e = &tp_rung_effects[kind];

    if (kind == TP_KIND_VISIBILITY && !view->estimate.fits[rung])
        return false;
    if (view->estimate.lobe && lights_half_the_columns(kind, rung))
        return false;
    if (e->needs_rung && e->needs_kind == TP_KIND_VISIBILITY
        && !view->estimate.fits[e->needs_rung])
        return false;
    return rung == 0 || tp_rung_prices[kind][rung].factor > 0;
}

/* Returns the set with another rung of a kind, and with the rungs that it needs. */
static tp_rung_set changed(const tp_view_costs *view, tp_rung_set set, int kind,
                           uint8_t rung, uint32_t open)
{
    const tp_rung_effect *e = &tp_rung_effects[kind];

    set.of[kind] = rung;
    if (rung && e->needs_rung && open >> e->needs_kind & 1)
        set.of[e->needs_kind] = e->needs_rung;
    if (set.of[TP_KIND_SHADING] && view->clear && open >> TP_KIND_refraction & 1
        && (kind == TP_KIND_SHADING || e->needs_kind == TP_KIND_SHADING))
        set.of[TP_KIND_refraction] = 1;
    return set;
}

/* True if a step of `save` instructions that adds `more` error is better than the best. */
static bool is_better(uint64_t more, uint64_t save, uint64_t best_more, uint64_t best_save)
{
    if (more == 0 && best_more == 0)
        return save > best_save;
    return more * (best_save >> 8) < best_more * (save >> 8);
}

/* Takes the best step down from `set`; returns false if there is none. */
static bool take_cheaper(const tp_view_costs *view, tp_rung_set *set, uint32_t open)
{
    const tp_set_price here = tp_set_price_estimate(view, set);
    tp_rung_set best = *set;
    uint64_t best_more = 1, best_save = 0;      /* 1 / 0: infinite */

    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        const uint8_t count = (uint8_t)tp_rung_kind_count(k);
        for (uint8_t r = 0; open >> k & 1 && r < count; r++) {
            if (r == set->of[k] || !tp_rung_is_known(view, k, r))
                continue;
            const tp_rung_set to = changed(view, *set, k, r, open);
            const tp_set_price price = tp_set_price_estimate(view, &to);
            if (price.cost + 256 > here.cost)
                continue;
            const uint64_t more = price.square > here.square
                                      ? price.square - here.square : 0;
            if (is_better(more, here.cost - price.cost, best_more, best_save)) {
                best = to;
                best_more = more;
                best_save = here.cost - price.cost;
            }
        }
    }
    *set = best;
    return best_save > 0;
}

void tp_set_walk_make(tp_set_walk *walk, const tp_view_costs *view, tp_rung_set from,
                      uint32_t open)
{
    tp_rung_set set = from;

    walk->count = 0;
    do {
        walk->set[walk->count] = set;
        walk->price[walk->count++] = tp_set_price_estimate(view, &set);
    } while (walk->count < TP_SET_STEPS && take_cheaper(view, &set, open));
}

/* Takes the change of one kind that saves most within the error; false: none saves. */
static bool take_saving(const tp_view_costs *view, tp_rung_set *set, uint32_t open,
                        uint64_t most)
{
    tp_rung_set best = *set;
    const uint64_t here = tp_set_price_estimate(view, set).cost;
    uint64_t least = here;

    for (int k = 0; k < TP_RUNG_KINDS; k++)
        for (uint8_t r = 0; open >> k & 1 && r < tp_rung_kind_count(k); r++) {
            const tp_rung_set to = changed(view, *set, k, r, open);
            const tp_set_price price = tp_set_price_estimate(view, &to);
            if (r != set->of[k] && tp_rung_is_known(view, k, r) && price.square <= most
                && price.cost < least) {
                best = to;
                least = price.cost;
            }
        }
    *set = best;
    return least < here;
}

static void save_all(const tp_view_costs *view, tp_rung_set *set, uint32_t open,
                     uint64_t most)
{
    while (take_saving(view, set, open, most))
        continue;
}

/* Makes a rung more exact and spends the error that this frees on others; takes the exchange
 * that saves most.  Returns false if none saves. */
static bool exchange(const tp_view_costs *view, tp_rung_set *set, uint32_t open,
                     uint64_t most)
{
    tp_rung_set best = *set;
    const uint64_t here = tp_set_price_estimate(view, set).cost;
    uint64_t least = here;

    for (int k = 0; k < TP_RUNG_KINDS; k++)
        for (uint8_t r = 0; open >> k & 1 && r < set->of[k]; r++) {
            if (!tp_rung_is_known(view, k, r))
                continue;
            tp_rung_set to = changed(view, *set, k, r, open);
            save_all(view, &to, open, most);
            const tp_set_price price = tp_set_price_estimate(view, &to);
            if (price.cost < least && price.square <= most) {
                best = to;
                least = price.cost;
            }
        }
    *set = best;
    return least < here;
}

/* Walks from a set, and changes *best to the cheapest set of the walk within the error, if
 * that is cheaper. */
static void choose_by_walk(const tp_view_costs *view, tp_rung_set at, uint32_t open,
                           uint64_t most, tp_rung_set *best)
{
    uint64_t least = tp_set_price_estimate(view, best).cost;

    for (int i = 0; i < TP_SET_STEPS; i++) {
        const tp_set_price price = tp_set_price_estimate(view, &at);
        if (price.square <= most && price.cost < least) {
            *best = at;
            least = price.cost;
        }
        if (!take_cheaper(view, &at, open))
            return;
    }
}

/* Fast shading pays only with several of its rungs, so a second walk begins there. */
void tp_set_choose(const tp_view_costs *view, tp_rung_set *set, uint32_t open,
                   uint64_t most)
{
    const uint64_t named = tp_set_price_estimate(view, set).square;
    const uint64_t limit = named > most ? named : most;
    tp_rung_set best[2] = { *set, *set };

    choose_by_walk(view, *set, open, limit, &best[0]);
    save_all(view, &best[0], open, limit);
    if (open >> TP_KIND_SHADING & 1)
        choose_by_walk(view, changed(view, *set, TP_KIND_SHADING, 1, open), open, limit,
                       &best[1]);
    save_all(view, &best[1], open, limit);
    const bool second = tp_set_price_estimate(view, &best[1]).cost
                      < tp_set_price_estimate(view, &best[0]).cost;
    *set = best[second];
    while (exchange(view, set, open, limit))
        continue;
}

void tp_set_refine(const tp_view_costs *view, tp_rung_set *set, uint32_t open,
                   uint64_t most)
{
    for (;;) {
        const tp_set_price here = tp_set_price_estimate(view, set);
        tp_rung_set best = *set;
        uint64_t least = here.square;
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            for (uint8_t r = 0; open >> k & 1 && r < set->of[k]; r++) {
                const tp_rung_set to = changed(view, *set, k, r, open);
                const tp_set_price price = tp_set_price_estimate(view, &to);
                if (tp_rung_is_known(view, k, r) && price.cost <= most && price.square < least) {
                    best = to;
                    least = price.square;
                }
            }
        if (least == here.square)
            return;
        *set = best;
    }
}

bool tp_set_fit(const tp_view_costs *view, tp_rung_set *set, uint32_t open, uint64_t most)
{
    tp_rung_set at = *set;

    for (int i = 0; tp_set_price_estimate(view, &at).cost > most; i++)
        if (i == TP_SET_STEPS || !take_cheaper(view, &at, open))
            return false;
    tp_set_refine(view, &at, open, most);
    *set = at;
    return true;
}
