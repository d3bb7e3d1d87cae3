/* SPDX-License-Identifier: MIT */
/* The foam field: foam fades by its time constant and to zero, drifts without loss, follows
 * the eye, and is the same in copies of the world. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/foam/foam.h"
#include "world/module.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

static uint64_t chance;

/* Still water with a foam field of 64 cells of 0.5 m around the eye. */
static tp_scene still(tp_fx fade)
{
    tp_scene s;

    tp_scene_level(&s);
    s.foam.cells = 64;
    s.foam.cell = TP_FX(0.5);
    s.foam.fade = fade;
    return s;
}

static double sum_of(const tp_world *world)
{
    const tp_foam *foam = tp_world_foam(world);
    const uint8_t *cover = (const uint8_t *)(foam + 1);
    double sum = 0;

    for (uint32_t i = 0; i < foam->cells * foam->cells; i++)
        sum += cover[i];
    return sum;
}

static void fill_any(tp_world *world)
{
    tp_foam *foam = tp_foam_of_world(world);

    for (uint32_t i = 0; i < foam->cells * foam->cells; i++)
        tp_foam_cover(foam)[i] = (uint8_t)random_next(&chance);
}

static void step(tp_world *world, const tp_scene *scene, int ticks)
{
    for (int i = 0; i < ticks; i++)
        tp_world_step(&tp_program_all, world, scene, NULL);
}

/* -- fading -------------------------------------------------------------------------- */

/* The sum over 4096 cells compared with e^(-t / fade): roundings are unbiased. */
static void foam_fades_by_its_time(void **state)
{
    static const double fades[] = { 0.1, 0.5, 4, 30, 600 };
    (void)state;

    for (int n = 0; n < 5; n++) {
        const tp_scene scene = still((tp_fx)lround(fades[n] * 65536));
        const double fade = (double)lround(fades[n] * 65536) / 65536;
        tp_world *world = scene_world(&scene, NULL);
        const int ticks = TP_FOAM_TICKS * (1 + (int)(fade * 60 / TP_FOAM_TICKS));
        fill_any(world);
        const double before = sum_of(world), want = exp(-ticks / 60.0 / fade);
        step(world, &scene, ticks);
        const double got = sum_of(world) / before;
        printf("    fade %5.1f s: after %5d ticks %.5f, e^-t/fade %.5f\n", fade, ticks,
               got, want);
        assert_true(fabs(got - want) < 0.003);
        free(world);
    }
}

static void still_water_ends_without_any(void **state)
{
    (void)state;
    const tp_scene scene = still(TP_FX(2.5));
    tp_world *world = scene_world(&scene, NULL);
    int ticks = 0;

    memset(tp_foam_cover(tp_foam_of_world(world)), 255, 64 * 64);
    for (; sum_of(world) > 0; ticks += TP_FOAM_TICKS) {
        assert_true(ticks < 60 * 60);
        step(world, &scene, TP_FOAM_TICKS);
    }
    printf("    fade 2.5 s: from white to nothing in %d ticks\n", ticks);
    assert_true(ticks > 60 * 2.5 * log(255));
    free(world);
}

/* -- drift --------------------------------------------------------------------------- */

/* A patch of foam lies at its drifted position without loss, at any speed: 37 ticks at 1.5
 * m/s are 0.925 m, almost two cells. */
static void drift_moves_foam_without_spreading_it(void **state)
{
    (void)state;
    tp_scene scene = still(600 * TP_FX_ONE);
    tp_world *world = scene_world(&scene, NULL);

    scene.foam.map.drift_x = TP_FX(1.5);
    scene.foam.map.drift_z = TP_FX(-0.7);
    tp_foam_add_blob(tp_foam_of_world(world), TP_FX(2.25), TP_FX(1.25), TP_FX(0.2), 200);
    const double sum = sum_of(world);
    const int there = tp_foam_sample(tp_world_foam(world), TP_FX(2.25), TP_FX(1.25));
    assert_true(there > 100);
    step(world, &scene, 37);
    assert_true(sum_of(world) <= sum && sum_of(world) > 0.99 * sum - 4);
    assert_true(abs(tp_foam_sample(tp_world_foam(world), TP_FX(2.25 + 0.925),
                               TP_FX(1.25 - 0.43167)) - there) <= 3);
    free(world);
}

/* Drift over many sides of the field, and back to the start after the same drift in
 * reverse. */
static void drift_goes_round(void **state)
{
    (void)state;
    tp_scene scene = still(600 * TP_FX_ONE);
    tp_world *world = scene_world(&scene, NULL);
    const tp_foam *foam = tp_world_foam(world);

    for (int n = 0; n < 2000; n++) {
        scene.foam.map.drift_x = chance_int(&chance, -20, 20) * TP_FX_ONE;
        scene.foam.map.drift_z = 20 * TP_FX_ONE;
        step(world, &scene, 1);
        const int64_t low = (int64_t)foam->first_x * foam->cell + (foam->drift_x >> 16);
        assert_true(foam->drift_x >= 0 && foam->drift_x < (int64_t)32 << 32);
        assert_true(low <= -16 * TP_FX_ONE + 1 && low > -TP_FX(16.51));
    }
    free(world);
}

/* -- the window ---------------------------------------------------------------------- */

/* Foam within 16 m of the eye keeps its position in the world; foam that the window leaves
 * behind is gone and does not reappear at the other side. */
static void the_window_follows_the_eye(void **state)
{
    (void)state;
    const tp_scene scene = still(600 * TP_FX_ONE);
    tp_world *world = scene_world(&scene, NULL);
    const tp_input aside = { .strafe = TP_FX(0.1) };

    tp_foam_add_blob(tp_foam_of_world(world), TP_FX(5.25), TP_FX(0.25), TP_FX(0.5), 250);
    const int there = tp_foam_sample(tp_world_foam(world), TP_FX(5.25), TP_FX(0.25));
    for (int i = 0; i < 190; i++)
        tp_world_step(&tp_program_all, world, &scene, &aside);
    assert_true(abs(tp_foam_sample(tp_world_foam(world), TP_FX(5.25), TP_FX(0.25)) - there)
                <= 4);
    for (int i = 0; i < 40; i++)
        tp_world_step(&tp_program_all, world, &scene, &aside);
    assert_true(sum_of(world) == 0);
    free(world);
}

/* The field is stored modulo its side: addresses beyond one side are those of cells at the
 * other side. */
static void beyond_the_window_there_is_no_foam(void **state)
{
    (void)state;
    const tp_scene scene = still(600 * TP_FX_ONE);
    tp_world *world = scene_world(&scene, NULL);
    const tp_foam *foam = tp_world_foam(world);
    const tp_fx left = foam->first_x * foam->cell, near = foam->first_z * foam->cell;
    const tp_fx side = 64 * foam->cell, off = foam->cell / 256;

    assert_true(foam->drift_x == 0 && foam->drift_z == 0);
    memset(tp_foam_cover(tp_foam_of_world(world)), 255, 64 * 64);
    for (tp_fx way = 0; way < side; way += off * 61) {
        assert_int_equal(tp_foam_sample(foam, left, near + way), 255);
        assert_int_equal(tp_foam_sample(foam, left - off, near + way), 0);
        assert_int_equal(tp_foam_sample(foam, left + side - 1, near + way), 255);
        assert_int_equal(tp_foam_sample(foam, left + side, near + way), 0);
        assert_int_equal(tp_foam_sample(foam, left + way, near), 255);
        assert_int_equal(tp_foam_sample(foam, left + way, near - off), 0);
        assert_int_equal(tp_foam_sample(foam, left + way, near + side - 1), 255);
        assert_int_equal(tp_foam_sample(foam, left + way, near + side), 0);
    }
    free(world);
}

/* -- the foam as a part of the world ------------------------------------------------- */

static void other_cells_need_another_world(void **state)
{
    (void)state;
    tp_scene scene = still(TP_FX_ONE);
    tp_world *world = scene_world(&scene, NULL);

    assert_non_null(tp_foam_of_world(world));
    scene.foam.fade = TP_FX(3);
    scene.foam.map.drift_x = TP_FX_ONE;
    assert_true(tp_world_apply(&tp_program_all, world, &scene, NULL));
    scene.foam.cell = TP_FX(0.6);
    assert_false(tp_world_apply(&tp_program_all, world, &scene, NULL));
    scene.foam.cell = TP_FX(0.5);
    scene.foam.cells = 63;
    assert_false(tp_world_apply(&tp_program_all, world, &scene, NULL));
    scene.foam.cells = 0;
    assert_int_equal(tp_world_bytes(&tp_program_all, &scene, NULL), sizeof(tp_world));
    free(world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(foam_fades_by_its_time),
        cmocka_unit_test(still_water_ends_without_any),
        cmocka_unit_test(drift_moves_foam_without_spreading_it),
        cmocka_unit_test(drift_goes_round),
        cmocka_unit_test(the_window_follows_the_eye),
        cmocka_unit_test(beyond_the_window_there_is_no_foam),
        cmocka_unit_test(other_cells_need_another_world),
    };
    return cmocka_run_group_tests_name("features/foam", tests, NULL, NULL);
}
