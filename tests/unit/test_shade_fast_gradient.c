/* SPDX-License-Identifier: MIT */
/* The fast stage of the gradient sky, compared with the exact stage and with rays in double
 * precision, for any cuts of spans and any camera. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"
#include "tests/lib/shading.h"
#include "tidepool/modules.h"

static uint64_t chance;

/* A random camera of `focal` px that may roll and look straight up; the sky goes from one
 * primary colour to the other. */
static tp_shade any_camera(int32_t focal)
{
    tp_shade s = shade_any(&chance);
    const tp_rotation turn = tp_rotation_from_angles((tp_turn)random_next(&chance),
                                                     (tp_turn)random_next(&chance),
                                                     (tp_turn)random_next(&chance));

    s.world.right = turn.x;
    s.world.up = turn.y;
    s.world.back = turn.z;
    s.focal = focal * 16;
    s.per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)s.focal);
    return s;
}

static void where_a_run_is_cut_does_not_show(void **state)
{
    (void)state;
    for (int n = 0; n < 6000; n++) {
        const tp_shade s = any_camera(chance_int(&chance, 60, 1000));
        const int32_t cut = chance_int(&chance, 1, TP_RUN - 1);
        test_run r;
        run_any(&r, 0, &chance);
        tp_run whole = r.run;
        tp_run left = run_part(&r.run, 0, cut), right = run_part(&r.run, cut, TP_RUN);
        tp_stage_sky_fast(&s, &whole);
        tp_stage_sky_fast(&s, &left);
        tp_stage_sky_fast(&s, &right);
        assert_memory_equal(whole.colour, left.colour, (size_t)cut * 4);
        assert_memory_equal(whole.colour + cut, right.colour, (size_t)(TP_RUN - cut) * 4);
    }
}

/* The entry of a colour in a sky of 256 blues. */
static void number_entries(tp_shade *s)
{
    static uint32_t numbers[TP_SKY + 1];

    for (uint32_t i = 0; i <= TP_SKY; i++)
        numbers[i] = i;
    s->sky = numbers;
}

/* A column's sine is that of a column at most two away, off by the chord over 32 columns as
 * the exact stage's is, and by a 16384th for each of six roundings.  The widest views of
 * 640 columns have a focal length of 268 px. */
static double largest_error(int32_t focal)
{
    const double angle = 32.0 / focal;

    return 2.0 / focal + angle * angle / 8 + 6 / 16384.0;
}

/* An entry is off by less than one besides. */
static void entries_are_those_of_the_rays_nearby(void **state)
{
    (void)state;
    int same = 0, all = 0;

    for (int n = 0; n < 3000; n++) {
        const int32_t focal = chance_int(&chance, 100, 1000);
        const double most = 256 * largest_error(focal) + 1;
        tp_shade s = any_camera(focal);
        test_run r;
        run_any(&r, 0, &chance);
        number_entries(&s);
        tp_run exact = r.run;
        tp_stage_sky(&s, &exact);
        tp_stage_sky_fast(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = shade_view(&s, &s.world, r.run.x + i, r.run.y);
            const double entry = fmax(-256 * v.y, 0);
            assert_true(r.run.colour[i] <= TP_SKY);
            assert_true(fabs(r.run.colour[i] + 0.5 - entry) <= most + 0.5);
            same += r.run.colour[i] == exact.colour[i];
            all++;
        }
    }
    printf("    %d of %d columns have the exact stage's entry\n", same, all);
    assert_true(same * 2 > all && same < all);
}

/* Below the horizon the fast sky has the horizon's colour. */
static void below_the_horizon_is_its_colour(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        const int32_t focal = chance_int(&chance, 100, 1000);
        tp_shade s = any_camera(focal);
        test_run r;
        run_any(&r, 0, &chance);
        number_entries(&s);
        tp_stage_sky_fast(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++)
            if (shade_view(&s, &s.world, r.run.x + i, r.run.y).y > largest_error(focal))
                assert_int_equal(r.run.colour[i], 0);
    }
}

/* -- whole pictures ------------------------------------------------------------------- */

enum { WIDTH = 144, HEIGHT = 90 };

static uint32_t picture[2][WIDTH * HEIGHT];

static void draw(const tp_scene *s, const tp_world *world, uint32_t tile_width,
                 uint32_t tile_height, uint32_t *to)
{
    const tp_config c = { .width = WIDTH, .height = HEIGHT, .tile_width = tile_width,
                          .tile_height = tile_height, .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(s, NULL, &c);

    frame_draw_picture(&f, world, to);
    frame_free(&f);
}

static int largest_change(void)
{
    int most = 0;

    for (int i = 0; i < WIDTH * HEIGHT; i++)
        for (int shift = 0; shift < 24; shift += 8) {
            const int off = (int)(picture[0][i] >> shift & 255)
                          - (int)(picture[1][i] >> shift & 255);
            most = abs(off) > most ? abs(off) : most;
        }
    return most;
}

/* The rung changes the sky by a few levels, the water and the world by nothing, and every
 * tiling draws it alike. */
static void a_scene_names_the_fast_gradient(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = { { 0, 1 }, { 16, 0 }, { 48, 7 }, { 144, 89 } };

    for (int n = 0; n < 8; n++) {
        tp_scene s = scene_plain();
        s.camera.pitch = chance_fx(&chance, 5, 30);
        s.camera.fov = 60 * TP_FX_ONE;
        tp_world *w = scene_world(&s, NULL);
        const tp_world before = *w;
        draw(&s, w, 0, 0, picture[0]);
        s.quality.sky = TP_RUNG_FAST;
        draw(&s, w, 0, 0, picture[1]);
        const int most = largest_change();
        assert_true(most > 0 && most <= 8);
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            draw(&s, w, sizes[i][0], sizes[i][1], picture[0]);
            assert_memory_equal(picture[1], picture[0], sizeof picture[0]);
        }
        assert_memory_equal(w, &before, sizeof before);
        free(w);
    }
}

/* A program without the fast stage draws the exact sky. */
static void a_program_without_the_stage_draws_the_exact_sky(void **state)
{
    (void)state;
    const tp_config c = { .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT,
                          .format = TP_FORMAT_XRGB8888 };
    static tp_program lacking;
    tp_scene s = scene_plain();
    tp_world *w = scene_world(&s, NULL);

    s.camera.pitch = 20 * TP_FX_ONE;
    draw(&s, w, 0, 0, picture[0]);
    s.quality.sky = TP_RUNG_FAST;
    lacking = tp_program_all;
    lacking.stage.sky_fast = NULL;
    test_frame f = frame_by(&lacking, &s, NULL, &c);
    frame_draw_picture(&f, w, picture[1]);
    assert_memory_equal(picture[1], picture[0], sizeof picture[0]);
    frame_free(&f);
    free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(where_a_run_is_cut_does_not_show),
        cmocka_unit_test(entries_are_those_of_the_rays_nearby),
        cmocka_unit_test(below_the_horizon_is_its_colour),
        cmocka_unit_test(a_scene_names_the_fast_gradient),
        cmocka_unit_test(a_program_without_the_stage_draws_the_exact_sky),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("shade fast gradient", tests, NULL, NULL);
}
