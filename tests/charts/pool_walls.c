/* SPDX-License-Identifier: MIT */
/* What walls do to waves: a standing wave of a square tank, against the exact standing
 * wave, as rows of the chart "pool-walls". The tank's walls are the edges of the grid, or
 * dark cells of a mask: straight, or stairs because the tank is turned. */
#include "tests/charts/pool_edges.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/charts/pool_runs.h"
#include "tests/charts/pool_truth.h"
#include "tests/charts/used.h"

#define PI 3.14159265358979323846

/* HALF_WAVES stand between two walls; 2 x PERIODS of them are a way through the tank, which
 * ends at a wall: two reflections in four periods. */
enum { DAMPING = 8, COURANT_SQ = 240, HALF_WAVES = 4, PERIODS = 4, TICKS_MOST = 4096 };

typedef struct {
    const char *name;
    double      cosine, sine;       /* of the tank's turn */
    bool        masked;
} wall_kind;

typedef struct {
    const wall_kind *kind;
    tp_cells bits;
    uint32_t wave;                  /* cells in a wave length */
    uint32_t side;                  /* cells of the grid */
    double  *mode;                  /* the wave at the cells, |mode| <= 1; 0 in walls */
    double   omega, gamma;          /* of the exact wave, radians and 1 a tick */
    double   speed;                 /* at tick 0: the tick before has the same heights */
} wall_tank;

static double tank_width(const wall_tank *t)
{
    return t->wave * HALF_WAVES / 2.0;
}

/* Place of a cell along the tank's two axes, from its middle. */
static double along(const wall_tank *t, uint32_t i, uint32_t j, bool second)
{
    const double x = i + 0.5 - t->side / 2.0, z = j + 0.5 - t->side / 2.0;
    return second ? z * t->kind->cosine - x * t->kind->sine
                  : x * t->kind->cosine + z * t->kind->sine;
}

static double mode_height(const wall_tank *t, uint32_t i, uint32_t j)
{
    const double half = tank_width(t) / 2, u = along(t, i, j, false);

    if (fabs(u) > half || fabs(along(t, i, j, true)) > half)
        return 0;
    return cos(PI * HALF_WAVES * (u + half) / (2 * half));
}

static wall_tank tank_of(const wall_kind *kind, tp_cells bits, uint32_t wave)
{
    wall_tank t = { .kind = kind, .bits = bits, .wave = wave };
    const double width = tank_width(&t);

    t.side = (uint32_t)(kind->masked ? width * (kind->cosine + kind->sine) + 4 : width);
    t.mode = pool_room(t.side * t.side);
    for (uint32_t i = 0; i < t.side * t.side; i++)
        t.mode[i] = mode_height(&t, i % t.side, i / t.side);
    t.omega = sqrt((double)COURANT_SQ / POOL_WHOLE) * 2 * PI / wave;
    t.gamma = -log(1 - ldexp(1, -DAMPING)) / 2;
    t.speed = pool_truth_speed(t.omega, t.gamma, 1, 1);
    return t;
}

/* The tank with the wave at half of the cells' range, or of 1 m. */
static tp_pool *pool_with_wave(const wall_tank *t)
{
    const uint32_t count = t->side * t->side;
    uint16_t *const dark = malloc(count * sizeof *dark);
    const tp_grey mask = { .cols = t->side, .rows = t->side, .sample = dark };
    const tp_pool_config config = {
        .cols = t->side, .rows = t->side, .cells = t->bits, .edges = TP_EDGES_WALL,
        .courant = TP_FX(0.484), .damping = DAMPING, .range = TP_FX(1),
        .cell = TP_FX(0.25), .mask = t->kind->masked ? &mask : NULL,
    };

    for (uint32_t i = 0; dark && i < count; i++)
        dark[i] = t->mode[i] != 0 ? 0xffff : 0;
    tp_pool *const pool = dark ? pool_new(&config) : NULL;
    const double most = t->bits == TP_CELLS_32 ? 1 << 23
                      : pool ? tp_pool_max_lsb(pool) / 2.0 : 0;
    free(dark);
    if (!pool)
        pool_give_up("out of memory");
    pool->courant_sq_q10 = COURANT_SQ;
    for (uint32_t i = 0; i < count; i++)
        tp_pool_add_cell_height(pool, i % t->side, i / t->side,
                                (int32_t)lround(most * t->mode[i]));
    tp_pool_start_carry_rounding(pool, (int32_t)most);
    return pool;
}

/* -- a run --------------------------------------------------------------------------- */

typedef struct {
    double omega;               /* measured, radians a tick */
    double kept;                /* amplitude after four periods over that of the exact wave */
    double error;               /* rms over the fourth period over the rms of the wave */
} wall_result;

/* Amplitude of the samples p[from .. from + count) about e^-gt (a cos wt + b sin wt). */
static double amplitude_of(const double *p, int from, int count, double omega, double gamma)
{
    double cc = 0, cs = 0, ss = 0, pc = 0, ps = 0;

    for (int t = from; t < from + count; t++) {
        const double c = cos(omega * t), s = sin(omega * t), y = p[t] * exp(gamma * t);
        cc += c * c, cs += c * s, ss += s * s, pc += y * c, ps += y * s;
    }
    const double det = cc * ss - cs * cs;
    return hypot((pc * ss - ps * cs) / det, (ps * cc - pc * cs) / det);
}

/* Frequency from the times of the zeros of p. */
static double frequency_of(const double *p, int ticks)
{
    double first = 0, last = 0;
    int zeros = 0;

    for (int t = 1; t <= ticks; t++)
        if ((p[t - 1] > 0) != (p[t] > 0)) {
            last = t - p[t] / (p[t] - p[t - 1]);
            first = zeros++ == 0 ? last : first;
        }
    return zeros > 1 ? PI * (zeros - 1) / (last - first) : 0;
}

/* Adds the square of the difference from the exact wave, relative to the wave at that
 * tick; returns the wave's part in the heights. */
static double compare(const wall_tank *t, const tp_pool *pool, double most, int tick,
                      double *squares)
{
    const double exact = pool_truth_mode(t->omega, t->gamma, 1, t->speed, tick);
    const double size = exp(-t->gamma * tick);
    double part = 0, norm = 0, off = 0;

    for (uint32_t i = 0; i < t->side * t->side; i++) {
        const double h = tp_pool_height_lsb(pool, i % t->side, i / t->side) / most;
        const double d = h - exact * t->mode[i];
        part += h * t->mode[i];
        norm += t->mode[i] * t->mode[i];
        off += d * d;
    }
    *squares += off / (norm * size * size / 2);
    return part / norm;
}

static wall_result run_tank(const wall_tank *t)
{
    static double p[TICKS_MOST];
    const double period = 2 * PI / t->omega;
    const int ticks = (int)lround(PERIODS * period), one = (int)lround(period);
    tp_pool *const pool = pool_with_wave(t);
    const double most = t->bits == TP_CELLS_32 ? 1 << 23 : tp_pool_max_lsb(pool) / 2.0;
    double early = 0, late = 0;

    if (ticks >= TICKS_MOST)
        pool_give_up("too long a wave");
    p[0] = 1;
    for (int tick = 1; tick <= ticks; tick++) {
        tp_pool_step(pool);
        p[tick] = compare(t, pool, most, tick, tick > ticks - one ? &late : &early);
    }
    free(pool);
    const double omega = frequency_of(p, ticks);
    return (wall_result){
        omega, amplitude_of(p, ticks - one, one, omega, t->gamma)
             / amplitude_of(p, 0, one, omega, t->gamma),
        sqrt(late / one),
    };
}

/* -- rows ---------------------------------------------------------------------------- */

/* Frequency of the exact wave, with its damping. */
static double exact_frequency(const wall_tank *t)
{
    return sqrt(t->omega * t->omega - t->gamma * t->gamma);
}

/* Frequency of the rule without rounding and without walls, along the tank: the angle of
 * its roots [C6] [C17]. */
static double grid_frequency(const wall_tank *t)
{
    const pool_rule rule = pool_rule_of(t->bits, (double)COURANT_SQ / POOL_WHOLE, DAMPING);
    const double half = PI / t->wave;
    const double mu = 4 * pow(sin(half * t->kind->cosine), 2)
                    + 4 * pow(sin(half * t->kind->sine), 2);
    return acos((1 + rule.keep - rule.kick * mu) / (2 * sqrt(rule.keep)));
}

static const wall_tank *sought;         /* argument of is_in */

static bool is_it(const tp_scene_pool *pool)
{
    const bool masked = pool->mask[0] != 0;

    return pool->cols > 0 && pool->cell_bits == (int32_t)sought->bits
        && (masked || pool->boundary == TP_EDGES_WALL)
        && masked == sought->kind->masked && sought->kind->sine == 0;
}

static bool is_in(const tp_scene *scene, int32_t of)
{
    (void)of;
    return is_it(&scene->pool) || is_it(&scene->field);
}

static void print_tank(const wall_kind *kind, tp_cells bits, uint32_t wave, bool cells_only)
{
    wall_tank t = tank_of(kind, bits, wave);
    const double exact = exact_frequency(&t), lag = 1 - grid_frequency(&t) / exact;
    char keys[48];

    snprintf(keys, sizeof keys, "pool-walls,%d;%s;%u", 8 << bits, kind->name,
             (unsigned)wave);
    printf("%s,updates,%.4g\n", keys, wave * 2 * PI * wave / t.omega);
    if (!cells_only) {
        const wall_result got = run_tank(&t);   /* four periods: two reflections */
        printf("%s,lag,%.3g\n", keys, 100 * (1 - got.omega / exact));
        printf("%s,phase,%.3g\n", keys,
               360 * PERIODS / 2 * (1 - lag - got.omega / exact));
        printf("%s,kept,%.4g\n", keys, 100 * sqrt(got.kept));
        printf("%s,error,%.3g\n", keys, 100 * got.error);
        printf("%s,theory,%.3g\n", keys,
               200 * fabs(sin(PI * (PERIODS - 0.5) * lag)));
    }
    free(t.mode);
    sought = &t;
    used_row("pool-walls", keys + strlen("pool-walls,"), is_in, 0);
}

void print_pool_walls(bool cells_only)
{
    static const wall_kind kinds[] = {
        { "edge", 1, 0, false }, { "mask", 1, 0, true },
        { "45-degrees", 0.70710678118654752, 0.70710678118654752, true },
        { "27-degrees", 0.89442719099991588, 0.44721359549995794, true },
    };
    static const uint32_t waves[] = { 8, 12, 16, 24, 32, 48, 64 };

    for (int n = 0; n < 4 * 7; n++)
        print_tank(&kinds[n / 7], TP_CELLS_16, waves[n % 7], cells_only);
    for (int n = 0; n < 2 * 7; n++)
        print_tank(&kinds[0], n < 7 ? TP_CELLS_8 : TP_CELLS_32, waves[n % 7], cells_only);
}
