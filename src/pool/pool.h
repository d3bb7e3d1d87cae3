/* SPDX-License-Identifier: MIT */
/* The pool: water as a damped cellular automaton on a grid, [C1]-[C18] of the models.
 *
 * Three kinds of cell share one interface.  A cell of 8 or 16 bits stores height and
 * velocity.  Its steps use two rounding modes, called gears: gear A lets ripples travel
 * far, gear B brings the water to exact rest.  A cell of 32 bits stores its height and two
 * fluxes through its edges: no volume is lost at any step.  All three kinds are bounded,
 * come to exact rest and do not drift.
 *
 * A pool is one block without pointers: a copy of its bytes is a snapshot. */
#ifndef TP_POOL_POOL_H
#define TP_POOL_POOL_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "fixed/arithmetic.h"
#include "tidepool/assets.h"
#include "tidepool/scene.h"

typedef struct {
    uint32_t cols, rows;    /* cells along x and z, 16..512 */
    tp_cells cells;
    tp_edges edges;
    tp_fx    courant;       /* Courant number r = wave speed x tick / cell, 0.05 to 0.49;
                             * the exact bound depends on the damping, see tp_pool_check */
    uint32_t damping;       /* m, 4..10: 2^-m of the motion is lost each tick */
    uint32_t interval;      /* n, 0..2: the cells step in every 2^n-th tick, for 2^n ticks */
    uint32_t sponge;        /* width in cells, 4..64; for TP_EDGES_SPONGE */
    tp_fx    range;         /* height at the full range of 8- and 16-bit cells, m, 0.01..64;
                             * 32-bit cells are Q8.24 metres and ignore `range` */
    tp_fx    cell;          /* side of a cell, m, 0.01..50 */
    tp_fx    x, z;          /* centre of the field, m */
    tp_fx    drive_min, drive_max;   /* band of the rms height, m; splashes keep the rms
                                     * inside [C16]; 0, 0: no splashes */
    tp_fx    drive_amplitude;          /* height of an injected splash, m */
    const tp_grey *mask;    /* stretched over all cells: darker than half is wall; or
                             * NULL */
} tp_pool_config;

/* Private: read by the functions below.  The cells follow this head.  Cells of 8 or 16
 * bits are pairs of height and velocity.  Cells of 32 bits are all heights, then all
 * fluxes to the right, then all fluxes down.  Walls, sponge and scratch rows follow where
 * the config needs them. */
typedef struct {
    uint32_t cols, rows;
    uint32_t cells, edges;          /* tp_cells, tp_edges */
    uint32_t courant_sq_q10;        /* 1024 r^2 of a step, rounded */
    uint32_t damping;               /* damping exponent m of a step */
    tp_fx    range, cell, x, z;
    uint64_t turns_x, turns_z;      /* 2^64 / (cells x cell): the field is one turn */
    int32_t  unit_q, unit_shift;    /* fine height (subcell.c) to metres, 16.16: factor */
    int32_t  slope_q, slope_shift;  /* factor from a difference over two cells to a slope */
    tp_fx    drive_min, drive_max, drive_amplitude;
    int32_t  drive_peak;            /* height of an injection, LSB, adapted by [C16] */
    uint32_t drive_ticks, drive_hits; /* of the current window: steps, steps with an
                                     * injection */
    uint32_t random;                /* state of the drive's random sequence */
    uint32_t injections;            /* number of injections since init */
    uint32_t gear;                  /* steps left in gear A; 0: gear B [C11] */
    uint32_t at_rest;               /* true: all is still until the next injection */
    uint32_t no_flux;               /* 32 bits: no flux in the last step */
    uint32_t walls, sponge, scratch, first;    /* byte offsets from the head; 0: none */
    uint32_t interval;              /* of the config */
    uint64_t tick;
} tp_pool;

/* Checks a config.  On failure err describes the fault, and err->word is the name of the
 * field.  r^2 beyond the bound of [C9], (1 - 1/(2 - delta)) / 2 with delta = 2^-damping, is
 * refused: the water would not come to rest, and little beyond would become unstable.
 *
 * A step in 2^n ticks has a time step 2^n times as long: r and delta of the step are 2^n
 * times those of a tick, so waves keep their speed and their decay per second.  Both bounds
 * hold for the step: damping - n is 4 or more, where 2^n 2^-damping is within 2.4 % of what
 * 2^n ticks lose. */
tp_status tp_pool_check(const tp_pool_config *config, tp_error *err);

/* Returns the rounding noise of 8- and 16-bit cells in moving water [C8]: the rms of the
 * heights in LSB, 16.16,
 *     sqrt(2^damping / 24) / courant.
 * At this level the rounding errors feed waves as fast as the damping drains waves.
 * Measured noise is 0.7 to 0.95 of the formula for courant from 0.3 on.  It is up to 3
 * times the formula for a small courant with strong damping, where rounding errors do not
 * average out.  With 8 bits the noise is below 16 LSB, an eighth of the range, for courant
 * above 0.0128 2^(damping / 2): 0.05 at damping 4, 0.41 at 10.  With a smaller courant
 * waves drown in the noise.  All other properties still hold: nothing leaves the range, and
 * the water comes to rest.
 *
 * A single wave may also repeat its roundings.  It then stops swinging when its height has
 * fallen to 1 / (2 courant^2 k) LSB, k in radians per cell [C14].  In total a wave of
 * initial height A has an rms error of at most
 *     1 + 8 x that noise + the lesser of 2 A and 1 / (courant^2 k)  LSB
 * in its first 400 ticks, and of twice as much in a corner, where the wave meets its mirror
 * images: of 150,000 random waves the worst had 0.88 of the bound.  After 400 ticks the
 * formula is no bound.  Over 6000 ticks of gear A two of 48,000 random waves of 8 bits
 * exceeded the formula, the worst by 1.5 times.  Of 17,000 waves of 16 bits with a courant
 * up to 0.31 one in 140 exceeded the formula, the worst by 4.0 times, an error of 2.3 % of
 * the range. */
tp_fx tp_pool_rounding_noise(tp_fx courant, uint32_t damping);

/* Returns the size of the block in bytes; the block must be aligned to 8.  Returns 0 if the
 * config is not valid. */
size_t tp_pool_bytes(const tp_pool_config *config);

/* Makes still water in a block of tp_pool_bytes() bytes.  Errors: as tp_pool_check, and
 * TP_E_NULL or TP_E_ALIGN for the block.  `mask` is read now and not kept. */
tp_status tp_pool_init(tp_pool *pool, const tp_pool_config *config, tp_error *err);

/* Applies the fields of a config that may change while the water moves: courant, damping,
 * sponge width, position and drive.  Returns false and changes nothing if the config is not
 * valid or describes another block. */
bool tp_pool_set_config(tp_pool *pool, const tp_pool_config *config);

/* True if the cells step in the next tick. */
static inline bool tp_pool_is_due(const tp_pool *pool)
{
    return (pool->tick & ((1u << pool->interval) - 1)) == 0;
}

/* Returns the fraction of a step, 0..1, from `lag` of a tick in the past to the last step.
 * The surface between two steps is shown while the ticks of the later step pass, so it never
 * jumps: the picture lags behind the cells by the ticks that a step has beyond the first. */
static inline tp_fx tp_pool_step_lag(const tp_pool *pool, tp_fx lag)
{
    const uint32_t left = (0u - (uint32_t)pool->tick) & ((1u << pool->interval) - 1);
    return ((tp_fx)left * TP_FX_ONE + lag) >> pool->interval;
}

/* Computes one tick: a step of the cells if it is due.  Accepts a courant_sq_q10 beyond the
 * bound, set by hand: charts show the result. */
void tp_pool_step(tp_pool *pool);

/* Returns height and slopes at a point (x, z) of the world, by bilinear interpolation
 * between cell centres; 0 inside walls, and outside of a field that is not tiled.
 * `lag`, 0..1 (16.16), is the fraction of a tick to look into the past.  The slope of
 * a cell is the central difference of its two neighbours [A6]; slopes are continuous
 * too.  Walls mirror. */
tp_height_slope tp_pool_height_slope(const tp_pool *pool, tp_fx x, tp_fx z, tp_fx lag);

/* -- kinds of pools, so that a program links no others ------------------------------- */

/* The 4 x 4 cells around a point, without the four corner cells: their columns and rows. */
typedef struct {
    uint32_t col[4], row[4], own_col, own_row;  /* own: the cell of the point */
    uint32_t s, t;              /* fraction from col[1], row[1] on, 1/65536 */
    tp_fx    lag;               /* fraction of a step into the past */
} tp_pool_patch;

/* The fine heights of the cells of a patch, [row][column]. */
typedef struct { int32_t h[4][4]; } tp_pool_heights;

typedef void tp_pool_gatherer(const tp_pool *restrict pool, const tp_pool_patch *restrict p,
                              tp_pool_heights *restrict to);
typedef void tp_pool_drive(tp_pool *pool);

/* A kind of pool, by cells and edges: one step of all cells; the heights of a patch of a
 * pool without walls, of the last step and p->lag earlier; of a pool with walls.  NULL: the
 * kind has no such pools. */
typedef struct {
    void (*step)(tp_pool *pool);
    tp_pool_gatherer *now, *back, *walled;
} tp_pool_kind;

#define TP_POOL_KINDS(X) \
    X(8) X(8_walls) X(8_sponge) X(16) X(16_walls) X(16_sponge) X(32)

#define X(name) extern const tp_pool_kind tp_pool_##name;
TP_POOL_KINDS(X)
#undef X

enum {
#define X(name) TP_POOL_KIND_##name,
    TP_POOL_KINDS(X)
#undef X
};

/* Returns a kind's place in the list.  A sponge has walls too. */
static inline uint32_t tp_pool_kind_number(tp_cells cells, bool walls, bool sponge)
{
    const uint32_t open = cells == TP_CELLS_16 ? TP_POOL_KIND_16 : TP_POOL_KIND_8;

    return cells == TP_CELLS_32 ? (uint32_t)TP_POOL_KIND_32
                                : open + (sponge ? 2 : walls ? 1 : 0);
}

const tp_pool_kind *tp_pool_find_kind(const tp_pool *pool);

/* tp_pool_step and tp_pool_height_slope, by the pool's kind. */
void tp_pool_step_kind(tp_pool *pool, const tp_pool_kind *kind, tp_pool_drive *drive);
tp_height_slope tp_pool_sample(const tp_pool *pool, const tp_pool_kind *kind, tp_fx x,
                               tp_fx z, tp_fx lag);

/* Injects a splash before a step if the water is too quiet [C16]. */
tp_pool_drive tp_pool_splash_if_quiet;

/* -- splashes, cells ----------------------------------------------------------------- */

/* Makes a splash of zero sum [C11] [D5]: `height` m in the middle, width sigma m (at least
 * 1.5 cells).  A part inside walls or outside of the field is left out, and the rest is
 * balanced to sum 0 again.  Returns false if the middle lies outside or in a wall. */
bool tp_pool_add_splash(tp_pool *pool, tp_fx x, tp_fx z, tp_fx sigma, tp_fx height);

/* Finds the cell that contains a point.  Returns false if the point is outside of the pool
 * or in a wall. */
bool tp_pool_open_cell_at_point(const tp_pool *pool, tp_fx x, tp_fx z, uint32_t *col,
                                uint32_t *row);

/* tp_pool_add_cell_height adds to the height of one cell, in LSB of the cell, and
 * returns the part that fitted.  The caller keeps the sum of all additions at zero,
 * then calls tp_pool_start_carry_rounding with the highest addition. */
int32_t tp_pool_add_cell_height(tp_pool *pool, uint32_t col, uint32_t row, int32_t lsb);
void    tp_pool_start_carry_rounding(tp_pool *pool, int32_t peak_lsb);
int32_t tp_pool_from_metres(const tp_pool *pool, tp_fx metres);     /* rounded to nearest */

/* Returns a bound of |height| of the water, m. */
tp_fx tp_pool_height_bound(const tp_pool *pool);

/* Stored state of a cell in LSB: height, and its change in the last step; 0 in walls. */
int32_t tp_pool_height_lsb(const tp_pool *pool, uint32_t col, uint32_t row);
int32_t tp_pool_velocity(const tp_pool *pool, uint32_t col, uint32_t row);
bool    tp_pool_is_wall_or_outside(const tp_pool *pool, uint32_t col, uint32_t row);

typedef struct {
    int64_t  sum;           /* sum of all heights, LSB */
    int32_t  highest;       /* highest, fastest: largest |height| and |velocity|, LSB */
    int32_t  fastest;
    bool     at_rest;
} tp_pool_state;
tp_pool_state tp_pool_stats(const tp_pool *pool);

/* Slopes dy/dx and dy/dz, Q3.12, clamped to +-4. */
typedef struct { int16_t x, z; } tp_pool_slope;

/* Writes the slopes at all cell centres times `gain`, at `lag` of a tick in the past.
 * A border of one cell all round is wrapped or mirrored: the table has (rows + 2) x
 * (cols + 2) entries, and bilinear sampling needs no special case at the edges.
 * Sampled slopes equal the slopes of tp_pool_height_slope, except inside walls: there
 * the sampled slopes fade out over one cell. */
void tp_pool_slopes(const tp_pool *pool, tp_fx lag, tp_fx gain, tp_pool_slope *to);

/* True if a pool from outside of the program is safe to step and read.  All fields derived
 * from the config must equal the fields of `fresh`, a pool of the same config.  Cells and
 * fluxes must be in the ranges kept by steps, and walls must be still. */
bool tp_pool_is_valid(const tp_pool *pool, const tp_pool *fresh);

/* -- private to src/pool ------------------------------------------------------------- */

/* Layout of the block, and functions shared by the files of the pool.
 *
 * The walls byte of a cell has a bit for each open neighbour, also across the edge of a
 * tiled field.  The byte of a wall cell has none of these bits.  Heights, velocities and
 * fluxes of walls are always 0. */

enum { TP_OPEN_LEFT = 1, TP_OPEN_RIGHT = 2, TP_OPEN_UP = 4, TP_OPEN_DOWN = 8,
       TP_WALL = 16 };

/* Cells of 8 and 16 bits: height h and velocity v. */
typedef struct { int8_t h, v; } tp_pool_pair_8;
typedef struct { int16_t h, v; } tp_pool_pair_16;

/* Largest |height| in LSB.  For 32 bits it is 64 m: differences of two heights, and all
 * other numbers of a step, fit 32 bits. */
enum { TP_FULL_8 = 127, TP_FULL_16 = 32767, TP_FULL_32 = (1 << 30) - 1 };

/* Length of the window in which the drive counts its injections, ticks [C16]. */
enum { TP_DRIVE_WINDOW = 64 };

static inline uint32_t tp_pool_drive_window_steps(const tp_pool *pool)
{
    return (uint32_t)TP_DRIVE_WINDOW >> pool->interval;
}

/* Largest r2q of a step (r = 0.865): no product of a step overflows. */
enum { TP_COURANT_SQ_MAX_Q10 = 767 };

static inline int32_t tp_pool_max_lsb(const tp_pool *pool)
{
    return pool->cells == TP_CELLS_8 ? TP_FULL_8
         : pool->cells == TP_CELLS_16 ? TP_FULL_16 : TP_FULL_32;
}

static inline uint32_t tp_pool_count(const tp_pool *pool)
{
    return pool->cols * pool->rows;
}

/* Address at an offset in bytes from the head of the block. */
static inline void *tp_pool_pointer(tp_pool *pool, uint32_t offset)
{
    return (char *)pool + offset;
}

static inline const void *tp_pool_const_pointer(const tp_pool *pool, uint32_t offset)
{
    return (const char *)pool + offset;
}

static inline bool tp_pool_is_wall(const tp_pool *pool, uint32_t index)
{
    const uint8_t *walls = tp_pool_const_pointer(pool, pool->walls);
    return pool->walls != 0 && (walls[index] & TP_WALL) != 0;
}

/* Returns 1024 r^2 for r < 4. */
static inline uint32_t tp_pool_square_courant(tp_fx courant)
{
    return (uint32_t)(((uint64_t)courant * (uint64_t)courant * 1024 + (1u << 31)) >> 32);
}

static inline uint32_t tp_pool_clamped_courant_sq_q10(const tp_pool *pool)
{
    return pool->courant_sq_q10 < TP_COURANT_SQ_MAX_Q10 ? pool->courant_sq_q10
                                                        : TP_COURANT_SQ_MAX_Q10;
}

/* Returns x 2^n, for n >= 0 and results in range. */
static inline int32_t tp_pool_shift_left(int32_t x, uint32_t n)
{
    return (int32_t)((uint32_t)x << n);
}

/* Layout of the block of a config: offsets of the parts, and `bytes`, the total size. */
typedef struct { uint32_t walls, sponge, scratch, first, bytes; } tp_pool_layout;

/* Returns the stored height of a cell inside the field. */
int32_t tp_pool_cell_height(const tp_pool *pool, uint32_t index);

/* For 32-bit cells: returns the inflow of a cell in the last step less its outflow.  Fluxes
 * through walls are 0, and so are fluxes across the edge of a field that is not tiled: the
 * neighbour index may wrap.  H and the height before the step are within 2^30; the sum fits
 * 32 bits (see flux.c). */
static inline int32_t tp_pool_net_inflow(const tp_pool *pool, uint32_t col, uint32_t row)
{
    const uint32_t cols = pool->cols, count = tp_pool_count(pool);
    const int32_t *const h = tp_pool_const_pointer(pool, sizeof *pool);
    const int32_t *const right = h + count, *const down = right + count;
    const uint32_t here = row * cols + col;
    const uint32_t left = col != 0 ? here - 1 : here + cols - 1;
    const uint32_t up = row != 0 ? here - cols : here + count - cols;

    return right[left] - right[here] + down[up] - down[here];
}

/* Converts a point to cells from the corner of the field, Q32.32.  Returns false
 * outside. */
bool tp_pool_locate(const tp_pool *pool, tp_fx x, tp_fx z, uint64_t *u, uint64_t *w);

tp_pool_gatherer tp_pool_gather_now_8, tp_pool_gather_back_8;
tp_pool_gatherer tp_pool_gather_now_16, tp_pool_gather_back_16;
tp_pool_gatherer tp_pool_gather_now_32, tp_pool_gather_back_32;
tp_pool_gatherer tp_pool_gather_walled;


#endif
