/* SPDX-License-Identifier: MIT */
/* Boat and pool come to rest [E4]: the hull does not react to its own ripples. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/boats.h"

static uint64_t chance;

/* -- rest ---------------------------------------------------------------------------- */

static void a_boat_at_rest_leaves_still_water_still(void **state)
{
    (void)state;
    for (int n = 0; n < 6; n++) {
        tp_scene s = pool_scene((tp_cells)(n % 3), TP_EDGES_WALL);
        s.boat.mode = n < 3 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        tp_world *w = wake_world(&s);
        for (int t = 0; t < 200; t++)
            tp_world_step(&tp_program_all, w, &s, NULL);
        const tp_pool_state look = tp_pool_stats(water_of(w));
        assert_int_equal(w->boat_state.wake_ticks, 0);
        assert_true(look.at_rest && look.highest == 0 && look.fastest == 0);
        free(w);
    }
}

static bool is_at_rest(const tp_world *w)
{
    const int64_t *speed = w->boat_state.attitude.speed;

    return tp_pool_stats(tp_world_pool(w)).at_rest && !speed[0] && !speed[1] && !speed[2]
           && memcmp(&w->boat, &w->last_boat, sizeof w->boat) == 0;
}

/* A boat sails for two seconds, turns and stops.  Returns the ticks until nothing moves for
 * 200 more ticks, and counts the strokes into the pool before the stop. */
static int ticks_to_rest(const tp_scene *s, int most, uint32_t *strokes)
{
    tp_world *w = wake_world(s);
    const tp_input in = { .throttle = 3 * TP_FX_ONE, .rudder = 30 * TP_FX_ONE };
    int t = 0, rests = 0;

    for (; t < 120; t++)
        tp_world_step(&tp_program_all, w, s, &in);
    *strokes = w->boat_state.wake_ticks;
    for (; rests < 200 && t < most; t++) {
        const uint32_t stirs = w->boat_state.wake_ticks;
        tp_world_step(&tp_program_all, w, s, NULL);
        rests = is_at_rest(w) && w->boat_state.wake_ticks == stirs ? rests + 1 : 0;
    }
    free(w);
    return t - rests;
}

/* At rest 16-bit cells are flat, hence the boat too; this is [C10].  Smoothed and floating
 * boats react to their own ripples. */
static void pool_and_boat_come_to_exact_rest(void **state)
{
    (void)state;
    for (int n = 0; n < 9; n++) {
        tp_scene s = pool_scene((tp_cells)(n % 3), TP_EDGES_WALL);
        s.pool.cols = s.pool.rows = 64;
        s.pool.damping = 4;
        s.boat.mode = n < 3 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        s.boat.smooth = n < 6 ? 0 : TP_FX(0.5);
        uint32_t strokes;
        const int ticks = ticks_to_rest(&s, 8000, &strokes);
        print_message("# %d bits, %s: rest after %d ticks\n", 8 << n % 3,
                      n < 3 ? "floating" : n < 6 ? "lying" : "smoothed", ticks);
        assert_true(ticks < 8000 && strokes > 5);
    }
}

/* Small pools with long ringing, and boats that fill the pool and lag far behind its waves:
 * a hull that reacted to its own ripples would excite the ripples forever. */
static void no_boat_stirs_its_own_ripples_on(void **state)
{
    (void)state;
    uint32_t sum = 0;

    for (int n = 0; n < 8; n++) {
        tp_scene s = pool_scene((tp_cells)(n % 3), TP_EDGES_WALL);
        uint32_t strokes;
        s.pool.cols = s.pool.rows = 32;
        s.pool.damping = 5;
        s.pool.courant = chance_fx(&chance, 0.3, 0.48);
        s.pool.cell = chance_scale(&chance, 0.1, 1);
        s.boat.length = chance_scale(&chance, 0.5, 12);
        s.boat.beam = chance_scale(&chance, 0.5, 6);
        s.boat.draft = chance_scale(&chance, 0.1, 1);
        s.boat.drag = TP_FX(0.2);
        s.boat.mode = n % 2 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        s.boat.smooth = chance_scale(&chance, 0.1, 1);
        assert_true(ticks_to_rest(&s, 12000, &strokes) < 11800);
        sum += strokes;
    }
    assert_true(sum > 100);         /* a small boat in coarse cells hardly stirs the pool */
}

/* A floating boat in a swell over a pool rocks relative to the swell, and its ripples
 * spread; a kinematic boat makes no ripples. */
static void a_boat_that_rocks_stirs_the_pool(void **state)
{
    (void)state;
    for (int n = 0; n < 2; n++) {
        tp_scene s = pool_scene(TP_CELLS_16, TP_EDGES_SPONGE);
        s.wave[0] = (tp_wave){ TP_FX(0.4), 12 * TP_FX_ONE, 0, 0, 0, TP_FX_ONE, 1 };
        s.boat.mode = n == 0 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        tp_world *w = wake_world(&s);
        int32_t far = 0;
        for (int t = 0; t < 300; t++) {
            tp_world_step(&tp_program_all, w, &s, NULL);
            const int32_t h = abs(tp_pool_height_lsb(tp_world_pool(w), 48, 20));
            far = h > far ? h : far;
        }
        print_message("# %s: %u strokes, %.1f mm at 7 m\n", n ? "lying" : "floating",
                      w->boat_state.wake_ticks, far / lsb_of(tp_world_pool(w)) * 1000);
        assert_int_equal(w->boat_state.wake_ticks > 200, n == 0);
        assert_int_equal(far > lsb_of(tp_world_pool(w)) * 0.002, n == 0);
        assert_int_equal(w->boat_state.wake_ticks == 0, n == 1);
        free(w);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_boat_at_rest_leaves_still_water_still),
        cmocka_unit_test(pool_and_boat_come_to_exact_rest),
        cmocka_unit_test(no_boat_stirs_its_own_ripples_on),
        cmocka_unit_test(a_boat_that_rocks_stirs_the_pool),
    };
    return cmocka_run_group_tests_name("features/boat_wake_rest", tests, NULL, NULL);
}
