/* SPDX-License-Identifier: MIT */
/* The quality plan with invented cost tables and any scenes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/tools.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"
#include "quality/prices.h"

enum { SCENES = 400 };

#define PLANS 0xe99ad001fdd93825ull

static uint64_t chance;

/* A cost table: exact rungs are the dearest and have no error; some rungs are not known. */
static tp_prices prices_of(uint64_t *state)
{
    tp_prices p = { .frame = chance_fx(state, 0, 200), .sky = chance_fx(state, 0, 60),
                    .slope_colour = chance_fx(state, 0, 2000) };

    for (int v = 0; v < TP_VISIBILITIES; v++)
        p.seen[v] = (tp_seen_price){
            .known = v == 0 || random_below(state, 5) > 0,
            .pixel = chance_fx(state, 0, 200), .vertex = chance_fx(state, 0, 3000),
            .wave = chance_fx(state, 0, 200), .pool = chance_fx(state, 0, 1000),
            .coastal = chance_fx(state, 0, 3000),
        };
    for (int s = 0; s < TP_SHADINGS; s++)
        for (int r = 0; r < TP_RATES; r++) {
            p.shaded[s][r].known = s + r == 0 || random_below(state, 5) > 0;
            for (int i = 0; i < TP_TRAIT_COUNT; i++)
                p.shaded[s][r].part[i] = chance_fx(state, 0, 200);
        }
    for (int k = 0; k < TP_KINDS; k++)
        for (int i = 0; i < TP_KIND_RUNGS; i++)
            for (int c = 0; c < TP_SEA_CLASSES; c++)
                p.error[k][i][c] = (tp_error_price){
                    .known = i == 0 || random_below(state, 8) > 0,
                    .px = i ? chance_fx(state, 0, 0.6) : 0,
                    .colour = i ? chance_fx(state, 0, 3) : 0,
                };
    return p;
}

typedef struct {
    tp_prices prices;
    test_kit  kit;
    tp_scene  scene;
    tp_assets assets;
    uint32_t  width, height;
} trial;

static void trial_make(trial *t, uint64_t *state)
{
    t->prices = prices_of(state);
    kit_make(&t->kit, state);
    t->scene = kit_scene(state, 16384, 64);
    t->assets = kit_assets(&t->kit, &t->scene, state);
    t->width = 16 + random_below(state, 1000);
    t->height = 16 + random_below(state, 1000);
    t->scene.quality.visibility = t->scene.quality.shading = 0;
    t->scene.quality.rate = 0;
    t->scene.quality.error_px = chance_fx(state, 0, 2);
    t->scene.quality.error_colour = chance_fx(state, 0, 8);
}

static tp_plan_input input_of(const trial *t)
{
    return (tp_plan_input){ tp_program_all.modules, &t->scene, &t->assets, t->width,
                            t->height };
}

static tp_plan_report report_of(const trial *t)
{
    const tp_plan_input in = input_of(t);
    return tp_plan_make_priced(&t->prices, &in);
}

static tp_price weighed(const trial *t)
{
    const tp_plan_input in = input_of(t);
    return tp_price_estimate(&t->prices, &in);
}

static void a_larger_budget_never_costs_more(void **state)
{
    static trial t;
    int cheaper = 0;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        trial_make(&t, &chance);
        uint64_t last = UINT64_MAX, first = 0;
        for (int k = 0; k <= 12; k++) {
            t.scene.quality.error_px = k * TP_FX(0.2);
            t.scene.quality.error_colour = k * TP_FX(0.9);
            const tp_price price = weighed(&t);
            assert_true(price.known);
            assert_true(price.cost <= last);
            last = price.cost;
            first = k ? first : last;
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
        const tp_price price = weighed(&t);
        assert_true(price.error_px <= t.scene.quality.error_px);
        assert_true(price.error_colour <= t.scene.quality.error_colour);
    }
}

/* No rung that the report rejects for its cost is cheaper than the plan. */
static void no_single_change_would_be_cheaper(void **state)
{
    static trial t;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        trial_make(&t, &chance);
        const tp_plan_report r = report_of(&t);
        for (int k = 0; k < TP_KINDS; k++)
            for (int n = 0; n < r.rung_count[k]; n++)
                if (r.rung[k][n].why == TP_WHY_COST)
                    assert_true(r.rung[k][n].price.cost >= r.total.cost);
    }
}

static void what_the_scene_names_is_taken(void **state)
{
    static trial t;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        trial_make(&t, &chance);
        t.scene.quality.visibility = chance_int(&chance, 0, 4);
        t.scene.quality.shading = chance_int(&chance, 0, 2);
        t.scene.quality.rate = chance_int(&chance, 0, 3);
        const tp_rungs r = report_of(&t).rungs;
        const int32_t got[] = { (int32_t)r.visibility, (int32_t)r.shading,
                                (int32_t)r.rate };
        const int32_t want[] = { t.scene.quality.visibility, t.scene.quality.shading,
                                 t.scene.quality.rate };
        for (int k = 0; k < TP_KINDS; k++)
            assert_true(got[k] >= 1 && (want[k] == 0 || got[k] == want[k]));
    }
}

/* A rung without measurement is not chosen; without any cost only exact rungs are
 * chosen. */
static void without_prices_all_is_exact(void **state)
{
    static const tp_prices none;
    static trial t;

    (void)state;
    trial_make(&t, &chance);
    t.prices = none;
    t.scene.quality.error_px = t.scene.quality.error_colour = TP_FX_ONE * 60;
    const tp_plan_report r = report_of(&t);
    assert_false(r.total.known);
    assert_int_equal(r.rungs.visibility, TP_VISIBILITY_TRIANGLES);
    assert_int_equal(r.rungs.shading, TP_SHADING_EXACT);
    assert_int_equal(r.rungs.rate, TP_RATE_FULL);
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
        t.scene.quality.frame_ms = TP_FX_ONE;
        const tp_plan_report r = report_of(&t);
        assert_in_range(r.rungs.visibility, 1, TP_VISIBILITIES);
        assert_in_range(r.rungs.rate, 1, TP_RATES);
        assert_true(r.water_pixels <= t.width * t.height);
        assert_true(r.waves + r.waves_dropped <= TP_WAVES);
    }
}

static void a_ladder_goes_down_and_ends(void **state)
{
    static trial t;

    (void)state;
    for (int i = 0; i < SCENES; i++) {
        trial_make(&t, &chance);
        t.scene.quality.frame_ms = 0;
        const tp_plan_input in = input_of(&t);
        tp_ladder ladder = tp_ladder_make_priced(&t.prices, &in);
        assert_int_equal(ladder.count, 1);
        t.scene.quality.frame_ms = TP_FX_ONE;
        ladder = tp_ladder_make_priced(&t.prices, &in);
        uint64_t last = UINT64_MAX;
        for (uint32_t k = 0; k < ladder.count; k++) {
            t.scene.quality.visibility = (int32_t)ladder.rung[k].visibility;
            t.scene.quality.shading = (int32_t)ladder.rung[k].shading;
            t.scene.quality.rate = (int32_t)ladder.rung[k].rate;
            const tp_price price = weighed(&t);
            assert_true(price.known && price.cost < last);
            last = price.cost;
        }
    }
}

/* Invented costs seldom leave more than two steps; the measured costs do. */
static void the_ladder_of_a_sea_has_several_steps(void **state)
{
    tp_scene s = scene_plain();
    const tp_assets none = { .boat = NULL };

    (void)state;
    s.quality.error_px = s.quality.error_colour = 0;
    s.quality.frame_ms = TP_FX_ONE;
    const tp_ladder ladder = tp_ladder_make(&s, &none, 320, 240);
    print_message("    %u steps\n", (unsigned)ladder.count);
    assert_true(ladder.count > 2);
}

/* Checksum of many plans with cost tables that are the same on every machine. */
static void plans_are_the_same_on_every_machine(void **state)
{
    static trial t;
    uint64_t fixed = 1, sum = 0;

    (void)state;
    for (int i = 0; i < 200; i++) {
        trial_make(&t, &fixed);
        t.scene = scene_any(&fixed);            /* without C library functions */
        const tp_plan_report r = report_of(&t);
        const uint64_t part[] = { r.rungs.visibility, r.rungs.shading, r.rungs.rate,
                                  r.total.cost, (uint64_t)r.total.error_px,
                                  (uint64_t)r.total.error_colour, r.water_pixels,
                                  r.vertices, r.waves };
        for (size_t k = 0; k < sizeof part / sizeof *part; k++)
            sum = (sum ^ part[k]) * 0x100000001b3u;
    }
    print_message("    sum of 200 plans %016llx\n", (unsigned long long)sum);
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
    assert_int_equal(tp_plan_make(&s, &none, 320, 240).waves, 3);
    s.quality.error_px = TP_FX_ONE;
    s.quality.error_colour = 2 * TP_FX_ONE;
    assert_int_equal(tp_plan_make(&s, &none, 320, 240).waves, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_larger_budget_never_costs_more),
        cmocka_unit_test(errors_stay_within_the_budget),
        cmocka_unit_test(no_single_change_would_be_cheaper),
        cmocka_unit_test(what_the_scene_names_is_taken),
        cmocka_unit_test(without_prices_all_is_exact),
        cmocka_unit_test(any_numbers_are_safe),
        cmocka_unit_test(a_ladder_goes_down_and_ends),
        cmocka_unit_test(the_ladder_of_a_sea_has_several_steps),
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
