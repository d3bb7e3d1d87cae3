/* SPDX-License-Identifier: MIT */
/* Spray and bubbles: flight compared with closed forms, the end of specks, and the
 * behaviour of a full list. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "world/module.h"
#include "features/spray/spray.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

static uint64_t chance;

static tp_scene still(int32_t count)
{
    tp_scene s;

    tp_scene_level(&s);
    s.spray.count = count;
    return s;
}

static tp_speck *speck(tp_world *world, uint32_t i)
{
    return (tp_speck *)(uintptr_t)&tp_spray_list(tp_world_spray(world))[i];
}

/* With v' = -g - v / tau, y = y0 + (v0 + g tau) tau (1 - e^(-t/tau)) - g tau t. */
static void a_speck_falls_with_its_drag(void **state)
{
    (void)state;
    const tp_scene scene = still(4);
    const double tau = 0.6, g = scene.water.gravity / 65536.0;

    for (int n = 0; n < 100; n++) {
        tp_world *world = scene_world(&scene, NULL);
        const tp_fx vx = chance_fx(&chance, -5, 5), vy = chance_fx(&chance, 2, 8);
        tp_spray_of_world(world)->count = 1;
        *speck(world, 0) = (tp_speck){ .place.y = 50 * TP_FX_ONE,
                                       .speed = { vx, vy, 0 } };
        for (int i = 1; i <= 90; i++) {
            tp_world_step(&tp_program_all, world, &scene, NULL);
            const double t = i / 60.0, gone = tau * (1 - exp(-t / tau));
            const double y = 50 + (vy / 65536.0 + g * tau) * gone - g * tau * t;
            assert_true(fabs(speck(world, 0)->place.x / 65536.0 - vx / 65536.0 * gone)
                        < 0.02);
            assert_true(fabs(speck(world, 0)->place.y / 65536.0 - y) < 0.02);
        }
        free(world);
    }
}

/* A speck thrown up from the level is gone within four ticks of its return; a bubble
 * likewise at the surface.  Last positions are those of the preceding tick. */
static void specks_end_at_the_water(void **state)
{
    (void)state;
    const tp_scene scene = still(4);
    tp_world *world = scene_world(&scene, NULL);
    tp_spray *spray = tp_spray_of_world(world);

    spray->count = 2;
    *speck(world, 0) = (tp_speck){ .place.y = TP_FX(0.1), .speed.y = TP_FX(2) };
    *speck(world, 1) = (tp_speck){ .place.y = TP_FX(-0.3), .speed.y = TP_FX(0.25),
                                   .kind = TP_SPECK_BUBBLE };
    int ticks = 0;
    for (; spray->count > 0 && ticks < 400; ticks++) {
        const tp_speck before = *speck(world, 0);
        tp_world_step(&tp_program_all, world, &scene, NULL);
        if (ticks == 0)
            assert_memory_equal(&speck(world, 0)->last, &before.place,
                                sizeof before.place);
        for (uint32_t i = 0; i < spray->count; i++)
            assert_true(speck(world, i)->kind == TP_SPECK_BUBBLE
                        ? speck(world, i)->place.y <= TP_FX(0.02)
                        : speck(world, i)->place.y > TP_FX(-0.3));
    }
    assert_true(ticks > 60 && ticks < 90);      /* the bubble's 0.3 m at 0.25 m/s */
    free(world);
}

static void a_full_list_counts_what_it_drops(void **state)
{
    (void)state;
    const tp_scene scene = still(16);
    const tp_impact impact = { .amplitude = TP_FX(0.05), .length = TP_FX(0.72) };
    tp_world *world = scene_world(&scene, NULL);
    tp_spray *spray = tp_spray_of_world(world);

    tp_spray_splash(spray, &scene, &impact, 0);
    assert_int_equal(spray->count, 16);
    assert_true(spray->dropped > 0);
    const uint32_t dropped = spray->dropped;
    tp_spray_splash(spray, &scene, &impact, 0);
    assert_int_equal(spray->count, 16);
    assert_true(spray->dropped > dropped + 16);
    free(world);
}

/* The crown flies outwards and up, bubbles go below. */
static void a_splash_is_a_crown(void **state)
{
    (void)state;
    const tp_scene scene = still(100);
    const tp_impact impact = { .x = TP_FX(3), .z = TP_FX(-2), .amplitude = TP_FX(0.05),
                               .length = TP_FX(0.72) };
    tp_world *world = scene_world(&scene, NULL);
    tp_spray *spray = tp_spray_of_world(world);
    int up = 0, bubbles = 0;

    tp_spray_splash(spray, &scene, &impact, TP_FX(0.5));
    for (uint32_t i = 0; i < spray->count; i++) {
        const tp_speck *s = speck(world, i);
        const int64_t dx = s->place.x - impact.x, dz = s->place.z - impact.z;
        if (s->kind == TP_SPECK_BUBBLE) {
            assert_true(s->place.y < TP_FX(0.5) && s->speed.y > 0);
            bubbles++;
            continue;
        }
        assert_true(s->speed.y > 0 && dx * s->speed.x + dz * s->speed.z > 0);
        up++;
    }
    assert_true(up >= 10 && bubbles * 2 >= up);
    free(world);
}

static uint32_t specks_after(const tp_scene *scene, int ticks)
{
    tp_world *world = scene_world(scene, NULL);

    for (int i = 0; i < ticks; i++)
        tp_world_step(&tp_program_all, world, scene, NULL);
    const uint32_t count = tp_world_spray(world)->count;
    free(world);
    return count;
}

static void sharp_crests_throw_specks_and_round_ones_do_not(void **state)
{
    (void)state;
    tp_scene s = scene_plain();

    s.boat.mesh[0] = '\0';
    s.spray.count = 300;
    s.wave[0].steepness = s.wave[1].steepness = s.wave[2].steepness = TP_FX(0.1);
    assert_int_equal(specks_after(&s, 300), 0);
    s.wave[0].steepness = s.wave[1].steepness = s.wave[2].steepness = TP_FX(0.32);
    assert_true(specks_after(&s, 300) > 20);
    s.spray.crest = 0;
    assert_int_equal(specks_after(&s, 300), 0);
}

static void a_bow_throws_specks_if_it_is_fast(void **state)
{
    (void)state;
    tp_scene s = still(200);

    strcpy(s.boat.mesh, "boat.obj");
    s.boat.speed = TP_FX(1.5);
    assert_int_equal(specks_after(&s, 100), 0);
    s.boat.speed = TP_FX(7);
    assert_true(specks_after(&s, 100) > 20);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_speck_falls_with_its_drag),
        cmocka_unit_test(specks_end_at_the_water),
        cmocka_unit_test(a_full_list_counts_what_it_drops),
        cmocka_unit_test(a_splash_is_a_crown),
        cmocka_unit_test(sharp_crests_throw_specks_and_round_ones_do_not),
        cmocka_unit_test(a_bow_throws_specks_if_it_is_fast),
    };
    return cmocka_run_group_tests_name("features/spray", tests, NULL, NULL);
}
