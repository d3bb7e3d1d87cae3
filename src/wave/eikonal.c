/* SPDX-License-Identifier: MIT */
/* Solves |grad S| = k on a square grid by fast sweeping: Gauss-Seidel in four orders.  Each
 * order settles the nodes reached by waves in its direction (Zhao 2005).
 *
 * a and b are the lower of the two neighbours along x and along z.  A node solves
 *     (S - a)^2 + (S - b)^2 = f^2,   f = k times the grid step,
 * or takes a + f if b is too high to contribute (Godunov).  A plane wave is an exact
 * solution, to the last bit.  k is taken half a step back, towards the neighbour with the
 * larger difference; a straight shore then has second order accuracy.  Behind an obstacle
 * the solution holds only the waves that arrive first. */
#include "wave/ocean_tables.h"

#define UNKNOWN INT64_MAX
#define ROUNDS  16

typedef struct {
    int64_t *turns;
    const tp_coastal_wave_node *ray;
    uint32_t cols, rows;
} lattice;

/* A neighbour: its phase, and its k times the step. */
typedef struct {
    int64_t turns;
    int64_t number;
} before;

static before lower_neighbour(const lattice *l, size_t at, size_t step, bool has_low,
                              bool has_high)
{
    const int64_t low = has_low ? l->turns[at - step] : UNKNOWN;
    const int64_t high = has_high ? l->turns[at + step] : UNKNOWN;
    const size_t from = low <= high ? at - step : at + step;

    if (low == UNKNOWN && high == UNKNOWN)
        return (before){ UNKNOWN, 0 };
    return (before){ low <= high ? low : high, (uint32_t)l->ray[from].turns };
}

/* Returns f half a step back from `here`, in Q32.32. */
static int64_t half_step_number(int64_t here, int64_t there)
{
    return (here + there) * ((int64_t)1 << 7);
}

/* Returns sqrt(2 f^2 - d^2) for |d| < f; f is first shifted down to 31 bits. */
static int64_t wavefront_root(int64_t f, int64_t d)
{
    int down = 0;

    for (; f >> 31 != 0; f >>= 1, d /= 2)
        down++;
    return (int64_t)tp_isqrt64((uint64_t)(2 * f * f - d * d)) << down;
}

static int64_t godunov_solution(int64_t number, before a, before b)
{
    if (a.turns > b.turns) {
        const before swap = a;
        a = b;
        b = swap;
    }
    if (a.turns == UNKNOWN)
        return UNKNOWN;
    const int64_t alone = half_step_number(number, a.number);
    if (b.turns == UNKNOWN || b.turns - a.turns >= alone)
        return a.turns + alone;
    const int64_t da = number - a.number, db = number - b.number;
    const bool more = (db < 0 ? -db : db) > (da < 0 ? -da : da);
    const int64_t f = half_step_number(number, more ? b.number : a.number);
    const int64_t d = b.turns - a.turns;
    if (d >= f)
        return a.turns + alone;
    return (a.turns + b.turns + wavefront_root(f, d)) / 2;
}

static bool update_node(const lattice *l, uint32_t col, uint32_t row)
{
    const size_t at = (size_t)row * l->cols + col;
    const before x = lower_neighbour(l, at, 1, col > 0, col + 1 < l->cols);
    const before z = lower_neighbour(l, at, l->cols, row > 0, row + 1 < l->rows);
    const int64_t turns = godunov_solution((uint32_t)l->ray[at].turns, x, z);

    if (turns >= l->turns[at])
        return false;
    l->turns[at] = turns;
    return true;
}

static bool sweep(const lattice *l, bool west, bool north)
{
    bool changed = false;

    for (uint32_t r = 0; r < l->rows; r++) {
        const uint32_t row = north ? l->rows - 1 - r : r;
        for (uint32_t c = 0; c < l->cols; c++)
            changed |= update_node(l, west ? l->cols - 1 - c : c, row);
    }
    return changed;
}

void tp_eikonal_solve(int64_t *turns, const tp_coastal_wave_node *ray, uint32_t cols,
                      uint32_t rows)
{
    TP_ASSERT(cols >= 2 && rows >= 2);
    const lattice l = { turns, ray, cols, rows };
    bool changed = true;

    for (int n = 0; n < ROUNDS && changed; n++) {
        changed = false;
        for (int way = 0; way < 4; way++)
            changed |= sweep(&l, way & 1, way & 2);
    }
}
