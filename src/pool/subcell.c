/* SPDX-License-Identifier: MIT */
/* The surface of a pool between its cells and between its ticks, at a point and as a
 * table of slopes.  The slope of a cell is the central difference of its two neighbours
 * [A6]. */
#include "base/base.h"
#include "pool/pool.h"

/* -- fine heights -------------------------------------------------------------------- */

/* Fine heights of cells: the stored height with extra fraction bits for interpolation.
 * 8-bit cells get 16 more bits, 16-bit cells 8 more, 32-bit cells none.  `lag` is a
 * fraction of a step into the past: the height was then H - lag V.  Neither the
 * height H nor the last one, H - V, leaves the range of the cell, and all heights
 * between fit 31 bits. */

/* Returns a fine height.  `row_start` is the index of the first cell of the row.
 * `interpolates` is true if lag is not 0.  `cells` and `interpolates` are literals in
 * fast loops. */
TP_ALWAYS_INLINE int32_t fine_height(const tp_pool *pool, uint32_t col,
                                             uint32_t row, uint32_t row_start, tp_fx lag,
                                             tp_cells cells, int interpolates)
{
    const void *const from = tp_pool_const_pointer(pool, sizeof *pool);
    const uint32_t i = row_start + col;

    if (cells == TP_CELLS_8) {
        const tp_pool_pair_8 *const cell = (const tp_pool_pair_8 *)from + i;
        return cell->h * 65536 - (interpolates ? cell->v * lag : 0);
    }
    if (cells == TP_CELLS_16) {             /* 32767 x 2^16 fits */
        const tp_pool_pair_16 *const cell = (const tp_pool_pair_16 *)from + i;
        return cell->h * 256 - (interpolates ? (cell->v * lag + 128) >> 8 : 0);
    }
    const int32_t h = ((const int32_t *)from)[i];
    if (!interpolates)
        return h;
    return h
           - (int32_t)(((int64_t)tp_pool_net_inflow(pool, col, row) * lag + 0x8000)
                       >> 16);
}

/* Returns column or row i, wrapped or mirrored into the field; i may lie one or
 * two cells outside. */
static inline uint32_t tp_pool_wrap_or_mirror(int32_t i, uint32_t cells, bool tiled)
{
    const int32_t n = (int32_t)cells;

    if (tiled)
        return (uint32_t)(i < 0 ? i + n : i < n ? i : i - n);
    return (uint32_t)(i < 0 ? -1 - i : i < n ? i : 2 * n - 1 - i);
}

/* -- height and slopes at a point ---------------------------------------------------- */

/* Heights and slopes are interpolated bilinearly from the four cells around a point. */

/* Converts a coordinate to cells.  The field is one turn of 2^64: points beyond a
 * tiled field wrap at no cost.  `turns` is rounded down: inside a field that is not
 * tiled the product stays within half a turn.  The far edge itself counts as the last
 * position in the last cell. */
static bool locate_on_axis(const tp_pool *pool, int64_t from_centre, uint64_t turns,
                           uint32_t cells, uint64_t *u)
{
    const int64_t side = (int64_t)pool->cell * (int64_t)cells;
    const uint64_t turn = (uint64_t)from_centre * turns + ((uint64_t)1 << 63);
    const bool edge = 2 * from_centre == side && pool->edges != TP_EDGES_TILE;

    *u = edge ? ((uint64_t)cells << 32) - 1 : (turn >> 32) * cells;
    return pool->edges == TP_EDGES_TILE
        || (2 * from_centre >= -side && 2 * from_centre <= side);
}

bool tp_pool_locate(const tp_pool *pool, tp_fx x, tp_fx z, uint64_t *u, uint64_t *w)
{
    const int64_t dx = (int64_t)x - pool->x, dz = (int64_t)z - pool->z;

    return locate_on_axis(pool, dx, pool->turns_x, pool->cols, u)
           && locate_on_axis(pool, dz, pool->turns_z, pool->rows, w);
}

bool tp_pool_open_cell_at_point(const tp_pool *pool, tp_fx x, tp_fx z, uint32_t *col,
                                uint32_t *row)
{
    uint64_t u, w;

    if (!tp_pool_locate(pool, x, z, &u, &w))
        return false;
    *col = (uint32_t)(u >> 32);
    *row = (uint32_t)(w >> 32);
    return !tp_pool_is_wall(pool, *row * pool->cols + *col);
}

/* fine_height for any kind of cell; slower. */
static int32_t fine_height_any(const tp_pool *pool, uint32_t col, uint32_t row,
                               tp_fx lag)
{
    return fine_height(pool, col, row, row * pool->cols, lag,
                               (tp_cells)pool->cells, 1);
}

/* Returns the fine height of a cell.  A wall cell gets the mean of the open cells beside
 * the wall: a flat wall mirrors, and the surface beside a wall does not depend on the side
 * it is sampled from.  A wall cell without open neighbours gets `fallback`. */
static int32_t fine_height_extended_into_wall(const tp_pool *pool, uint32_t col,
                                              uint32_t row, tp_fx lag, int32_t fallback)
{
    TP_ASSERT(col < pool->cols && row < pool->rows);
    static const int8_t beside[4][2] = { { -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } };
    const bool tiled = pool->edges == TP_EDGES_TILE;
    int64_t    sum = 0;
    int32_t    open = 0;

    if (!tp_pool_is_wall(pool, row * pool->cols + col))
        return fine_height_any(pool, col, row, lag);
    for (int n = 0; n < 4; n++) {
        const uint32_t x =
            tp_pool_wrap_or_mirror((int32_t)col + beside[n][0], pool->cols, tiled);
        const uint32_t y =
            tp_pool_wrap_or_mirror((int32_t)row + beside[n][1], pool->rows, tiled);
        if (!tp_pool_is_wall(pool, y * pool->cols + x)) {
            sum += fine_height_any(pool, x, y, lag);
            open++;
        }
    }
    return open != 0 ? (int32_t)(sum / open) : fallback;
}

/* Collects the heights of row i of the 4 x 4 patch; `no_corners` leaves out the first and
 * the last column, for rows 0 and 3.  `interpolated` takes the heights p->lag earlier.
 * i, no_corners, cells and interpolated are literals. */
TP_ALWAYS_INLINE void gather_patch_row(const tp_pool *pool, const tp_pool_patch *p,
                                       tp_pool_heights *to, int i, int no_corners,
                                       tp_cells cells, int interpolated)
{
    const uint32_t row = p->row[i], base = row * pool->cols;

    to->h[i][1] = fine_height(pool, p->col[1], row, base, p->lag, cells,
                                      interpolated);
    to->h[i][2] = fine_height(pool, p->col[2], row, base, p->lag, cells,
                                      interpolated);
    if (!no_corners) {
        to->h[i][0] =
            fine_height(pool, p->col[0], row, base, p->lag, cells,
                                      interpolated);
        to->h[i][3] =
            fine_height(pool, p->col[3], row, base, p->lag, cells, interpolated);
    }
}

#define X(name, cells, interpolates)                                                     \
    void tp_pool_gather_##name(const tp_pool *restrict pool,                             \
                               const tp_pool_patch *restrict p,                          \
                               tp_pool_heights *restrict to)                             \
    {                                                                                    \
        gather_patch_row(pool, p, to, 0, 1, cells, interpolates);                        \
        gather_patch_row(pool, p, to, 1, 0, cells, interpolates);                        \
        gather_patch_row(pool, p, to, 2, 0, cells, interpolates);                        \
        gather_patch_row(pool, p, to, 3, 1, cells, interpolates);                        \
    }
X(now_8, TP_CELLS_8, 0) X(now_16, TP_CELLS_16, 0) X(now_32, TP_CELLS_32, 0)
X(back_8, TP_CELLS_8, 1) X(back_16, TP_CELLS_16, 1) X(back_32, TP_CELLS_32, 1)
#undef X

/* One small function for all cells. */
void tp_pool_gather_walled(const tp_pool *restrict pool, const tp_pool_patch *restrict p,
                           tp_pool_heights *restrict to)
{
    const int32_t own = fine_height_any(pool, p->own_col, p->own_row, p->lag);

    for (int n = 0; n < 16; n++) {
        const int i = n >> 2, j = n & 3;
        if (i % 3 != 0 || j % 3 != 0)           /* no corner */
            to->h[i][j] =
                fine_height_extended_into_wall(pool, p->col[j], p->row[i], p->lag, own);
    }
}

/* Finds the four columns (or rows) around u.  Returns the position of u from the second to
 * the third, in 1/65536. */
static uint32_t find_neighbour_indices(uint64_t u, uint32_t cells, bool tiled,
                                       uint32_t at[4])
{
    const int64_t from = (int64_t)u - ((int64_t)1 << 31);       /* centre of cell 0 */

    const int32_t i = (int32_t)(from >> 32);

    if (i > 0 && i + 2 < (int32_t)cells) {
        at[1] = (uint32_t)i;
        at[0] = at[1] - 1;
        at[2] = at[1] + 1;
        at[3] = at[1] + 2;
    } else {
        for (int32_t n = 0; n < 4; n++)
            at[n] = tp_pool_wrap_or_mirror(i + n - 1, cells, tiled);
    }
    return (uint32_t)(uint64_t)from >> 16;
}

/* a + (b - a) t, rounded half up; t in 1/65536. */
static int32_t interpolate(int32_t a, int32_t b, uint32_t t)
{
    return (int32_t)(a + ((((int64_t)b - a) * (int64_t)t + 0x8000) >> 16));
}

static tp_fx scaled(int32_t x, int32_t factor, int32_t shift)
{
    return (tp_fx)(((int64_t)x * factor + ((int64_t)1 << (shift - 1))) >> shift);
}

static tp_height_slope interpolate_height_slope(const tp_pool *pool, const tp_pool_patch *p,
                                                const tp_pool_heights *of)
{
    int32_t across[4], down[4];     /* across: columns at the point's row; down:
                                     * rows at its column */

    for (int n = 0; n < 4; n++) {
        across[n] = interpolate(of->h[1][n], of->h[2][n], p->t);
        down[n] = interpolate(of->h[n][1], of->h[n][2], p->s);
    }
    return (tp_height_slope){
        .height = scaled(interpolate(across[1], across[2], p->s), pool->unit_q,
                         pool->unit_shift),
        .slope_x = scaled(interpolate(across[2] - across[0], across[3] - across[1], p->s),
                          pool->slope_q, pool->slope_shift),
        .slope_z = scaled(interpolate(down[2] - down[0], down[3] - down[1], p->t),
                          pool->slope_q, pool->slope_shift),
    };
}

tp_height_slope tp_pool_sample(const tp_pool *pool, const tp_pool_kind *kind, tp_fx x,
                               tp_fx z, tp_fx lag)
{
    TP_ASSERT(kind != NULL && lag >= 0 && lag <= TP_FX_ONE);
    TP_ASSERT((pool->walls != 0) == (kind->walled != NULL) || pool->cells == TP_CELLS_32);
    const bool tiled = pool->edges == TP_EDGES_TILE;
    uint64_t u, w;
    tp_pool_heights of;
    tp_pool_patch p;

    if (pool->at_rest && pool->cells != TP_CELLS_32)
        return (tp_height_slope){ 0 };
    if (!tp_pool_locate(pool, x, z, &u, &w))
        return (tp_height_slope){ 0 };
    p.own_col = (uint32_t)(u >> 32);
    p.own_row = (uint32_t)(w >> 32);
    if (tp_pool_is_wall(pool, p.own_row * pool->cols + p.own_col))
        return (tp_height_slope){ 0 };
    p.lag = tp_pool_step_lag(pool, lag);
    p.s = find_neighbour_indices(u, pool->cols, tiled, p.col);
    p.t = find_neighbour_indices(w, pool->rows, tiled, p.row);
    (pool->walls != 0 ? kind->walled : p.lag != 0 ? kind->back : kind->now)(pool, &p, &of);
    return interpolate_height_slope(pool, &p, &of);
}

tp_height_slope tp_pool_height_slope(const tp_pool *pool, tp_fx x, tp_fx z, tp_fx lag)
{
    return tp_pool_sample(pool, tp_pool_find_kind(pool), x, z, lag);
}

/* -- the table of slopes ------------------------------------------------------------- */

/* The slopes of all cells, for code that samples slopes at every pixel. */

/* One row of the table: the row of cells at its height, the row above (up)
 * and below (down). */
typedef struct {
    const tp_pool *pool;
    uint32_t row, up, down;
    tp_fx    lag, gain;
} pool_row;

/* Slopes in 16.16 are far below 2^31: 64 m over two cells of a centimetre are 2^27. */
static int16_t scale_slope(const pool_row *l, int32_t difference)
{
    const tp_pool *const pool = l->pool;
    const int64_t slope = (int64_t)difference * pool->slope_q >> pool->slope_shift;
    const int64_t held = (slope * l->gain + ((int64_t)1 << 19)) >> 20;

    return (int16_t)(held < -16383 ? -16383 : held > 16383 ? 16383 : held);
}

/* A row of a pool without walls.  `cells` and `interpolates` are literals. */
TP_ALWAYS_INLINE void write_open_row(const pool_row *l, tp_pool_slope *to, tp_cells cells,
                                     int interpolates)
{
    const tp_pool *const pool = l->pool;
    const uint32_t cols = pool->cols, base = l->row * cols;
    const bool     tiled = pool->edges == TP_EDGES_TILE;

    for (int32_t col = -1; col <= (int32_t)cols; col++) {
        const uint32_t at = tp_pool_wrap_or_mirror(col, cols, tiled);
        const uint32_t left = tp_pool_wrap_or_mirror(col - 1, cols, tiled);
        const uint32_t right = tp_pool_wrap_or_mirror(col + 1, cols, tiled);
        const int32_t x =
            fine_height(pool, right, l->row, base, l->lag, cells, interpolates)
            - fine_height(pool, left, l->row, base, l->lag, cells, interpolates);
        const int32_t z = fine_height(pool, at, l->down, l->down * cols, l->lag,
                                              cells, interpolates)
                          - fine_height(pool, at, l->up, l->up * cols, l->lag,
                                                cells, interpolates);
        *to++ = (tp_pool_slope){ scale_slope(l, x), scale_slope(l, z) };
    }
}

/* A row of a pool with walls.  Deep inside walls all neighbours are 0, and the slope is
 * 0. */
static void write_walled_row(const pool_row *l, tp_pool_slope *to)
{
    const tp_pool *const pool = l->pool;
    const uint32_t cols = pool->cols;
    const bool     tiled = pool->edges == TP_EDGES_TILE;

    for (int32_t col = -1; col <= (int32_t)cols; col++) {
        const uint32_t at = tp_pool_wrap_or_mirror(col, cols, tiled);
        const uint32_t left = tp_pool_wrap_or_mirror(col - 1, cols, tiled);
        const uint32_t right = tp_pool_wrap_or_mirror(col + 1, cols, tiled);
        const int32_t  own = fine_height_extended_into_wall(pool, at, l->row, l->lag, 0);
        const int32_t  x = fine_height_extended_into_wall(pool, right, l->row, l->lag, own)
                         - fine_height_extended_into_wall(pool, left, l->row, l->lag, own);
        const int32_t  z = fine_height_extended_into_wall(pool, at, l->down, l->lag, own)
                         - fine_height_extended_into_wall(pool, at, l->up, l->lag, own);
        *to++ = (tp_pool_slope){ scale_slope(l, x), scale_slope(l, z) };
    }
}

static void write_slope_row(const pool_row *l, tp_pool_slope *to)
{
    const tp_cells cells = (tp_cells)l->pool->cells;

    if (l->pool->walls != 0)
        write_walled_row(l, to);
    else if (cells == TP_CELLS_8)
        write_open_row(l, to, TP_CELLS_8, 1);
    else if (cells == TP_CELLS_16)
        write_open_row(l, to, TP_CELLS_16, 1);
    else
        write_open_row(l, to, TP_CELLS_32, 1);
}

void tp_pool_slopes(const tp_pool *pool, tp_fx lag, tp_fx gain, tp_pool_slope *to)
{
    TP_ASSERT(lag >= 0 && lag <= TP_FX_ONE);
    TP_ASSERT(to != NULL);
    const bool tiled = pool->edges == TP_EDGES_TILE;
    const tp_fx step_lag = tp_pool_step_lag(pool, lag);

    for (int32_t row = -1; row <= (int32_t)pool->rows; row++) {
        const pool_row l = { pool, tp_pool_wrap_or_mirror(row, pool->rows, tiled),
                         tp_pool_wrap_or_mirror(row - 1, pool->rows, tiled),
                         tp_pool_wrap_or_mirror(row + 1, pool->rows, tiled), step_lag,
                         gain };
        write_slope_row(&l, to);
        to += pool->cols + 2;
    }
}
