/* SPDX-License-Identifier: MIT */
/* The step of 32-bit cells: one flux for each edge between two cells, [C17] of the
 * models.
 *
 *     q = tz(tz(q + (Hi - Hj) r^2) (1 - 2^-m)),   Hi -= q,   Hj += q;
 * tz cuts towards 0.  What leaves one cell enters the next, so the sum of heights is
 * exact at every step; cutting makes every flux die.  Fluxes come from the old heights
 * alone: rows may be computed in any order, and columns 8 at a time.
 *
 * Heights are Q8.24 metres within FULL = 2^30 - 1.  A flux is at most a fourth of what
 * its giver has above -FULL and its taker lacks to FULL, so no height ever leaves that
 * range, whatever r2q is set to; below 16 m this bound is never met. */
#include "pool/pool.h"
#include "base/base.h"

#define FULL TP_FULL_32

enum { RIGHT = 1, DOWN = 3 };   /* bits of a walls byte */
_Static_assert(1 << RIGHT == TP_OPEN_RIGHT && 1 << DOWN == TP_OPEN_DOWN, "see pool.h");

/* What one row of fluxes is computed with. */
typedef struct {
    int32_t rate;               /* r2q <= 767 */
    int32_t damping;            /* m, in a sponge of this row */
    const uint8_t *walls;       /* of this row */
    const uint8_t *sponge;      /* of the columns */
    int32_t way;                /* RIGHT or DOWN */
} edges;

/* |Hi - Hj| < 2^31, so its product by r2q / 1024 is formed of two: |high| < 2^21 x 767
 * and a part below 767.  |q| <= 2^29 and the kick < 0.75 x 2^31: their sum fits, and with
 * it the 2^m - 1 that make the shift cut towards 0. */
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

/* The flux of cell x; walls and sponge are literals. */
TP_ALWAYS_INLINE int32_t flux_of(int32_t q, int32_t from, int32_t to, size_t x,
                                 const edges *e, int walls, int sponge)
{
    const int32_t column = sponge ? e->sponge[x] : e->damping;
    const int32_t damping = column < e->damping ? column : e->damping;
    const int32_t open = walls ? -(e->walls[x] >> e->way & 1) : -1;

    return open & flux(q, from, to, e->rate, damping);
}

/* Between `count` cells and their neighbours `to`; not 0: something flows.  The loops of
 * eight are what compilers turn into vectors at -O2 as well. */
TP_ALWAYS_INLINE int32_t flow(int32_t *restrict q, const int32_t *restrict from,
                              const int32_t *restrict to, uint32_t count,
                              const edges *given, int walls, int sponge)
{
    const edges e = *given;             /* locals: q may alias *given */
    int32_t moved[8] = { 0 };
    size_t  x = 0;

    for (; x + 8 <= count; x += 8) {
        for (size_t i = 0; i < 8; i++) {
            const size_t n = x + i;
            q[n] = flux_of(q[n], from[n], to[n], n, &e, walls, sponge);
            moved[i] |= q[n];
        }
    }
    for (; x < count; x++) {
        q[x] = flux_of(q[x], from[x], to[x], x, &e, walls, sponge);
        moved[0] |= q[x];
    }
    return moved[0] | moved[1] | moved[2] | moved[3] | moved[4] | moved[5] | moved[6]
         | moved[7];
}

#define X(name, walls, sponge)                                                          \
    static int32_t name(int32_t *restrict q, const int32_t *restrict from,              \
                        const int32_t *restrict to, uint32_t count, const edges *e)     \
    {                                                                                   \
        return flow(q, from, to, count, e, walls, sponge);                              \
    }
X(flow_open, 0, 0) X(flow_walls, 1, 0) X(flow_sponge, 1, 1)
#undef X

/* Heights of a row after its fluxes; right[-1] is what flows into its first cell. */
static void spill(int32_t *restrict h, const int32_t *restrict right,
                  const int32_t *restrict up, const int32_t *restrict down, uint32_t cols)
{
    const int32_t *const left = right - 1;

    for (size_t x = 0; x < cols; x++)
        h[x] += left[x] - right[x] + up[x] - down[x];
}

/* What a step works on: heights, and fluxes to the right and down, row by row, one block
 * after the other: what lies beside a row's ends is another number of the pool's. */
typedef struct {
    int32_t *h, *right, *down;
    uint32_t cols, rows;
    bool     tiled;
    const uint8_t *walls, *sponge;      /* NULL: none */
    edges    edge;
} sheet;

/* Fluxes q of the cells of row y to the cells `to`. */
static int32_t flow_row(const sheet *s, uint32_t y, int32_t *q, const int32_t *to,
                        int32_t way)
{
    const size_t at = (size_t)y * s->cols;
    const int32_t *const from = s->h + at;
    edges e = s->edge;

    if (s->walls == NULL)
        return flow_open(q + at, from, to, s->cols, &e);
    e.walls = s->walls + at;
    e.way = way;
    if (s->sponge == NULL)
        return flow_walls(q + at, from, to, s->cols, &e);
    e.sponge = s->sponge;
    e.damping = s->sponge[s->cols + y];
    return flow_sponge(q + at, from, to, s->cols, &e);
}

/* So that rows are whole for their loops, the last cell finds its right neighbour behind
 * it for once: the first cell of a tiled field, or itself, where nothing flows. */
static int32_t flow_right(const sheet *s, uint32_t y)
{
    int32_t *const h = s->h + (size_t)y * s->cols, *const beyond = h + s->cols;
    const int32_t kept = *beyond;

    *beyond = s->tiled ? h[0] : h[s->cols - 1];
    const int32_t moved = flow_row(s, y, s->right, h + 1, RIGHT);
    *beyond = kept;
    return moved;
}

/* And the first cell the flux from its left, which beyond a wall's last column is 0. */
static void spill_row(const sheet *s, uint32_t y)
{
    const uint32_t cols = s->cols;
    const size_t at = (size_t)y * cols;
    const size_t above = (size_t)(y == 0 ? s->rows - 1 : y - 1) * cols;
    int32_t *const right = s->right + at;
    const int32_t kept = right[-1];

    right[-1] = right[cols - 1];
    spill(s->h + at, right, s->down + above, s->down + at, cols);
    right[-1] = kept;
}

/* A row's heights change as soon as its fluxes are known: no row below asks for them any
 * more.  Row 0 is needed once more by a tiled field's last row, whose fluxes down
 * therefore come first. */
static int32_t step_rows(const sheet *s)
{
    const uint32_t last = s->rows - 1;
    int32_t moved = s->tiled ? flow_row(s, last, s->down, s->h, DOWN) : 0;

    for (uint32_t y = 0; y <= last; y++) {
        moved |= flow_right(s, y);
        if (y < last)
            moved |= flow_row(s, y, s->down, s->h + (size_t)(y + 1) * s->cols,
                              DOWN);
        spill_row(s, y);
    }
    return moved;
}

void tp_pool_step_32(tp_pool *pool)
{
    const size_t count = tp_pool_count(pool);
    int32_t *const h = tp_pool_at(pool, sizeof *pool);
    const sheet s = {
        .h = h, .right = h + count, .down = h + 2 * count,
        .cols = pool->cols, .rows = pool->rows, .tiled = pool->edges == TP_EDGES_TILE,
        .walls = pool->walls != 0 ? tp_pool_from(pool, pool->walls) : NULL,
        .sponge = pool->sponge != 0 ? tp_pool_from(pool, pool->sponge) : NULL,
        .edge = { .rate = (int32_t)tp_pool_r2q(pool), .damping = (int32_t)pool->damping },
    };
    TP_ASSERT(s.edge.rate <= TP_R2Q_MAX && s.edge.damping >= 4);
    const int32_t moved = step_rows(&s);

    pool->at_rest = moved == 0 && pool->still != 0;
    pool->still = moved == 0;
}
