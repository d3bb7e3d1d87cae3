/* SPDX-License-Identifier: MIT */
/* What a sponge sends back: a group of waves starts in the middle of a channel, runs into
 * the sponges at both ends, and what is left runs back; as rows of the chart "pool-sponge".
 * The share is the root of the energy [C3] of the water between the sponges over that of a
 * group that only the field's damping lessens. */
#include "tests/charts/pool_edges.h"
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/charts/pool_runs.h"
#include "tests/charts/used.h"

#define PI 3.14159265358979323846

enum { DAMPING = 10, COURANT_SQ = 240, NARROW = 16, USEFUL = 128 };

typedef struct {
    uint32_t width;             /* cells of a sponge; 0: a radiating edge, in theory only */
    uint32_t wave;              /* cells in a wave length */
    uint32_t half_waves;        /* across the channel; 0: waves along the channel */
    uint32_t rows;
    double   kx, ky, r2;
    bool     smooth;            /* in theory only: damping not rounded to powers of 1/2 */
} sponge_case;

/* [C6], with the field's damping. */
static double frequency(const sponge_case *c, double kx)
{
    const double mu = 4 - 2 * cos(kx) - 2 * cos(c->ky), rho = 1 - ldexp(1, -DAMPING);
    return acos((1 + rho) * (1 - c->r2 * mu / 2) / (2 * sqrt(rho)));
}

static sponge_case case_of(uint32_t width, uint32_t wave, uint32_t degrees)
{
    const double k = 2 * PI / wave;
    sponge_case c = { width, wave, 0, NARROW, k, 0, (double)COURANT_SQ / POOL_WHOLE,
                      false };

    if (degrees > 0) {          /* two half waves or more across, of `degrees` about */
        const double half = PI / (k * sin(degrees * PI / 180));
        c.half_waves = (uint32_t)fmax(2, ceil(NARROW / half));
        c.rows = (uint32_t)lround(half * c.half_waves);
        c.ky = PI * c.half_waves / c.rows;
        c.kx = sqrt(k * k - c.ky * c.ky);
    }
    return c;
}

/* -- theory -------------------------------------------------------------------------- */

/* delta of the d-th cell from the edge: 8 (W - d)^2 / (max(W, 16) W^2) as the nearest power
 * of 1/2, and not below the field's [C15]. */
static double delta_at(const sponge_case *c, uint32_t d)
{
    const double w = c->width, least = ldexp(1, -DAMPING);
    if (d >= c->width)
        return least;
    const double delta = 8 * (w - d) * (w - d) / (fmax(w, 16) * w * w);
    return fmin(0.5, fmax(least, c->smooth ? delta : exp2(-ceil(-log2(delta) - 0.5))));
}

/* h / right neighbour's part of the rule [C4] for a time factor z a tick:
 *     h (z - 1) = (1 - d) h (1 - 1 / z) + (1 - d / 2) (r^2 F - s h),  s = (d / 2)^2
 * where d is stronger than the field's. Returns F / h. */
static complex double force_over_height(const sponge_case *c, double d, complex double z)
{
    const double s = d > ldexp(1, -DAMPING) ? d * d / 4 : 0;
    return ((z - 1 - (1 - d) * (1 - 1 / z)) / (1 - d / 2) + s) / c->r2;
}

/* e^(i x) */
static complex double turn(complex double x)
{
    return cexp((complex double)I * x);
}

/* Share of a wave exp(i (omega t + kx x)) that comes back from x = 0, by its amplitude: the
 * heights from the edge to beyond the sponge follow one from another. All waves lessen by
 * the field's damping, so the share is that of the wave's energy at one moment. */
static double theory_at(const sponge_case *c, double kx)
{
    const complex double z = sqrt(1 - ldexp(1, -DAMPING)) * turn(frequency(c, kx));
    const double across = 2 - 2 * cos(c->ky), plain = ldexp(1, -DAMPING);
    complex double before = 1, here = 1;

    for (uint32_t d = 0; d < c->width; d++) {
        const complex double f = force_over_height(c, delta_at(c, d), z);
        const complex double next = (f + 2 + across) * here - before;
        before = here, here = next;
    }
    if (c->width == 0)          /* h' = h + r (right - h), of [Engquist and Majda] */
        here = 1 + (z - 1) / sqrt(c->r2);
    /* beyond: h = A e^ix + B e^-ix */
    const complex double x = cacos((force_over_height(c, plain, z) + 2 + across) / 2);
    const complex double in = turn(x);
    const complex double a = here - before / in, b = here - before * in;
    const double ratio = cabs(b / a);
    return ratio < 1 ? ratio : 1 / ratio;
}

/* The mean over the spectrum of the group, by energy. */
static double theory_of(const sponge_case *c)
{
    double sum = 0, all = 0;

    for (int i = -60; i <= 60; i++) {
        const double dk = i * 0.05 / c->wave, kx = c->kx + dk;
        const double omega = frequency(c, kx);
        const double energy = exp(-dk * dk * c->wave * c->wave) * omega * omega;
        const double share = theory_at(c, kx);
        sum += energy * share * share;
        all += energy;
    }
    return sqrt(sum / all);
}

/* -- a run --------------------------------------------------------------------------- */

static uint32_t open_half(const sponge_case *c)
{
    return 3 * c->wave + c->width;
}

static tp_pool *channel_new(const sponge_case *c, tp_cells bits)
{
    const uint32_t cols = 2 * (open_half(c) + c->width);
    const tp_pool_config config = {
        .cols = cols, .rows = c->rows, .cells = bits, .edges = TP_EDGES_SPONGE,
        .courant = TP_FX(0.484), .damping = DAMPING, .sponge = c->width,
        .range = TP_FX(1), .cell = TP_FX(0.25),
    };
    tp_pool *const pool = pool_new(&config);
    const double most = bits == TP_CELLS_32 ? 1 << 23 : tp_pool_max_lsb(pool) / 2.0;
    uint8_t *const row = (uint8_t *)tp_pool_pointer(pool, pool->sponge) + cols;

    pool->courant_sq_q10 = COURANT_SQ;
    for (uint32_t j = 0; j < c->rows; j++)
        row[j] = DAMPING;           /* no sponge along the channel */
    for (uint32_t i = 0; i < cols * c->rows; i++) {
        const double x = i % cols + 0.5 - cols / 2.0, z = i / cols + 0.5;
        const double group = exp(-x * x / (2.0 * c->wave * c->wave)) * cos(c->kx * x);
        tp_pool_add_cell_height(pool, i % cols, i / cols,
                                (int32_t)lround(most * group * cos(c->ky * z)));
    }
    tp_pool_start_carry_rounding(pool, (int32_t)most);
    return pool;
}

/* Energy of the water between the sponges. */
static double energy_between(const tp_pool *pool, const sponge_case *c)
{
    const uint32_t cols = pool->cols, rows = pool->rows;
    pool_field w = pool_field_of(pool);
    double sum = 0;

    for (uint32_t j = 0; j < rows; j++)
        for (uint32_t x = c->width; x < cols - c->width; x++) {
            const uint32_t i = j * cols + x, up = j ? i - cols : i,
                           down = j + 1 < rows ? i + cols : i;
            const double before = w.h[i] - w.v[i];
            const double k0 = 4 * before - (w.h[i - 1] - w.v[i - 1])
                            - (w.h[i + 1] - w.v[i + 1]) - (w.h[up] - w.v[up])
                            - (w.h[down] - w.v[down]);
            sum += w.v[i] * w.v[i] + c->r2 * w.h[i] * k0;
        }
    pool_field_free(&w);
    return fmax(sum, 0);
}

/* From the middle to a sponge and back, so far beyond the middle that what the front of the
 * sponge and what its wall sends back both lie between the sponges. */
static double share_back(const sponge_case *c, tp_cells bits)
{
    const double step = 1e-4;
    const double speed = (frequency(c, c->kx + step) - frequency(c, c->kx - step))
                       / (2 * step);
    const int ticks = (int)lround((2.0 * open_half(c) + c->width) / speed);
    tp_pool *const pool = channel_new(c, bits);
    const double start = energy_between(pool, c);

    for (int t = 0; t < ticks; t++)
        tp_pool_step(pool);
    const double end = energy_between(pool, c);
    free(pool);
    return sqrt(end / (start * pow(1 - ldexp(1, -DAMPING), ticks)));
}

/* -- rows ---------------------------------------------------------------------------- */

static bool has_width(const tp_scene_pool *pool, int32_t width)
{
    return pool->cols > 0 && pool->boundary == TP_EDGES_SPONGE && pool->sponge == width;
}

static bool is_in(const tp_scene *scene, int32_t width)
{
    return has_width(&scene->pool, width) || has_width(&scene->field, width);
}

static void print_sponge(uint32_t width, uint32_t degrees, uint32_t wave, bool cells_only)
{
    sponge_case c = case_of(width, wave, degrees);
    const double side = USEFUL + 2.0 * width;
    char keys[48];

    snprintf(keys, sizeof keys, "pool-sponge,%u;%u;%u", (unsigned)width, (unsigned)degrees,
             (unsigned)wave);
    printf("%s,updates,%.6g\n", keys, side * side);
    if (cells_only)
        return;
    printf("%s,theory,%.3g\n", keys, 100 * theory_of(&c));
    if (width > 0)
        printf("%s,back,%.3g\n", keys, 100 * share_back(&c, TP_CELLS_16));
    if (width > 0 && degrees == 0)
        printf("%s,back_32,%.3g\n", keys, 100 * share_back(&c, TP_CELLS_32));
    c.smooth = true;
    printf("%s,smooth,%.3g\n", keys, 100 * theory_of(&c));
    used_row("pool-sponge", keys + strlen("pool-sponge,"), is_in, (int32_t)width);
}

void print_pool_sponge(uint32_t degrees, bool cells_only)
{
    static const uint32_t widths[] = { 0, 4, 8, 16, 24, 32, 64 };
    static const uint32_t waves[] = { 6, 8, 12, 16, 24, 32, 40 };

    for (int n = 0; n < 7 * 7; n++)
        print_sponge(widths[n / 7], degrees, waves[n % 7], cells_only);
}
