/* SPDX-License-Identifier: MIT */
/* The pool: water as a damped automaton on a grid of cells, [C1]-[C18] of the models.
 *
 * Three kinds of cell behind one interface.  8 and 16 bits: height and velocity, rounded
 * by two gears, so that ripples travel far and the water still comes to exact rest.
 * 32 bits: height and two fluxes through the cell's edges, so that no volume is lost at
 * any step.  All are bounded, come to exact rest and do not drift.
 *
 * A pool is one block without pointers: copying its bytes is a snapshot. */
#ifndef TP_POOL_POOL_H
#define TP_POOL_POOL_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "fx/fx.h"
#include "tidepool/assets.h"
#include "tidepool/scene.h"

typedef struct {
    uint32_t cols, rows;    /* cells along x and z, 16..512 */
    tp_cells cells;
    tp_edges edges;
    tp_fx    courant;       /* r = wave speed x tick / cell, 0.05 to 0.49 and by the
                             * damping a little more: see tp_pool_check */
    uint32_t damping;       /* m, 4..10: 2^-m of the motion goes each tick */
    uint32_t sponge;        /* cells, 4..64, of TP_EDGES_SPONGE */
    tp_fx    range;         /* m at the full range of 8- and 16-bit cells, 0.01..64;
                             * 32-bit cells are Q8.24 metres and ignore it */
    tp_fx    cell;          /* m, side of a cell, 0.01..50 */
    tp_fx    x, z;          /* m, the centre of the field */
    tp_fx    feed_low, feed_high;   /* m: the band in which feeding holds the rms of the
                                     * heights [C16]; 0, 0: it is not fed */
    tp_fx    feed;          /* m: height of an injection */
    const tp_grey *mask;    /* laid over all cells: darker than half is wall; or NULL */
} tp_pool_config;

/* Private: read by the functions below.  Cells of 8 or 16 bits follow this head as pairs
 * of height and velocity; of 32 bits as heights, then fluxes to the right, then fluxes
 * down; then, where the config needs them, walls, sponge and rows of work. */
typedef struct {
    uint32_t cols, rows;
    uint32_t cells, edges;          /* tp_cells, tp_edges */
    uint32_t r2q;                   /* 1024 r^2, rounded */
    uint32_t damping;               /* m */
    tp_fx    range, cell, x, z;
    uint64_t turns_x, turns_z;      /* 2^64 / (cells x cell): a field is one turn */
    int32_t  unit_q, unit_shift;    /* metres (16.16) of a fine height, see sample.c */
    int32_t  slope_q, slope_shift;  /* slope of a fine height over two cells */
    tp_fx    feed_low, feed_high, feed;
    int32_t  feed_peak;             /* LSB of an injection, raised as [C16] says */
    uint32_t feed_ticks, feed_hits; /* of the window in which injections are counted */
    uint32_t random;                /* of the feed: a linear congruential sequence */
    uint32_t injections;            /* of the feed, so far */
    uint32_t gear;                  /* ticks that gear A will last; 0: gear B [C11] */
    uint32_t at_rest;               /* nothing moves, or will without an injection */
    uint32_t still;                 /* 32 bits: no flux in the last step */
    uint32_t walls, sponge, work, first;    /* byte offsets from the head, 0: none */
    uint64_t tick;
} tp_pool;

/* Whether the config can be used: err says what is wrong, err->word is the field's name.
 * r^2 beyond the bound of [C9], (1 - 1/(2 - delta)) / 2 with delta = 2^-damping, is
 * refused: water would not come to rest, and soon would not be stable. */
tp_status tp_pool_check(const tp_pool_config *config, tp_error *err);

/* What the roundings of 8- and 16-bit cells leave in water that moves [C8]: the rms of
 * its heights in LSB, 16.16,
 *     sqrt(2^damping / 24) / courant,
 * where the error that a cell passes on feeds a wave as fast as damping takes from it.
 * Measured are 0.7 to 0.95 of this for courant from 0.3 on, and up to 3 times as much
 * where a small one and strong damping keep roundings from averaging.  With 8 bits it is
 * below 16 LSB, an eighth of their range, for courant above 0.0128 2^(damping / 2): 0.05
 * at damping 4, 0.41 at 10.  Below that waves drown in it, but all else holds: nothing
 * leaves the range, and the water comes to rest.
 *
 * One wave may also repeat its roundings, and does not swing any more once its height has
 * come down to 1 / (2 courant^2 k) LSB, k radians a cell [C14].  All together a wave that
 * begins with the height A is off by an rms of at most
 *     1 + 8 x that noise + the lesser of 2 A and 1 / (courant^2 k)  LSB
 * in its first 400 ticks, and by twice as much in a corner, where it meets its images: of
 * 150,000 random waves the worst had 0.88 of that.  Later this is no bound.  Over 6000
 * ticks of gear A all of 5600 random waves of 8 bits kept it, the worst with 0.88; of
 * 17,000 of 16 bits with a courant up to 0.31 one in 140 passed it, the worst by 4.0
 * times, which was 2.3 % of the range. */
tp_fx tp_pool_noise(tp_fx courant, uint32_t damping);

/* Of the block, aligned to 8; 0 if the config cannot be used. */
size_t tp_pool_bytes(const tp_pool_config *config);

/* Still water, in tp_pool_bytes() bytes; errors as tp_pool_check, and TP_E_NULL or
 * TP_E_ALIGN of the block.  `mask` is read now and
 * not kept. */
tp_status tp_pool_init(tp_pool *pool, const tp_pool_config *config, tp_error *err);

/* Takes what of a config may change while the water moves: courant, damping, place and
 * feed.  False, and nothing is done: it cannot be used, or is that of another block. */
bool tp_pool_tune(tp_pool *pool, const tp_pool_config *config);

/* One tick.  Accepts any r2q that was set by hand: charts show what happens beyond. */
void tp_pool_step(tp_pool *pool);

/* Height and slopes above any place (x, z) of the world, bilinear between cells' centres;
 * 0 outside of a field that is not tiled and in walls.  `back`, 0..1 (16.16): so much of a
 * tick ago.  A cell's slope is that of its two neighbours [A6], so slopes are continuous
 * as well; walls mirror. */
tp_relief tp_pool_relief(const tp_pool *pool, tp_fx x, tp_fx z, tp_fx back);

/* A zero-sum hat [C11] [D5]: `height` m in the middle, width sigma m (at least 1.5
 * cells).  What falls into walls or outside is not lost: the rest is balanced again.
 * False: its middle lies outside, or in a wall. */
bool tp_pool_hat(tp_pool *pool, tp_fx x, tp_fx z, tp_fx sigma, tp_fx height);

/* The cell at a place; false: none, or wall. */
bool tp_pool_cell(const tp_pool *pool, tp_fx x, tp_fx z, uint32_t *col, uint32_t *row);

/* Adds to one cell's height, in its own LSB; returns what fitted.  Whoever adds keeps the
 * sum at zero, and calls tp_pool_stirred with the highest of what it added. */
int32_t tp_pool_add(tp_pool *pool, uint32_t col, uint32_t row, int32_t lsb);
void    tp_pool_stirred(tp_pool *pool, int32_t peak_lsb);
int32_t tp_pool_lsb(const tp_pool *pool, tp_fx metres);     /* rounded to nearest */

/* No water stands higher or lower, m. */
tp_fx tp_pool_highest(const tp_pool *pool);

/* Cells as they are: height and velocity of the last step in LSB; walls are 0. */
int32_t tp_pool_height(const tp_pool *pool, uint32_t col, uint32_t row);
int32_t tp_pool_velocity(const tp_pool *pool, uint32_t col, uint32_t row);
bool    tp_pool_wall(const tp_pool *pool, uint32_t col, uint32_t row);

typedef struct {
    int64_t  sum;           /* of all heights, LSB */
    int32_t  highest;       /* largest |height| and |velocity|, LSB */
    int32_t  fastest;
    bool     at_rest;
} tp_pool_state;
tp_pool_state tp_pool_look(const tp_pool *pool);

/* -- inside ------------------------------------------------------------------------------ */

/* Inside the pool: where things lie in its block, and what its files share.
 *
 * A walls byte of a cell says to which neighbours water can go, tiling included; a wall's
 * own byte has none of them.  Heights, velocities and fluxes of walls are always 0. */

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
