/* SPDX-License-Identifier: MIT */
/* Prints measurements of pools for the charts as rows of the sweep,
 * CHART,KEYS,COLUMN,VALUE:
 *
 *     pools pool BITS LEAST MOST              tanks with LEAST to MOST columns
 *     pools stability-growth BITS LEAST MOST  dampings 2^-m with m from LEAST to MOST
 *     pools stability-rest BITS LEAST MOST
 *     pools stability-drift BITS LEAST MOST
 *     pools pool-waves                        standing waves on grids
 *     pools pool-walls[-cells]                walls, see pool_edges.h
 *     pools pool-sponge[-cells] DEGREES       sponges
 *     pools pool-feed M                       driven fields, damping 2^-M */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/charts/pool_edges.h"
#include "tests/charts/pool_points.h"
#include "tests/charts/pool_runs.h"
#include "tests/charts/pool_waves.h"
#include "tests/charts/used.h"

enum { SIDE = 64, REST_MOST = 40000 };

/* Arguments of the command line. */
typedef struct {
    const char *chart;
    tp_cells    cells;
    uint32_t    least, most;
} pool_chart_request;

/* -- chart "pool" -------------------------------------------------------------------- */

static const pool_point *sought;        /* argument of is_in */

static bool is_it(const tp_scene_pool *pool)
{
    return pool->cols == (int32_t)sought->cols && pool->rows == (int32_t)sought->rows
        && pool->cell_bits == (int32_t)sought->cells && pool->courant == sought->courant
        && pool->damping == (int32_t)sought->damping;
}

static bool is_in(const tp_scene *scene, int32_t of)
{
    (void)of;
    return is_it(&scene->pool) || is_it(&scene->field);
}

static uint32_t r2q_of(double r)
{
    return (uint32_t)lround(r * r * POOL_WHOLE);
}

static void print_point(const pool_point *p)
{
    static const uint32_t ticks[] = { 100, 200, 400 };
    const tp_pool_config config = {
        .cols = p->cols, .rows = p->rows, .cells = p->cells, .courant = p->courant,
        .damping = p->damping, .range = TP_FX(1), .cell = TP_FX(0.25),
    };
    const double r = p->courant / 65536.0;
    const pool_tank tank = { p->cells, p->cols, p->rows, r2q_of(r), p->damping };
    double off[3], unrounded[3];

    pool_tank_errors(&tank, r, ticks, 3, off, unrounded);
    const pool_rest rest = pool_tank_rest(&tank, UINT32_MAX);
    printf("pool,%s,bytes,%u\n", p->keys, (unsigned)tp_pool_bytes(&config));
    for (int n = 0; n < 3; n++) {
        printf("pool,%s,error_%u,%.4g\n", p->keys, (unsigned)ticks[n], 100 * off[n]);
        printf("pool,%s,grid_%u,%.4g\n", p->keys, (unsigned)ticks[n], 100 * unrounded[n]);
    }
    printf("pool,%s,rest,%u\n", p->keys, (unsigned)rest.ticks);
    sought = p;
    used_row("pool", p->keys, is_in, 0);
}

static void print_points(const pool_chart_request *a)
{
    for (const pool_point *p = pool_points; p->keys; p++)
        if (p->cells == a->cells && p->cols >= a->least && p->cols <= a->most)
            print_point(p);
}

/* -- stability charts ---------------------------------------------------------------- */

static void say(const pool_chart_request *a, uint32_t m, double r, const char *column,
                double value)
{
    printf("%s,%d;%u;%.4f,%s,%.4g\n", a->chart, 8 << a->cells, (unsigned)m, r, column,
           value);
}

static void print_growth(const pool_chart_request *a, uint32_t m, double r)
{
    const pool_tank tank = { a->cells, GROWTH_SIDE, GROWTH_SIDE, r2q_of(r), m };
    const pool_growth g = pool_tank_growth(&tank);
    const double r2 = (double)tank.courant_sq_q10 / POOL_WHOLE;
    const double shortest = pool_rule_root(pool_rule_of(a->cells, r2, m), 8);

    say(a, m, r, "growth", 100 * (g.growth - 1));
    say(a, m, r, "unrounded", 100 * (g.unrounded - 1));
    say(a, m, r, "shortest", 100 * (shortest - 1));
    say(a, m, r, "full_at", g.full_at);
    say(a, m, r, "neumann", sqrt(pool_neumann_r2(a->cells, m)));
    say(a, m, r, "bound", sqrt(pool_bound_r2(m)));
    say(a, m, r, "noise", a->cells == TP_CELLS_32 ? 0 : pool_noise_r(g.rms, m));
}

static void print_rest(const pool_chart_request *a, uint32_t m, double r)
{
    static const char *const word[] = { "rests", "flickers", "full", "moves" };
    const pool_tank tank = { a->cells, SIDE, SIDE, r2q_of(r), m };
    const pool_rest rest = pool_tank_rest(&tank, REST_MOST);

    if (strcmp(a->chart, "stability-drift") == 0) {
        say(a, m, r, "drift", rest.drift);
        say(a, m, r, "drift_gear_a", rest.drift_a);
        say(a, m, r, "neumann", sqrt(pool_neumann_r2(a->cells, m)));
    } else {
        say(a, m, r, "ticks", rest.ticks);
        say(a, m, r, "theory", pool_rest_ticks(&tank));
        say(a, m, r, "residue", rest.residue);
        say(a, m, r, "creep", pool_creep_r(SIDE, m));
    }
    printf("%s,%d;%u;%.4f,ending,%s\n", a->chart, 8 << a->cells, (unsigned)m, r,
           word[rest.ending]);
    say(a, m, r, "full", rest.full);
    say(a, m, r, "bound", sqrt(pool_bound_r2(m)));
}

/* r = 0.05 .. 0.8625, the whole range of a step, in steps of `step` / 80. */
static void print_map(const pool_chart_request *a, int step,
                      void (*print)(const pool_chart_request *a, uint32_t m, double r))
{
    for (uint32_t m = a->least; m <= a->most; m++)
        for (int i = 4; i <= 69; i += step)
            print(a, m, i / 80.0);
}

/* -- choice of the chart ------------------------------------------------------------- */

static bool print_chart(const pool_chart_request *a)
{
    const bool map = a->least >= 1 && a->most <= 10;

    if (strcmp(a->chart, "pool") == 0)
        print_points(a);
    else if (strcmp(a->chart, "stability-growth") == 0 && map)
        print_map(a, 1, print_growth);
    else if (strcmp(a->chart, "stability-rest") == 0 && map)
        print_map(a, 2, print_rest);
    else if (strcmp(a->chart, "stability-drift") == 0 && map)
        print_map(a, 2, print_rest);
    else
        return false;
    return true;
}

/* Charts with at most one number. */
static bool print_small_chart(const char *name, uint32_t number)
{
    if (strcmp(name, "pool-waves") == 0)
        print_pool_waves();
    else if (strcmp(name, "pool-walls") == 0 || strcmp(name, "pool-walls-cells") == 0)
        print_pool_walls(strcmp(name, "pool-walls") != 0);
    else if (strcmp(name, "pool-sponge") == 0 || strcmp(name, "pool-sponge-cells") == 0)
        print_pool_sponge(number, strcmp(name, "pool-sponge") != 0);
    else if (strcmp(name, "pool-feed") == 0 && number >= 4 && number <= 10)
        print_pool_feed(number);
    else
        return false;
    return true;
}

int main(int argc, char **argv)
{
    const int bits = argc == 5 ? atoi(argv[2]) : 0;
    const pool_chart_request a = {
        .chart = argc == 5 ? argv[1] : "", .cells = (tp_cells)(bits / 16),
        .least = argc == 5 ? (uint32_t)atoi(argv[3]) : 0,
        .most = argc == 5 ? (uint32_t)atoi(argv[4]) : 0,
    };

    if ((argc == 2 || argc == 3)
        && print_small_chart(argv[1], argc == 3 ? (uint32_t)atoi(argv[2]) : 0))
        return EXIT_SUCCESS;
    if ((bits == 8 || bits == 16 || bits == 32) && print_chart(&a))
        return EXIT_SUCCESS;
    fprintf(stderr, "usage: pools pool|stability-growth|stability-rest|stability-drift "
            "8|16|32 LEAST MOST\n       pools pool-waves|pool-walls[-cells]\n"
            "       pools pool-sponge[-cells] DEGREES\n       pools pool-feed M\n");
    return 2;
}
