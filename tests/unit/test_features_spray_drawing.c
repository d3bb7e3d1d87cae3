/* SPDX-License-Identifier: MIT */
/* Specks in the picture: position, size, occlusion. */
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

static uint32_t drawn(const tp_scene *scene, const tp_world *world)
{
    marks_draw(scene, &none, world, config, key, NULL);
    return marks_count(key, WIDTH * HEIGHT, MARKS_SPRAY);
}

/* A disc of the right area around the right pixel. */
static void a_speck_lies_where_the_camera_sees_it(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        tp_scene s = scene_of(4);
        tp_world *world = scene_world(&s, &none);
        const tp_vec3 at = { chance_fx(&chance, -1, 1), chance_fx(&chance, 9.5, 10.5),
                             chance_fx(&chance, -4, -2) };
        const ref_camera camera = ref_camera_make(world->eye, 0, 0, s.camera.fov,
                                                s.camera.near, WIDTH, HEIGHT);
        put(world, at, TP_SPECK_SPRAY, 128);
        const uint32_t count = drawn(&s, world);
        const double depth = -at.z / 65536.0, r = 0.05 * camera.focal / depth;
        const double u = camera.u0 + camera.focal * at.x / 65536.0 / depth;
        const double v = camera.v0 - camera.focal * (at.y / 65536.0 - 10) / depth;
        assert_true(fabs(count - 3.1416 * r * r) < 3 + 4 * r);
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            if (TP_MARK(key[i]) == MARKS_SPRAY)
                assert_true(hypot(i % WIDTH + 0.5 - u, i / WIDTH + 0.5 - v) < r + 1);
        free(world);
    }
}

/* Among 256 specks a quarter of a pixel wide, a quarter is drawn, one pixel each. */
static void far_specks_thin_out(void **state)
{
    (void)state;
    tp_scene s = scene_of(256);
    tp_world *world = scene_world(&s, &none);

    s.camera.x = 0;
    for (int i = 0; i < 256; i++)
        put(world, (tp_vec3){ (i % 16 - 8) * TP_FX_ONE, (8 + i / 16) * TP_FX_ONE,
                              -38 * TP_FX_ONE }, TP_SPECK_SPRAY, (uint8_t)i);
    const uint32_t count = drawn(&s, world);
    printf("    %u of 256 specks of %.2f pixels\n", count, 0.1 * 97 / 38);
    assert_true(count > 35 && count < 90);
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
    assert_int_equal(drawn(&s, world), 0);
    put(world, (tp_vec3){ 0, TP_FX(2), -15 * TP_FX_ONE }, TP_SPECK_SPRAY, 128);
    assert_true(drawn(&s, world) > 10);
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
    assert_int_equal(drawn(&s, world), 0);
    s.water.clarity = 5 * TP_FX_ONE;
    assert_true(drawn(&s, world) > 10);
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
        double sum = 0;
        world->lag = k * TP_FX_ONE / 2;
        const uint32_t count = drawn(&s, world);
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            sum += TP_MARK(key[i]) == MARKS_SPRAY ? i % WIDTH + 0.5 : 0;
        middle[k] = sum / count;
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
    assert_true(marks_count(key, WIDTH * HEIGHT, MARKS_SPRAY) > 5);
    free(world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_speck_lies_where_the_camera_sees_it),
        cmocka_unit_test(far_specks_thin_out),
        cmocka_unit_test(water_hides_what_lies_under_it),
        cmocka_unit_test(bubbles_are_seen_through_clear_water),
        cmocka_unit_test(specks_glide_between_ticks),
        cmocka_unit_test(every_tiling_gives_the_same_picture),
    };
    return cmocka_run_group_tests_name("features/spray drawing", tests, NULL, NULL);
}
