/* SPDX-License-Identifier: MIT */
/* Specks in the picture: position, size, opacity, occlusion. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/camera.h"
#include "features/spray/spray.h"
#include "tests/lib/tilings.h"

enum { WIDTH = 160, HEIGHT = 112 };

static uint64_t chance;
static uint32_t key[WIDTH * HEIGHT];
static double cover[WIDTH * HEIGHT];    /* opacity of specks, 0..1 */
static const tp_assets none;
static const tp_config config = {
    .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_XRGB8888
};

/* Still water below an eye at 10 m that looks to -z. */
static tp_scene scene_of(int32_t count)
{
    tp_scene s = marks_still(10);

    s.spray.count = count;
    s.spray.size = TP_FX(0.1);
    return s;
}

static void put(tp_world *world, tp_vec3 at, tp_speck_kind kind, uint8_t luck)
{
    tp_spray *spray = (tp_spray *)(uintptr_t)tp_world_spray(world);
    tp_speck *list = (tp_speck *)(uintptr_t)tp_spray_list(spray);

    assert_true(spray->count < spray->capacity);
    list[spray->count++] = (tp_speck){ .place = at, .last = at, .kind = (uint8_t)kind,
                                       .chance = luck };
}

/* Draws a black picture with white specks, so green is the specks' opacity.  Returns the
 * sum of the opacity over the picture, pixels. */
static double drawn(const tp_scene *scene, const tp_world *world)
{
    tp_scene black = *scene;
    test_frame f;
    static uint32_t pixel[WIDTH * HEIGHT];
    double sum = 0;

    black.light.ambient = TP_FX_ONE;
    black.foam.colour = 0xffffff;
    black.sky.horizon = black.sky.zenith = black.water.colour = 0;
    black.water.deep_colour = black.water.tint = black.water.specular = 0;
    black.sky.haze = 0;
    f = frame_of(&black, &none, &config);
    frame_draw_picture(&f, world, pixel);
    frame_free(&f);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        cover[i] = (pixel[i] >> 8 & 0xff) / 255.0;
        sum += cover[i];
    }
    return sum;
}

/* Middle of the opacity of the picture, px. */
static void middle_of(double sum, double middle[2])
{
    middle[0] = middle[1] = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        middle[0] += (i % WIDTH + 0.5) * cover[i] / sum;
        middle[1] += (i / WIDTH + 0.5) * cover[i] / sum;
    }
}

/* A soft disc of 2 to 6 pixels, around the right place: its opacity adds up to half of the
 * area.  The middle is rounded to 1/16 px, up to 0.05 px off; the radius is rounded down.
 * The disc's few pixels have their own middle up to 0.166 px from the disc's, most at a
 * radius of 1.25 px (all radii and places of 1/16 px). */
static void a_speck_lies_where_the_camera_sees_it(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        tp_scene s = scene_of(4);
        tp_world *world = scene_world(&s, &none);
        const tp_vec3 at = { chance_fx(&chance, -1, 1), chance_fx(&chance, 9.5, 10.5),
                             chance_fx(&chance, -12, -3) };
        const ref_camera camera = ref_camera_make(world->eye, 0, 0, s.camera.fov,
                                                s.camera.near, WIDTH, HEIGHT);
        double middle[2];
        put(world, at, TP_SPECK_SPRAY, 128);
        const double sum = drawn(&s, world);
        const double depth = -at.z / 65536.0, r = fmin(3, 0.1 * camera.focal / depth);
        const double u = camera.u0 + camera.focal * at.x / 65536.0 / depth;
        const double v = camera.v0 - camera.focal * (at.y / 65536.0 - 10) / depth;
        assert_true(fabs(sum - 3.1416 * r * r / 2) < 0.5 + 0.25 * r * r);
        middle_of(sum, middle);
        assert_true(hypot(middle[0] - u, middle[1] - v) < 0.166 + 0.05);
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            assert_true(cover[i] == 0
                        || hypot(i % WIDTH + 0.5 - u, i / WIDTH + 0.5 - v)
                               < fmax(1, r) + 0.05);
        free(world);
    }
}

/* A speck fades from 2 m to 1 m. */
static void specks_before_the_eye_fade(void **state)
{
    static const double depth[] = { 2.2, 1.5, 1.05, 0.7 };
    double sum[4];

    (void)state;
    for (int k = 0; k < 4; k++) {
        tp_scene s = scene_of(4);
        tp_world *world = scene_world(&s, &none);
        put(world, (tp_vec3){ 0, 10 * TP_FX_ONE, (tp_fx)(-depth[k] * 65536) },
            TP_SPECK_SPRAY, 128);
        sum[k] = drawn(&s, world);
        free(world);
    }
    assert_true(sum[0] > 10 && fabs(sum[1] / sum[0] - 0.5) < 0.1);
    assert_true(sum[2] < 0.1 * sum[0] && sum[3] == 0);
}

/* A speck that flies across the picture is stretched along its way, and fainter. */
static void a_flying_speck_is_a_streak(void **state)
{
    double high[2] = { 0 }, wide[2] = { 0 };

    (void)state;
    for (int k = 0; k < 2; k++) {
        tp_scene s = scene_of(4);
        tp_world *world = scene_world(&s, &none);
        put(world, (tp_vec3){ 0, 10 * TP_FX_ONE, -6 * TP_FX_ONE }, TP_SPECK_SPRAY, 128);
        ((tp_speck *)(uintptr_t)tp_spray_list(tp_world_spray(world)))->last.x
            -= k * TP_FX_ONE / 2;
        double middle[2], sum = drawn(&s, world);
        middle_of(sum, middle);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            wide[k] += pow(i % WIDTH + 0.5 - middle[0], 2) * cover[i] / sum;
            high[k] += pow(i / WIDTH + 0.5 - middle[1], 2) * cover[i] / sum;
        }
        free(world);
    }
    printf("    variance along and across: %.2f %.2f px2, at rest %.2f %.2f\n", wide[1],
           high[1], wide[0], high[0]);
    assert_true(fabs(wide[0] / high[0] - 1) < 0.2 && wide[1] > 2 * high[1]);
}

/* 256 specks a quarter of a pixel in radius lose their area only by the rounding of their
 * opacity. */
static void far_specks_are_faint(void **state)
{
    (void)state;
    tp_scene s = scene_of(256);
    tp_world *world = scene_world(&s, &none);

    s.camera.x = 0;
    for (int i = 0; i < 256; i++)
        put(world, (tp_vec3){ (i % 16 - 8) * TP_FX_ONE, (8 + i / 16) * TP_FX_ONE,
                              -38 * TP_FX_ONE }, TP_SPECK_SPRAY, (uint8_t)i);
    const double r = 0.1 * 97 / 38, sum = drawn(&s, world), area = 256 * 1.57 * r * r;
    printf("    %.1f pixels for %.1f of the discs\n", sum, area);
    assert_true(sum > 0.85 * area && sum < 1.3 * area);
    free(world);
}

/* A speck under water is hidden from above; a speck over the water is visible. */
static void water_hides_what_lies_under_it(void **state)
{
    (void)state;
    tp_scene s = scene_of(4);
    s.camera.pitch = -30 * TP_FX_ONE;
    s.spray.size = TP_FX_ONE;
    tp_world *world = scene_world(&s, &none);

    put(world, (tp_vec3){ 0, TP_FX(-2), -17 * TP_FX_ONE }, TP_SPECK_SPRAY, 128);
    assert_true(drawn(&s, world) == 0);
    put(world, (tp_vec3){ 0, TP_FX(2), -15 * TP_FX_ONE }, TP_SPECK_SPRAY, 128);
    assert_true(drawn(&s, world) > 5);
    free(world);
}

/* Bubbles are visible only through clear water. */
static void bubbles_are_seen_through_clear_water(void **state)
{
    (void)state;
    tp_scene s = scene_of(4);
    s.camera.pitch = -30 * TP_FX_ONE;
    s.spray.size = TP_FX_ONE;
    tp_world *world = scene_world(&s, &none);

    put(world, (tp_vec3){ 0, TP_FX(-1), -17 * TP_FX_ONE }, TP_SPECK_BUBBLE, 128);
    assert_true(drawn(&s, world) == 0);
    s.water.clarity = 5 * TP_FX_ONE;
    assert_true(drawn(&s, world) > 5);
    free(world);
}

/* A speck between two ticks is drawn between its last two positions. */
static void specks_glide_between_ticks(void **state)
{
    (void)state;
    tp_scene s = scene_of(4);
    tp_world *world = scene_world(&s, &none);
    double middle[2];

    put(world, (tp_vec3){ 0, 10 * TP_FX_ONE, -4 * TP_FX_ONE }, TP_SPECK_SPRAY, 128);
    ((tp_speck *)(uintptr_t)tp_spray_list(tp_world_spray(world)))->last.x = -TP_FX_ONE;
    for (int k = 0; k < 2; k++) {
        double at[2];
        world->lag = k * TP_FX_ONE / 2;
        middle_of(drawn(&s, world), at);
        middle[k] = at[0];
    }
    assert_true(fabs(middle[0] - middle[1] - 0.5 * 97 / 4) < 1);
    free(world);
}

/* Foam and spray on moving deep water, drawn in bands, strips and blocks. */
static void every_tiling_gives_the_same_picture(void **state)
{
    static const uint32_t tiles[][2] = { { 0, 1 }, { 16, 0 }, { 48, 13 } };
    (void)state;
    tp_scene s = scene_plain();

    s.boat.mesh[0] = '\0';
    s.wave[0].steepness = s.wave[1].steepness = s.wave[2].steepness = TP_FX(0.32);
    s.foam.cells = 100;
    s.spray.count = 300;
    s.spray.size = TP_FX(0.2);
    tp_world *world = scene_world(&s, &none);
    for (int i = 0; i < 200; i++)
        tp_world_step(&tp_program_all, world, &s, NULL);
    world->lag = TP_FX(0.3);
    marks_assert_tiled(&s, &none, world, config, tiles, sizeof tiles / sizeof *tiles, key);
    s.foam.cells = 0;
    assert_true(drawn(&s, world) > 5);
    free(world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_speck_lies_where_the_camera_sees_it),
        cmocka_unit_test(specks_before_the_eye_fade),
        cmocka_unit_test(a_flying_speck_is_a_streak),
        cmocka_unit_test(far_specks_are_faint),
        cmocka_unit_test(water_hides_what_lies_under_it),
        cmocka_unit_test(bubbles_are_seen_through_clear_water),
        cmocka_unit_test(specks_glide_between_ticks),
        cmocka_unit_test(every_tiling_gives_the_same_picture),
    };
    return cmocka_run_group_tests_name("features/spray drawing", tests, NULL, NULL);
}
