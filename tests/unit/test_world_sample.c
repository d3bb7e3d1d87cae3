/* SPDX-License-Identifier: MIT */
/* The velocity of the water at a point, compared with the orbits of Gerstner waves in
 * closed form, and with positions of points a tick apart. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "tests/lib/worlds.h"

#define PI 3.14159265358979323846

static uint64_t chance;

static double metres(tp_fx x)
{
    return x / 65536.0;
}

static tp_scene scene_wave(void)
{
    tp_scene s = scene_plain();

    s.boat.mesh[0] = '\0';
    s.wave[1].amplitude = s.wave[2].amplitude = 0;
    s.wave[0].amplitude = chance_fx(&chance, 0.1, 2);
    s.wave[0].length = chance_fx(&chance, 10, 60);
    s.wave[0].steepness = chance_fx(&chance, 0, 0.6);
    s.wave[0].heading = chance_fx(&chance, 0, 360);
    s.wave[0].phase = 0;
    return s;
}

typedef struct {
    double x, y, z;
} speed;

/* [A7]: the point with rest position x0, z0 moves by d/dt of (QA D cos th, A sin th), t =
 * th of the middle of the last tick.  Bisection along the wave's direction finds the rest
 * position. */
static speed orbit(const tp_scene *s, double x, double z, double seconds)
{
    const tp_wave *w = &s->wave[0];
    const double k = 2 * PI / metres(w->length), a = metres(w->amplitude);
    const double qa = metres(w->steepness) / k,
                 omega = sqrt(metres(s->water.gravity) * k);
    const double dx = sin(metres(w->heading) * PI / 180),
                 dz = -cos(metres(w->heading) * PI / 180);
    const double now = omega * seconds, along = x * dx + z * dz;
    double low = along - qa - 1, high = along + qa + 1;

    for (int i = 0; i < 60; i++) {
        const double at = (low + high) / 2;
        *(at + qa * cos(k * at - now) < along ? &low : &high) = at;
    }
    const double th = k * low - (now - omega / 120);
    return (speed){ qa * dx * omega * sin(th), -a * omega * cos(th),
                    qa * dz * omega * sin(th) };
}

static void a_wave_moves_its_points_in_orbits(void **state)
{
    (void)state;
    double worst = 0, fastest = 0;
    for (int n = 0; n < 400; n++) {
        const tp_scene scene = scene_wave();
        tp_world *w = scene_world(&scene, NULL);
        const int ticks = chance_int(&chance, 1, 400);
        for (int i = 0; i < ticks; i++)
            tp_world_step(&tp_program_all, w, &scene, NULL);
        const tp_fx x = chance_fx(&chance, -50, 50), z = chance_fx(&chance, -50, 50);
        const tp_water water = tp_world_sample(&tp_program_all, w, x, z);
        const speed want = orbit(&scene, metres(x), metres(z), ticks / 60.0);
        const double off = fmax(fmax(fabs(metres(water.velocity.x) - want.x),
                                     fabs(metres(water.velocity.y) - want.y)),
                                fabs(metres(water.velocity.z) - want.z));
        worst = fmax(worst, off - 0.001 * metres(scene.wave[0].amplitude));
        fastest = fmax(fastest, fabs(want.y));
        free(w);
    }
    printf("    off by %.2f mm/s beside 1 mm/s a metre of amplitude, up to %.2f m/s\n",
           1000 * worst, fastest);
    assert_true(fastest > 1);
    assert_true(worst < 0.002);
}

/* True within 0.2 m of the rim of a pool.  The height ends at the rim, so a point that
 * crosses the rim jumps. */
static bool is_near_rim(const tp_scene_pool *pool, tp_fx x, tp_fx z)
{
    const double half_x = metres(pool->cell) * pool->cols / 2;
    const double half_z = metres(pool->cell) * pool->rows / 2;
    const double out_x = fabs(metres(x - pool->x)) - half_x;
    const double out_z = fabs(metres(z - pool->z)) - half_z;
    return pool->cols > 0 && fabs(fmax(out_x, out_z)) < 0.2;
}

/* A point that is here now was v / 60 away a tick ago, on the surface of the preceding
 * tick: all wave models together, by differences of positions in double precision. */
static void follow_points(uint32_t parts, double *worst, double *fastest)
{
    tp_scene scene = scene_with(&chance, parts);
    scene.boat.mesh[0] = '\0';
    scene.drops.target = TP_DROPS_RINGS;
    scene.drops.rings = 40;
    tp_world *w = scene_world(&scene, NULL), *last = scene_world(&scene, NULL);

    for (int i = 0; i < 200; i++)
        tp_world_step(&tp_program_all, w, &scene, NULL);
    /* splashes are no motion */
    scene.pool.splash_interval = scene.field.splash_interval = 0;
    scene.pool.paddle = scene.field.paddle = 0;
    for (int i = 0; i < 40; i++) {
        const tp_fx x = chance_fx(&chance, -6, 6), z = chance_fx(&chance, -6, 6);
        memcpy(last, w, w->layout.bytes);
        tp_world_step(&tp_program_all, w, &scene, NULL);
        if (is_near_rim(&scene.pool, x, z) || is_near_rim(&scene.field, x, z))
            continue;
        const tp_water now = tp_world_sample(&tp_program_all, w, x, z);
        const tp_water then = tp_world_sample(
            &tp_program_all, last, x - now.velocity.x / 60, z - now.velocity.z / 60);
        const double rise = 60 * (metres(now.height) - metres(then.height));
        *worst = fmax(*worst, fabs(metres(now.velocity.y) - rise));
        *fastest = fmax(*fastest, fabs(rise));
    }
    free(last);
    free(w);
}

static void points_come_from_where_velocities_say(void **state)
{
    (void)state;
    for (uint32_t parts = 0; parts < 32; parts++) {
        double worst = 0, fastest = 0;
        for (int n = 0; n < 6; n++)
            follow_points(parts, &worst, &fastest);
        printf("    parts %2u: off by %.2f mm/s at the most, of up to %.2f m/s\n", parts,
               1000 * worst, fastest);
        assert_true(fastest > 0.3);
        assert_true(worst < 0.006);
    }
}

/* A pure height model lifts the point and does not move the point sideways. */
static void still_water_stands_still(void **state)
{
    (void)state;
    tp_scene scene = scene_with(&chance, 4);
    scene.boat.mesh[0] = '\0';
    for (int i = 0; i < TP_WAVES; i++)
        scene.wave[i].amplitude = 0;
    scene.pool.splash_interval = 0;
    scene.pool.paddle = 0;
    tp_world *w = scene_world(&scene, NULL);

    tp_water water = tp_world_sample(&tp_program_all, w, 5, 5);
    assert_memory_equal(&water, &(tp_water){ 0 }, sizeof water);
    tp_world_push(&tp_program_all, w, &scene, scene.pool.x, scene.pool.z, TP_FX_ONE,
                  TP_FX(0.3));
    tp_world_step(&tp_program_all, w, &scene, NULL);
    water = tp_world_sample(&tp_program_all, w, scene.pool.x, scene.pool.z);
    assert_int_equal(water.velocity.x, 0);
    assert_true(water.velocity.y < 0); /* a splash sinks */
    free(w);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wave_moves_its_points_in_orbits),
        cmocka_unit_test(points_come_from_where_velocities_say),
        cmocka_unit_test(still_water_stands_still),
    };
    return cmocka_run_group_tests_name("world/sample", tests, NULL, NULL);
}
