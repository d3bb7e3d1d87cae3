/* SPDX-License-Identifier: MIT */
/* The fast view into clear water: the same picture for every tiling, near the exact one,
 * and the colour of deep water where no floor is visible; caustics of fewer cells. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include "features/underwater/fast_refraction.h"
#include "features/underwater/underwater.h"
#include "frame/frame.h"
#include "tests/lib/clear_water.h"
#include "tests/lib/frames.h"
#include "tests/lib/measure.h"
#include "tests/lib/picture_difference.h"
#include "tests/lib/scenes.h"
#include "world/pools.h"

enum { WIDE = 160, HIGH = 96, PIXELS = WIDE * HIGH };
static uint64_t chance;
static test_boat boat;

/* -- pictures -------------------------------------------------------------------------- */

/* Draws a picture in tiles of a size, 0 for whole.  Returns true if the water's list has
 * the fast stage. */
static bool draw(const tp_scene *s, const tp_assets *assets, const tp_world *world,
                 uint32_t tile_wide, uint32_t tile_high, uint32_t *pixels)
{
    const tp_config c = { .width = WIDE, .height = HIGH, .tile_width = tile_wide,
                          .tile_height = tile_high, .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(s, assets, &c);
    bool fast = false;

    frame_draw_picture(&f, world, pixels);
    for (const tp_shader *at = tp_frame_list(f.frame, TP_MARK_WATER)->shader; at->stage; at++)
        fast |= at->stage == tp_stage_quick_refract;
    frame_free(&f);
    return fast;
}

static void every_tiling_has_the_same_fast_water(void **state)
{
    (void)state;
    static uint32_t whole[PIXELS], cut[PIXELS];

    for (int n = 0; n < 4 * KINDS; n++) {
        const tp_scene s = clear_scene(n % KINDS, &chance);
        const tp_assets assets = clear_assets(n % KINDS, &boat);
        tp_world *world = stirred_world(&s, &assets);
        assert_true(draw(&s, &assets, world, 0, 0, whole));
        for (int k = 0; k < 3; k++) {
            draw(&s, &assets, world, 16u * (1 + random_below(&chance, 5)),
                 1 + random_below(&chance, 40), cut);
            assert_memory_equal(whole, cut, sizeof whole);
        }
        free(world);
    }
}

/* Textures are noise here, the worst case: neighbouring texels do not resemble each other.
 * The bounds are 1.3 times the largest of 377 pictures of each kind: 11.1, 7.6, 9.3, 8.0 and
 * 7.5 levels. */
static void fast_water_is_near_the_exact_one(void **state)
{
    (void)state;
    static uint32_t fast[PIXELS], exact[PIXELS];
    static const double bound[KINDS] = { 14.4, 9.9, 12, 10.4, 9.8 };

    for (int n = 0; n < 6 * KINDS; n++) {
        tp_scene s = clear_scene(n % KINDS, &chance);
        const tp_assets assets = clear_assets(n % KINDS, &boat);
        tp_world *world = stirred_world(&s, &assets);
        assert_true(draw(&s, &assets, world, 0, 0, fast));
        s.quality.shading = TP_SHADING_EXACT;
        s.quality.refraction = TP_RUNG_EXACT;
        assert_false(draw(&s, &assets, world, 0, 0, exact));
        printf("    kind %d: rms %.2f levels\n", n % KINDS, picture_rms(fast, exact, PIXELS));
        assert_true(picture_rms(fast, exact, PIXELS) <= bound[n % KINDS]);
        free(world);
    }
}

/* Without the row the scene is drawn by exact stages, although fast shading is named. */
static void the_exact_rung_keeps_exact_stages(void **state)
{
    (void)state;
    static uint32_t named[PIXELS], exact[PIXELS];
    tp_scene s = clear_scene(LEVEL, &chance);
    const tp_assets assets = clear_assets(LEVEL, &boat);
    tp_world *world = stirred_world(&s, &assets);

    s.quality.refraction = TP_RUNG_EXACT;
    assert_false(draw(&s, &assets, world, 0, 0, named));
    s.quality.shading = TP_SHADING_EXACT;
    assert_false(draw(&s, &assets, world, 0, 0, exact));
    assert_memory_equal(named, exact, sizeof named);
    free(world);
}

/* -- no floor in sight ----------------------------------------------------------------- */

/* Water without a floor, and water whose floor lies far below its clarity: every pixel of
 * water without reflection has the colour of deep water and a part of the lit colour. */
static void deep_water_has_one_colour(void **state)
{
    (void)state;
    static uint32_t pixels[PIXELS];

    for (int n = 0; n < 2; n++) {
        tp_scene s = clear_scene(LEVEL, &chance);
        s.floor.depth = n ? 200 * TP_FX_ONE : 0;
        s.water.reflection = s.water.specular = s.water.caustics = 0;
        const tp_assets assets = { .boat = NULL };
        tp_world *world = stirred_world(&s, &assets);
        assert_true(draw(&s, &assets, world, 0, 0, pixels));
        const uint32_t first = pixels[PIXELS - 1];
        for (int i = PIXELS - WIDE; i < PIXELS; i++)
            assert_int_equal(pixels[i], first);
        const uint32_t deep = (uint32_t)s.water.deep_colour;
        const uint32_t lit = (uint32_t)s.water.colour;
        const uint32_t least = tp_fast_own_colour(deep, lit, 0);
        const uint32_t most = tp_fast_own_colour(deep, lit, 256);
        for (int k = 0; k < 24; k += 8) {
            assert_true((first >> k & 255) + 1 >= (least >> k & 255));
            assert_true((first >> k & 255) <= (most >> k & 255));
        }
        free(world);
    }
}

/* -- caustics of fewer cells ----------------------------------------------------------- */

/* Returns the mean of the caustics map, 256 is even light, and its cells along a side. */
static double mean_light(const tp_scene *s, const tp_world *world, uint32_t *cells)
{
    const tp_config c = { .width = 32, .height = 32, .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(s, NULL, &c);
    double sum = 0;

    tp_frame_begin(f.frame, world);
    const tp_caustic *map = f.frame->shade.caustic;
    *cells = map->cells;
    for (uint32_t i = 0; i < map->cells * map->cells; i++)
        sum += map->light[i];
    sum /= (double)map->cells * map->cells;
    frame_free(&f);
    return sum;
}

static void fewer_cells_gather_as_much_light(void **state)
{
    (void)state;
    static const uint32_t want[] = { 32, 32, 16, 8 };

    for (int rung = 0; rung < 4; rung++) {
        tp_scene s = clear_scene(GLASS, &chance);
        const tp_assets assets = clear_assets(GLASS, &boat);
        tp_world *world = stirred_world(&s, &assets);
        uint32_t cells;
        s.quality.caustics = rung;
        const double light = mean_light(&s, world, &cells);
        assert_int_equal(cells, want[rung]);
        assert_true(fabs(light - 256) <= 2);
        free(world);
    }
}

/* A frame made for a cheaper rung keeps its memory when the scene asks for a dearer one. */
static void a_dearer_rung_keeps_to_the_memory_of_init(void **state)
{
    (void)state;
    tp_scene s = clear_scene(GLASS, &chance);
    tp_world *world = scene_world(&s, NULL);
    const tp_config c = { .width = 32, .height = 32, .format = TP_FORMAT_XRGB8888 };

    s.quality.caustics = 2;
    test_frame f = frame_of(&s, NULL, &c);
    s.quality.caustics = 1;
    tp_frame_begin(f.frame, world);
    assert_int_equal(f.frame->shade.caustic->cells, 16);
    s.quality.caustics = 3;
    tp_frame_begin(f.frame, world);
    assert_int_equal(f.frame->shade.caustic->cells, 8);
    assert_true(frame_guard_holds(f.block, f.bytes));
    frame_free(&f);
    free(world);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    make_hills();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_has_the_same_fast_water),
        cmocka_unit_test(fast_water_is_near_the_exact_one),
        cmocka_unit_test(the_exact_rung_keeps_exact_stages),
        cmocka_unit_test(deep_water_has_one_colour),
        cmocka_unit_test(fewer_cells_gather_as_much_light),
        cmocka_unit_test(a_dearer_rung_keeps_to_the_memory_of_init),
    };
    return cmocka_run_group_tests_name("features/underwater/fast", tests, NULL, NULL);
}
