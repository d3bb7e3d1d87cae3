/* SPDX-License-Identifier: MIT */
/* Regret of the plan (tp_set_choose): the cost of the set that it finds within a budget of
 * error, over the cost of the cheapest of all sets within it, as rows of the chart
 * "regret":
 *
 *     regret SCENE
 *
 * Rungs that the scene names are left out.  Costs and errors are the model's
 * (tp_set_price_estimate).  The cheapest set is exact, not sampled.  With the water's
 * renderer and fast shading chosen, kinds that change no part in common change the cost by
 * amounts that add, as their errors do: regret_search.c lists all sets of each group of
 * kinds, keeps those that no other beats in both, and joins groups by sums.  Sets at
 * random, each improved by single changes, must find no cheaper set.
 *
 * walk     the last step of the walk within the budget
 * single   that set, then the single change that saves most and stays within it, until none
 *          saves; with a change of shading come the rungs that it needs
 * plan     the cheaper of this and of the same by a walk from fast shading, then exchanges:
 *          a rung made more exact, and others changed by what that frees
 * best     the cheapest set within the budget */
#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include "app/files/log.h"
#include "app/scene/loaded_scene.h"
#include "quality/rung_prices.h"
#include "tests/charts/regret_search.h"
#include "tests/lib/random.h"

enum { RANDOM_SETS = 200 };

static const uint16_t sizes[][2] = { { 160, 120 }, { 320, 240 }, { 640, 480 } };
static const uint32_t budgets[] = { 2, 6 };      /* levels of 255, rms */

/* Returns the last step of the walk within the budget. */
static uint32_t walk_choice(const tp_set_walk *walk, uint64_t most)
{
    uint32_t at = 0;

    for (uint32_t i = 0; i < walk->count; i++)
        if (walk->price[i].square <= most)
            at = i;
    return at;
}

/* Returns the least cost of sets at random, improved by single changes. */
static uint64_t random_best(const regret_view *v, const tp_rung_set *from, uint64_t seed)
{
    uint64_t least = UINT64_MAX;

    for (int n = 0; n < RANDOM_SETS; n++) {
        tp_rung_set set = *from;
        for (int k = 0; k < TP_RUNG_KINDS; k++) {
            const uint8_t r =
                (uint8_t)(random_next(&seed) % tp_rung_kind_count(k));
            if (v->open >> k & 1 && random_next(&seed) % 3 == 0 && tp_rung_is_known(v->costs, k, r))
                set.of[k] = r;
        }
        if (tp_set_price_estimate(v->costs, &set).square > v->most)
            continue;
        regret_improve(v, &set);
        const uint64_t cost = tp_set_price_estimate(v->costs, &set).cost;
        least = cost < least ? cost : least;
    }
    return least;
}

/* Names the kinds by which two sets differ, "layers:0-1 sky:1-0". */
static void print_difference(const tp_rung_set *from, const tp_rung_set *to)
{
    const char *space = "";

    for (int k = 0; k < TP_RUNG_KINDS; k++)
        if (from->of[k] != to->of[k]) {
            const char *row = tp_rung_kind_row(k), *dot = strchr(row, '.');
            printf("%s%s:%d-%d", space, strncmp(row, "quality.", 8) ? row : dot + 1,
                   from->of[k], to->of[k]);
            space = " ";
        }
    puts(*space ? "" : "-");
}

static uint64_t cost_of(const regret_view *v, const tp_rung_set *set)
{
    return tp_set_price_estimate(v->costs, set).cost;
}

static void print_cost(const char *key, const char *column, uint64_t cost, uint64_t best)
{
    printf("%s,%s,%" PRIu64 "\n", key, column, cost);
    printf("%s,%s_off,%.2f\n", key, column, 100.0 * (double)cost / (double)best - 100);
}

/* Prints the costs of the found sets; returns the plan's. */
static uint64_t print_found(const regret_view *v, const tp_set_walk *walk, const char *key,
                            uint64_t least)
{
    const uint32_t at = walk_choice(walk, v->most);
    tp_rung_set single = walk->set[at], plan = walk->set[0];

    print_cost(key, "walk", walk->price[at].cost, least);
    regret_improve(v, &single);
    print_cost(key, "single", cost_of(v, &single), least);
    tp_set_choose(v->costs, &plan, v->open, v->most);
    print_cost(key, "plan", cost_of(v, &plan), least);
    return cost_of(v, &plan);
}

/* Returns false if the cheapest set is not the cheapest, or beyond the budget. */
static bool print_cell(const regret_view *v, const tp_rung_set *from, const char *key)
{
    static tp_set_walk walk;
    const tp_rung_set best = regret_cheapest(v, from);
    const uint64_t least = cost_of(v, &best);

    tp_set_walk_make(&walk, v->costs, *from, v->open);
    const uint64_t found = print_found(v, &walk, key, least);
    printf("%s,best,%" PRIu64 "\n%s,missed,", key, least, key);
    print_difference(&walk.set[walk_choice(&walk, v->most)], &best);
    if (tp_set_price_estimate(v->costs, &best).square <= v->most
        && random_best(v, from, least) >= least && found >= least)
        return true;
    fprintf(stderr, "%s: the cheapest set is not within the budget, or another one is"
                    " cheaper\n", key);
    return false;
}

static bool print_size(const loaded_scene *s, const uint16_t *size)
{
    static tp_view_costs costs;
    tp_scene plain = s->file.scene;
    const tp_plan_input in = { tp_program_all.modules, &plain, &s->assets.names, size[0],
                               size[1] };
    regret_view v = { .costs = &costs };
    bool held = true;
    char key[96];

    memset(&plain.quality.visibility, 0,        /* no rung is named */
           sizeof plain.quality - offsetof(tp_scene_quality, visibility));
    tp_view_costs_make(&costs, &tp_prices_measured, &in);
    const tp_rung_set from = tp_rung_set_named(&plain, true, &v.open);
    for (size_t b = 0; b < sizeof budgets / sizeof *budgets; b++) {
        v.most = (uint64_t)budgets[b] * budgets[b] << 16;
        snprintf(key, sizeof key, "regret,%s;%ux%u;%u", s->file.name, size[0], size[1],
                 (unsigned)budgets[b]);
        held = print_cell(&v, &from, key) && held;
    }
    return held;
}

int main(int count, char **words)
{
    char path[160];
    const options o = { .command = "plan", .scene = path, .width = 320, .height = 240,
                        .quiet = true };
    loaded_scene s;
    bool held = true;

    if (count != 2) {
        fprintf(stderr, "usage: regret SCENE\n");
        return 2;
    }
    snprintf(path, sizeof path, "assets/scenes/%s.ini", words[1]);
    const int code = loaded_scene_load(&s, &o);
    for (size_t i = 0; !code && i < sizeof sizes / sizeof *sizes; i++)
        held = print_size(&s, sizes[i]) && held;
    loaded_scene_close(&s);
    return code ? code : held ? EXIT_DONE : EXIT_CHECK;
}
