/* SPDX-License-Identifier: MIT */
/* Prices of a Cortex-M0+: products of 64 bits are dearer there, errors are the same, walks
 * get cheaper; and a view is priced for a Cortex-M4 unless the caller asks for another
 * processor, so the plan's set is the same on all machines. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "quality/processor_prices.h"
#include "tests/lib/scenes.h"

#define ALL_KINDS ((1u << TP_RUNG_KINDS) - 1)

enum { SCENES = 40 };

static uint64_t chance;
static const tp_assets none;
static const tp_rung_set exact = { .of = { 0 } };
static tp_set_walk walk, other_walk;

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

static void make_view(tp_view_costs *view, const tp_scene *scene)
{
    const tp_plan_input in = { tp_program_all.modules, scene, &none, 320, 240 };

    tp_view_costs_make(view, &tp_prices_measured, &in);
}

/* A set at random that the view can show. */
static tp_rung_set set_any(const tp_view_costs *view)
{
    tp_rung_set set = exact;

    for (int k = 0; k < TP_RUNG_KINDS; k++)
        set.of[k] = (uint8_t)chance_int(&chance, 0, (int)tp_rung_kind_count(k) - 1);
    if (!view->estimate.fits[set.of[TP_KIND_VISIBILITY]])
        set.of[TP_KIND_VISIBILITY] = 0;
    return set;
}

/* No part takes fewer instructions, and parts of products of 64 bits take more of them than
 * the walk over the pixels of the water. */
static void products_of_64_bits_are_dearer(void **state)
{
    static const int products[] = { TP_PART_edges, TP_PART_vertices, TP_PART_waves,
                                    TP_PART_faces };

    (void)state;
    for (int f = 0; f < TP_SHADED_COUNT; f++) {
        const uint16_t *factor = tp_m0plus_factors[f];
        for (int p = 0; p < TP_PART_COUNT; p++)
            assert_true(factor[p] >= 256);
        for (size_t i = 0; i < sizeof products / sizeof *products; i++)
            assert_true(factor[products[i]] > factor[TP_PART_visibility]
                        && factor[products[i]] > 3 * 256);
    }
}

/* The processor changes the costs of parts by their factors, and nothing else.  Counted
 * pictures take 2.1 to 4.0 times as many; sets at random get down to 1.98, those of light
 * alone. */
static void sets_cost_their_parts_on_either_processor(void **state)
{
    (void)state;
    for (int n = 0; n < SCENES; n++) {
        const tp_scene s = swells_any();
        uint64_t m4[TP_PART_COUNT], m0plus[TP_PART_COUNT], sum = 0, other_sum = 0;
        tp_view_costs view;
        make_view(&view, &s);
        const tp_rung_set set = set_any(&view);
        const uint16_t *factor = tp_m0plus_factors[tp_set_shaded(&view, &set)];
        const tp_set_price price = tp_set_price_estimate(&view, &set);
        tp_set_part_costs(&view, &set, m4);
        view.processor = TP_PROCESSOR_M0PLUS;
        const tp_set_price other = tp_set_price_estimate(&view, &set);
        tp_set_part_costs(&view, &set, m0plus);
        for (int p = 0; p < TP_PART_COUNT; p++) {
            sum += m4[p];
            other_sum += m0plus[p];
            assert_int_equal(m0plus[p], m4[p] * factor[p] >> 8);
        }
        assert_int_equal(price.cost, sum);
        assert_int_equal(other.cost, other_sum);
        assert_int_equal(price.square, other.square);
        assert_true(10 * other.cost > 18 * price.cost && other.cost < 5 * price.cost);
    }
}

/* What a view was priced for before leaves no trace: the plan's set depends on the scene
 * alone. */
static void a_view_is_priced_for_a_cortex_m4(void **state)
{
    (void)state;
    for (int n = 0; n < SCENES; n++) {
        const tp_scene s = swells_any();
        tp_view_costs view;
        make_view(&view, &s);
        tp_set_walk_make(&walk, &view, exact, ALL_KINDS);
        view.processor = TP_PROCESSOR_M0PLUS;
        make_view(&view, &s);
        assert_int_equal(view.processor, TP_PROCESSOR_M4);
        tp_set_walk_make(&other_walk, &view, exact, ALL_KINDS);
        assert_int_equal(walk.count, other_walk.count);
        for (uint32_t i = 0; i < walk.count; i++) {
            assert_memory_equal(&walk.set[i], &other_walk.set[i], sizeof walk.set[i]);
            assert_int_equal(walk.price[i].cost, other_walk.price[i].cost);
        }
    }
}

static void walks_of_another_processor_get_cheaper(void **state)
{
    uint32_t differ = 0;

    (void)state;
    for (int n = 0; n < SCENES; n++) {
        const tp_scene s = swells_any();
        tp_view_costs view;
        make_view(&view, &s);
        tp_set_walk_make(&walk, &view, exact, ALL_KINDS);
        view.processor = TP_PROCESSOR_M0PLUS;
        tp_set_walk_make(&other_walk, &view, exact, ALL_KINDS);
        assert_true(other_walk.count >= 4);
        for (uint32_t i = 1; i < other_walk.count; i++)
            assert_true(other_walk.price[i].cost < other_walk.price[i - 1].cost);
        differ += walk.count != other_walk.count
               || memcmp(walk.set, other_walk.set, walk.count * sizeof *walk.set) != 0;
    }
    printf("    %u of %d walks differ\n", (unsigned)differ, SCENES);
    assert_true(differ > 0);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_of_64_bits_are_dearer),
        cmocka_unit_test(sets_cost_their_parts_on_either_processor),
        cmocka_unit_test(a_view_is_priced_for_a_cortex_m4),
        cmocka_unit_test(walks_of_another_processor_get_cheaper),
    };
    return cmocka_run_group_tests_name("quality/processors", tests, NULL, NULL);
}
