/* SPDX-License-Identifier: MIT */
/* Pools in the shading normals: the slopes at a sample's position equal those of
 * tp_pool_height_slope, which test_pool_sample.c compares with double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/water/water.h"
#include "tests/lib/pools.h"
#include "tests/lib/shading.h"

#define Q12 4096.0

static uint64_t chance;

typedef struct {
    tp_pool       *pool;
    tp_pool_slope *slope;
    tp_shade       shade;
    tp_pool_bumps  bumps;
} bumped;

/* A stirred pool at a random position; its cells are larger than pixels. */
static bumped any_bumped(tp_cells cells, tp_edges edges, const tp_grey *mask, tp_fx gain)
{
    tp_pool_config c = pool_config(cells, edges, (uint32_t)chance_int(&chance, 16, 64),
                                   (uint32_t)chance_int(&chance, 16, 64));
    c.cell = chance_scale(&chance, 0.05, 20);
    c.x = chance_fx(&chance, -3000, 3000);
    c.z = chance_fx(&chance, -3000, 3000);
    c.range = TP_FX(0.1) + c.cell / 8;
    c.mask = mask;
    bumped b = { .pool = pool_make(&c) };
    pool_fill(b.pool, &chance, tp_pool_from_metres(b.pool, c.cell / 8));
    pool_steps(b.pool, 3);
    const size_t bytes = (size_t)(c.cols + 2) * (c.rows + 2) * sizeof *b.slope;
    b.slope = malloc(bytes);
    memset(b.slope, 0xa5, bytes);
    tp_pool_slopes(b.pool, TP_FX(0.3), gain, b.slope);
    b.shade.zi_log = 29 * 256;
    b.bumps.pool[1].slope = NULL;
    b.bumps.pool[0] = tp_pool_bump_make(b.pool, b.slope);
    b.bumps.pool[0].lod = -20000;
    return b;
}

static void bump(const bumped *b, tp_run *run)
{
    run->mine = &b->bumps;
    tp_stage_pool_bump(&b->shade, run);
}

static void bumped_free(bumped *b)
{
    free(b->pool);
    free(b->slope);
}

/* Positions inside the pool and, a quarter of the samples, around the pool. */
static void places_near(const tp_pool *pool, test_run *r)
{
    const int64_t wide = (int64_t)pool->cell * pool->cols * 2 / 3;
    const int64_t deep = (int64_t)pool->cell * pool->rows * 2 / 3;

    for (int i = 0; i < TP_RUN; i++) {
        r->s[i] = (uint32_t)pool->x + (uint32_t)chance_int(&chance, (int32_t)-wide,
                                                            (int32_t)wide);
        r->t[i] = (uint32_t)pool->z + (uint32_t)chance_int(&chance, (int32_t)-deep,
                                                            (int32_t)deep);
    }
}

/* True for a sample exactly on the far edge of a pool that is not tiled: inside the pool
 * for tp_pool_height_slope, outside for the map, whose turns wrap there. */
static bool is_on_far_edge(const tp_pool *pool, const test_run *r, int i)
{
    const int64_t x = (int64_t)(tp_fx)r->s[i] - pool->x;
    const int64_t z = (int64_t)(tp_fx)r->t[i] - pool->z;

    return pool->edges != TP_EDGES_TILE
        && (2 * x == (int64_t)pool->cell * pool->cols
            || 2 * z == (int64_t)pool->cell * pool->rows);
}

/* Compares the slopes.  The bound: weights of 1/256 between cells, half an LSB of the map
 * and of the sum. */
static void compare(const bumped *b, double gain, measure *off, measure *mean)
{
    test_run r;

    run_any(&r, 1000, &chance);
    places_near(b->pool, &r);
    bump(b, &r.run);
    for (int i = 0; i < TP_RUN; i++) {
        const tp_height_slope at =
            tp_pool_height_slope(b->pool, (tp_fx)r.s[i], (tp_fx)r.t[i], TP_FX(0.3));
        const double ex = (r.run.sx[i] - (int16_t)(r.n[i] >> 16)) / Q12
                        - at.slope_x / 65536.0 * gain;
        const double ez = (r.run.sz[i] - (int16_t)(r.n[i] & 0xffff)) / Q12
                        - at.slope_z / 65536.0 * gain;
        const double e = fmax(fabs(ex), fabs(ez));
        if (is_on_far_edge(b->pool, &r, i))
            continue;
        measure_add(off, e, r.s[i], r.t[i], b->pool->edges);
        mean->worst += e;
        mean->inputs++;
    }
}

static void bumps_are_the_slopes_of_the_relief(void **state)
{
    (void)state;
    measure off = { .what = "pool bump", .unit = "of slope 1" }, mean = { 0 };

    for (int n = 0; n < 900; n++) {
        const double gain = n % 4 / 2.0 + 0.5;
        bumped b = any_bumped((tp_cells)(n % 3), (tp_edges)(n / 3 % 3), NULL,
                              (tp_fx)(gain * 65536));
        compare(&b, gain, &off, &mean);
        bumped_free(&b);
    }
    measure_print(&off);
    printf("    mean of the error  %.6f\n", mean.worst / (double)mean.inputs);
    assert_true(off.worst <= 0.03);
    assert_true(mean.worst / (double)mean.inputs <= 0.001);
}

/* A flat wall reflects: beside the wall the slopes equal those of the pool's relief too. */
static void walls_mirror_the_water_before_them(void **state)
{
    (void)state;
    static uint16_t sample[32];
    static const tp_grey half = { 32, 1, sample };
    measure off = { .what = "beside a wall", .unit = "of slope 1" };

    for (int i = 0; i < 32; i++)
        sample[i] = i < 16 ? 0 : 65535;
    for (int n = 0; n < 60; n++) {
        bumped b = any_bumped((tp_cells)(n % 3), TP_EDGES_WALL, &half, TP_FX_ONE);
        test_run r;
        run_any(&r, 0, &chance);
        places_near(b.pool, &r);
        bump(&b, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            uint32_t col, row;
            const tp_height_slope at =
                tp_pool_height_slope(b.pool, (tp_fx)r.s[i], (tp_fx)r.t[i], TP_FX(0.3));
            if (is_on_far_edge(b.pool, &r, i)
                || !tp_pool_open_cell_at_point(b.pool, (tp_fx)r.s[i], (tp_fx)r.t[i], &col,
                                               &row))
                continue;
            measure_add(&off, fabs(r.run.sx[i] / Q12 - at.slope_x / 65536.0), col, row, n);
            measure_add(&off, fabs(r.run.sz[i] / Q12 - at.slope_z / 65536.0), col, row, n);
        }
        bumped_free(&b);
    }
    measure_print(&off);
    assert_true(off.inputs > 500 && off.worst <= 0.03);
}

/* The slope is full where a cell covers a pixel or more, and zero where a pixel covers four
 * cells. */
static void bumps_fade_where_pixels_hold_cells(void **state)
{
    (void)state;
    bumped b = any_bumped(TP_CELLS_16, TP_EDGES_TILE, NULL, TP_FX_ONE);
    test_run r;
    int32_t last = 0, whole = 0;

    run_any(&r, 0, &chance);
    for (int i = 0; i < TP_RUN; i++) {
        r.key[i] = 0x10000000;
        r.s[i] = r.s[0];
        r.t[i] = r.t[0];
    }
    const int32_t depth = tp_log_depth(&b.shade, r.key[0]);
    const int32_t at = -(depth + (depth > 0 ? depth / 2 : 0));
    for (int level = -300; level <= 600; level += 20) {
        b.bumps.pool[0].lod = at + level;
        bump(&b, &r.run);
        const int32_t sx = abs(r.run.sx[7] - (int16_t)(r.n[7] >> 16));
        whole = level == -300 ? sx : whole;
        if (level <= 256)
            assert_int_equal(sx, whole);
        else
            assert_true(sx <= last);
        if (level >= 512)
            assert_true(sx <= 1);
        last = sx;
    }
    bumped_free(&b);
}

/* Slopes of both pools add to the slope of the mesh. */
static void pool_and_field_add_up(void **state)
{
    (void)state;
    bumped a = any_bumped(TP_CELLS_16, TP_EDGES_WALL, NULL, TP_FX(0.5));
    bumped b = any_bumped(TP_CELLS_8, TP_EDGES_TILE, NULL, TP_FX(0.5));
    test_run r;

    run_any(&r, 900, &chance);
    places_near(a.pool, &r);
    tp_run one = r.run, other = r.run;
    bump(&a, &one);
    bump(&b, &other);
    a.bumps.pool[1] = b.bumps.pool[0];
    bump(&a, &r.run);
    for (int i = 0; i < TP_RUN; i++) {
        assert_int_equal(r.run.sx[i], one.sx[i] + other.sx[i] - (int16_t)(r.n[i] >> 16));
        assert_int_equal(r.run.sz[i], one.sz[i] + other.sz[i] - (int16_t)r.n[i]);
    }
    bumped_free(&a);
    bumped_free(&b);
}

static void runs_may_be_cut_at_sixteenths(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        bumped b = any_bumped(TP_CELLS_16, TP_EDGES_TILE, NULL, TP_FX_ONE);
        test_run r;
        run_any(&r, 5000, &chance);
        b.bumps.pool[0].lod = chance_int(&chance, -3000, 1000);
        const tp_run before = r.run;
        bump(&b, &r.run);
        for (int32_t from = 0; from < TP_RUN; from += 16) {
            tp_run part = run_part(&before, from, from + 16);
            bump(&b, &part);
            assert_memory_equal(part.sx, r.run.sx + from, 16 * sizeof *part.sx);
            assert_memory_equal(part.sz, r.run.sz + from, 16 * sizeof *part.sz);
        }
        bumped_free(&b);
    }
}

/* -- the fast stage ------------------------------------------------------------------ */

/* Sets rest positions along a row with eight columns a cell. */
static void places_along_a_row(const tp_pool *pool, test_run *r)
{
    for (int i = 0; i < TP_RUN; i++) {
        r->s[i] = (uint32_t)(pool->x + (i - TP_RUN / 2) * (pool->cell / 8));
        r->t[i] = (uint32_t)(pool->z + (i - TP_RUN / 2) * (pool->cell / 24));
    }
}

/* With eight columns a cell the mean of two columns is off by at most an eighth of the
 * largest slope: where the slope turns back at a cell's middle.  Stirred pools have 0.06. */
static void fast_bumps_are_near_the_exact_ones(void **state)
{
    (void)state;
    measure off = { .what = "fast bumps", .unit = "of the range" };

    for (int n = 0; n < 300; n++) {
        bumped b = any_bumped(TP_CELLS_16, n % 2 ? TP_EDGES_TILE : TP_EDGES_WALL, NULL,
                              TP_FX_ONE);
        test_run r;
        int32_t most = 1;
        run_any(&r, 1000, &chance);
        places_along_a_row(b.pool, &r);
        bump(&b, &r.run);
        const tp_run exact = r.run;
        memcpy(r.run.slope, r.n, sizeof r.n);
        tp_stage_quick_pool_bump(&b.shade, &r.run);
        for (int i = 0; i < TP_RUN; i++)
            most = most > tp_abs(exact.sx[i] - (int16_t)(r.n[i] >> 16))
                       ? most : tp_abs(exact.sx[i] - (int16_t)(r.n[i] >> 16));
        for (int i = 0; i < TP_RUN; i++)
            measure_add(&off, abs((int16_t)(r.run.slope[i] >> 16) - exact.sx[i])
                                  / (double)most, n, i, most);
        bumped_free(&b);
    }
    measure_print(&off);
    assert_true(off.worst <= 0.125);
}

/* The same bits, whole and cut at multiples of 16 columns. */
static void fast_runs_may_be_cut_at_sixteenths(void **state)
{
    (void)state;

    for (int n = 0; n < 200; n++) {
        bumped b = any_bumped(TP_CELLS_16, n % 2 ? TP_EDGES_TILE : TP_EDGES_WALL, NULL,
                              TP_FX_ONE);
        const int32_t cut = 16 * chance_int(&chance, 1, 3);
        test_run r;
        run_any(&r, 1000, &chance);
        places_near(b.pool, &r);
        if (n % 4 > 1)
            b.bumps.pool[0].lod = 100;
        r.run.mine = &b.bumps;
        memcpy(r.run.slope, r.n, sizeof r.n);
        tp_run first = run_part(&r.run, 0, cut), second = run_part(&r.run, cut, TP_RUN);
        memcpy(second.slope, r.n + cut, (size_t)(TP_RUN - cut) * sizeof *r.n);
        tp_stage_quick_pool_bump(&b.shade, &r.run);
        tp_stage_quick_pool_bump(&b.shade, &first);
        tp_stage_quick_pool_bump(&b.shade, &second);
        assert_memory_equal(r.run.slope, first.slope, (size_t)cut * 4);
        assert_memory_equal(r.run.slope + cut, second.slope, (size_t)(TP_RUN - cut) * 4);
        bumped_free(&b);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bumps_are_the_slopes_of_the_relief),
        cmocka_unit_test(walls_mirror_the_water_before_them),
        cmocka_unit_test(bumps_fade_where_pixels_hold_cells),
        cmocka_unit_test(pool_and_field_add_up),
        cmocka_unit_test(runs_may_be_cut_at_sixteenths),
        cmocka_unit_test(fast_bumps_are_near_the_exact_ones),
        cmocka_unit_test(fast_runs_may_be_cut_at_sixteenths),
    };
    return cmocka_run_group_tests_name("features/water bumps", tests, NULL, NULL);
}
