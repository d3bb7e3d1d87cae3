/* SPDX-License-Identifier: MIT */
#include "tests/charts/pool_runs.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "pool/pool.h"
#include "tests/charts/pool_truth.h"

#define PI   3.14159265358979323846
#define DROP (100.0 / 127)              /* height of the splash, m */

static tp_pool_config config_of(const pool_tank *tank)
{
    return (tp_pool_config){
        .cols = tank->cols, .rows = tank->rows, .cells = tank->cells,
        .edges = TP_EDGES_WALL, .courant = TP_FX(0.25), .damping = 6,
        .range = TP_FX(1), .cell = TP_FX(0.25),
    };
}

static size_t bytes_of(const pool_tank *tank)
{
    const tp_pool_config config = config_of(tank);
    return tp_pool_bytes(&config);
}

tp_pool *pool_new(const tp_pool_config *config)
{
    const size_t bytes = tp_pool_bytes(config);
    tp_pool *const pool = bytes ? malloc(bytes) : NULL;

    if (!pool || tp_pool_init(pool, config, NULL))
        pool_give_up("no pool of that size");
    return pool;
}

tp_pool *pool_tank_new(const pool_tank *tank)
{
    const tp_pool_config config = config_of(tank);
    tp_pool *const pool = pool_new(&config);

    pool->courant_sq_q10 = tank->courant_sq_q10;
    pool->damping = tank->m;
    return pool;
}

void pool_tank_drop(tp_pool *pool)
{
    if (!tp_pool_add_splash(pool, -(tp_fx)pool->cols * 1024, (tp_fx)pool->rows * 512,
                            TP_FX(1), TP_FX(DROP)))
        pool_give_up("a drop beside the tank");
}

/* -- errors -------------------------------------------------------------------------- */

void pool_tank_errors(const pool_tank *tank, double r, const uint32_t *ticks, int count,
                      double *off, double *unrounded)
{
    const uint32_t cells = tank->cols * tank->rows;
    const pool_rule rule = pool_rule_of(tank->cells, r * r, tank->m);
    tp_pool *const pool = pool_tank_new(tank);
    double *const right = pool_room(cells);
    pool_truth truth;

    pool_tank_drop(pool);
    pool_field plain = pool_field_of(pool);
    pool_truth_init(&truth, tank->cols, tank->rows, r, rule.keep, plain.h, plain.h);
    for (int n = 0; n < count; n++) {
        for (uint32_t t = n ? ticks[n - 1] : 0; t < ticks[n]; t++) {
            tp_pool_step(pool);
            pool_field_step(&plain, rule);
        }
        pool_field now = pool_field_of(pool);
        pool_truth_at(&truth, ticks[n], 1, right);
        const double high = pool_rms(right, NULL, cells);
        off[n] = pool_rms(now.h, right, cells) / high;
        unrounded[n] = pool_rms(plain.h, right, cells) / high;
        pool_field_free(&now);
    }
    pool_truth_free(&truth);
    pool_field_free(&plain);
    free(right);
    free(pool);
}

/* -- growth -------------------------------------------------------------------------- */

/* Adds noise with the sum 0: each cell has an opposite cell. */
static void stir(tp_pool *pool, int32_t part)
{
    const uint32_t cols = pool->cols, half = tp_pool_count(pool) / 2;
    const int32_t most = tp_pool_max_lsb(pool) / part;
    uint32_t random = 1;

    for (uint32_t i = 0; i < half; i++) {
        random = random * 1664525 + 1013904223;
        const int32_t h = (int32_t)((int64_t)(int32_t)random * most >> 31);
        tp_pool_add_cell_height(pool, i % cols, i / cols, h);
        tp_pool_add_cell_height(pool, (i + half) % cols, (i + half) / cols, -h);
    }
    pool->gear = 2;
}

static double energy_of(const tp_pool *pool, double r2, bool heights)
{
    pool_field w = pool_field_of(pool);
    const double e = pool_field_energy(&w, r2, heights);

    pool_field_free(&w);
    return e;
}

/* The statistics of tp_pool_stats, without the velocities of 32-bit cells. */
static tp_pool_state look_quickly(const tp_pool *pool)
{
    const void *const cells = tp_pool_const_pointer(pool, sizeof *pool);
    const bool small = pool->cells == TP_CELLS_8, whole = pool->cells == TP_CELLS_32;
    tp_pool_state look = { 0 };

    for (uint32_t i = 0; i < tp_pool_count(pool); i++) {
        const tp_pool_pair_8  byte = small ? ((const tp_pool_pair_8 *)cells)[i]
                                           : (tp_pool_pair_8){ 0 };
        const tp_pool_pair_16 word = small || whole ? (tp_pool_pair_16){ byte.h, byte.v }
                                   : ((const tp_pool_pair_16 *)cells)[i];
        const int32_t h = whole ? ((const int32_t *)cells)[i] : word.h;
        look.sum += h;
        look.highest = abs(h) > look.highest ? abs(h) : look.highest;
        look.fastest = abs(word.v) > look.fastest ? abs(word.v) : look.fastest;
    }
    return look;
}

/* True if a cell is above 1 / share of its range. */
static bool is_full(const tp_pool *pool, const tp_pool_state *look, int32_t share)
{
    const int32_t end = tp_pool_max_lsb(pool) / share;
    return look->highest >= end || look->fastest >= end;
}

/* Tick at which a cell is above 1 / share of its range, from noise of 1 / part of the
 * range. */
static int32_t full_at(const pool_tank *tank, int32_t part, int32_t share)
{
    tp_pool *const pool = pool_tank_new(tank);
    int32_t at = 0;

    stir(pool, part);
    for (int32_t tick = 1; tick <= FULL_TICKS && !at; tick++) {
        pool->gear = 2;
        tp_pool_step(pool);
        const tp_pool_state look = look_quickly(pool);
        at = is_full(pool, &look, share) ? tick : 0;
    }
    free(pool);
    return at;
}

/* Adds the logarithm, `sign` times, of the energies or squares of both fields. */
static void add_logs(pool_growth *g, const tp_pool *pool, const pool_field *plain,
                     double r2, bool beyond, double sign)
{
    g->growth += sign * log(energy_of(pool, r2, beyond));
    g->unrounded += sign * log(pool_field_energy(plain, r2, beyond));
}

pool_growth pool_tank_growth(const pool_tank *tank)
{
    const double r2 = (double)tank->courant_sq_q10 / POOL_WHOLE;
    const bool beyond = r2 >= pool_neumann_r2(tank->cells, tank->m);
    const pool_rule rule = pool_rule_of(tank->cells, r2, tank->m);
    const int32_t part = beyond ? 32 : 4, half = full_at(tank, part, 2);
    pool_growth g = { .full_at = full_at(tank, 4, 1) };
    const bool short_run = beyond && half > 1 && half <= GROWTH_TICKS;
    const int32_t end = short_run ? half - 1 : GROWTH_TICKS;
    const int32_t from = beyond ? end / 2 : 0;
    tp_pool *const pool = pool_tank_new(tank);

    stir(pool, part);
    pool_field plain = pool_field_of(pool);
    g.rms = pool_rms(plain.h, NULL, tp_pool_count(pool));
    for (int32_t tick = 0; tick <= end; tick++) {
        if (tick == from)
            add_logs(&g, pool, &plain, r2, beyond, -1);
        if (tick == end)
            add_logs(&g, pool, &plain, r2, beyond, 1);
        pool->gear = 2;                         /* gear A for as long as the test runs */
        tp_pool_step(pool);
        pool_field_step(&plain, rule);
    }
    pool_field_free(&plain);
    free(pool);
    g.growth = exp(g.growth / (2 * (end - from)));
    g.unrounded = exp(g.unrounded / (2 * (end - from)));
    return g;
}

/* -- rest and drift ------------------------------------------------------------------ */

/* True if the cells return to their present state within 4 ticks. */
static bool flickers(const tp_pool *pool, size_t bytes)
{
    tp_pool *const copy = malloc(bytes);
    const size_t cells = tp_pool_count(pool) * (pool->cells == TP_CELLS_8    ? 2u
                                                : pool->cells == TP_CELLS_16 ? 4u : 12u);
    bool same = false;

    if (!copy)
        pool_give_up("out of memory");
    memcpy(copy, pool, bytes);
    for (int n = 0; n < 4 && !same; n++) {
        tp_pool_step(copy);
        same = memcmp(copy + 1, pool + 1, cells) == 0;
    }
    free(copy);
    return same;
}

/* Beyond von Neumann's bound a full pool stays full; inside, a full pool settles too. */
static bool goes_on(const tp_pool *pool, size_t bytes, const pool_rest *rest,
                    uint32_t most, bool beyond)
{
    if (pool->at_rest || rest->ticks >= most || (beyond && rest->full))
        return false;
    return pool->gear > 0 || rest->ticks % 1024 || pool->cells == TP_CELLS_32
        || !flickers(pool, bytes);
}

static void look_at(pool_rest *rest, const tp_pool *pool, bool gear_a)
{
    const tp_pool_state look = look_quickly(pool);
    const double mean = fabs((double)look.sum) / tp_pool_count(pool);

    rest->drift = fmax(rest->drift, mean);
    if (gear_a)
        rest->drift_a = fmax(rest->drift_a, mean);
    rest->full |= is_full(pool, &look, 1);
    rest->residue = look.highest;
}

pool_rest pool_tank_rest(const pool_tank *tank, uint32_t most)
{
    const bool beyond = (double)tank->courant_sq_q10 / POOL_WHOLE
                        >= pool_neumann_r2(tank->cells, tank->m);
    const size_t bytes = bytes_of(tank);
    tp_pool *const pool = pool_tank_new(tank);
    pool_rest rest = { .ending = POOL_RESTS };

    pool_tank_drop(pool);
    while (goes_on(pool, bytes, &rest, most, beyond)) {
        const bool gear_a = pool->gear > 0 || pool->cells == TP_CELLS_32;
        tp_pool_step(pool);
        rest.ticks++;
        look_at(&rest, pool, gear_a);
    }
    if (!pool->at_rest)
        rest.ending = beyond && rest.full ? POOL_FULL
                    : flickers(pool, bytes) ? POOL_FLICKERS : POOL_MOVES;
    free(pool);
    return rest;
}

double pool_rest_ticks(const pool_tank *tank)
{
    const double twice = ldexp(2, (int)tank->m);
    tp_pool *const pool = pool_tank_new(tank);

    pool_tank_drop(pool);
    pool_field start = pool_field_of(pool);
    const double h = pool_rms(start.h, NULL, tp_pool_count(pool));
    const double q = sqrt((double)tank->courant_sq_q10 / POOL_WHOLE / 2) * h;
    const double time = tank->cells == TP_CELLS_32 ? twice * log(1 + PI * q / twice)
                                                   : pool->gear;
    pool_field_free(&start);
    free(pool);
    return time;
}
