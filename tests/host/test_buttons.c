/* SPDX-License-Identifier: MIT */
/* Five buttons as input: each has its effect once, on release. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include "../../ports/serial/buttons.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"
#include "world/world.h"

#define NONE 0x1fu              /* no button pressed: all lines are high */

static const tp_assets none;

typedef struct { tp_scene scene; tp_world *world; } water;

/* A pool of 8 m per side around (1, -2), and drops. */
static water water_with(int32_t cols, int32_t drops)
{
    water w = { .scene = scene_plain() };
    w.scene.boat.mesh[0] = '\0';
    w.scene.pool.cols = cols;
    w.scene.pool.rows = 16;
    w.scene.pool.cell = TP_FX(0.5);
    w.scene.pool.x = TP_FX(1);
    w.scene.pool.z = TP_FX(-2);
    w.scene.drops.count = drops;
    const size_t bytes = tp_world_bytes(&tp_program_all, &w.scene, &none);
    w.world = malloc(bytes);
    assert_int_equal(
        tp_world_init(&tp_program_all, w.world, bytes, &w.scene, &none, NULL), TP_OK);
    return w;
}

static void water_free(water *w)
{
    free(w->world);
}

/* Returns the input of a button pressed and released. */
static tp_input click(const water *w, uint32_t button)
{
    buttons  b = { NONE };
    tp_input input = { 0 };
    buttons_read(&b, NONE & ~button, w->world, &w->scene, &input);
    assert_memory_equal(&input, &(tp_input){ 0 }, sizeof input);
    buttons_read(&b, NONE, w->world, &w->scene, &input);
    return input;
}

static void each_button_does_what_it_stands_for(void **state)
{
    (void)state;
    water w = water_with(16, 4);
    const tp_input drop = { .drops = 1 }, light = { .light_turn = (int32_t)TP_DEG(15) };
    const tp_input left = { .sphere_x = TP_FX(-0.25) }, right = { .sphere_x = TP_FX(0.25) };
    tp_input got = click(&w, BUTTON_UP);
    assert_memory_equal(&got, &drop, sizeof got);
    got = click(&w, BUTTON_DOWN);
    assert_memory_equal(&got, &light, sizeof got);
    got = click(&w, BUTTON_LEFT);
    assert_memory_equal(&got, &left, sizeof got);
    got = click(&w, BUTTON_RIGHT);
    assert_memory_equal(&got, &right, sizeof got);
    assert_int_equal(click(&w, BUTTON_SELECT).push[0].height, w.scene.pool.splash_height);
    water_free(&w);
}

/* Poke lines have filled the tick's input: the button acts in the next tick. */
static void a_poke_that_finds_no_room_comes_a_tick_later(void **state)
{
    (void)state;
    water w = water_with(24, 8);
    buttons b = { NONE & ~(uint32_t)BUTTON_SELECT };
    tp_input full = { 0 }, next = { 0 }, after = { 0 };
    for (int i = 0; i < TP_PUSHES; i++)
        full.push[i].height = 1;
    buttons_read(&b, NONE, w.world, &w.scene, &full);
    buttons_read(&b, NONE, w.world, &w.scene, &next);
    assert_int_equal(next.push[0].height, w.scene.pool.splash_height);
    buttons_read(&b, NONE, w.world, &w.scene, &after);
    assert_int_equal(after.push[0].height, 0);
    water_free(&w);
}

static void without_drops_the_camera_turns_and_nothing_falls(void **state)
{
    (void)state;
    water w = water_with(0, 0);
    const tp_input left = { .turn = -(int32_t)TP_DEG(10) }, nothing = { 0 };
    tp_input got = click(&w, BUTTON_LEFT);
    assert_memory_equal(&got, &left, sizeof got);
    got = click(&w, BUTTON_UP);
    assert_memory_equal(&got, &nothing, sizeof got);
    got = click(&w, BUTTON_SELECT);
    assert_memory_equal(&got, &nothing, sizeof got);
    got = click(&w, BUTTON_LEFT | BUTTON_RIGHT);
    assert_memory_equal(&got, &nothing, sizeof got);
    water_free(&w);
}

/* Input lines of an emulator read low until first driven. */
static void only_what_rises_acts(void **state)
{
    (void)state;
    water w = water_with(16, 4);
    buttons  b = { 0 };
    tp_input input = { 0 };
    for (int i = 0; i < 5; i++)
        buttons_read(&b, 0, w.world, &w.scene, &input);
    assert_int_equal(input.drops, 0);
    for (int i = 0; i < 5; i++)
        buttons_read(&b, BUTTON_UP, w.world, &w.scene, &input);
    assert_int_equal(input.drops, 1);
    buttons_read(&b, 0, w.world, &w.scene, &input);
    buttons_read(&b, BUTTON_UP, w.world, &w.scene, &input);
    assert_int_equal(input.drops, 2);
    water_free(&w);
}

static void aim_from(water *w, double x, double y, double z, double degrees)
{
    w->world->eye = (tp_vec3){ (tp_fx)(x * 65536), (tp_fx)(y * 65536),
                               (tp_fx)(z * 65536) };
    w->world->pitch = tp_turn_of_degrees((tp_fx)(degrees * 65536));
    tp_world_move_camera(w->world, &(tp_input){ 0 });
}

static void a_poke_falls_where_the_middle_looks(void **state)
{
    (void)state;
    water w = water_with(16, 0);
    aim_from(&w, 2, 3, 2, -45);
    tp_input got = click(&w, BUTTON_SELECT);
    assert_in_range(got.push[0].x, TP_FX(1.99), TP_FX(2.01));
    assert_in_range(got.push[0].z + TP_FX(5), TP_FX(3.99), TP_FX(4.01));   /* 2 - 3 */
    water_free(&w);
}

/* From far away, behind the pool, above the horizon or below: the poke still hits the
 * pool. */
static void a_poke_falls_into_the_pool(void **state)
{
    static const double pitch[] = { -89, -45, -3, -0.01, 0, 20, 89 };
    static const double eye[][3] = { { 0, 3, 0 }, { 8000, 2000, 8000 }, { -8000, 9, 3 },
                                     { 1, -4, -2 }, { 7999, 0, -7999 } };
    (void)state;
    water w = water_with(16, 0);
    for (size_t i = 0; i < sizeof pitch / sizeof pitch[0]; i++)
        for (size_t j = 0; j < sizeof eye / sizeof eye[0]; j++) {
            aim_from(&w, eye[j][0], eye[j][1], eye[j][2], pitch[i]);
            const tp_input got = click(&w, BUTTON_SELECT);
            assert_true(got.push[0].x >= TP_FX(-3) && got.push[0].x <= TP_FX(5));
            assert_true(got.push[0].z >= TP_FX(-6) && got.push[0].z <= TP_FX(2));
        }
    water_free(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_button_does_what_it_stands_for),
        cmocka_unit_test(a_poke_that_finds_no_room_comes_a_tick_later),
        cmocka_unit_test(without_drops_the_camera_turns_and_nothing_falls),
        cmocka_unit_test(only_what_rises_acts),
        cmocka_unit_test(a_poke_falls_where_the_middle_looks),
        cmocka_unit_test(a_poke_falls_into_the_pool),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
