/* SPDX-License-Identifier: MIT */
/*
 * The step of a pool, by the type of its cells: gears of 8- and 16-bit cells, [C8]-[C13]
 * of the models, and fluxes of 32-bit cells, [C17].
 */
#include "base/base.h"
#include "pool/pool.h"

/* -- 8- and 16-bit cells: gears ------------------------------------------------------ */

/* Two ways of rounding, called gears.
 *
 * F is the sum of the four neighbours less four times the height.  The
 * centred damping [C4] is
 *     S = (2 - 2^-m) (V + r^2 F / 2),   V' = S - V,   H' = H + V',
 * and the behaviour depends on the rounding of S.  Gear A passes the rounding error of each
 * cell on to the next cell: ripples travel far, and the sum of heights is kept.  Gear B
 * rounds towards 0: it never adds energy [C5], and the water settles.  When nothing moves
 * any more, each tick takes all heights one step nearer to 0 [C10], until all are 0.
 *
 * In a sponge, gear A does not keep the sum: the stronger damping absorbs part of a wave
 * and its sum with it.  Waves started in a sponge left a mean of -13000 LSB of 32767 in
 * 20000 ticks.  Each sponge cell is therefore also pulled to 0 by a spring of (delta /
 * 2)^2.  The spring is part of F, and the theorem of [C5] still holds.  A line with equal
 * damping of both its quantities does not reflect.  With the spring the mean stays within
 * 200 LSB, and the reflections do not change.
 *
 * Only the sponge needs 64 bits.  With T = 2^11 V + r2q F, S is (2^(m+1) - 1) T / 2^(11+m),
 * rounded.  |V| <= 32767 and |F| <= 8 x 32767: |T| < 2^26 + 767 x 2^18 < 2^28.  The
 * division takes two steps.  The first divides by 2^(m+1), where (2^(m+1) T + w) / 2^(m+1)
 * = T + w / 2^(m+1): the large product is never formed, and a floor of a floor is exact.
 * The second divides by 2^10.  This literal costs a Cortex-M4 less than the reduced
 * fraction of [C13], and the bits are the same. */

typedef struct {
    int32_t  rate;          /* r2q */
    uint32_t down;          /* m + 1 */
    int32_t  whole;         /* denominator of S: 2^(11+m) <= 2^21 */
} gear;

static gear make_step_constants(const tp_pool *pool)
{
    return (gear){ (int32_t)tp_pool_clamped_courant_sq_q10(pool), pool->damping + 1,
                   (int32_t)1 << (11 + pool->damping) };
}

/* Gear A: rounds S + carry to nearest, halves away from 0; the error becomes the new carry.
 * The carry is stored with half of `whole` added, 0 < carry <= whole, to make the rounding
 * a floor.  A floor rounds a tie up; below 0 a tie has to go down, and the last lines
 * correct the result. */
TP_ALWAYS_INLINE int32_t damp_and_round(int32_t t, const gear *g, int32_t *carry)
{
    const int32_t w = *carry - t;
    int32_t s = (t + (w >> g->down)) >> 10;
    int32_t rest = tp_pool_shift_left(t - s * 1024, g->down) + w;

    if (rest == 0 && s <= 0) {
        rest = tp_pool_shift_left(1024, g->down);
        s--;
    }
    *carry = rest;
    return s;
}

/* Gear A in a sponge, where the damping `cell_damping` of the cell is stronger.  The
 * carry stays in units of the damping of the field: (2^(m+1) - 2^(m-own)) T fits 39
 * bits. */
TP_ALWAYS_INLINE int32_t damp_and_round_in_sponge(int32_t t, const gear *g,
                                                  uint32_t cell_damping, int32_t *carry)
{
    const int32_t factor = (1 << g->down) - (1 << (g->down - 1 - cell_damping));
    const int64_t y = (int64_t)factor * t + *carry;
    int32_t s = (int32_t)(y >> (10 + g->down));
    int32_t rest = (int32_t)(y - (int64_t)s * g->whole);

    if (rest == 0 && s <= 0) {
        rest = g->whole;
        s--;
    }
    *carry = rest;
    return s;
}

/* Gear B: truncates S towards 0. */
TP_ALWAYS_INLINE int32_t damp_and_truncate(int32_t t, const gear *g)
{
    const int32_t w = (t >> 31 & (g->whole - 1)) - t;
    return (t + (w >> g->down)) >> 10;
}

#define CELL    int8_t
#define PAIR    tp_pool_pair_8
#define NAME(x) x##_8
#define KIND(x) tp_pool_8_##x
#define FULL    TP_FULL_8
#include "pool/gears.inc"

#define CELL    int16_t
#define PAIR    tp_pool_pair_16
#define NAME(x) x##_16
#define KIND(x) tp_pool_16_##x
#define FULL    TP_FULL_16
#include "pool/gears.inc"

/* -- 32-bit cells: fluxes ------------------------------------------------------------ */

/* One flux through each edge between two cells.
 *
 *     q = tz(tz(q + (Hi - Hj) r^2) (1 - 2^-m)),   Hi -= q,   Hj += q;
 * tz truncates towards 0.  The outflow of one cell is the inflow of the next: the sum of
 * heights is exact at every step.  The truncation makes every flux die out.  Fluxes depend
 * on the old heights alone: rows may be computed in any order, and columns 8 at a time.
 *
 * Heights are Q8.24 metres within +-FULL = +-(2^30 - 1).  A flux is at most a fourth of the
 * giver's height above -FULL, and at most a fourth of the taker's distance to FULL.  No
 * height ever leaves the range, for any value of r2q; below 16 m the bound is never met. */

#define FULL TP_FULL_32

enum { RIGHT = 1, DOWN = 3 };   /* bit numbers in a walls byte */
_Static_assert(1 << RIGHT == TP_OPEN_RIGHT && 1 << DOWN == TP_OPEN_DOWN, "see pool.h");

/* Parameters of one row of fluxes. */
typedef struct {
    int32_t rate;               /* r2q <= 767 */
    int32_t damping;            /* damping exponent m; in a sponge: of this row */
    const uint8_t *walls;       /* walls bytes of this row */
    const uint8_t *sponge;      /* damping exponents of the columns */
    int32_t way;                /* direction of the flux: RIGHT or DOWN */
} edges;

/* Returns the new flux between two cells.  |Hi - Hj| < 2^31; its product by r2q / 1024 is
 * the sum of two parts: |high| < 2^21 x 767, and a low part below 767.  |q| <= 2^29 and the
 * added part < 0.75 x 2^31: their sum fits 32 bits, also with the 2^m - 1 that makes the
 * shift truncate towards 0. */
TP_ALWAYS_INLINE int32_t flux(int32_t q, int32_t from, int32_t to, int32_t rate,
                              int32_t damping)
{
    const int32_t fall = from - to;
    const int32_t most = (FULL + (from < -to ? from : -to)) >> 2;
    const int32_t least = -((FULL + (to < -from ? to : -from)) >> 2);

    q += (fall >> 10) * rate + (((fall & 1023) * rate + (fall >> 31 & 1023)) >> 10);
    q -= (q + (((1 << damping) - 1) & ~(q >> 31))) >> damping;
    return tp_clamp(q, least, most);
}

/* Returns the flux of cell x; `walls` and `sponge` are literals. */
TP_ALWAYS_INLINE int32_t cell_flux(int32_t q, int32_t from, int32_t to, size_t x,
                                   const edges *e, int walls, int sponge)
{
    const int32_t column = sponge ? e->sponge[x] : e->damping;
    const int32_t damping = column < e->damping ? column : e->damping;
    const int32_t open = walls ? -(e->walls[x] >> e->way & 1) : -1;

    return open & flux(q, from, to, e->rate, damping);
}

/* Updates the fluxes between `count` cells `from` and their neighbours `to`.  Returns
 * non-zero if any water flows.  Compilers turn the inner loops of eight into vector
 * code, at -O2 too. */
TP_ALWAYS_INLINE int32_t update_fluxes_any_nonzero(int32_t *restrict q,
                                                   const int32_t *restrict from,
                                                   const int32_t *restrict to,
                                                   uint32_t count, const edges *given,
                                                   int walls, int sponge)
{
    const edges e = *given;             /* locals: q may alias *given */
    int32_t moved[8] = { 0 };
    size_t  x = 0;

    for (; x + 8 <= count; x += 8) {
        for (size_t i = 0; i < 8; i++) {
            const size_t n = x + i;
            q[n] = cell_flux(q[n], from[n], to[n], n, &e, walls, sponge);
            moved[i] |= q[n];
        }
    }
    for (; x < count; x++) {
        q[x] = cell_flux(q[x], from[x], to[x], x, &e, walls, sponge);
        moved[0] |= q[x];
    }
    return moved[0] | moved[1] | moved[2] | moved[3] | moved[4] | moved[5] | moved[6]
         | moved[7];
}

#define X(name, walls, sponge)                                                           \
    static int32_t name(int32_t *restrict q, const int32_t *restrict from,               \
                        const int32_t *restrict to, uint32_t count, const edges *e)      \
    {                                                                                    \
        return update_fluxes_any_nonzero(q, from, to, count, e, walls, sponge);          \
    }
X(flow_open, 0, 0)
X(flow_walls, 1, 0) X(flow_sponge, 1, 1)
#undef X

/* Updates the heights of a row by its fluxes; right[-1] is the flux into the first cell. */
static void apply_fluxes(int32_t *restrict h, const int32_t *restrict right,
                         const int32_t *restrict up, const int32_t *restrict down,
                         uint32_t cols)
{
    const int32_t *const left = right - 1;

    for (size_t x = 0; x < cols; x++)
        h[x] += left[x] - right[x] + up[x] - down[x];
}

/* The arrays of a step: heights, fluxes to the right and fluxes down, row by row,
 * one array after the other.  The number before or after a row belongs to a
 * neighbouring row or array. */
typedef struct {
    int32_t *h, *right, *down;
    uint32_t cols, rows;
    bool     tiled;
    const uint8_t *walls, *sponge;      /* NULL: none */
    edges    edge;
} flux_cells;

/* Updates the fluxes q from the cells of row y to the cells `to`.  Returns 0 if no water
 * flows. */
static int32_t update_row_fluxes(const flux_cells *s, uint32_t y, int32_t *q,
                                 const int32_t *to, int32_t direction)
{
    const size_t at = (size_t)y * s->cols;
    const int32_t *const from = s->h + at;
    edges e = s->edge;

    if (s->walls == NULL)
        return flow_open(q + at, from, to, s->cols, &e);
    e.walls = s->walls + at;
    e.way = direction;
    if (s->sponge == NULL)
        return flow_walls(q + at, from, to, s->cols, &e);
    e.sponge = s->sponge;
    e.damping = s->sponge[s->cols + y];
    return flow_sponge(q + at, from, to, s->cols, &e);
}

/* Updates the fluxes to the right in row y.  Returns 0 if no water flows.  The loop
 * reads the right neighbour of the last cell from behind the row.  This number is
 * replaced for the time of the loop: by the first cell of the row in a tiled field,
 * otherwise by the last cell itself, where nothing flows. */
static int32_t update_right_fluxes(const flux_cells *s, uint32_t y)
{
    int32_t *const h = s->h + (size_t)y * s->cols, *const beyond = h + s->cols;
    const int32_t kept = *beyond;

    *beyond = s->tiled ? h[0] : h[s->cols - 1];
    const int32_t moved = update_row_fluxes(s, y, s->right, h + 1, RIGHT);
    *beyond = kept;
    return moved;
}

/* Updates the heights of row y.  The first cell reads the flux from its left in
 * right[-1], replaced for the time of the loop by the flux of the last column: 0 if the
 * field ends there. */
static void apply_row_fluxes(const flux_cells *s, uint32_t y)
{
    const uint32_t cols = s->cols;
    const size_t at = (size_t)y * cols;
    const size_t above = (size_t)(y == 0 ? s->rows - 1 : y - 1) * cols;
    int32_t *const right = s->right + at;
    const int32_t kept = right[-1];

    right[-1] = right[cols - 1];
    apply_fluxes(s->h + at, right, s->down + above, s->down + at, cols);
    right[-1] = kept;
}

/* Runs a step, row by row, and returns 0 if no flux moved water.  The heights of a row
 * change as soon as the fluxes of the row are known: later rows do not read the old
 * heights.  The last row of a tiled field is an exception: its fluxes down need the
 * old row 0 and are computed first. */
static int32_t step_rows(const flux_cells *s)
{
    const uint32_t last = s->rows - 1;
    int32_t moved = s->tiled ? update_row_fluxes(s, last, s->down, s->h, DOWN) : 0;

    for (uint32_t y = 0; y <= last; y++) {
        moved |= update_right_fluxes(s, y);
        if (y < last)
            moved |= update_row_fluxes(s, y, s->down, s->h + (size_t)(y + 1) * s->cols,
                              DOWN);
        apply_row_fluxes(s, y);
    }
    return moved;
}

static void step_32(tp_pool *pool)
{
    const size_t count = tp_pool_count(pool);
    int32_t *const h = tp_pool_pointer(pool, sizeof *pool);
    const flux_cells s = {
        .h = h, .right = h + count, .down = h + 2 * count,
        .cols = pool->cols, .rows = pool->rows, .tiled = pool->edges == TP_EDGES_TILE,
        .walls = pool->walls != 0 ? tp_pool_const_pointer(pool, pool->walls) : NULL,
        .sponge = pool->sponge != 0 ? tp_pool_const_pointer(pool, pool->sponge) : NULL,
        .edge = { .rate = (int32_t)tp_pool_clamped_courant_sq_q10(pool),
                  .damping = (int32_t)pool->damping },
    };
    TP_ASSERT(s.edge.rate <= TP_COURANT_SQ_MAX_Q10 && s.edge.damping >= 4);
    const int32_t moved = step_rows(&s);

    pool->at_rest = moved == 0 && pool->no_flux != 0;
    pool->no_flux = moved == 0;
}

const tp_pool_kind tp_pool_32 = {
    step_32, tp_pool_gather_now_32, tp_pool_gather_back_32, tp_pool_gather_walled,
};
