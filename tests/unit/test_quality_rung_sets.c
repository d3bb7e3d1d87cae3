/* SPDX-License-Identifier: MIT */
/* Sets of rungs: kinds and rows agree with the table of parameters; costs are sums of parts,
 * and errors are 0 only where measured; walks get cheaper at each step, and their sets fit
 * the scene. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "quality/rung_prices.h"
#include "tests/lib/scenes.h"
#include "world/text.h"

static uint64_t chance;
static const tp_assets none;
static tp_set_walk walk;

static tp_view_costs view_of(const tp_scene *scene)
{
    const tp_plan_input in = { tp_program_all.modules, scene, &none, 320, 240 };

    tp_view_costs view;

    tp_view_costs_make(&view, &tp_prices_measured, &in);
    return view;
}

/* A scene of three waves with glints, a sky and layers, from a camera at random. */
static tp_scene swells_any(void)
{
    tp_scene s = scene_plain();

    s.camera.y = chance_fx(&chance, 1, 12);
    s.camera.pitch = chance_fx(&chance, -40, 0);
    s.camera.heading = chance_fx(&chance, -180, 180);
    s.sky.haze = chance_int(&chance, 0, 1) ? 2000 * TP_FX_ONE : 0;
    s.water.reflection = TP_FX(0.6);
    s.grid.vertices = chance_int(&chance, 500, 6000);
    return s;
}

/* -- rows ---------------------------------------------------------------------------- */

static void every_kind_has_a_row_of_as_many_rungs(void **state)
{
    (void)state;
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        const char *name = tp_rung_kind_row(k);
        const tp_param *row = tp_param_find(name, strlen(name));
        assert_non_null(row);
        assert_in_range(tp_rung_kind_count(k), 2, TP_KIND_RUNGS_MOST);
        if (k == TP_KIND_VISIBILITY)            /* walk has no price */
            assert_int_equal(row->high, tp_rung_kind_count(k) + 1);
        else if (k < TP_KIND_mirror_size)
            assert_int_equal(row->high, tp_rung_kind_count(k));
    }
}

static void a_set_names_its_rows_and_is_read_from_them(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_rung_set set = { .of = { 0 } };
        tp_scene s = scene_plain();
        uint32_t open;
        for (int k = 0; k < TP_KIND_mirror_size; k++)
            set.of[k] = (uint8_t)chance_int(&chance, 0, (int)tp_rung_kind_count(k) - 1);
        tp_rung_set_apply(&s, &set);
        const tp_rung_set named = tp_rung_set_named(&s, false, &open);
        assert_int_equal(open, 0);
        assert_memory_equal(named.of, set.of, TP_KIND_mirror_size);
    }
}

static void kinds_of_auto_are_open(void **state)
{
    (void)state;
    tp_scene s = scene_plain();
    uint32_t open;

    memset(&s.quality.visibility, 0,
           sizeof s.quality - offsetof(tp_scene_quality, visibility));
    s.quality.foam = TP_RUNG_FAST;
    const tp_rung_set set = tp_rung_set_named(&s, true, &open);
    assert_int_equal(open, ((1u << TP_RUNG_KINDS) - 1) & ~(1u << TP_KIND_foam));
    assert_int_equal(set.of[TP_KIND_foam], 1);
    tp_rung_set_named(&s, false, &open);
    assert_int_equal(open >> TP_KIND_mirror_size, 0);
}

/* -- prices -------------------------------------------------------------------------- */

/* A rung whose error is measured has an error in every view in which it takes effect,
 * however small the share that shows it: a predicted error of 0 is a measured one. */
static void errors_that_are_measured_are_never_predicted_as_zero(void **state)
{
    uint32_t zeros = 0, errors = 0;

    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene s = swells_any();
        const tp_view_costs view = view_of(&s);
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            for (uint8_t r = 1; r < tp_rung_kind_count(k); r++) {
                const tp_rung_effect *e = &tp_rung_effects[k];
                tp_rung_set set = { .of = { 0 } };
                if (e->needs_rung)
                    set.of[e->needs_kind] = e->needs_rung;
                const uint64_t before = tp_set_price_estimate(&view, &set).square;
                set.of[k] = r;
                const uint64_t after = tp_set_price_estimate(&view, &set).square;
                const bool measured = tp_rung_prices[k][r].square[view.estimate.sea] > 0;
                assert_int_equal(after > before,
                                 measured && tp_rung_takes_effect(&view, &set, k));
                zeros += after == before;
                errors += after > before;
            }
    }
    assert_true(zeros > 40 && errors > 400);
}

/* The exact set has no error; its cost is the sum of its parts by their factors. */
static void exact_sets_cost_their_parts(void **state)
{
    static const tp_rung_set exact = { .of = { 0 } };

    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene s = swells_any();
        const tp_view_costs view = view_of(&s);
        const tp_set_price price = tp_set_price_estimate(&view, &exact);
        uint64_t sum = 0;
        for (int p = 0; p < TP_PART_COUNT; p++)
            sum += p < TP_PARTS_SEEN ? view.seen[0][p] * tp_seen_factors[0][p] >> 8
                                     : view.part[p] * tp_part_factors[0][p] >> 8;
        assert_true(price.square == 0);
        assert_true(price.cost == sum && sum > 0);
    }
}

/* Rungs that another rung replaces change neither cost nor error: colours of half rate
 * replace fast light, and fast sines replace fast waves. */
static void replaced_rungs_change_nothing(void **state)
{
    static const uint8_t pairs[][3] = { { TP_KIND_RATE, 2, TP_KIND_light },
                                        { TP_KIND_sine, 1, TP_KIND_waves } };

    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene s = swells_any();
        const tp_view_costs view = view_of(&s);
        for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
            tp_rung_set set = { .of = { 0 } };
            set.of[TP_KIND_SHADING] = 1;
            set.of[pairs[i][0]] = pairs[i][1];
            const tp_set_price one = tp_set_price_estimate(&view, &set);
            set.of[pairs[i][2]] = 1;
            const tp_set_price both = tp_set_price_estimate(&view, &set);
            assert_true(one.cost == both.cost && one.square == both.square);
        }
    }
}

/* -- choice -------------------------------------------------------------------------- */

/* A chosen set keeps the error, costs no more than any set of the walk that keeps it, and no
 * change of one kind is cheaper. */
static void chosen_sets_are_cheapest_within_the_error(void **state)
{
    const uint32_t open = ~0u >> (32 - TP_RUNG_KINDS);

    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene s = swells_any();
        const tp_view_costs view = view_of(&s);
        const tp_rung_set exact = { .of = { 0 } };
        const uint64_t most = (uint64_t)chance_int(&chance, 0, 12 * 65536);
        tp_rung_set set = exact;
        tp_set_choose(&view, &set, open, most);
        const tp_set_price price = tp_set_price_estimate(&view, &set);
        assert_true(price.square <= most);
        tp_set_walk_make(&walk, &view, exact, open);
        for (uint32_t i = 0; i < walk.count; i++)
            assert_true(walk.price[i].square > most || price.cost <= walk.price[i].cost);
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            for (uint8_t r = 0; r < tp_rung_kind_count(k); r++) {
                tp_rung_set to = set;
                to.of[k] = r;
                if (!tp_rung_is_known(&view, k, r))
                    continue;
                const tp_set_price other = tp_set_price_estimate(&view, &to);
                assert_true(other.square > most || other.cost >= price.cost);
            }
    }
}

static void sets_that_fit_a_cost_keep_it(void **state)
{
    const uint32_t open = ~0u >> (32 - TP_RUNG_KINDS);
    uint32_t fit = 0;

    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene s = swells_any();
        const tp_view_costs view = view_of(&s);
        tp_rung_set set = { .of = { 0 } };
        const uint64_t most = (uint64_t)chance_int(&chance, 2000000, 40000000);
        const bool fits = tp_set_fit(&view, &set, open, most);
        assert_true((tp_set_price_estimate(&view, &set).cost <= most) == fits);
        fit += fits;
    }
    printf("    %u of 40 fit\n", (unsigned)fit);
    assert_true(fit > 4);
}

/* -- walks --------------------------------------------------------------------------- */

static void each_step_is_cheaper(void **state)
{
    uint32_t steps = 0;

    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene s = swells_any();
        const tp_view_costs view = view_of(&s);
        const tp_rung_set exact = { .of = { 0 } };
        tp_set_walk_make(&walk, &view, exact, ~0u >> (32 - TP_RUNG_KINDS));
        assert_true(walk.count >= 4 && walk.count <= TP_SET_STEPS);
        assert_memory_equal(&walk.set[0], &exact, sizeof exact);
        for (uint32_t i = 1; i < walk.count; i++) {
            assert_true(walk.price[i].cost < walk.price[i - 1].cost);
            assert_true(view.estimate.fits[walk.set[i].of[TP_KIND_VISIBILITY]]);
        }
        assert_true(walk.price[walk.count - 1].cost < walk.price[0].cost * 3 / 4);
        steps += walk.count;
    }
    printf("    %u steps of 40 scenes\n", (unsigned)steps);
}

/* True if a set lights every second column only. */
static bool has_half_columns(const tp_rung_set *set)
{
    return set->of[TP_KIND_light] || set->of[TP_KIND_RATE] == 2;
}

/* Fast light and colours of half rate light every second column: a walk takes them only
 * where no lobe shows.  Light ahead over waves has a lobe, light behind the camera over
 * gentle water has none. */
static void walks_light_every_column_in_a_lobe(void **state)
{
    uint32_t taken[2] = { 0 };

    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = swells_any();
        const tp_rung_set exact = { .of = { 0 } };
        s.camera.heading = s.light.heading + (n & 1 ? TP_FX(180) : 0);
        s.camera.pitch = TP_FX(-12);
        s.light.elevation = TP_FX(20);
        s.water.specular = TP_FX(0.9);
        for (int i = 0; i < TP_WAVES; i++)
            s.wave[i].amplitude /= 8;
        const tp_view_costs view = view_of(&s);
        assert_int_equal(view.estimate.lobe, !(n & 1));
        const int kind = n / 2 & 1 ? TP_KIND_light : TP_KIND_RATE;
        tp_set_walk_make(&walk, &view, exact, 1u << TP_KIND_SHADING | 1u << kind);
        for (uint32_t i = 0; i < walk.count; i++) {
            assert_false(view.estimate.lobe && has_half_columns(&walk.set[i]));
            taken[n / 2 & 1] += has_half_columns(&walk.set[i]);
        }
    }
    assert_true(taken[0] > 0 && taken[1] > 0);
}

/* Seen straight from above, all level water lies at one distance: what haze of h leaves of a
 * colour at a distance z, and of an error, is h^2 / (z^2 + h^2). */
static void errors_fade_in_haze(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = swells_any();
        tp_rung_set set = { .of = { 0 } };
        s.camera.pitch = -90 * TP_FX_ONE;
        s.camera.fov = 4 * TP_FX_ONE;
        s.sky.haze = 0;
        set.of[TP_KIND_lines] = 1;
        const tp_view_costs clear = view_of(&s);
        const double was = (double)tp_set_price_estimate(&clear, &set).square;
        s.sky.haze = chance_fx(&chance, 1, 100);
        const tp_view_costs hazy = view_of(&s);
        const double now = (double)tp_set_price_estimate(&hazy, &set).square;
        const double z = s.camera.y / 65536.0, h = s.sky.haze / 65536.0;
        const double left = h * h / (z * z + h * h);
        assert_true(was > 0 && now > 0);
        assert_true(fabs(now / was - left * left) < 0.01 + 2 / was);
    }
}

/* The view's exposure part has the price of HDR stages only under a sky with light beyond
 * white: a gradient and a dome without a sun have none. */
static void light_beyond_white_is_paid_where_there_is_some(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = swells_any();
        uint64_t part[2];
        s.sky.kind = n & 1 ? TP_SKY_DAY : TP_SKY_GRADIENT;
        s.sky.sun = n & 2 ? TP_FX(8) : 0;
        for (int i = 0; i < 2; i++) {
            s.hdr.share = i * TP_FX_ONE;
            const tp_view_costs view = view_of(&s);
            part[i] = view.part[TP_PART_exposure];
        }
        if ((n & 3) == 3)
            assert_true(part[1] > part[0]);
        else
            assert_true(part[1] == part[0]);
    }
}

static void kinds_that_are_not_open_stay(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene s = swells_any();
        const tp_view_costs view = view_of(&s);
        const tp_rung_set exact = { .of = { 0 } };
        const uint32_t open = (uint32_t)random_next(&chance) & ~(1u << TP_KIND_SHADING);
        tp_set_walk_make(&walk, &view, exact, open);
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            if (!(open >> k & 1))
                assert_int_equal(walk.set[walk.count - 1].of[k], 0);
    }
}

static void refined_sets_err_less_and_stay_within_the_cost(void **state)
{
    uint32_t refined = 0;

    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_scene s = swells_any();
        const tp_view_costs view = view_of(&s);
        const tp_rung_set exact = { .of = { 0 } };
        const uint32_t open = ~0u >> (32 - TP_RUNG_KINDS);
        tp_set_walk_make(&walk, &view, exact, open);
        const uint32_t at = (uint32_t)chance_int(&chance, 1, (int)walk.count - 1);
        const uint64_t most = walk.price[at].cost + walk.price[at].cost / 10;
        tp_rung_set set = walk.set[at];
        tp_set_refine(&view, &set, open, most);
        const tp_set_price price = tp_set_price_estimate(&view, &set);
        assert_true(price.cost <= most && price.square <= walk.price[at].square);
        refined += price.square < walk.price[at].square;
    }
    printf("    %u of 40 refined\n", (unsigned)refined);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_has_a_row_of_as_many_rungs),
        cmocka_unit_test(a_set_names_its_rows_and_is_read_from_them),
        cmocka_unit_test(kinds_of_auto_are_open),
        cmocka_unit_test(chosen_sets_are_cheapest_within_the_error),
        cmocka_unit_test(sets_that_fit_a_cost_keep_it),
        cmocka_unit_test(exact_sets_cost_their_parts),
        cmocka_unit_test(errors_that_are_measured_are_never_predicted_as_zero),
        cmocka_unit_test(replaced_rungs_change_nothing),
        cmocka_unit_test(each_step_is_cheaper),
        cmocka_unit_test(walks_light_every_column_in_a_lobe),
        cmocka_unit_test(errors_fade_in_haze),
        cmocka_unit_test(light_beyond_white_is_paid_where_there_is_some),
        cmocka_unit_test(kinds_that_are_not_open_stay),
        cmocka_unit_test(refined_sets_err_less_and_stay_within_the_cost),
    };
    return cmocka_run_group_tests_name("quality/rung_sets", tests, NULL, NULL);
}
