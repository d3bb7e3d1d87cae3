/* SPDX-License-Identifier: MIT */
/* How well the drive keeps the level of a field [C16]: rms of the heights over `drive_min`
 * by the height of a splash, the damping and `drive_max`; as rows of the chart "pool-feed". */
#include "tests/charts/pool_edges.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include "tests/charts/pool_runs.h"
#include "tests/charts/used.h"

#define PI 3.14159265358979323846

/* Cells of 16 bits, tiled; `drive_min` in LSB; ticks for filling and of the trace. The level
 * is read in one of EVERY ticks once the field is filled. */
enum { SIDE = 64, LOW = 512, FILL = 1500, ALL = 4000, TRACE = 800, STEP = 10,
       EVERY = 4 };

typedef struct {
    uint32_t m;                 /* damping 2^-m */
    double   splash;            /* drive_amplitude / drive_min */
    double   above;             /* drive_max / drive_min */
} feed_case;

/* Observed levels are over drive_min. */
typedef struct {
    double mean, spread;        /* of the level after the filling; spread: rms off 1 */
    double share;               /* of the ticks with a splash, after the filling */
    int    filled;              /* first tick with a level of 1 or more; 0: never */
} feed_result;

static tp_pool *field_new(const feed_case *c)
{
    const double lsb = 65536 / 32767.0;
    const tp_pool_config config = {
        .cols = SIDE, .rows = SIDE, .cells = TP_CELLS_16, .edges = TP_EDGES_TILE,
        .courant = TP_FX(0.484), .damping = c->m, .range = TP_FX(1), .cell = TP_FX(0.25),
        .drive_min = (tp_fx)lround(LOW * lsb),
        .drive_max = (tp_fx)lround(c->above * LOW * lsb),
        .drive_amplitude = (tp_fx)lround(c->splash * LOW * lsb),
    };
    return pool_new(&config);
}

static double level_of(const tp_pool *pool)
{
    double squares = 0;

    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        const double h = tp_pool_cell_height(pool, i);
        squares += h * h;
    }
    return sqrt(squares / (SIDE * SIDE)) / LOW;
}

/* Share of the ticks with a splash by theory. A splash of height A and width sigma holds
 * the squares pi sigma^2 A^2 / 2; half becomes motion, and the sum of both falls by 2^-m a
 * tick. At most each tick has one. */
static double share_in_theory(const feed_case *c)
{
    const double splash = PI * 2.5 * 2.5 * c->splash * c->splash / 2 / 2;
    return fmin(1, (double)SIDE * SIDE * ldexp(1, -(int)c->m) / splash);
}

static void print_row(const feed_case *c, int tick, const char *column, double value)
{
    printf("pool-feed,%u;%.3g;%.3g;%d,%s,%.4g\n", (unsigned)c->m, c->splash, c->above, tick,
           column, value);
}

static void look(feed_result *r, double level)
{
    const double part = (double)EVERY / (ALL - FILL);

    r->mean += level * part;
    r->spread += (level - 1) * (level - 1) * part;
}

static feed_result run_field(const feed_case *c, bool trace)
{
    feed_result r = { .filled = 0 };
    tp_pool *const pool = field_new(c);
    uint32_t before = 0;

    for (int tick = 1; tick <= ALL; tick++) {
        tp_pool_step(pool);
        const bool asked = tick <= FILL ? !r.filled || tick <= TRACE : tick % EVERY == 0;
        const double level = asked ? level_of(pool) : 0;
        if (level >= 1 && !r.filled)
            r.filled = tick;
        if (trace && tick <= TRACE && tick % STEP == 0)
            print_row(c, tick, "level", 100 * level);
        if (tick == FILL)
            before = pool->injections;
        if (tick > FILL && asked)
            look(&r, level);
    }
    r.share = (double)(pool->injections - before) / (ALL - FILL);
    r.spread = sqrt(r.spread);
    free(pool);
    return r;
}

static const feed_case *sought;         /* argument of is_in */

static bool is_it(const tp_scene_pool *pool)
{
    const double low = pool->drive_min;

    return pool->cols > 0 && low > 0 && pool->damping == (int32_t)sought->m
        && fabs(pool->drive_amplitude / low - sought->splash) < 0.01
        && fabs(pool->drive_max / low - sought->above) < 0.01;
}

static bool is_in(const tp_scene *scene, int32_t of)
{
    (void)of;
    return is_it(&scene->pool) || is_it(&scene->field);
}

/* The figures of a whole run have the tick 0. */
static void print_field(const feed_case *c, bool trace)
{
    const feed_result r = run_field(c, trace);
    char keys[48];

    print_row(c, 0, "mean", 100 * r.mean);
    print_row(c, 0, "error", 100 * r.spread);
    print_row(c, 0, "share", 100 * r.share);
    print_row(c, 0, "theory", 100 * share_in_theory(c));
    print_row(c, 0, "filled", r.filled);
    snprintf(keys, sizeof keys, "%u;%.3g;%.3g;0", (unsigned)c->m, c->splash, c->above);
    sought = c;
    used_row("pool-feed", keys, is_in, 0);
}

/* Splashes of 35 / 6 of drive_min, up to 4 / 3 of it, are those of the shipped pond. */
void print_pool_feed(uint32_t m)
{
    static const double splashes[] = { 0.25, 1, 2, 4, 35 / 6.0, 8, 16 };

    for (int n = 0; n < 7; n++)
        print_field(&(feed_case){ m, splashes[n], 4 / 3.0 }, m == 6);
    for (int n = 1; n < 7; n += 3)
        print_field(&(feed_case){ m, splashes[n], 1.02 }, false);
}
