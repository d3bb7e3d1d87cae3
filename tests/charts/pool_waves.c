/* SPDX-License-Identifier: MIT */
/* The lag of waves on a pool's grid: standing waves between walls, along an axis and along
 * the diagonal, as rows of the chart "pool-waves". */
#include "tests/charts/pool_waves.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "tests/charts/pool_runs.h"

#define PI 3.14159265358979323846

enum { DAMPING = 10, HALF_WAVES = 8, DIAGONAL = 6, CROSSINGS = 9, TICKS_MOST = 20000 };

typedef struct {
    uint32_t side;              /* cells */
    int      across, down;      /* half waves along x and z */
    double   r;
} standing_wave;

static double wave_number(const standing_wave *w)       /* radians a cell */
{
    return PI * hypot(w->across, w->down) / w->side;
}

static double mode_height(const standing_wave *w, uint32_t i, uint32_t j)
{
    return cos(PI * w->across * (i + 0.5) / w->side)
         * cos(PI * w->down * (j + 0.5) / w->side);
}

/* Frequency of the rule without rounding: sin^2(omega / 2) = r^2 mu / 4, mu the mode's
 * eigenvalue. */
static double grid_frequency(const standing_wave *w)
{
    const double sx = sin(PI * w->across / w->side / 2);
    const double sz = sin(PI * w->down / w->side / 2);
    return 2 * asin(w->r * hypot(sx, sz));
}

static void raise_mode(tp_pool *pool, const standing_wave *w)
{
    const double most = tp_pool_max_lsb(pool) / 4.0;

    for (uint32_t j = 0; j < w->side; j++)
        for (uint32_t i = 0; i < w->side; i++)
            tp_pool_add_cell_height(pool, i, j,
                                    (int32_t)lround(most * mode_height(w, i, j)));
    tp_pool_start_carry_rounding(pool, (int32_t)most);
}

static double project_mode(const tp_pool *pool, const standing_wave *w)
{
    double sum = 0;

    for (uint32_t j = 0; j < w->side; j++)
        for (uint32_t i = 0; i < w->side; i++)
            sum += tp_pool_height_lsb(pool, i, j) * mode_height(w, i, j);
    return sum;
}

/* Frequency of the engine's wave, radians a tick, from the times of its zeros. */
static double measured_frequency(const standing_wave *w)
{
    const pool_tank tank = { TP_CELLS_16, w->side, w->side,
                             (uint32_t)lround(w->r * w->r * POOL_WHOLE), DAMPING };
    tp_pool *const pool = pool_tank_new(&tank);
    double first = 0, last = 0, before, now;
    int zeros = 0;

    raise_mode(pool, w);
    now = project_mode(pool, w);
    for (int t = 1; t < TICKS_MOST && zeros < CROSSINGS; t++) {
        before = now;
        tp_pool_step(pool);
        now = project_mode(pool, w);
        if ((before > 0) != (now > 0)) {
            last = t - now / (now - before);
            first = zeros++ == 0 ? last : first;
        }
    }
    free(pool);
    return PI * (zeros - 1) / (last - first);
}

static void print_wave(const standing_wave *w)
{
    const double k = wave_number(w), wave = 2 * PI / k;
    char keys[40];

    snprintf(keys, sizeof keys, "pool-waves,%s;%.3f;%u", w->down ? "diagonal" : "axis",
             w->r, (unsigned)w->side);
    printf("%s,wave,%.4g\n", keys, wave);
    printf("%s,updates,%.4g\n", keys, wave * wave * wave / w->r);
    printf("%s,lag,%.3g\n", keys, 100 * (1 - measured_frequency(w) / (w->r * k)));
    printf("%s,theory,%.3g\n", keys, 100 * (1 - grid_frequency(w) / (w->r * k)));
}

void print_pool_waves(void)
{
    static const double rs[] = { 0.125, 0.25, 0.484375 };
    static const uint32_t sides[] = { 16, 20, 24, 32, 40, 48, 64, 96, 128 };

    for (int n = 0; n < 3 * 9; n++) {
        const double r = sqrt(floor(rs[n / 9] * rs[n / 9] * POOL_WHOLE) / POOL_WHOLE);
        print_wave(&(standing_wave){ sides[n % 9], HALF_WAVES, 0, r });
        print_wave(&(standing_wave){ sides[n % 9], DIAGONAL, DIAGONAL, r });
    }
}
