/* SPDX-License-Identifier: MIT */
/* Chooses the rungs of a scene: among all combinations of the open kinds, the cheapest
 * with errors within the budget.  A kind is open if the scene leaves the choice of its rung
 * to the plan.
 *
 * The error of a rung is relative to the exact rung, itself not free of error.  Errors
 * are summed, the worst case.  Rungs named by the scene are not tested against the
 * budget, but their errors reduce the budget of the other kinds.  The exact rungs always
 * fit the budget, so a plan always exists.  A larger budget allows every plan of a
 * smaller budget, so a larger budget never costs more. */
#include "base/base.h"
#include "quality/prices.h"
#include "world/pools.h"

#define COMBINATIONS (TP_VISIBILITIES * TP_SHADINGS * TP_RATES)

static const uint8_t counts[TP_KINDS] = { TP_VISIBILITIES, TP_SHADINGS, TP_RATES };

/* A rung of each kind, counted from 0. */
typedef struct {
    uint8_t of[TP_KINDS];
} choice;

typedef struct {
    const tp_prices *prices;
    tp_view_estimate estimate;
    tp_wave_cull faint;
    int8_t     named[TP_KINDS];         /* rung named by the scene; -1: open */
    tp_fx      left_px, left_colour;    /* budget left for the open kinds */
    int64_t    works;                   /* fixed cost, instructions, Q16 */
    uint32_t   hidden;                  /* water pixels behind solid objects */
} plan_conditions;

static choice decode_choice(uint32_t number)
{
    TP_ASSERT(number < COMBINATIONS);
    choice c;

    for (int k = TP_KINDS - 1; k >= 0; k--) {
        c.of[k] = (uint8_t)(number % counts[k]);
        number /= counts[k];
    }
    return c;
}

static tp_rungs make_rungs(choice c)
{
    return (tp_rungs){ (tp_visibility)(c.of[0] + 1), (tp_shading)(c.of[1] + 1),
                       (tp_rate)(c.of[2] + 1) };
}

/* -- costs --------------------------------------------------------------------------- */

/* True if the rung can draw this view.  Otherwise the frame draws with the exact rung of
 * the kind. */
static bool is_fit(const plan_conditions *g, int kind, int rung)
{
    return kind == TP_KIND_VISIBILITY ? g->estimate.fits[rung] != 0
         : kind != TP_KIND_SHADING || rung == 0 || g->estimate.quick;
}

static tp_error_price rung_error(const plan_conditions *g, int kind, int rung)
{
    return g->prices->error[kind][is_fit(g, kind, rung) ? rung : 0][g->estimate.sea];
}

static int drawn_method(const plan_conditions *g, choice c)
{
    const int v = c.of[TP_KIND_VISIBILITY];
    return is_fit(g, TP_KIND_VISIBILITY, v) ? v : 0;
}

/* Returns the cost of finding the water. */
static const tp_seen_price *seen_price(const plan_conditions *g, choice c)
{
    return &g->prices->seen[drawn_method(g, c)];
}

/* Returns the cost of shading.  A measured rate that changes nothing has no cost of its
 * own and is not `known`: the cost of the full rate applies. */
static const tp_shaded_price *shaded_price(const plan_conditions *g, choice c)
{
    const int s = c.of[TP_KIND_SHADING];
    const int drawn = is_fit(g, TP_KIND_SHADING, s) ? s : 0;
    const tp_shaded_price *shaded = g->prices->shaded[drawn];
    return &shaded[shaded[c.of[TP_KIND_RATE]].known ? c.of[TP_KIND_RATE] : 0];
}

/* True if the kind is open: the scene names no rung of the kind. */
static bool is_chosen_by_plan(const plan_conditions *g, int kind)
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

static int64_t point_price(const plan_conditions *g, const tp_seen_price *seen)
{
    const tp_view_estimate *o = &g->estimate;
    const int64_t wave = (int64_t)seen->wave + (o->sharp ? seen->sharp : 0);
    const tp_fx   coastal = o->floor > 1 ? seen->map
                          : o->floor     ? seen->floor : seen->coastal;

    return seen->vertex + wave * g->faint.left + (int64_t)seen->pool * o->pools
         + (o->coastal ? coastal : 0);
}

/* Costs are below 2^31, pixels below 2^24, vertices below 2^20; waves are at most 16. */
static tp_price estimate_price(const plan_conditions *g, choice c)
{
    const tp_prices *p = g->prices;
    const tp_view_estimate *o = &g->estimate;
    const tp_seen_price *seen = seen_price(g, c);
    const tp_shaded_price *shaded = shaded_price(g, c);
    const tp_fx pixel = o->still ? seen->still : seen->pixel;
    const int64_t cost = (int64_t)p->frame * 1000 + (int64_t)p->sky * o->other_pixels
                       + (pixel + pixel_price(o, shaded)) * o->water_pixels
                       + point_price(g, seen) * o->points[drawn_method(g, c)] + g->works;
    tp_price price = { .cost = cost > 0 ? (uint64_t)cost >> 16 : 0,
                       .error_px = g->faint.px, .error_colour = g->faint.colour,
                       .known = seen->known && shaded->known };

    for (int k = 0; k < TP_KINDS; k++) {
        const tp_error_price error = rung_error(g, k, c.of[k]);
        price.known = price.known && error.known;
        price.error_px += error.px;
        price.error_colour += error.colour;
    }
    return price;
}

/* -- combinations within the budget -------------------------------------------------- */

/* True if all rungs of open kinds fit the view; named rungs may be unfit. */
static bool all_fit(const plan_conditions *g, choice c)
{
    for (int k = 0; k < TP_KINDS; k++)
        if (is_chosen_by_plan(g, k) && !is_fit(g, k, c.of[k]))
            return false;
    return true;
}

/* True if the errors of the open kinds stay within the budget left for them. */
static bool is_within_budget(const plan_conditions *g, choice c)
{
    tp_fx px = 0, colour = 0;

    for (int k = 0; k < TP_KINDS; k++) {
        px += is_chosen_by_plan(g, k) ? rung_error(g, k, c.of[k]).px : 0;
        colour += is_chosen_by_plan(g, k) ? rung_error(g, k, c.of[k]).colour : 0;
    }
    return px <= g->left_px && colour <= g->left_colour;
}

/* True if the choice has the rung that the scene names, for each kind that is not open. */
static bool keeps_named_rungs(const plan_conditions *g, choice c)
{
    for (int k = 0; k < TP_KINDS; k++)
        if (!is_chosen_by_plan(g, k) && g->named[k] != (int8_t)c.of[k])
            return false;
    return true;
}

/* Returns the named rungs and, for each open kind, the exact rung.  An exact rung needs
 * no known cost. */
static choice exact_choice(const plan_conditions *g)
{
    choice c;

    for (int k = 0; k < TP_KINDS; k++)
        c.of[k] = is_chosen_by_plan(g, k) ? 0 : (uint8_t)g->named[k];
    return c;
}

static choice find_cheapest(const plan_conditions *g)
{
    choice   best = exact_choice(g);
    tp_price least = estimate_price(g, best);

    for (uint32_t i = 0; least.known && i < COMBINATIONS; i++) {
        const choice   c = decode_choice(i);
        const tp_price price = estimate_price(g, c);
        if (price.known && price.cost < least.cost && keeps_named_rungs(g, c)
            && all_fit(g, c) && is_within_budget(g, c)) {
            best = c;
            least = price;
        }
    }
    return best;
}

/* -- the inputs of a plan ------------------------------------------------------------ */

/* Returns the named rung, or -1. A number out of range counts as open. */
static int8_t named_rung(int32_t rung, int kind)
{
    if (kind == TP_KIND_VISIBILITY && rung == TP_VISIBILITY_WALK)
        return TP_VISIBILITY_TRIANGLES - 1;
    return rung > 0 && rung <= counts[kind] ? (int8_t)(rung - 1) : -1;
}

static plan_conditions make_plan_conditions(const tp_prices *prices,
                                            const tp_plan_input *in)
{
    TP_ASSERT(in->width > 0 && in->height > 0);
    const tp_scene *scene = in->scene;
    const int32_t asked[TP_KINDS] = { scene->quality.visibility, scene->quality.shading,
                                      scene->quality.rate };
    plan_conditions g = { .prices = prices, .estimate = tp_view_estimate_make(in) };

    tp_wave_cull_limits limits = tp_wave_cull_limits_make(scene, g.estimate.waves,
                                                prices->slope_colour);
    limits.focal = g.estimate.focal;
    limits.near = g.estimate.near;
    g.faint = tp_wave_cull_evaluate(scene, &limits, prices->slope_colour);
    g.left_px = scene->quality.error_px - scene->quality.error_px / TP_WAVE_CULL_SHARE;
    g.left_colour = scene->quality.error_colour
                  - scene->quality.error_colour / TP_WAVE_CULL_SHARE;
    for (int k = 0; k < TP_KINDS; k++) {
        g.named[k] = named_rung(asked[k], k);
        if (g.named[k] >= 0) {
            g.left_px -= rung_error(&g, k, g.named[k]).px;
            g.left_colour -= rung_error(&g, k, g.named[k]).colour;
        }
    }
    g.left_px = g.left_px > 0 ? g.left_px : 0;
    g.left_colour = g.left_colour > 0 ? g.left_colour : 0;
    return g;
}

bool tp_plan_culls_waves(const tp_plan_input *in)
{
    const plan_conditions g = make_plan_conditions(&tp_prices_measured, in);
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
    const plan_conditions g = make_plan_conditions(prices, in);
    return with_walk_if_named(make_rungs(find_cheapest(&g)), in->scene);
}

/* -- reports ------------------------------------------------------------------------- */

/* Returns the cost of a water pixel with the exact rungs, minus the cost of a sky pixel. */
static int64_t exact_pixel(const plan_conditions *g)
{
    const tp_seen_price *seen = &g->prices->seen[0];

    return (g->estimate.still ? seen->still : seen->pixel)
           + pixel_price(&g->estimate, &g->prices->shaded[0][0]) - g->prices->sky;
}

/* Adds the fixed cost after the rungs are chosen, and subtracts the water pixels hidden
 * behind solid objects.  Hidden pixels are subtracted at the exact rungs' cost, so the
 * sum is the same for all rungs. */
static void add_works(plan_conditions *g, choice chosen, const tp_plan_input *in)
{
    const bool quick = chosen.of[TP_KIND_SHADING] > 0 && g->estimate.quick;
    const tp_fixed_cost works = tp_fixed_cost_estimate(in, &g->estimate, quick);
    int64_t sum = -exact_pixel(g) * works.hidden;

    for (int i = 0; i < TP_WORK_COUNT; i++)
        sum += (int64_t)g->prices->work[i] * works.of[i];
    g->works = sum;
    g->hidden = works.hidden;
}

static tp_why explain_rung(const plan_conditions *g, int kind, choice chosen, choice c)
{
    const tp_price price = estimate_price(g, c);

    if (c.of[kind] == chosen.of[kind])
        return is_chosen_by_plan(g, kind) ? TP_WHY_CHOSEN : TP_WHY_NAMED;
    if (!is_chosen_by_plan(g, kind))
        return TP_WHY_OTHER_NAMED;
    if (!is_fit(g, kind, c.of[kind]))
        return TP_WHY_UNFIT;
    if (!price.known)
        return TP_WHY_UNKNOWN;
    return is_within_budget(g, c) ? TP_WHY_COST : TP_WHY_ERROR;
}

static tp_rung_report report_rung(const plan_conditions *g, int kind, choice chosen,
                                  int rung)
{
    const tp_error_price error = rung_error(g, kind, rung);
    choice c = chosen;

    c.of[kind] = (uint8_t)rung;
    tp_rung_report report = { estimate_price(g, c), explain_rung(g, kind, chosen, c) };
    report.price.error_px = error.px;
    report.price.error_colour = error.colour;
    return report;
}

tp_price tp_price_estimate(const tp_prices *prices, const tp_plan_input *in)
{
    const plan_conditions g = make_plan_conditions(prices, in);
    return estimate_price(&g, find_cheapest(&g));
}

tp_plan_report tp_plan_make_priced(const tp_prices *prices, const tp_plan_input *in)
{
    plan_conditions g = make_plan_conditions(prices, in);
    const choice chosen = find_cheapest(&g);
    add_works(&g, chosen, in);
    tp_plan_report r = {
        .rungs = make_rungs(chosen), .total = estimate_price(&g, chosen),
        .water_pixels = g.estimate.water_pixels - g.hidden, .vertices = g.estimate.vertices,
        .waves = g.faint.left, .waves_dropped = g.estimate.waves - g.faint.left,
        .waves_px = g.faint.px, .waves_colour = g.faint.colour,
    };

    for (int k = 0; k < TP_KINDS; k++) {
        r.rung_count[k] = counts[k];
        for (int i = 0; i < counts[k]; i++)
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
static bool lower_choice(const plan_conditions *g, choice *from)
{
    const tp_price here = estimate_price(g, *from);
    choice   best = *from;
    uint64_t added = 1, saved = 0;              /* of the best step; 1 / 0: infinite */

    for (int k = 0; k < TP_KINDS; k++) {
        for (uint8_t i = 0; is_chosen_by_plan(g, k) && i < counts[k]; i++) {
            choice c = *from;
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
    const plan_conditions g = make_plan_conditions(prices, in);
    choice c = find_cheapest(&g);
    tp_ladder ladder = { .count = 0 };

    ladder.rung[ladder.count++] = with_walk_if_named(make_rungs(c), in->scene);
    while (in->scene->quality.frame_ms > 0 && ladder.count < TP_LADDER
           && lower_choice(&g, &c))
        ladder.rung[ladder.count++] = with_walk_if_named(make_rungs(c), in->scene);
    return ladder;
}
