/* SPDX-License-Identifier: MIT */
/* The quality plan of any scenes, and the culling of waves. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/tools.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"
#include "quality/plan.h"

enum { SCENES = 120 };

/* Changes with the prices: prices.inc, rung_prices.inc. */
#define PLANS 0x4ac0f24b30388a64ull

static uint64_t chance;

typedef struct {
    test_kit  kit;
    tp_scene  scene;
    tp_assets assets;
    uint32_t  width, height;
} trial;

static void trial_make(trial *t, uint64_t *state)
{
    kit_make(&t->kit, state);
    do
        t->scene = kit_scene(state, 16384, 64);
    while (tp_scene_check(&t->scene, NULL) != TP_OK);
    t->assets = kit_assets(&t->kit, &t->scene, state);
    t->width = 16 + random_below(state, 1000);
    t->height = 16 + random_below(state, 1000);
    memset(&t->scene.quality.visibility, 0,
           sizeof t->scene.quality - offsetof(tp_scene_quality, visibility));
    t->scene.quality.error_px = chance_fx(state, 0, 2);
    t->scene.quality.error_colour = chance_fx(state, 0, 8);
}

static tp_plan plan_of(const trial *t)
{
    return tp_plan_make(&t->scene, &t->assets, t->width, t->height);
}

/* The search is not exhaustive: in 10 of 14400 cases a larger budget cost more, by 3 % at
 * most. */
static void a_larger_budget_saves_more(void **state)
{
    static trial t;
    int cheaper = 0;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        trial_make(&t, &chance);
        uint64_t last = UINT64_MAX, first = 0;
        for (int k = 0; k <= 6; k++) {
            t.scene.quality.error_px = 0;
            t.scene.quality.error_colour = k * TP_FX(1.8);
            const uint64_t cost = plan_of(&t).price.cost;
            assert_true(cost <= last + last / 20);
            last = cost;
            first = k ? first : cost;
        }
        cheaper += last < first;
    }
    assert_true(cheaper > SCENES / 4);
}

static void errors_stay_within_the_budget(void **state)
{
    static trial t;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        trial_make(&t, &chance);
        const int64_t most = t.scene.quality.error_colour;
        assert_true(plan_of(&t).price.square <= (uint64_t)(most * most) >> 16);
    }
}

static int32_t *row_place(tp_scene *scene, int kind)
{
    return (int32_t *)(void *)&scene->quality.visibility + kind;
}

static void what_the_scene_names_is_taken(void **state)
{
    static trial t;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        int32_t want[TP_KIND_mirror_size];
        trial_make(&t, &chance);
        for (int k = 0; k < TP_KIND_mirror_size; k++)
            want[k] = *row_place(&t.scene, k) =
                chance_int(&chance, 0, 2) ? 0
                : chance_int(&chance, 1, (int)tp_rung_kind_count(k));
        const tp_plan plan = plan_of(&t);
        tp_scene drawn = t.scene;
        tp_rung_set_apply_some(&drawn, &plan.set, plan.open);
        for (int k = 0; k < TP_KIND_mirror_size; k++) {
            assert_int_equal(plan.open >> k & 1, want[k] == 0 && k != TP_KIND_mesh);
            assert_true(want[k] == 0 || *row_place(&drawn, k) == want[k]);
            assert_true(want[k] || plan.set.of[k] < tp_rung_kind_count(k));
        }
        assert_int_equal(plan.open >> TP_KIND_mirror_size, 0);
    }
}

/* Rungs that the scene names and that exceed the budget leave nothing to the others. */
static void named_errors_use_the_budget(void **state)
{
    static trial t;
    uint32_t spent = 0;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        trial_make(&t, &chance);
        tp_rung_set named = { .of = { 0 } };
        tp_view_costs view;
        t.scene.quality.lines = TP_RUNG_FAST;
        t.scene.quality.error_colour = TP_FX(0.1);
        named.of[TP_KIND_lines] = 1;
        assert_true(tp_plan_view(&view, &t.scene, &t.assets, t.width, t.height));
        const uint64_t alone = tp_set_price_estimate(&view, &named).square;
        const uint64_t square = plan_of(&t).price.square, budget = 656;
        assert_true(square <= (alone > budget ? alone : budget));
        spent += alone > budget;
    }
    assert_true(spent > SCENES / 10);
}

static void any_numbers_are_safe(void **state)
{
    static trial t;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        trial_make(&t, &chance);
        t.scene = scene_any(&chance);
        t.scene.quality.visibility = chance_int(&chance, INT32_MIN, INT32_MAX);
        t.scene.quality.rate = chance_int(&chance, -9, 9);
        const tp_plan plan = plan_of(&t);
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            assert_true(plan.set.of[k] < tp_rung_kind_count(k));
        const tp_plan_input in = { tp_program_all.modules, &t.scene, &t.assets, t.width,
                                   t.height };
        tp_view_costs view;
        tp_view_costs_make(&view, &tp_prices_measured, &in);
        assert_true(view.water + view.other <= t.width * t.height);
        assert_true(view.culled.left <= view.estimate.waves);
        assert_true(view.estimate.waves <= TP_WAVES);
    }
}

/* Checksum of many choices, the same on every machine. */
static void plans_are_the_same_on_every_machine(void **state)
{
    static trial t;
    uint64_t fixed = 1, sum = 0;

    (void)state;
    for (int i = 0; i < 60; i++) {
        trial_make(&t, &fixed);
        t.scene = scene_any(&fixed);            /* without C library functions */
        const tp_plan_input in = { tp_program_all.modules, &t.scene, &t.assets, t.width,
                                   t.height };
        tp_view_costs view;
        tp_rung_set set = { .of = { 0 } };
        tp_view_costs_make(&view, &tp_prices_measured, &in);
        tp_set_choose(&view, &set, UINT32_MAX, (uint64_t)(i % 20) << 16);
        const tp_set_price price = tp_set_price_estimate(&view, &set);
        const uint64_t part[] = { price.cost, price.square, view.water, view.culled.left };
        for (size_t k = 0; k < sizeof part / sizeof *part; k++)
            sum = (sum ^ part[k]) * 0x100000001b3u;
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            sum = (sum ^ set.of[k]) * 0x100000001b3u;
    }
    print_message("    sum of 60 plans %016llx\n", (unsigned long long)sum);
    assert_true(sum == PLANS);
}

/* Rungs for which the frame has no memory, and no rungs at all. */
static void a_frame_takes_any_rungs(void **state)
{
    const tp_config config = { .width = 48, .height = 32, .tile_height = 32 };
    const tp_assets none = { .boat = NULL };
    tp_scene s = scene_plain();
    tp_tile tile;
    uint32_t want[48 * 32];

    (void)state;
    s.boat.mesh[0] = '\0';
    s.quality.error_px = s.quality.error_colour = 0;        /* the exact rungs */
    tp_world *world = scene_world(&s, &none);
    test_frame f = frame_of(&s, &none, &config);
    for (int i = 0; i < 50; i++) {
        const tp_rungs rungs = { (tp_visibility)chance_int(&chance, 0, 40),
                                 (tp_shading)chance_int(&chance, 0, 40),
                                 (tp_rate)chance_int(&chance, 0, 40) };
        tp_frame_set_rungs(f.frame, i ? &rungs : NULL);
        tp_frame_begin(f.frame, world);
        tp_frame_draw_tile(f.frame, 0, f.scratch, &tile);
        if (i == 0)
            memcpy(want, tile.pixels, sizeof want);
        assert_memory_equal(tile.pixels, want, sizeof want);
    }
    assert_true(frame_guard_holds(f.block, f.bytes));
    frame_free(&f);
    free(world);
}

/* -- wave culling ------------------------------------------------------------------- */

/* As its amplitude grows, a wave appears without a jump, and is never drawn larger than its
 * amplitude. */
static void a_faint_wave_fades_in(void **state)
{
    const tp_wave_cull_limits limits = { .px = TP_FX(0.1), .slope = TP_FX(0.001),
                                     .focal = 200, .near = 10 * TP_FX_ONE };
    tp_fx last = 0;

    (void)state;
    for (tp_fx a = 1; a < TP_FX(0.05); a++) {
        const tp_fx slope = a / 16;
        const tp_fx weight = tp_wave_cull_weight(&limits, a, slope);
        const tp_fx drawn = tp_fx_mul(a, weight);
        assert_in_range(weight, 0, TP_FX_ONE);
        assert_true(drawn >= last && drawn <= last + 8 && drawn <= a);
        last = drawn;
    }
    assert_true(last == TP_FX(0.05) - 1);
}

/* Waves of 12 px (drawn by a fifth) and 2 px (not drawn), and a wave drawn whole. */
static const tp_wave_cull_limits coarse = { .px = 10 * TP_FX_ONE, .slope = TP_FX(0.1),
                                        .focal = 200, .near = 10 * TP_FX_ONE };
static const tp_wave low[3] = {
    { .amplitude = TP_FX(0.6), .length = 60 * TP_FX_ONE },
    { .amplitude = TP_FX(0.1), .length = 60 * TP_FX_ONE },
    { .amplitude = 2 * TP_FX_ONE, .length = 40 * TP_FX_ONE },
};

static void a_sea_is_thinned_only_if_some_wave_is_faint(void **state)
{
    const tp_turn phases[TP_WAVES] = { 11, 22, 33 };
    tp_turn thin_phases[TP_WAVES] = { 44 };
    tp_deep_water deep, thin, untouched;

    (void)state;
    memset(&thin, 0xa5, sizeof thin);
    memset(&untouched, 0xa5, sizeof untouched);
    tp_deep_water_init(&deep, &low[2], 1, TP_FX(9.81));
    assert_false(tp_wave_cull_deep_water(&thin, thin_phases, &deep, phases, &coarse));
    assert_memory_equal(&thin, &untouched, sizeof thin);
    assert_int_equal(thin_phases[0], 44);

    tp_deep_water_init(&deep, low, 3, TP_FX(9.81));
    assert_true(tp_wave_cull_deep_water(&thin, thin_phases, &deep, phases, &coarse));
    assert_int_equal(thin.count, 2);
    assert_true(abs(thin.swell[0].amplitude - TP_FX(0.12)) <= 2);
    assert_int_equal(thin.swell[1].amplitude, 2 * TP_FX_ONE);
    assert_int_equal(thin_phases[0], 11);
    assert_int_equal(thin_phases[1], 33);
    assert_int_equal(thin.height, deep.height);
}

/* Errors of the first two waves: squares of 9.6 and 2 px, and of their slopes, whose rms is
 * the maximum over root 2. */
static void errors_of_faint_waves_add_up_as_squares(void **state)
{
    const double slope = 3.14159265 / 30 * sqrt((0.48 * 0.48 + 0.1 * 0.1) / 2);
    tp_scene s = scene_plain();

    (void)state;
    memset(s.wave, 0, sizeof s.wave);
    s.wave[0] = low[2];
    tp_wave_cull got = tp_wave_cull_evaluate(&s, &coarse, 100 * TP_FX_ONE);
    assert_false(got.any);
    assert_int_equal(got.left, 1);
    assert_int_equal(got.px, 0);
    assert_int_equal(got.colour, 0);

    memcpy(s.wave, low, sizeof low);
    got = tp_wave_cull_evaluate(&s, &coarse, 100 * TP_FX_ONE);
    assert_true(got.any);
    assert_int_equal(got.left, 2);
    assert_true(fabs(got.px / 65536.0 - sqrt(9.6 * 9.6 + 2 * 2)) < 0.001);
    assert_true(fabs(got.colour / 65536.0 - 100 * slope) < 0.01);
}

static void a_budget_of_0_keeps_every_wave(void **state)
{
    tp_scene s = scene_plain();
    const tp_assets none = { .boat = NULL };

    (void)state;
    s.wave[0].amplitude = 1;
    s.quality.error_px = s.quality.error_colour = 0;
    tp_view_costs view;
    assert_true(tp_plan_view(&view, &s, &none, 320, 240));
    assert_int_equal(view.culled.left, 3);
    s.quality.error_px = TP_FX_ONE;
    s.quality.error_colour = 2 * TP_FX_ONE;
    assert_true(tp_plan_view(&view, &s, &none, 320, 240));
    assert_int_equal(view.culled.left, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_larger_budget_saves_more),
        cmocka_unit_test(errors_stay_within_the_budget),
        cmocka_unit_test(what_the_scene_names_is_taken),
        cmocka_unit_test(named_errors_use_the_budget),
        cmocka_unit_test(any_numbers_are_safe),
        cmocka_unit_test(plans_are_the_same_on_every_machine),
        cmocka_unit_test(a_frame_takes_any_rungs),
        cmocka_unit_test(a_faint_wave_fades_in),
        cmocka_unit_test(a_sea_is_thinned_only_if_some_wave_is_faint),
        cmocka_unit_test(errors_of_faint_waves_add_up_as_squares),
        cmocka_unit_test(a_budget_of_0_keeps_every_wave),
    };

    chance = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
