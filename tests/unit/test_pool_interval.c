/* SPDX-License-Identifier: MIT */
/* Pools whose cells step in every second or fourth tick: waves keep their speed and their
 * decay per second, the shown surface moves evenly from tick to tick, and the water comes to
 * exact rest; too long a step is refused in words. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/pools.h"

#define PI 3.14159265358979323846

static uint64_t chance;

static tp_pool_config slow_pool(tp_cells cells, tp_edges edges, uint32_t interval)
{
    tp_pool_config c = pool_config(cells, edges, 48, 32);

    c.courant = TP_FX(0.12);
    c.damping = 8;
    c.interval = interval;
    return c;
}

/* -- refusals ------------------------------------------------------------------------ */

static void refuses(const tp_pool_config *c, const char *sentence)
{
    char text[160];
    tp_error err;

    assert_int_not_equal(tp_pool_check(c, &err), TP_OK);
    assert_string_equal(err.word, "interval");
    tp_error_text(&err, text, sizeof text);
    assert_non_null(strstr(text, sentence));
}

static void too_long_a_step_is_refused(void **state)
{
    (void)state;
    tp_pool_config c = slow_pool(TP_CELLS_16, TP_EDGES_WALL, 1);

    for (c.interval = 0; c.interval <= 2; c.interval++)
        assert_int_equal(tp_pool_check(&c, NULL), TP_OK);
    c.interval = 1;
    c.courant = TP_FX(0.25);
    refuses(&c, "interval: a step in 2 ticks takes a courant up to 0.249 with this damping");
    c.interval = 2;
    refuses(&c, "interval: a step in 4 ticks takes a courant up to 0.124 with this damping");
    c.courant = TP_FX(0.1);
    c.damping = 5;
    refuses(&c, "interval: a step in 4 ticks takes a damping of 6 or more");
    c.interval = 3;
    refuses(&c, "interval is outside the range of pools");
}

/* The bound of a step in n ticks is that of a step in one at n times the Courant number. */
static void the_bound_is_that_of_the_step(void **state)
{
    (void)state;
    for (uint32_t m = 5; m <= 10; m++) {
        tp_pool_config one = slow_pool(TP_CELLS_16, TP_EDGES_WALL, 0), two = one;
        two.interval = 1;
        two.damping = m;
        one.damping = m - 1;
        for (int k = 0; k < 400; k++) {
            two.courant = TP_FX(0.23) + 5 * k;
            one.courant = 2 * two.courant;
            assert_int_equal(tp_pool_check(&one, NULL) == TP_OK,
                             tp_pool_check(&two, NULL) == TP_OK);
        }
    }
}

static void a_moving_pool_keeps_its_interval(void **state)
{
    (void)state;
    tp_pool_config c = slow_pool(TP_CELLS_16, TP_EDGES_WALL, 1);
    tp_pool *pool = pool_make(&c);

    assert_true(tp_pool_set_config(pool, &c));
    c.interval = 0;
    assert_false(tp_pool_set_config(pool, &c));
    c.interval = 2;
    assert_false(tp_pool_set_config(pool, &c));
    free(pool);
}

/* -- waves --------------------------------------------------------------------------- */

/* Raises a standing wave of `length` cells along x. */
static void raise_wave(tp_pool *pool, double length, int32_t high)
{
    for (uint32_t y = 0; y < pool->rows; y++)
        for (uint32_t x = 0; x < pool->cols; x++)
            tp_pool_add_cell_height(pool, x, y,
                                    (int32_t)lround(high * cos(2 * PI * x / length)));
    tp_pool_start_carry_rounding(pool, high);
}

/* Returns the wave's amplitude, m: its height over column 0 at the last step. */
static double crest_after(uint32_t interval, uint32_t damping, int ticks)
{
    tp_pool_config c = slow_pool(TP_CELLS_32, TP_EDGES_TILE, interval);
    c.damping = damping;
    tp_pool *pool = pool_make(&c);

    raise_wave(pool, 24, 1 << 23);
    pool_steps(pool, ticks);
    const double crest = tp_pool_height_lsb(pool, 0, 0) / (double)(1 << 24);
    free(pool);
    return crest;
}

/* 24 cells at 0.12 cells a tick are a period of 200 ticks; m = 8 loses e^(-t / 2 2^8). */
static void waves_keep_their_speed_and_decay(void **state)
{
    (void)state;
    static const int ticks[] = { 48, 100, 200, 400, 600 };

    for (uint32_t interval = 0; interval <= 2; interval++)
        for (size_t i = 0; i < sizeof ticks / sizeof ticks[0]; i++) {
            const double exact = 0.5 * cos(2 * PI * ticks[i] / 200.0)
                               * exp(-ticks[i] / 512.0);
            assert_true(fabs(crest_after(interval, 8, ticks[i]) - exact) < 0.03);
        }
}

/* Sums of squares of all heights after 480 ticks. */
static double energy_after(tp_edges edges, uint32_t interval)
{
    const tp_pool_config c = slow_pool(TP_CELLS_32, edges, interval);
    tp_pool *pool = pool_make(&c);
    double sum = 0;

    tp_pool_add_splash(pool, 0, 0, TP_FX(0.75), TP_FX(0.4));
    for (int tick = 0; tick < 480; tick++) {
        tp_pool_step(pool);
        for (uint32_t i = 0; tick >= 360 && i < tp_pool_count(pool); i++) {
            const double h = tp_pool_cell_height(pool, i) / (double)(1 << 24);
            sum += h * h;
        }
    }
    free(pool);
    return sum;
}

/* Energies after 6 s, of that of a pool with walls that steps in every tick. */
static void walls_keep_and_sponges_take_as_much_a_second(void **state)
{
    (void)state;
    const double walls = energy_after(TP_EDGES_WALL, 0);
    const double sponge = energy_after(TP_EDGES_SPONGE, 0) / walls;

    for (uint32_t interval = 0; interval <= 2; interval++) {
        const double w = energy_after(TP_EDGES_WALL, interval) / walls;
        const double s = energy_after(TP_EDGES_SPONGE, interval) / walls;
        print_message("    %u ticks a step: walls %.3f, sponge %.4f\n", 1u << interval, w,
                      s);
        assert_true(w > 0.95 && w < 1.05);
        assert_true(s > sponge - 0.004 && s < sponge + 0.004);
    }
}

/* -- the shown surface --------------------------------------------------------------- */

static tp_height_slope shown(const tp_pool *pool, int i, tp_fx lag)
{
    return tp_pool_height_slope(pool, TP_FX(0.3) * i - TP_FX(3), TP_FX(0.2) * i, lag);
}

/* The surface a tick ago is that of the last tick's end, and half a tick ago half way. */
static void the_shown_surface_never_jumps(void **state)
{
    (void)state;
    for (int n = 0; n < 18; n++) {
        const tp_pool_config c = slow_pool((tp_cells)(n % 3), (tp_edges)(n / 3 % 3),
                                           (uint32_t)(1 + n / 9));
        tp_pool *pool = pool_make(&c);
        tp_pool_add_splash(pool, 0, 0, TP_FX(0.9), TP_FX(0.5));
        pool_steps(pool, 4 * n);
        for (int tick = 0; tick < 24; tick++) {
            tp_fx before[20];
            for (int i = 0; i < 20; i++)
                before[i] = shown(pool, i, 0).height;
            tp_pool_step(pool);
            for (int i = 0; i < 20; i++) {
                const tp_fx now = shown(pool, i, 0).height;
                const tp_fx half = shown(pool, i, TP_FX_ONE / 2).height;
                assert_true(tp_abs(shown(pool, i, TP_FX_ONE).height - before[i]) <= 2);
                assert_true(tp_abs(half - (now + before[i]) / 2) <= 2);
            }
        }
        free(pool);
    }
}

/* A sample and the table of slopes agree between two steps. */
static void slopes_follow_the_shown_surface(void **state)
{
    (void)state;
    static tp_pool_slope table[50 * 34];
    const tp_pool_config c = slow_pool(TP_CELLS_16, TP_EDGES_WALL, 2);
    tp_pool *pool = pool_make(&c);

    tp_pool_add_splash(pool, 0, 0, TP_FX(0.9), TP_FX(0.5));
    for (int tick = 0; tick < 50; tick++) {
        tp_pool_step(pool);
        tp_pool_slopes(pool, TP_FX(0.25), TP_FX_ONE, table);
        const tp_pool_slope *at = table + 50 * 17 + 25;     /* cell 24, 16 */
        const tp_height_slope s = tp_pool_height_slope(pool, TP_FX(0.125), TP_FX(0.125),
                                                       TP_FX(0.25));
        assert_true(tp_abs(at->x * 16 - s.slope_x) <= 40);
        assert_true(tp_abs(at->z * 16 - s.slope_z) <= 40);
    }
    free(pool);
}

/* -- rest, drive --------------------------------------------------------------------- */

static void water_comes_to_exact_rest(void **state)
{
    (void)state;
    for (int n = 0; n < 18; n++) {
        tp_pool_config c = slow_pool((tp_cells)(n % 3), (tp_edges)(n / 3 % 3),
                                     (uint32_t)(1 + n / 9));
        c.damping = 6;
        c.cols = c.rows = 20;
        tp_pool *pool = pool_make(&c);
        pool_fill(pool, &chance, c.cells == TP_CELLS_8 ? 60 : 400);
        for (int tick = 0; tick < 40000 && !pool->at_rest; tick++)
            tp_pool_step(pool);
        assert_true(pool->at_rest);
        assert_int_equal(look_bounded(pool).fastest, 0);
        free(pool);
    }
}

/* The drive holds the rms of heights in its band at each interval. */
static void the_drive_keeps_its_band(void **state)
{
    (void)state;
    for (uint32_t interval = 0; interval <= 2; interval++) {
        tp_pool_config c = slow_pool(TP_CELLS_16, TP_EDGES_TILE, interval);
        c.damping = 7;
        c.drive_min = TP_FX(0.02);
        c.drive_max = TP_FX(0.03);
        c.drive_amplitude = TP_FX(0.1);
        tp_pool *pool = pool_make(&c);
        double mean = 0;
        for (int tick = 0; tick < 1500; tick++) {
            double sum = 0;
            tp_pool_step(pool);
            for (uint32_t i = 0; i < tp_pool_count(pool); i++) {
                const double h = tp_pool_cell_height(pool, i) / 32767.0;
                sum += h * h;
            }
            mean += tick < 500 ? 0 : sqrt(sum / tp_pool_count(pool)) / 1000;
        }
        print_message("    %u ticks a step: rms %.4f m\n", 1u << interval, mean);
        assert_true(mean > 0.018 && mean < 0.034);
        free(pool);
    }
}

/* In a pool that stays too quiet, splashes grow once in 64 ticks at each interval. */
static void the_drive_raises_its_splashes_as_soon(void **state)
{
    (void)state;
    int32_t peak[3];

    for (uint32_t interval = 0; interval <= 2; interval++) {
        tp_pool_config c = slow_pool(TP_CELLS_16, TP_EDGES_TILE, interval);
        c.drive_min = TP_FX(0.9);
        c.drive_max = TP_FX(0.95);
        c.drive_amplitude = TP_FX(0.01);
        tp_pool *pool = pool_make(&c);
        const int32_t first = pool->drive_peak;
        pool_steps(pool, 640);
        peak[interval] = pool->drive_peak;
        assert_true(peak[interval] > 2 * first);
        assert_int_equal(peak[interval], peak[0]);
        free(pool);
    }
}

static void only_every_nth_tick_moves_the_cells(void **state)
{
    (void)state;
    for (uint32_t interval = 0; interval <= 2; interval++) {
        const tp_pool_config c = slow_pool(TP_CELLS_16, TP_EDGES_WALL, interval);
        tp_pool *pool = pool_make(&c);
        pool_fill(pool, &chance, 4000);
        int moved = 0;
        for (int tick = 0; tick < 16; tick++) {
            const bool due = tp_pool_is_due(pool);
            const int32_t before = tp_pool_height_lsb(pool, 5, 5);
            tp_pool_step(pool);
            const bool moves = tp_pool_height_lsb(pool, 5, 5) != before;
            assert_true(due || !moves);
            moved += moves;
        }
        assert_true(moved <= 16 >> interval && moved >= (16 >> interval) - 2);
        free(pool);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(too_long_a_step_is_refused),
        cmocka_unit_test(the_bound_is_that_of_the_step),
        cmocka_unit_test(a_moving_pool_keeps_its_interval),
        cmocka_unit_test(waves_keep_their_speed_and_decay),
        cmocka_unit_test(walls_keep_and_sponges_take_as_much_a_second),
        cmocka_unit_test(the_shown_surface_never_jumps),
        cmocka_unit_test(slopes_follow_the_shown_surface),
        cmocka_unit_test(water_comes_to_exact_rest),
        cmocka_unit_test(the_drive_keeps_its_band),
        cmocka_unit_test(the_drive_raises_its_splashes_as_soon),
        cmocka_unit_test(only_every_nth_tick_moves_the_cells),
    };
    return cmocka_run_group_tests_name("pool/interval", tests, NULL, NULL);
}
