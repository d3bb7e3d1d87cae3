/* SPDX-License-Identifier: MIT */
/* Effect of a boat on the pool in which the boat floats [E4]: the hull displaces water
 * without loss, a boat at rest leaves the pool at rest, and a boat faster than the waves
 * leaves a V-shaped wake. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/measure.h"
#include "tests/lib/boats.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

/* -- the hull, in double precision --------------------------------------------------- */

/* Depth of the submerged column at a point, m: the formula of wake.c. */
static double ref_column(const tp_scene *s, const tp_pool *pool, const tp_hull *hull,
                         double x, double z)
{
    const double turn = hull->heading / 4294967296.0 * 2 * 3.14159265358979;
    const double dx = x - hull->x * LSB, dz = z - hull->z * LSB;
    const double length = s->boat.length * LSB / 2, beam = s->boat.beam * LSB / 2;
    const double least = 1.5 * pool->cell * LSB;
    const double a = (dx * sin(turn) - dz * cos(turn)) / fmax(length, least);
    const double b = (dx * cos(turn) + dz * sin(turn)) / fmax(beam, least);
    const double draft = s->boat.draft * LSB;
    const double deep = draft + (hull->immersion[0] + a * hull->immersion[1] / 2
                                 - b * hull->immersion[2] / 2) * LSB;
    const double shallow = fmin(1, length / least) * fmin(1, beam / least);

    if (fabs(a) >= 1 || fabs(b) >= 1)
        return 0;
    return fmax(0, fmin(2 * draft, deep)) * (1 - a * a) * (1 - b * b) * shallow
         * s->boat.wake * LSB;
}

static double cell_x(const tp_pool *p, uint32_t col)
{
    return (p->x + (col + 0.5 - p->cols / 2.0) * p->cell) * LSB;
}

static double cell_z(const tp_pool *p, uint32_t row)
{
    return (p->z + (row + 0.5 - p->rows / 2.0) * p->cell) * LSB;
}

static void any_small_boat(tp_scene *s)
{
    s->boat.length = chance_scale(&chance, 0.1, 12);
    s->boat.beam = chance_scale(&chance, 0.1, 6);
    s->boat.draft = chance_scale(&chance, 0.05, 1);
    s->boat.wake = chance_fx(&chance, 0, 1);
    s->boat.heading = chance_fx(&chance, -360, 360);
}

/* One step of the hull from pose to pose over still water, cell by cell; cells outside both
 * poses share the remainder of the roundings. */
static void compare_stroke(tp_scene *s, measure *off)
{
    tp_world *w = wake_world(s);
    tp_pool *pool = water_of(w);
    tp_hull *hull = &w->boat_state.hull;
    const double lsb = lsb_of(pool);

    hull->x += chance_fx(&chance, -0.5, 0.5);
    hull->z += chance_fx(&chance, -0.5, 0.5);
    hull->heading += (tp_turn)chance_int(&chance, -100000000, 100000000);
    for (int k = 0; k < 3; k++)
        hull->immersion[k] = chance_fx(&chance, -0.3, 0.3);
    const tp_hull before = w->boat_state.wake_hull, now = *hull;
    tp_boat_stir_pool(w, s);
    for (uint32_t row = 0; row < pool->rows; row++) {
        for (uint32_t col = 0; col < pool->cols; col++) {
            const double x = cell_x(pool, col), z = cell_z(pool, row);
            const double was = ref_column(s, pool, &before, x, z);
            const double is = ref_column(s, pool, &now, x, z);
            if (is > 0.001)     /* well within: no share of the remainder goes here */
                measure_add(off, tp_pool_height_lsb(pool, col, row) - (was - is) * lsb,
                            (int64_t)col, row, 0);
        }
    }
    assert_int_equal(tp_pool_stats(pool).sum, 0);
    free(w);
}

static void the_hull_s_column_follows_the_models(void **state)
{
    (void)state;
    measure off = { .what = "column", .unit = "LSB of 0.5 mm" };

    for (int n = 0; n < 60; n++) {
        tp_scene s = pool_scene(TP_CELLS_16, TP_EDGES_WALL);
        any_small_boat(&s);
        s.pool.max_height = 16 * TP_FX_ONE;
        compare_stroke(&s, &off);
    }
    measure_print(&off);
    assert_true(off.worst < 2);     /* three roundings, and 16.16 */
}

/* -- volume -------------------------------------------------------------------------- */

/* Boats of every size that sail anywhere over pools of every kind, over the edges, in water
 * without room for the boat. */
static void no_water_is_lost_or_won(void **state)
{
    (void)state;
    uint32_t stirs = 0, full = 0;

    for (int n = 0; n < 48; n++) {
        tp_scene s = pool_scene((tp_cells)(n % 3), (tp_edges)(n / 3 % 3));
        any_small_boat(&s);
        s.pool.cols = chance_int(&chance, 16, 64);
        s.pool.rows = chance_int(&chance, 16, 64);
        s.pool.max_height = chance_scale(&chance, 0.01, 8);
        s.pool.cell = chance_scale(&chance, 0.1, 1);
        s.boat.mode = n % 2 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        s.boat.x = chance_fx(&chance, -10, 10);
        s.boat.z = chance_fx(&chance, -10, 10);
        tp_world *w = wake_world(&s);
        const double high = s.pool.max_height * LSB;
        for (int t = 0; t < 60; t++) {
            const tp_input in = { .throttle = chance_fx(&chance, -4, 30),
                                  .rudder = chance_fx(&chance, -90, 90) };
            tp_pool_step(water_of(w));
            const int64_t before = tp_pool_stats(water_of(w)).sum;
            const tp_pool *water = water_of(w);
            const bool settling = s.pool.cell_bits != TP_CELLS_32 && water->gear == 0
                               && !water->at_rest;
            sail(w, &s, &in);
            const tp_pool_state after = tp_pool_stats(water);
            if (!settling || after.sum != 0)    /* a settling pool drifts and is levelled */
                assert_int_equal(after.sum, before);
            full += s.pool.cell_bits != TP_CELLS_32
                 && after.highest >= lsb_of(water_of(w)) * high - 1;
        }
        stirs += w->boat_state.wake_ticks;
        free(w);
    }
    print_message("# stirred %u times, %u with a cell that was full\n", stirs, full);
    assert_true(stirs > 500);
    assert_true(full > 50);
}

/* Returns the highest |height| of the cells well within the hull's present pose: the
 * cells at its rim share the remainders of the roundings. */
static int32_t highest_under(tp_world *w, const tp_scene *s)
{
    const tp_pool *pool = water_of(w);
    int32_t highest = 0;

    for (uint32_t row = 0; row < pool->rows; row++) {
        for (uint32_t col = 0; col < pool->cols; col++) {
            const int32_t h = abs(tp_pool_height_lsb(pool, col, row));
            if (h > highest
                && ref_column(s, pool, &w->boat_state.hull, cell_x(pool, col),
                              cell_z(pool, row)) > 0.001)
                highest = h;
        }
    }
    return highest;
}

/* A hull that is lowered and lifted in place gives back all displaced water except for
 * movements below the dead zone; around the hull each stroke leaves a rounding. */
static void a_hull_that_comes_back_has_added_nothing(void **state)
{
    (void)state;
    for (int n = 0; n < 30; n++) {
        tp_scene s = pool_scene((tp_cells)(n % 3), TP_EDGES_WALL);
        any_small_boat(&s);
        s.boat.draft = TP_FX_ONE;
        tp_world *w = wake_world(&s);
        const tp_hull rest = w->boat_state.hull;
        for (int t = 0; t < 20; t++) {
            w->boat_state.hull.immersion[0] = t == 19 ? rest.immersion[0]
                                             : chance_fx(&chance, -0.4, 0.4);
            tp_boat_stir_pool(w, &s);
        }
        assert_true(highest_under(w, &s) < 2);
        assert_true(tp_pool_stats(water_of(w)).highest <= 20);
        free(w);
    }
}

/* -- the V-shaped wake --------------------------------------------------------------- */

/* Slope of the crest line behind the boat: along the columns from 8 m to 24 m astern, the
 * row of the highest water, fitted by least squares. */
static double spread_of(const tp_world *w, const tp_pool *pool, int side)
{
    double n = 0, sx = 0, sz = 0, sxx = 0, sxz = 0;

    for (uint32_t col = 0; col < pool->cols; col++) {
        const double astern = w->boat.place.x * LSB - cell_x(pool, col);
        int32_t highest = 0;
        double  at = 0;
        if (astern < 8 || astern > 24)
            continue;
        for (uint32_t row = 0; row < pool->rows; row++) {
            const int32_t h = tp_pool_height_lsb(pool, col, row);
            if (cell_z(pool, row) * side > 0 && h > highest) {
                highest = h;
                at = cell_z(pool, row) * side;
            }
        }
        n++;
        sx += astern;
        sz += at;
        sxx += astern * astern;
        sxz += astern * at;
    }
    return (n * sxz - sx * sz) / (n * sxx - sx * sx);
}

/* The tangent of the half-angle asin(c / U): all waves of the pool have one speed. */
static void a_boat_faster_than_waves_leaves_a_v(void **state)
{
    (void)state;
    const double ratio[2] = { 0.45, 0.65 };

    for (int i = 0; i < 2; i++) {
        tp_scene s = pool_scene(TP_CELLS_32, TP_EDGES_WALL);
        s.pool.cols = s.pool.rows = 256;
        s.pool.damping = 10;
        const double c = s.pool.courant * LSB * s.pool.cell * LSB * 60;
        s.boat.x = -28 * TP_FX_ONE;
        s.boat.heading = 90 * TP_FX_ONE;
        s.boat.speed = (tp_fx)lround(c / ratio[i] * 65536);
        tp_world *w = wake_world(&s);
        for (int t = 0; t < (int)(50 / (c / ratio[i]) * 60); t++)
            tp_world_step(&tp_program_all, w, &s, NULL);
        const double model = asin(ratio[i]) * 180 / 3.14159265;
        const double port = atan(spread_of(w, water_of(w), -1)) * 180 / 3.14159265;
        const double starboard = atan(spread_of(w, water_of(w), 1)) * 180 / 3.14159265;
        print_message("# c/U %.2f: %.2f and %.2f degrees, model %.2f\n", ratio[i], port,
                      starboard, model);
        assert_true(fabs(port - model) < 1.5 && fabs(starboard - model) < 1.5);
        free(w);
    }
}

/* -- repeatability ------------------------------------------------------------------- */

static void a_wake_replays_bit_for_bit(void **state)
{
    (void)state;
    for (int n = 0; n < 6; n++) {
        tp_scene s = pool_scene((tp_cells)(n % 3), (tp_edges)(n / 2));
        s.boat.mode = n % 2 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        const size_t bytes = tp_world_bytes(&tp_program_all, &s, NULL);
        tp_world *w = wake_world(&s), *copy = malloc(bytes);
        tp_input tape[80];
        for (int t = 0; t < 80; t++) {
            tape[t] = (tp_input){ .throttle = random_number(&chance),
                                  .rudder = random_number(&chance) };
            if (t == 20)
                memcpy(copy, w, bytes);
            tp_world_step(&tp_program_all, w, &s, &tape[t]);
        }
        for (int t = 20; t < 80; t++)
            tp_world_step(&tp_program_all, copy, &s, &tape[t]);
        assert_memory_equal(copy, w, bytes);
        assert_true(w->boat_state.wake_ticks > 0);
        free(w);
        free(copy);
    }
}

/* Boats of every size and position of the table, over pools of every size and position. */
static void any_boat_may_stir_any_pool(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = scene_any(&chance);
        strcpy(s.boat.mesh, "boat.obj");
        s.drops.count = 0;
        s.floor.depth = s.wind.strength = 0;
        s.pool.cols = n % 2 ? 16 + n % 5 : 0;
        s.field.cols = 16 + n % 7;
        s.pool.rows = s.field.rows = 16 + n % 11;
        s.pool.courant = s.field.courant = TP_FX(0.4);
        s.pool.drive_min = s.field.drive_min = 0;
        if (n % 4) {
            s.boat.x = s.pool.x + chance_fx(&chance, -3, 3);
            s.boat.z = s.pool.z + chance_fx(&chance, -3, 3);
        }
        if (tp_world_bytes(&tp_program_all, &s, NULL) == 0)
            continue;
        tp_world *w = wake_world(&s);
        for (int t = 0; t < 20; t++) {
            const tp_input in = { .throttle = random_number(&chance),
                                  .rudder = random_number(&chance) };
            const int64_t before = tp_pool_stats(water_of(w)).sum;
            sail(w, &s, &in);
            assert_int_equal(tp_pool_stats(water_of(w)).sum, before);
        }
        free(w);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_hull_s_column_follows_the_models),
        cmocka_unit_test(no_water_is_lost_or_won),
        cmocka_unit_test(a_hull_that_comes_back_has_added_nothing),
        cmocka_unit_test(a_boat_faster_than_waves_leaves_a_v),
        cmocka_unit_test(a_wake_replays_bit_for_bit),
        cmocka_unit_test(any_boat_may_stir_any_pool),
    };
    return cmocka_run_group_tests_name("features/boat wake", tests, NULL, NULL);
}
