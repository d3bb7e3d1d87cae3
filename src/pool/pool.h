/* SPDX-License-Identifier: MIT */
/* Inside the pool: where things lie in its block, and what its files share.
 *
 * A walls byte of a cell says to which neighbours water can go, tiling included; a wall's
 * own byte has none of them.  Heights, velocities and fluxes of walls are always 0. */
#ifndef TP_POOL_POOL_H
#define TP_POOL_POOL_H
#include "tidepool/pool.h"

enum { TP_OPEN_LEFT = 1, TP_OPEN_RIGHT = 2, TP_OPEN_UP = 4, TP_OPEN_DOWN = 8,
       TP_WALL = 16 };

/* Cells of 8 and 16 bits. */
typedef struct { int8_t h, v; } tp_pool_pair_8;
typedef struct { int16_t h, v; } tp_pool_pair_16;

/* Full range of a height, either way.  Of 32 bits it is 64 m: differences of two heights,
 * and so everything in a step, fit 32 bits. */
enum { TP_FULL_8 = 127, TP_FULL_16 = 32767, TP_FULL_32 = (1 << 30) - 1 };

/* Ticks in which the feed counts its injections [C16]. */
enum { TP_FEED_WINDOW = 64 };

/* Steps take no larger r2q, so that no product of theirs overflows: r = 0.865. */
enum { TP_R2Q_MAX = 767 };

static inline int32_t tp_pool_full(const tp_pool *pool)
{
    return pool->cells == TP_CELLS_8 ? TP_FULL_8
         : pool->cells == TP_CELLS_16 ? TP_FULL_16 : TP_FULL_32;
}

static inline uint32_t tp_pool_count(const tp_pool *pool)
{
    return pool->cols * pool->rows;
}

/* Of the block, `bytes` from its head. */
static inline void *tp_pool_at(tp_pool *pool, uint32_t bytes)
{
    return (char *)pool + bytes;
}

static inline const void *tp_pool_from(const tp_pool *pool, uint32_t bytes)
{
    return (const char *)pool + bytes;
}

static inline bool tp_pool_is_wall(const tp_pool *pool, uint32_t index)
{
    const uint8_t *walls = tp_pool_from(pool, pool->walls);
    return pool->walls != 0 && (walls[index] & TP_WALL) != 0;
}

/* 1024 r^2; r < 1 here. */
static inline uint32_t tp_pool_r2q_of(tp_fx courant)
{
    return (uint32_t)(((uint64_t)courant * (uint64_t)courant * 1024 + (1u << 31)) >> 32);
}

static inline uint32_t tp_pool_r2q(const tp_pool *pool)
{
    return pool->r2q < TP_R2Q_MAX ? pool->r2q : TP_R2Q_MAX;
}

/* x 2^n, for n >= 0 and results in range. */
static inline int32_t tp_pool_up(int32_t x, uint32_t n)
{
    return (int32_t)((uint32_t)x << n);
}

/* How a config lies in its block; `bytes` is the whole. */
typedef struct { uint32_t walls, sponge, work, first, bytes; } tp_pool_layout;
tp_pool_layout tp_pool_lay_out(const tp_pool_config *config);

/* Walls of `mask` (may be NULL) and of the edges, into a block whose sizes are set. */
void tp_pool_set_walls(tp_pool *pool, const tp_grey *mask);
/* One damping for each column, then for each row; a cell has the smaller of its two. */
void tp_pool_set_sponge(tp_pool *pool, uint32_t width);

/* Height of a cell that is in the field, as stored. */
int32_t tp_pool_height_at(const tp_pool *pool, uint32_t index);

/* Of 32-bit cells: what flowed into a cell in the last step less what flowed out.  Fluxes
 * through walls are 0, those beyond the field too unless it is tiled: neighbours may
 * wrap.  H and what it was before are within 2^30, so the sum fits (see flux.c). */
static inline int32_t tp_pool_gain(const tp_pool *pool, uint32_t col, uint32_t row)
{
    const uint32_t cols = pool->cols, count = tp_pool_count(pool);
    const int32_t *const h = tp_pool_from(pool, sizeof *pool);
    const int32_t *const right = h + count, *const down = right + count;
    const uint32_t here = row * cols + col;
    const uint32_t left = col != 0 ? here - 1 : here + cols - 1;
    const uint32_t up = row != 0 ? here - cols : here + count - cols;

    return right[left] - right[here] + down[up] - down[here];
}

/* Where a place lies: in cells from the field's corner, Q32.32.  False: outside. */
bool tp_pool_place(const tp_pool *pool, tp_fx x, tp_fx z, uint64_t *u, uint64_t *w);

/* The hat around (u, w), Q32.32 in cells and inside the field, no wall; sigma in cells,
 * 16.16, of which less than 1.5 is 1.5 and more than 128 is 128; peak within the
 * range. */
void tp_pool_splash(tp_pool *pool, uint64_t u, uint64_t w, tp_fx sigma, int32_t peak);

/* dy/dx and dy/dz, Q3.12, held within 4. */
typedef struct { int16_t x, z; } tp_pool_slope;

/* Slopes at all cells' centres, `gain` times, `back` of a tick ago, and one more all
 * round, wrapped or mirrored: (rows + 2) x (cols + 2), so that bilinear sampling needs no
 * edges.  Between them they give tp_pool_relief's slopes, but that within walls they fade
 * over a cell. */
void tp_pool_slopes(const tp_pool *pool, tp_fx back, tp_fx gain, tp_pool_slope *to);

/* Whether a pool whose bytes come from outside can be stepped and read: what follows from
 * the config equals `fresh`'s, a pool of the same config in the same room; cells and
 * fluxes are in the ranges that steps keep, walls are still. */
bool tp_pool_is_valid(const tp_pool *pool, const tp_pool *fresh);

/* One step of all cells, of each kind. */
void tp_pool_step_8(tp_pool *pool);
void tp_pool_step_16(tp_pool *pool);
void tp_pool_step_32(tp_pool *pool);

/* Before a step: injects if the water has become too quiet [C16]. */
void tp_pool_feed(tp_pool *pool);
#endif
