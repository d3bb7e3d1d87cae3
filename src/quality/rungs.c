/* SPDX-License-Identifier: MIT */
/* Chooses the rungs of a scene: among all combinations of the open kinds, the cheapest
 * with errors within the budget.  A kind is open if the scene leaves the choice
 * of its rung to the plan.
 *
 * The error of a rung is relative to the exact rung, itself not free of error.  Errors
 * are summed, the worst case.  Rungs named by the scene are not tested against the
 * budget, but their errors reduce the budget of the other kinds.  The exact rungs always
 * fit the budget, so a plan always exists.  A larger budget allows every plan of a
 * smaller budget, so a larger budget never costs more. */
#include "base/base.h"
#include "quality/conditions.h"

#define COMBINATIONS (TP_VISIBILITIES * TP_SHADINGS * TP_RATES)

static tp_plan_choice decode_choice(uint32_t number)
{
    TP_ASSERT(number < COMBINATIONS);
    tp_plan_choice c;

    for (int k = TP_KINDS - 1; k >= 0; k--) {
        c.of[k] = (uint8_t)(number % tp_plan_kind_counts[k]);
        number /= tp_plan_kind_counts[k];
    }
    return c;
}

static tp_rungs make_rungs(tp_plan_choice c)
{
    return (tp_rungs){ (tp_visibility)(c.of[0] + 1), (tp_shading)(c.of[1] + 1),
                       (tp_rate)(c.of[2] + 1) };
}

/* -- costs --------------------------------------------------------------------------- */

/* True if the kind is open: the scene names no rung of the kind. */
static bool is_chosen_by_plan(const tp_plan_conditions *g, int kind)
{
    return g->named[kind] < 0;
}

static int64_t pixel_price(const tp_view_estimate *o, const tp_shaded_price *shaded)
{
    int64_t sum = 0;

    for (int i = 0; i < TP_TRAIT_COUNT; i++)
        sum += (int64_t)o->trait[i] * shaded->part[i];
    return sum;
}

/* Costs are below 2^31, pixels below 2^24, vertices below 2^20; waves are at most 16. */
static tp_price estimate_price(const tp_plan_conditions *g, tp_plan_choice c)
{
    const tp_prices *p = g->prices;
    const tp_view_estimate *o = &g->estimate;
    const tp_seen_price *seen = tp_plan_seen_price(g, c);
    const tp_shaded_price *shaded = tp_plan_shaded_price(g, c);
    const tp_fx pixel = o->still ? seen->still : seen->pixel;
    const int64_t cost = (int64_t)p->frame * 1000 + (int64_t)p->sky * o->other_pixels
                       + (pixel + pixel_price(o, shaded)) * o->water_pixels
                       + tp_plan_point_price(g, seen)
                             * o->points[tp_plan_drawn_method(g, c)]
                       + g->works;
    tp_price price = { .cost = cost > 0 ? (uint64_t)cost >> 16 : 0,
                       .error_px = g->faint.px, .error_colour = g->faint.colour,
                       .known = seen->known && shaded->known };

    for (int k = 0; k < TP_KINDS; k++) {
        const tp_error_price error = tp_plan_rung_error(g, k, c.of[k]);
        price.known = price.known && error.known;
        price.error_px += error.px;
        price.error_colour += error.colour;
    }
    return price;
}

/* -- combinations within the budget -------------------------------------------------- */

/* True if all rungs of open kinds fit the view; named rungs may be unfit. */
static bool all_fit(const tp_plan_conditions *g, tp_plan_choice c)
{
    for (int k = 0; k < TP_KINDS; k++)
        if (is_chosen_by_plan(g, k) && !tp_plan_is_fit(g, k, c.of[k]))
            return false;
    return true;
}

/* True if the errors of the open kinds stay within the budget left for them. */
static bool is_within_budget(const tp_plan_conditions *g, tp_plan_choice c)
{
    tp_fx px = 0, colour = 0;

    for (int k = 0; k < TP_KINDS; k++) {
        px += is_chosen_by_plan(g, k) ? tp_plan_rung_error(g, k, c.of[k]).px : 0;
        colour += is_chosen_by_plan(g, k) ? tp_plan_rung_error(g, k, c.of[k]).colour : 0;
    }
    return px <= g->left_px && colour <= g->left_colour;
}

/* True if the choice has the rung that the scene names, for each kind that is not open. */
static bool keeps_named_rungs(const tp_plan_conditions *g, tp_plan_choice c)
{
    for (int k = 0; k < TP_KINDS; k++)
        if (!is_chosen_by_plan(g, k) && g->named[k] != (int8_t)c.of[k])
            return false;
    return true;
}

/* Returns the named rungs and, for each open kind, the exact rung.  An exact rung needs
 * no known cost. */
static tp_plan_choice exact_choice(const tp_plan_conditions *g)
{
    tp_plan_choice c;

    for (int k = 0; k < TP_KINDS; k++)
        c.of[k] = is_chosen_by_plan(g, k) ? 0 : (uint8_t)g->named[k];
    return c;
}

static tp_plan_choice find_cheapest(const tp_plan_conditions *g)
{
    tp_plan_choice   best = exact_choice(g);
    tp_price least = estimate_price(g, best);

    for (uint32_t i = 0; least.known && i < COMBINATIONS; i++) {
        const tp_plan_choice   c = decode_choice(i);
        const tp_price price = estimate_price(g, c);
        if (price.known && price.cost < least.cost && keeps_named_rungs(g, c)
            && all_fit(g, c) && is_within_budget(g, c)) {
            best = c;
            least = price;
        }
    }
    return best;
}

bool tp_plan_culls_waves(const tp_plan_input *in)
{
    const tp_plan_conditions g = tp_plan_conditions_make(&tp_prices_measured, in);
    return g.faint.any && !g.estimate.coastal;
}

/* Walked water has no price yet: it is drawn if the scene names it, and planned with the
 * price of triangles, which draw it where it does not fit. */
static tp_rungs with_walk_if_named(tp_rungs rungs, const tp_scene *scene)
{
    if (scene->quality.visibility == TP_VISIBILITY_WALK)
        rungs.visibility = TP_VISIBILITY_WALK;
    return rungs;
}

tp_rungs tp_rungs_choose_priced(const tp_prices *prices, const tp_plan_input *in)
{
    const tp_plan_conditions g = tp_plan_conditions_make(prices, in);
    return with_walk_if_named(make_rungs(find_cheapest(&g)), in->scene);
}

/* -- reports ------------------------------------------------------------------------- */

/* Returns the cost of a water pixel with the exact rungs, minus the cost of a sky pixel. */
static int64_t exact_pixel(const tp_plan_conditions *g)
{
    const tp_seen_price *seen = &g->prices->seen[0];

    return (g->estimate.still ? seen->still : seen->pixel)
           + pixel_price(&g->estimate, &g->prices->shaded[0][0]) - g->prices->sky;
}

/* Adds the fixed cost after the rungs are chosen, and subtracts the water pixels hidden
 * behind solid objects.  Hidden pixels are subtracted at the exact rungs' cost, so the
 * sum is the same for all rungs. */
static void add_works(tp_plan_conditions *g, tp_plan_choice chosen, const tp_plan_input *in)
{
    const bool quick = chosen.of[TP_KIND_SHADING] > 0 && g->estimate.quick;
    const tp_fixed_cost works = tp_fixed_cost_estimate(in, &g->estimate, quick);
    int64_t sum = -exact_pixel(g) * works.hidden;

    for (int i = 0; i < TP_WORK_COUNT; i++)
        sum += (int64_t)g->prices->work[i] * works.of[i];
    g->works = sum;
    g->hidden = works.hidden;
}

static tp_why explain_rung(const tp_plan_conditions *g, int kind, tp_plan_choice chosen,
                           tp_plan_choice c)
{
    const tp_price price = estimate_price(g, c);

    if (c.of[kind] == chosen.of[kind])
        return is_chosen_by_plan(g, kind) ? TP_WHY_CHOSEN : TP_WHY_NAMED;
    if (!is_chosen_by_plan(g, kind))
        return TP_WHY_OTHER_NAMED;
    if (!tp_plan_is_fit(g, kind, c.of[kind]))
        return TP_WHY_UNFIT;
    if (!price.known)
        return TP_WHY_UNKNOWN;
    return is_within_budget(g, c) ? TP_WHY_COST : TP_WHY_ERROR;
}

static tp_rung_report report_rung(const tp_plan_conditions *g, int kind,
                                  tp_plan_choice chosen, int rung)
{
    const tp_error_price error = tp_plan_rung_error(g, kind, rung);
    tp_plan_choice c = chosen;

    c.of[kind] = (uint8_t)rung;
    tp_rung_report report = { estimate_price(g, c), explain_rung(g, kind, chosen, c) };
    report.price.error_px = error.px;
    report.price.error_colour = error.colour;
    return report;
}

tp_price tp_price_estimate(const tp_prices *prices, const tp_plan_input *in)
{
    const tp_plan_conditions g = tp_plan_conditions_make(prices, in);
    return estimate_price(&g, find_cheapest(&g));
}

tp_plan_report tp_plan_make_priced(const tp_prices *prices, const tp_plan_input *in)
{
    tp_plan_conditions g = tp_plan_conditions_make(prices, in);
    const tp_plan_choice chosen = find_cheapest(&g);
    add_works(&g, chosen, in);
    tp_plan_report r = {
        .rungs = make_rungs(chosen), .total = estimate_price(&g, chosen),
        .water_pixels = g.estimate.water_pixels - g.hidden, .vertices = g.estimate.vertices,
        .waves = g.faint.left, .waves_dropped = g.estimate.waves - g.faint.left,
        .waves_px = g.faint.px, .waves_colour = g.faint.colour,
    };

    for (int k = 0; k < TP_KINDS; k++) {
        r.rung_count[k] = tp_plan_kind_counts[k];
        for (int i = 0; i < tp_plan_kind_counts[k]; i++)
            r.rung[k][i] = report_rung(&g, k, chosen, i);
    }
    return r;
}

/* -- the ladder ---------------------------------------------------------------------- */

/* Returns the combined error, Q18: 4 x outline error in px + colour error in levels.  The
 * weight follows the default budget of half a pixel and two levels. */
static uint64_t weigh_errors(tp_price price)
{
    return 4 * (uint64_t)price.error_px + (uint64_t)price.error_colour;
}

/* Takes the step from `from` that adds the least error per instruction saved. */
static bool lower_choice(const tp_plan_conditions *g, tp_plan_choice *from)
{
    const tp_price here = estimate_price(g, *from);
    tp_plan_choice   best = *from;
    uint64_t added = 1, saved = 0;              /* of the best step; 1 / 0: infinite */

    for (int k = 0; k < TP_KINDS; k++) {
        for (uint8_t i = 0; is_chosen_by_plan(g, k) && i < tp_plan_kind_counts[k]; i++) {
            tp_plan_choice c = *from;
            c.of[k] = i;
            const tp_price p = estimate_price(g, c);
            if (!p.known || p.cost >= here.cost || !all_fit(g, c))
                continue;
            const uint64_t save = here.cost - p.cost;
            const uint64_t more = weigh_errors(p) > weigh_errors(here)
                                      ? weigh_errors(p) - weigh_errors(here)
                                      : 0;
            if (more * (saved >> 8) < added * (save >> 8)) {
                best = c;
                added = more;
                saved = save;
            }
        }
    }
    *from = best;
    return saved > 0;
}

tp_ladder tp_ladder_make_priced(const tp_prices *prices, const tp_plan_input *in)
{
    const tp_plan_conditions g = tp_plan_conditions_make(prices, in);
    tp_plan_choice c = find_cheapest(&g);
    tp_ladder ladder = { .count = 0 };

    ladder.rung[ladder.count++] = with_walk_if_named(make_rungs(c), in->scene);
    while (in->scene->quality.frame_ms > 0 && ladder.count < TP_LADDER
           && lower_choice(&g, &c))
        ladder.rung[ladder.count++] = with_walk_if_named(make_rungs(c), in->scene);
    return ladder;
}
