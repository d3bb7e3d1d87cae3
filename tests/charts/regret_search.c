/* SPDX-License-Identifier: MIT */
/* The cheapest set of a view within a budget.
 *
 * Given the water's renderer and the shading, a kind's rung multiplies the parts that it
 * changes and adds its error.  Kinds without a part in common therefore add in both.  Each
 * group of kinds that are linked by parts is listed whole; of its sets those stay that no
 * other beats in cost and error (its front).  Fronts of two groups are joined by all sums
 * of their points.  A point that is left out has one that is as cheap and as exact in its
 * group, and so in every sum: the result is the optimum, to the bit. */
#include "tests/charts/regret_search.h"
#include <stdlib.h>
#include <string.h>
#include "quality/rung_prices.h"

/* Differences to the base set: instructions, mean square. */
typedef struct {
    int64_t     cost;
    uint64_t    square;
    tp_rung_set set;
} point;

typedef struct {
    point *of;
    size_t count, room;
} front;

/* -- fronts -------------------------------------------------------------------------- */

static void front_add(front *f, point p)
{
    if (f->count == f->room) {
        f->room = f->room ? 2 * f->room : 256;
        f->of = realloc(f->of, f->room * sizeof *f->of);
        if (!f->of)
            abort();
    }
    f->of[f->count++] = p;
}

static int order(const void *a, const void *b)
{
    const point *p = a, *q = b;

    if (p->cost != q->cost)
        return p->cost < q->cost ? -1 : 1;
    return p->square < q->square ? -1 : p->square > q->square;
}

/* Leaves the points that no other one beats, the cheapest first. */
static void front_prune(front *f)
{
    size_t kept = 0;

    qsort(f->of, f->count, sizeof *f->of, order);
    for (size_t i = 0; i < f->count; i++)
        if (kept == 0 || f->of[i].square < f->of[kept - 1].square)
            f->of[kept++] = f->of[i];
    f->count = kept;
}

/* Joins the front of another group to a front. */
static void front_join(front *f, const front *other, const tp_rung_set *base, uint64_t most)
{
    front sum = { NULL, 0, 0 };

    for (size_t i = 0; i < f->count; i++)
        for (size_t j = 0; j < other->count; j++) {
            point p = f->of[i];
            p.cost += other->of[j].cost;
            p.square += other->of[j].square;
            for (int k = 0; k < TP_RUNG_KINDS; k++)
                p.set.of[k] = (uint8_t)(p.set.of[k] + other->of[j].set.of[k] - base->of[k]);
            if (p.square <= most)
                front_add(&sum, p);
        }
    front_prune(&sum);
    free(f->of);
    *f = sum;
}

/* -- groups of kinds ----------------------------------------------------------------- */

/* Returns the bits of the parts of a kind that cost something. */
static uint64_t parts_of(const regret_view *v, const tp_rung_set *base, int kind)
{
    const tp_view_costs *c = v->costs;
    const uint64_t *seen = c->seen[tp_set_renderer(c, base)];
    uint64_t parts = tp_rung_effects[kind].parts, paid = 0;

    for (int p = 0; p < TP_PART_COUNT; p++) {
        const bool counted = parts >> p & 1
            || (kind == TP_KIND_vertices && p >= TP_PART_cells && p < TP_PARTS_SEEN);
        if (counted && (p < TP_PARTS_SEEN ? seen[p] : c->part[p]) > 0)
            paid |= (uint64_t)1 << p;
    }
    return paid;
}

/* True if the rung can make a set cheaper. */
static bool may_save(const regret_view *v, const tp_rung_set *base, int kind, uint8_t rung)
{
    tp_rung_set set = *base;

    set.of[kind] = rung;
    return tp_rung_is_known(v->costs, kind, rung) && parts_of(v, base, kind)
        && tp_rung_takes_effect(v->costs, &set, kind)
        && (tp_rung_prices[kind][rung].factor < 256 || kind == TP_KIND_vertices);
}

static bool is_fixed(int kind)
{
    return kind == TP_KIND_VISIBILITY || kind == TP_KIND_SHADING
        || kind == TP_KIND_refraction;
}

/* Returns the bits of the open kinds that can make the set cheaper. */
static uint32_t useful_kinds(const regret_view *v, const tp_rung_set *base)
{
    uint32_t kinds = 0;

    for (int k = 0; k < TP_RUNG_KINDS; k++)
        for (uint8_t r = 1; v->open >> k & 1 && !is_fixed(k) && r < tp_rung_kind_count(k);
             r++)
            if (may_save(v, base, k, r))
                kinds |= 1u << k;
    return kinds;
}

/* Returns the kinds of `left` that are linked with the first one of them by parts. */
static uint32_t linked_kinds(const regret_view *v, const tp_rung_set *base, uint32_t left)
{
    uint32_t kinds = left & -left, before;
    uint64_t parts = 0;

    do {
        before = kinds;
        for (int k = 0; k < TP_RUNG_KINDS; k++) {
            const uint64_t own = left >> k & 1 ? parts_of(v, base, k) : 0;
            if (kinds >> k & 1 || own & parts) {
                kinds |= 1u << k;
                parts |= own;
            }
        }
    } while (kinds != before);
    return kinds;
}

/* Moves on to the next set of the kinds; returns false after the last one. */
static bool next_set(const regret_view *v, const tp_rung_set *base, uint32_t kinds,
                     tp_rung_set *set)
{
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        const uint8_t count = (uint8_t)tp_rung_kind_count(k);
        if (!(kinds >> k & 1))
            continue;
        do
            set->of[k]++;
        while (set->of[k] < count && !may_save(v, base, k, set->of[k]));
        if (set->of[k] < count)
            return true;
        set->of[k] = base->of[k];
    }
    return false;
}

static front list_group(const regret_view *v, const tp_rung_set *base, uint32_t kinds)
{
    const tp_set_price from = tp_set_price_estimate(v->costs, base);
    front f = { NULL, 0, 0 };
    tp_rung_set set = *base;

    do {
        const tp_set_price price = tp_set_price_estimate(v->costs, &set);
        const uint64_t more = price.square - from.square;
        if (more <= v->most)
            front_add(&f, (point){ (int64_t)price.cost - (int64_t)from.cost, more, set });
        if (f.count == 1 << 16)
            front_prune(&f);
    } while (next_set(v, base, kinds, &set));
    front_prune(&f);
    return f;
}

/* -- the cheapest set ---------------------------------------------------------------- */

/* Sets *best to the cheapest set with the renderer and the shading of `base`, if it is
 * cheaper than *least. */
static void search_from(const regret_view *v, const tp_rung_set *base, uint64_t *least,
                        tp_rung_set *best)
{
    const tp_set_price from = tp_set_price_estimate(v->costs, base);
    front all = { NULL, 0, 0 };
    uint32_t left = useful_kinds(v, base);

    if (from.square > v->most)
        return;
    front_add(&all, (point){ 0, 0, *base });
    while (left) {
        const uint32_t kinds = linked_kinds(v, base, left);
        front group = list_group(v, base, kinds);
        front_join(&all, &group, base, v->most - from.square);
        free(group.of);
        left &= ~kinds;
    }
    const uint64_t cost = (uint64_t)((int64_t)from.cost + all.of[0].cost);
    if (cost < *least) {
        *least = cost;
        *best = all.of[0].set;
    }
    free(all.of);
}

tp_rung_set regret_cheapest(const regret_view *v, const tp_rung_set *from)
{
    const bool clear = v->costs->clear && v->open >> TP_KIND_refraction & 1;
    uint64_t least = UINT64_MAX;
    tp_rung_set best = *from;

    for (uint8_t r = 0; r < TP_VISIBILITIES; r++)
        for (uint8_t shading = 0; shading < TP_SHADINGS; shading++) {
            tp_rung_set base = *from;
            if (v->open >> TP_KIND_VISIBILITY & 1)
                base.of[TP_KIND_VISIBILITY] = r;
            if (v->open >> TP_KIND_SHADING & 1)
                base.of[TP_KIND_SHADING] = shading;
            if (base.of[TP_KIND_SHADING] && clear)
                base.of[TP_KIND_refraction] = 1;
            if (base.of[TP_KIND_VISIBILITY] == r
                && tp_rung_is_known(v->costs, TP_KIND_VISIBILITY, r))
                search_from(v, &base, &least, &best);
        }
    return best;
}

/* -- improvements -------------------------------------------------------------------- */

/* Changes a kind of the set, and the rungs that it needs. */
static void change(const regret_view *v, tp_rung_set *set, int kind, uint8_t rung)
{
    const tp_rung_effect *e = &tp_rung_effects[kind];

    set->of[kind] = rung;
    if (rung && e->needs_rung && v->open >> e->needs_kind & 1
        && tp_rung_is_known(v->costs, e->needs_kind, e->needs_rung))
        set->of[e->needs_kind] = e->needs_rung;
    if (set->of[TP_KIND_SHADING] && v->costs->clear && v->open >> TP_KIND_refraction & 1)
        set->of[TP_KIND_refraction] = 1;
}

static void take_better(const regret_view *v, const tp_rung_set *to, tp_rung_set *best,
                        uint64_t *least)
{
    const tp_set_price price = tp_set_price_estimate(v->costs, to);

    if (price.square <= v->most && price.cost < *least) {
        *least = price.cost;
        *best = *to;
    }
}

void regret_improve(const regret_view *v, tp_rung_set *set)
{
    for (;;) {
        tp_rung_set best = *set;
        uint64_t least = tp_set_price_estimate(v->costs, set).cost;
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            for (uint8_t r = 0; v->open >> k & 1 && r < tp_rung_kind_count(k); r++) {
                tp_rung_set to = *set;
                if (r == set->of[k] || !tp_rung_is_known(v->costs, k, r))
                    continue;
                change(v, &to, k, r);
                take_better(v, &to, &best, &least);
            }
        if (memcmp(&best, set, sizeof best) == 0)
            return;
        *set = best;
    }
}
