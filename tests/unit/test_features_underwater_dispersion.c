/* SPDX-License-Identifier: MIT */
/* Rungs of quality.dispersion, in the exact and in the fast view into the water: the same
 * bits in every tiling, close to a ray for each colour, none where there is none. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include "frame/frame.h"
#include "tests/lib/clear_water.h"
#include "tests/lib/frames.h"
#include "tests/lib/measure.h"
#include "tests/lib/picture_difference.h"

enum { WIDE = 96, HIGH = 64, PIXELS = WIDE * HIGH };
enum { EXACT_VIEW, FAST_VIEW };

static uint64_t chance;
static test_boat boat;

static tp_scene dispersed_scene(int kind, double dispersion)
{
    tp_scene s = clear_scene(kind, &chance);

    s.water.dispersion = TP_FX(dispersion);
    s.floor.texture_size = s.tank.tile = TP_FX(0.3);
    return s;
}

static void set_view(tp_scene *s, int view, int32_t dispersion)
{
    s->quality.shading = view == FAST_VIEW ? TP_SHADING_QUICK : TP_SHADING_EXACT;
    s->quality.refraction = view == FAST_VIEW ? TP_RUNG_FAST : TP_RUNG_EXACT;
    s->quality.dispersion = dispersion;
}

/* Draws a picture in tiles of a size, 0 for whole.  Returns the view's stage. */
static tp_stage draw(const tp_scene *s, const tp_assets *assets, const tp_world *world,
                     uint32_t tile_wide, uint32_t tile_high, uint32_t *pixels)
{
    const tp_config c = { .width = WIDE, .height = HIGH, .tile_width = tile_wide,
                          .tile_height = tile_high, .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(s, assets, &c);
    const tp_stage *known = tp_clear_water_stages;
    tp_stage found = NULL;

    frame_draw_picture(&f, world, pixels);
    for (const tp_shader *at = tp_frame_list(f.frame, TP_MARK_WATER)->shader; at->stage; at++)
        for (int i = 0; i < TP_COUNT_OF_clear_water; i++)
            found = at->stage == known[i] ? known[i] : found;
    frame_free(&f);
    return found;
}

static void every_tiling_has_the_same_bits(void **state)
{
    static uint32_t whole[PIXELS], cut[PIXELS];

    (void)state;
    for (int n = 0; n < 4 * KINDS; n++) {
        tp_scene s = dispersed_scene(n % KINDS, chance_double(&chance, 0.02, 0.5));
        const tp_assets assets = clear_assets(n % KINDS, &boat);
        tp_world *world = stirred_world(&s, &assets);
        set_view(&s, n & 1, n & 2 ? TP_DISPERSION_OFF : TP_RUNG_FAST);
        draw(&s, &assets, world, 0, 0, whole);
        for (int k = 0; k < 2; k++) {
            draw(&s, &assets, world, 16u * (1 + random_below(&chance, 5)),
                 1 + random_below(&chance, 40), cut);
            assert_memory_equal(whole, cut, sizeof whole);
        }
        free(world);
    }
}

/* Floors of noise, the worst case.  Shifted places have 0.15 of the error that no dispersion
 * has against the exact rung. */
static void shifted_colours_are_near_dispersed_ones(void **state)
{
    static uint32_t exact[PIXELS], fast[PIXELS], off[PIXELS];
    double error[2] = { 0 };

    (void)state;
    for (int n = 0; n < 8 * KINDS; n++) {
        tp_scene s = dispersed_scene(n % KINDS, 0.02);
        const tp_assets assets = clear_assets(n % KINDS, &boat);
        tp_world *world = stirred_world(&s, &assets);
        set_view(&s, EXACT_VIEW, TP_RUNG_EXACT);
        assert_ptr_equal(draw(&s, &assets, world, 0, 0, exact),
                         tp_clear_water_stages[TP_NTH_refract_dispersed]);
        set_view(&s, EXACT_VIEW, TP_RUNG_FAST);
        assert_ptr_equal(draw(&s, &assets, world, 0, 0, fast),
                         tp_clear_water_stages[TP_NTH_refract_shifted]);
        set_view(&s, EXACT_VIEW, TP_DISPERSION_OFF);
        assert_ptr_equal(draw(&s, &assets, world, 0, 0, off),
                         tp_clear_water_stages[TP_NTH_refract]);
        error[0] += picture_rms(fast, exact, PIXELS) / (8 * KINDS);
        error[1] += picture_rms(off, exact, PIXELS) / (8 * KINDS);
        free(world);
    }
    printf("    rms shifted %.2f, without %.2f levels\n", error[0], error[1]);
    assert_true(error[1] > 1 && error[0] < 0.3 * error[1]);
}

/* Without dispersion in the scene, and in water too deep for a floor, rungs are equal. */
static void rungs_without_dispersion_are_equal(void **state)
{
    static uint32_t first[PIXELS], other[PIXELS];

    (void)state;
    for (int n = 0; n < 4; n++) {
        tp_scene s = dispersed_scene(LEVEL, n & 2 ? 0.1 : 0);
        const tp_assets assets = clear_assets(LEVEL, &boat);
        s.floor.depth = n & 2 ? 200 * TP_FX_ONE : s.floor.depth;
        tp_world *world = stirred_world(&s, &assets);
        set_view(&s, n & 1, TP_RUNG_EXACT);
        draw(&s, &assets, world, 0, 0, first);
        for (int32_t rung = TP_RUNG_FAST; rung <= TP_DISPERSION_OFF; rung++) {
            set_view(&s, n & 1, rung);
            draw(&s, &assets, world, 0, 0, other);
            assert_memory_equal(first, other, sizeof first);
        }
        free(world);
    }
}

/* In the fast view only the rung fast has dispersion.  A view of little water may show none:
 * one in 17 scenes. */
static void fast_views_keep_to_one_place(void **state)
{
    static uint32_t first[PIXELS], other[PIXELS];
    int shown = 0;

    (void)state;
    for (int n = 0; n < 6; n++) {
        tp_scene s = dispersed_scene(LEVEL, 0.1);
        const tp_assets assets = clear_assets(LEVEL, &boat);
        tp_world *world = stirred_world(&s, &assets);
        for (int32_t rung = TP_RUNG_AUTO; rung <= TP_DISPERSION_OFF; rung++) {
            const bool shifts = rung == TP_RUNG_FAST;
            set_view(&s, FAST_VIEW, rung);
            assert_ptr_equal(draw(&s, &assets, world, 0, 0, rung ? other : first),
                             tp_clear_water_stages[shifts ? TP_NTH_quick_refract_shifted
                                                          : TP_NTH_quick_refract]);
            const bool same = memcmp(first, other, sizeof first) == 0;
            assert_true(rung == 0 || shifts || same);
            shown += shifts && !same;
        }
        free(world);
    }
    assert_true(shown >= 3);
}

/* Scenes of shifted colours in the fast view are nearer to exact ones than those without. */
static void fast_views_gain_by_shifts(void **state)
{
    static uint32_t exact[PIXELS], fast[PIXELS], off[PIXELS];
    double error[2] = { 0 };

    (void)state;
    for (int n = 0; n < 20; n++) {
        tp_scene s = dispersed_scene(LEVEL, 0.3);
        s.floor.texture_size = TP_FX(1.5);
        const tp_assets assets = clear_assets(LEVEL, &boat);
        tp_world *world = stirred_world(&s, &assets);
        set_view(&s, EXACT_VIEW, TP_RUNG_EXACT);
        draw(&s, &assets, world, 0, 0, exact);
        set_view(&s, FAST_VIEW, TP_RUNG_FAST);
        draw(&s, &assets, world, 0, 0, fast);
        set_view(&s, FAST_VIEW, TP_DISPERSION_OFF);
        draw(&s, &assets, world, 0, 0, off);
        error[0] += picture_rms(fast, exact, PIXELS) / 20;
        error[1] += picture_rms(off, exact, PIXELS) / 20;
        free(world);
    }
    printf("    fast view: rms shifted %.2f, without %.2f levels\n", error[0], error[1]);
    assert_true(error[0] < 0.9 * error[1]);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    make_hills();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_has_the_same_bits),
        cmocka_unit_test(shifted_colours_are_near_dispersed_ones),
        cmocka_unit_test(rungs_without_dispersion_are_equal),
        cmocka_unit_test(fast_views_keep_to_one_place),
        cmocka_unit_test(fast_views_gain_by_shifts),
    };
    return cmocka_run_group_tests_name("features/underwater dispersion", tests, NULL, NULL);
}
