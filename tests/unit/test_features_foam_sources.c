/* SPDX-License-Identifier: MIT */
/* Sources of foam: the Jacobian compared with double precision, crests, shore, walls and a
 * hull. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/foam/foam.h"
#include "waves/deep_water.h"
#include "world/module.h"
#include "tests/lib/measure.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

static uint64_t chance;

static tp_scene sea_any(void)
{
    tp_scene s;

    tp_scene_level(&s);
    for (int i = 0; i < TP_WAVES; i++) {
        s.wave[i].amplitude = chance_int(&chance, 0, 2) ? 0 : chance_fx(&chance, 0.1, 2);
        s.wave[i].length = chance_fx(&chance, 4, 90);
        s.wave[i].steepness = chance_fx(&chance, 0, 0.3);
        s.wave[i].heading = chance_fx(&chance, -180, 180);
    }
    return s;
}

static double jacobian(const tp_deep_water *deep, const tp_turn *phases, double x, double z)
{
    double bxx = 0, bxz = 0, bzz = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        const double q32 = 4294967296.0, q30 = 1073741824.0, tau = 6.283185307179586;
        const double turns = phases[i] / q32 + (double)w->turns_x / q32 * x
                           + (double)w->turns_z / q32 * z;
        const double s = sin(tau * turns);
        bxx += w->bend_xx / q30 * s;
        bxz += w->bend_xz / q30 * s;
        bzz += w->bend_zz / q30 * s;
    }
    return (1 - bxx) * (1 - bzz) - bxz * bxz;
}

static void the_squeeze_is_the_jacobian(void **state)
{
    (void)state;
    measure off = { .what = "Jacobian", .unit = "" };

    for (int n = 0; n < 20000; n++) {
        const tp_scene scene = sea_any();
        tp_turn phases[TP_WAVES];
        tp_deep_water deep;
        tp_deep_water_init(&deep, scene.wave, TP_WAVES, scene.water.gravity);
        tp_deep_water_phases(&deep, random_below(&chance, 100000), 0, phases);
        const tp_fx x = chance_fx(&chance, -2000, 2000);
        const tp_fx z = chance_fx(&chance, -2000, 2000);
        measure_add(&off, tp_deep_water_jacobian(&deep, phases, x, z) / 65536.0
                          - jacobian(&deep, phases, x / 65536.0, z / 65536.0), x, z, n);
    }
    measure_print(&off);
    assert_true(off.worst < 6e-5);
}

static double mean_of(const tp_world *world)
{
    const tp_foam *foam = tp_world_foam(world);
    const uint8_t *cover = (const uint8_t *)(foam + 1);
    double sum = 0;

    for (uint32_t i = 0; i < foam->cells * foam->cells; i++)
        sum += cover[i];
    return sum / (foam->cells * foam->cells);
}

static double mean_after(const tp_scene *scene, int ticks)
{
    tp_world *world = scene_world(scene, NULL);

    for (int i = 0; i < ticks; i++)
        tp_world_step(&tp_program_all, world, scene, NULL);
    const double mean = mean_of(world);
    free(world);
    return mean;
}

static tp_scene field(tp_scene s, tp_fx cell)
{
    s.foam.cells = 64;
    s.foam.cell = cell;
    return s;
}

static void sharp_crests_foam_and_round_ones_do_not(void **state)
{
    (void)state;
    tp_scene s = field(scene_plain(), TP_FX_ONE);

    s.boat.mesh[0] = '\0';
    s.wave[0].steepness = s.wave[1].steepness = s.wave[2].steepness = TP_FX(0.1);
    assert_true(mean_after(&s, 600) == 0);
    s.wave[0].steepness = s.wave[1].steepness = s.wave[2].steepness = TP_FX(0.3);
    assert_true(mean_after(&s, 600) > 2);
    s.foam.crest = 0;
    assert_true(mean_after(&s, 600) == 0);
}

/* A beach that falls towards +z, with the shore line at z = -20: foam in a strip along the
 * line if waves come in, no foam on land, no foam on still water. */
static void the_shore_foams_where_it_moves(void **state)
{
    (void)state;
    tp_scene s = field(scene_plain(), TP_FX(1));

    s.boat.mesh[0] = '\0';
    s.floor.depth = TP_FX(1);
    s.floor.slope = TP_FX(0.05);
    s.foam.shore = TP_FX(0.5);
    s.foam.breaking = s.foam.crest = 0;
    tp_world *world = scene_world(&s, NULL);
    for (int i = 0; i < 400; i++)
        tp_world_step(&tp_program_all, world, &s, NULL);
    int strip = 0;
    for (int x = -20; x < 20; x++) {
        strip += tp_foam_sample(tp_world_foam(world), x * TP_FX_ONE, TP_FX(-15));
        assert_int_equal(tp_foam_sample(tp_world_foam(world), x * TP_FX_ONE, TP_FX(-25)),
                         0);
        assert_int_equal(tp_foam_sample(tp_world_foam(world), x * TP_FX_ONE, TP_FX(5)),
                         0);
    }
    assert_true(strip > 40 * 5);
    free(world);
    for (int i = 0; i < 3; i++)
        s.wave[i].amplitude = 0;
    assert_true(mean_after(&s, 100) == 0);
}

/* A poked pool: foam along its walls only. */
static void walls_foam_where_the_water_moves(void **state)
{
    (void)state;
    tp_scene s;

    tp_scene_level(&s);
    s.pool.cols = s.pool.rows = 48;
    s.pool.cell = TP_FX(0.1);
    s.pool.splash_interval = TP_FX(0.5);
    s.pool.splash_height = TP_FX(0.3);
    s.pool.splash_width = TP_FX(0.25);
    s = field(s, TP_FX(0.1));
    tp_world *world = scene_world(&s, NULL);
    for (int i = 0; i < 600; i++)
        tp_world_step(&tp_program_all, world, &s, NULL);
    assert_true(mean_of(world) > 0.1);
    for (int x = -20; x < 20; x++)
        assert_int_equal(tp_foam_sample(tp_world_foam(world), x * TP_FX(0.1), 0), 0);
    free(world);
}

static tp_scene with_boat(tp_fx speed)
{
    tp_scene s;

    tp_scene_level(&s);
    strcpy(s.boat.mesh, "boat.obj");
    s.boat.z = 0;
    s.boat.heading = 90 * TP_FX_ONE;        /* towards +x */
    s.boat.speed = speed;
    s.foam.hull = TP_FX_ONE;
    return field(s, TP_FX(0.5));
}

static int at(const tp_world *world, double x, double z)
{
    return tp_foam_sample(tp_world_foam(world), (tp_fx)(x * 65536), (tp_fx)(z * 65536));
}

/* The hull is 3 m wide amidships: a line of foam along the hull, nothing away from the
 * hull. */
static void a_hull_at_rest_has_a_line_around_it(void **state)
{
    (void)state;
    const tp_scene s = with_boat(0);
    tp_world *world = scene_world(&s, NULL);

    for (int i = 0; i < 300; i++)
        tp_world_step(&tp_program_all, world, &s, NULL);
    assert_true(at(world, 0.2, 1.6) > 60 && at(world, 0.2, -1.6) > 60);
    assert_true(at(world, 0, 3) == 0 && at(world, 9, 0) == 0 && at(world, -9, 0) == 0);
    free(world);
}

/* After 3 s at 4 m/s: foam behind the boat on both sides, in a V; no foam ahead. */
static void a_hull_that_sails_leaves_a_wake(void **state)
{
    (void)state;
    const tp_scene s = with_boat(4 * TP_FX_ONE);
    tp_world *world = scene_world(&s, NULL);

    for (int i = 0; i < 180; i++)
        tp_world_step(&tp_program_all, world, &s, NULL);
    const double bow = world->boat_state.hull.x / 65536.0 + 5.88;
    for (int side = -1; side <= 1; side += 2) {
        int arm = 0;
        for (double d = -1; d <= 0.5; d += 0.25)
            arm += at(world, bow - 8, side * (8 * 0.3536 + d));
        assert_true(arm > 100);
        assert_int_equal(at(world, bow - 4, side * 4), 0);
        assert_int_equal(at(world, bow + 1.5, side), 0);
    }
    assert_true(at(world, bow - 14, 0.3) > 20);
    free(world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_squeeze_is_the_jacobian),
        cmocka_unit_test(sharp_crests_foam_and_round_ones_do_not),
        cmocka_unit_test(the_shore_foams_where_it_moves),
        cmocka_unit_test(walls_foam_where_the_water_moves),
        cmocka_unit_test(a_hull_at_rest_has_a_line_around_it),
        cmocka_unit_test(a_hull_that_sails_leaves_a_wake),
    };
    return cmocka_run_group_tests_name("features/foam sources", tests, NULL, NULL);
}
