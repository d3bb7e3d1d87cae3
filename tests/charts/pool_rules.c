/* SPDX-License-Identifier: MIT */
#include "tests/charts/pool_rules.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "pool/pool.h"

#define PI 3.14159265358979323846

/* -- theory -------------------------------------------------------------------------- */

pool_rule pool_rule_of(tp_cells cells, double r2, uint32_t m)
{
    const double keep = 1 - ldexp(1, -(int)m);

    return (pool_rule){ keep, cells == TP_CELLS_32 ? keep * r2 : (1 + keep) * r2 / 2 };
}

/* Larger root of z^2 - (1 + keep - kick mu) z + keep. */
double pool_rule_root(pool_rule rule, double mu)
{
    const double half = (1 + rule.keep - rule.kick * mu) / 2;
    const double square = half * half - rule.keep;

    return square < 0 ? sqrt(rule.keep) : fabs(half) + sqrt(square);
}

/* Stable if kick mu < 2 (1 + keep) for all mu < 8. */
double pool_neumann_r2(tp_cells cells, uint32_t m)
{
    const double keep = 1 - ldexp(1, -(int)m);

    return cells == TP_CELLS_32 ? (1 + keep) / (4 * keep) : 0.5;
}

double pool_bound_r2(uint32_t m)
{
    return (1 - 1 / (2 - ldexp(1, -(int)m))) / 2;
}

double pool_noise_r(double rms, uint32_t m)
{
    return sqrt(ldexp(1, (int)m) / 24) / rms;
}

double pool_creep_r(uint32_t cols, uint32_t m)
{
    return -log(1 - ldexp(1, -(int)m)) / 2 * cols / PI;
}

/* -- fields in double precision ------------------------------------------------------ */

void pool_give_up(const char *what)
{
    fprintf(stderr, "pools: %s\n", what);
    exit(EXIT_FAILURE);
}

double *pool_room(uint32_t count)
{
    double *const room = calloc(count, sizeof *room);

    if (!room)
        pool_give_up("out of memory");
    return room;
}

static double force(const pool_field *w, uint32_t at)
{
    const uint32_t i = at % w->cols, j = at / w->cols;
    const double h = w->h[at];

    return (i ? w->h[at - 1] - h : 0) + (i + 1 < w->cols ? w->h[at + 1] - h : 0)
         + (j ? w->h[at - w->cols] - h : 0)
         + (j + 1 < w->rows ? w->h[at + w->cols] - h : 0);
}

void pool_field_step(pool_field *w, pool_rule rule)
{
    for (uint32_t at = 0; at < w->cols * w->rows; at++)
        w->f[at] = force(w, at);
    for (uint32_t at = 0; at < w->cols * w->rows; at++) {
        w->v[at] = rule.keep * w->v[at] + rule.kick * w->f[at];
        w->h[at] += w->v[at];
    }
}

pool_field pool_field_of(const tp_pool *pool)
{
    const uint32_t count = tp_pool_count(pool);
    pool_field w = { pool->cols, pool->rows, pool_room(count), pool_room(count),
                     pool_room(count) };

    for (uint32_t at = 0; at < count; at++) {
        w.h[at] = tp_pool_height_lsb(pool, at % w.cols, at / w.cols);
        w.v[at] = tp_pool_velocity(pool, at % w.cols, at / w.cols);
    }
    return w;
}

void pool_field_free(pool_field *w)
{
    free(w->h);
    free(w->v);
    free(w->f);
}

double pool_rms(const double *a, const double *b, uint32_t count)
{
    double sum = 0;

    for (uint32_t i = 0; i < count; i++)
        sum += (a[i] - (b ? b[i] : 0)) * (a[i] - (b ? b[i] : 0));
    return sqrt(sum / count);
}

double pool_field_energy(const pool_field *w, double r2, bool heights)
{
    double sum = 0;

    for (uint32_t at = 0; at < w->cols * w->rows; at++)
        sum += heights ? w->h[at] * w->h[at]
                       : w->v[at] * w->v[at] - r2 * (w->h[at] - w->v[at]) * force(w, at);
    return sum;
}
