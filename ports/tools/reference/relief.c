/* SPDX-License-Identifier: MIT */
/* Rings and pools; see the header. */
#include "relief.h"
#include <math.h>
#include <stdlib.h>
#include "deep_water.h"
#include "features/drops/drops.h"
#include "surf.h"
#include "world/pools.h"
#include "world/world.h"

/* -- rings --------------------------------------------------------------------------- */

/* Evaluates a ring; `now` in ticks x 65536. */
static bool make_ring(const tp_ring *from, int64_t now, ref_ring *ring)
{
    const double age = (double)(now - from->start) / 65536 / TP_TICKS_PER_SECOND;
    const double attack = ref_number(from->attack);
    const double length = ref_number(from->length);

    if (age <= 0)
        return false;
    *ring = (ref_ring){
        .x = ref_number(from->x), .z = ref_number(from->z), .length = length,
        .crest = length / 2 + ref_number(from->speed) * age,
        .gain = ref_number(from->amplitude) * exp(-age / ref_number(from->decay))
              * (attack > 0 ? ref_smoothstep(0, attack, age) : 1),
        .spread = ref_number(from->spread),
    };
    return true;
}

static void add_ring(const ref_ring *ring, double x, double z, ref_heights *sum)
{
    const double dx = x - ring->x, dz = z - ring->z, rho = hypot(dx, dz);
    const double xi = rho - ring->crest, turn = 2 * PI * xi / ring->length;

    if (fabs(xi) >= ring->length / 2)
        return;
    const double s = 1 / sqrt(1 + rho / ring->spread), w = (1 + cos(turn)) / 2;
    const double rise = -PI / ring->length * sin(turn);
    const double slope = ring->gain * (s * rise - s * s * s * w / (2 * ring->spread));
    sum->height += ring->gain * s * w;
    sum->slope_x += slope * dx / rho;
    sum->slope_z += slope * dz / rho;
}

static void read_rings(ref_relief *relief, const tp_drops *drops, int64_t now)
{
    relief->ring = calloc(drops->rings + 1, sizeof *relief->ring);
    for (uint32_t i = 0; relief->ring && i < drops->rings; i++) {
        ref_ring *to = &relief->ring[relief->rings];
        if (!make_ring(&tp_drops_rings(drops)[i], now, to))
            continue;
        relief->rings++;
        relief->high += to->gain;
        relief->steep += to->gain * (PI / to->length + 0.5 / to->spread);
        relief->fine = fmin(relief->fine, to->length);
    }
}

/* -- cells --------------------------------------------------------------------------- */

static int folded(int i, int n, bool tiled)
{
    if (tiled)
        return (i % n + n) % n;
    return i < 0 ? -1 - i : i < n ? i : 2 * n - 1 - i;
}

static double of_wall(const ref_cells *c, int col, int row)
{
    static const int beside[4][2] = { { -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } };
    double sum = 0;
    int open = 0;

    for (int n = 0; n < 4; n++) {
        const int at = folded(row + beside[n][1], c->rows, c->tiled) * c->cols
                     + folded(col + beside[n][0], c->cols, c->tiled);
        if (!c->wall[at]) {
            sum += c->height[at];
            open++;
        }
    }
    return open ? sum / open : (double)NAN;
}

static double pool_lsb(const tp_pool *pool)
{
    return pool->cells == TP_CELLS_8 ? ref_number(pool->range) / 127
         : pool->cells == TP_CELLS_16 ? ref_number(pool->range) / 32767 : 0x1p-24;
}

static void read_heights(ref_cells *c, const tp_pool *pool, double back)
{
    const double lsb = pool_lsb(pool);
    const uint32_t left = (0u - (uint32_t)pool->tick) & ((1u << pool->interval) - 1);

    back = (left + back) / (1u << pool->interval);      /* of a step */
    for (int i = 0; i < c->cols * c->rows; i++) {
        const uint32_t col = (uint32_t)(i % c->cols), row = (uint32_t)(i / c->cols);
        c->wall[i] = tp_pool_is_wall_or_outside(pool, col, row);
        c->height[i] = lsb * (tp_pool_height_lsb(pool, col, row)
                              - back * tp_pool_velocity(pool, col, row));
    }
    for (int i = 0; i < c->cols * c->rows; i++) {
        if (c->wall[i])
            c->height[i] = of_wall(c, i % c->cols, i / c->cols);
    }
}

/* Bounds of height and slope: the steepest step between neighbours times sqrt(2) for both
 * axes. */
static void bound_cells(const ref_cells *c, ref_relief *relief)
{
    double high = 0, step = 0;

    for (int i = 0; i < c->cols * c->rows; i++) {
        const int right = i % c->cols + 1 < c->cols ? i + 1 : i;
        const int below = i / c->cols + 1 < c->rows ? i + c->cols : i;
        high = fmax(high, fabs(c->height[i]));
        step = fmax(step, fabs(c->height[right] - c->height[i]));
        step = fmax(step, fabs(c->height[below] - c->height[i]));
    }
    if (relief->bump > 0)
        return;
    relief->high += high;
    relief->steep += step / c->cell * 1.4143;
    relief->fine = fmin(relief->fine, 4 * c->cell);
}

static void read_cells(ref_relief *relief, ref_cells *c, const tp_pool *pool, double back)
{
    const size_t count = (size_t)pool->cols * pool->rows;

    *c = (ref_cells){
        .cols = (int)pool->cols, .rows = (int)pool->rows,
        .tiled = pool->edges == TP_EDGES_TILE, .cell = ref_number(pool->cell),
        .x = ref_number(pool->x), .z = ref_number(pool->z),
        .height = malloc(count * sizeof *c->height), .wall = malloc(count),
    };
    c->x -= c->cell * c->cols / 2;
    c->z -= c->cell * c->rows / 2;
    if (!c->height || !c->wall)
        abort();
    read_heights(c, pool, back);
    bound_cells(c, relief);
}

typedef struct {
    double h[4][4];             /* heights of the cells around, by row and column */
    double s, t;                /* place between the second and the third cell, 0..1 */
} ref_patch;

static ref_patch gather_patch(const ref_cells *c, double u, double w)
{
    const int i = (int)floor(u - 0.5), j = (int)floor(w - 0.5);
    const int own = (int)floor(w) * c->cols + (int)floor(u);
    ref_patch p = { .s = u - 0.5 - i, .t = w - 0.5 - j };

    for (int n = 0; n < 16; n++) {
        const int col = folded(i + n % 4 - 1, c->cols, c->tiled);
        const int row = folded(j + n / 4 - 1, c->rows, c->tiled);
        const double h = c->height[row * c->cols + col];
        p.h[n / 4][n % 4] = isnan(h) ? c->height[own] : h;
    }
    return p;
}

static double mixed(double a, double b, double t)
{
    return a + (b - a) * t;
}

static void add_cells(const ref_cells *c, double x, double z, ref_heights *sum)
{
    double u = (x - c->x) / c->cell, w = (z - c->z) / c->cell;
    double across[4], down[4];

    if (c->tiled) {
        u -= c->cols * floor(u / c->cols);
        w -= c->rows * floor(w / c->rows);
    }
    if (u < 0 || w < 0 || u > c->cols || w > c->rows)
        return;
    u = fmin(u, c->cols - 1e-9);        /* the far edge belongs to the last cell */
    w = fmin(w, c->rows - 1e-9);
    if (c->wall[(int)w * c->cols + (int)u])
        return;
    const ref_patch p = gather_patch(c, u, w);
    for (int n = 0; n < 4; n++) {
        across[n] = mixed(p.h[1][n], p.h[2][n], p.t);
        down[n] = mixed(p.h[n][1], p.h[n][2], p.s);
    }
    const double steep = 1 / (2 * c->cell);
    sum->height += mixed(across[1], across[2], p.s);
    sum->slope_x += steep * mixed(across[2] - across[0], across[3] - across[1], p.s);
    sum->slope_z += steep * mixed(down[2] - down[0], down[3] - down[1], p.t);
}

/* -- rings and cells together -------------------------------------------------------- */

ref_relief ref_relief_make(const tp_world *world, double bump)
{
    const tp_drops *drops = tp_world_drops(world);
    const tp_pool *pools[2] = { tp_world_pool(world), tp_world_field(world) };
    ref_relief relief = { .fine = 1e9, .bump = bump };

    if (drops)
        read_rings(&relief, drops, (int64_t)world->tick * 65536 - world->lag);
    for (int i = 0; i < 2; i++) {
        if (pools[i])
            read_cells(&relief, &relief.cells[i], pools[i], ref_number(world->lag));
    }
    return relief;
}

void ref_relief_free(ref_relief *relief)
{
    free(relief->ring);
    for (int i = 0; i < 2; i++) {
        free(relief->cells[i].height);
        free(relief->cells[i].wall);
    }
}

ref_heights ref_relief_sample(const ref_relief *relief, double x, double z)
{
    ref_heights sum = { 0 };

    for (int i = 0; i < relief->rings; i++)
        add_ring(&relief->ring[i], x, z, &sum);
    for (int i = 0; i < 2; i++) {
        ref_heights cells = { 0 };
        if (!relief->cells[i].cols)
            continue;
        add_cells(&relief->cells[i], x, z, relief->bump > 0 ? &cells : &sum);
        sum.bump_x[i] = relief->bump * cells.slope_x;
        sum.bump_z[i] = relief->bump * cells.slope_z;
    }
    return sum;
}
