/* SPDX-License-Identifier: MIT */
/* The fast stage of stone: the same picture for every tiling, near the exact one, and the
 * exact one where no stone is in view. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "features/tank/tank.h"
#include "frame/frame.h"
#include "tests/lib/frames.h"
#include "tests/lib/measure.h"
#include "tests/lib/picture_difference.h"
#include "tests/lib/scenes.h"

enum { WIDE = 160, HIGH = 96, PIXELS = WIDE * HIGH };

static uint64_t chance;
static test_boat boat;

/* A tank of stone, or of glass with stone behind, seen from above its rim. */
static tp_scene stone_scene(bool glass)
{
    tp_scene s;

    tp_scene_level(&s);
    s.pool.cols = s.pool.rows = 32;
    s.pool.cell = TP_FX(0.1);
    s.grid.vertices = 1089;
    s.tank.sea = 0;
    s.tank.kind = glass ? TP_TANK_GLASS : TP_TANK_STONE;
    s.tank.rim = TP_FX(0.4);
    s.water.clarity = 3 * TP_FX_ONE;
    s.camera.near = TP_FX(0.05);
    s.camera.x = chance_fx(&chance, 1.8, 3.5);
    s.camera.z = chance_fx(&chance, 1.8, 3.5);
    s.camera.y = chance_fx(&chance, 0.8, 3);
    s.camera.heading = chance_fx(&chance, -75, -15);
    s.camera.pitch = chance_fx(&chance, -45, -5);
    return s;
}

/* Draws a picture in tiles of a size, 0 for whole. */
static void draw(const tp_scene *s, int32_t rung, uint32_t tile_wide, uint32_t tile_high,
                 uint32_t *pixels)
{
    const tp_config c = { .width = WIDE, .height = HIGH, .tile_width = tile_wide,
                          .tile_height = tile_high, .format = TP_FORMAT_XRGB8888 };
    const tp_assets assets = { .tank_wall = &boat.texture[0],
                               .tank_floor = &boat.texture[1] };
    tp_scene with = *s;

    with.quality.solids = rung;
    tp_world *world = scene_world(&with, &assets);
    test_frame f = frame_of(&with, &assets, &c);
    frame_draw_picture(&f, world, pixels);
    frame_free(&f);
    free(world);
}

static void every_tiling_has_the_same_stone(void **state)
{
    (void)state;
    static uint32_t whole[PIXELS], cut[PIXELS];

    for (int n = 0; n < 12; n++) {
        const tp_scene s = stone_scene(n % 2);
        draw(&s, TP_RUNG_FAST, 0, 0, whole);
        for (int k = 0; k < 3; k++) {
            draw(&s, TP_RUNG_FAST, 16u * (1 + random_below(&chance, 5)),
                 1 + random_below(&chance, 40), cut);
            assert_memory_equal(whole, cut, sizeof whole);
        }
    }
}

/* The texture is noise, the worst case.  The bound is 1.3 times the largest of 600
 * pictures, 5.4 levels. */
static void fast_stone_is_near_the_exact_one(void **state)
{
    (void)state;
    static uint32_t fast[PIXELS], exact[PIXELS];
    double most = 0, all = 0;

    for (int n = 0; n < 12; n++) {
        const tp_scene s = stone_scene(n % 2);
        draw(&s, TP_RUNG_FAST, 0, 0, fast);
        draw(&s, TP_RUNG_EXACT, 0, 0, exact);
        const double apart = picture_rms(fast, exact, PIXELS);
        most = apart > most ? apart : most;
        all += apart;
    }
    printf("    largest rms %.2f levels\n", most);
    assert_true(all > 0);
    assert_true(most <= 7.1);
}

static void no_stone_in_view_is_the_exact_picture(void **state)
{
    (void)state;
    static uint32_t fast[PIXELS], exact[PIXELS];
    tp_scene s = stone_scene(false);

    s.camera.heading += 180 * TP_FX_ONE;
    draw(&s, TP_RUNG_FAST, 0, 0, fast);
    draw(&s, TP_RUNG_EXACT, 0, 0, exact);
    assert_memory_equal(fast, exact, sizeof fast);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_has_the_same_stone),
        cmocka_unit_test(fast_stone_is_near_the_exact_one),
        cmocka_unit_test(no_stone_in_view_is_the_exact_picture),
    };
    return cmocka_run_group_tests_name("features/tank/fast", tests, NULL, NULL);
}
