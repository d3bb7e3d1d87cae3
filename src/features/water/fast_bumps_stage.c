/* SPDX-License-Identifier: MIT */
/*
 * Fast form of the pools' slopes on flat water: added to the packed slopes of a run.
 *
 * Slopes are read in every second column of a block of 16 columns and in the last one; the
 * columns between take the mean.  The four weights of a cell's neighbours include the fade
 * with distance, so each slope takes four products.  From one cell a pixel on the nearest
 * entry is read.
 */
#include "features/water/water.h"
#include "shade/slope.h"

#define SAMPLES 9               /* of a block of 16 columns */

/* A pool's slopes as a block of columns reads them. */
typedef struct {
    const tp_pool_slope *slope;
    uint32_t cols, rows, stride;        /* stride: entries of a row, borders included */
    uint32_t x, z;                      /* middle, m, 16.16 */
    uint64_t turns_x, turns_z;          /* sides a metre, Q48 over Q16.16 */
    uint32_t side_x, side_z;            /* m, 16.16; 0: tiled */
    int32_t  share;                     /* weight of the slopes, 0..256 */
} pool_block;

static pool_block pool_block_make(const tp_pool_bump *pool, int32_t level)
{
    return (pool_block){
        pool->slope, pool->cols, pool->rows, pool->cols + 2,
        (uint32_t)pool->x, (uint32_t)pool->z, pool->turns_x, pool->turns_z,
        pool->side_x, pool->side_z, tp_clamp(512 - level, 0, 256),
    };
}

/* Returns the level of the pool's cells at the depth of a sample, Q8; 0: a cell a pixel. */
static int32_t cell_level(const tp_shade *shade, const tp_pool_bump *pool, uint32_t key)
{
    const int32_t depth = tp_log_depth(shade, key);
    return pool->lod + depth + (depth > 0 ? depth / 2 : 0);
}

/* Returns slopes x:z at a place, shares of the sides.  Entries are below 2^14 and the
 * weights' sum is 2^16: a sum of products fits 31 bits. */
TP_ALWAYS_INLINE uint32_t bilinear_slopes(const pool_block *p, uint32_t x, uint32_t z)
{
    const uint64_t su = (uint64_t)x * p->cols + 0x80000000u;
    const uint64_t tv = (uint64_t)z * p->rows + 0x80000000u;
    const uint32_t u = (uint32_t)(su >> 32), v = (uint32_t)(tv >> 32);
    const int32_t fs = (int32_t)((uint32_t)su >> 24), ft = (int32_t)((uint32_t)tv >> 24);
    const int32_t low = ft * p->share >> 8, high = p->share - low;
    const int32_t b = high * fs, a = high * 256 - b, d = low * fs, c = low * 256 - d;
    const tp_pool_slope *over = p->slope + (v * p->stride + u);
    const tp_pool_slope *under = over + p->stride;

    return tp_pair16(
        (over[0].x * a + over[1].x * b + under[0].x * c + under[1].x * d) >> 16,
        (over[0].z * a + over[1].z * b + under[0].z * c + under[1].z * d) >> 16);
}

TP_ALWAYS_INLINE uint32_t nearest_slopes(const pool_block *p, uint32_t x, uint32_t z)
{
    const uint32_t u = (uint32_t)((uint64_t)x * p->cols >> 32);
    const uint32_t v = (uint32_t)((uint64_t)z * p->rows >> 32);
    const tp_pool_slope *at = p->slope + ((v + 1) * p->stride + u + 1);

    return tp_pair16(at->x * p->share >> 8, at->z * p->share >> 8);
}

/* Returns the place along a side, Q0.32 of it, of a point at a distance from its middle. */
TP_ALWAYS_INLINE uint32_t place_on_side(uint32_t from_middle, uint64_t turns)
{
    return (uint32_t)((uint64_t)(int64_t)(int32_t)from_middle * turns >> 16) + 0x80000000u;
}

TP_ALWAYS_INLINE bool is_within_side(uint32_t from_middle, uint32_t side)
{
    return from_middle + side / 2 < side;
}

/* Returns the slopes at a rest position; 0 outside of a pool with sides. */
TP_ALWAYS_INLINE uint32_t sample_slopes(const pool_block *p, uint32_t s, uint32_t t,
                                        int tiled, int nearest)
{
    const uint32_t x = s - p->x, z = t - p->z;

    if (!tiled && !(is_within_side(x, p->side_x) && is_within_side(z, p->side_z)))
        return 0;
    const uint32_t u = place_on_side(x, p->turns_x), v = place_on_side(z, p->turns_z);
    return nearest ? nearest_slopes(p, u, v) : bilinear_slopes(p, u, v);
}

/* Adds samples and their means to the slopes of `count` columns. */
static void add_samples(const uint32_t *restrict sample, uint32_t *restrict slope,
                        int32_t count)
{
    uint32_t here = sample[0];
    int32_t k = 0;

    for (; k + 2 < count; k += 2) {
        const uint32_t next = sample[(k >> 1) + 1];
        slope[k] = tp_qadd16(slope[k], here);
        slope[k + 1] = tp_qadd16(slope[k + 1], tp_shadd16(here, next));
        here = next;
    }
    slope[k] = tp_qadd16(slope[k], here);
    if (k + 1 < count)
        slope[k + 1] = tp_qadd16(slope[k + 1], sample[(k >> 1) + 1]);
}

TP_ALWAYS_INLINE void add_block_slopes(const pool_block *pool, tp_run *run, int32_t i,
                                       int32_t count, int tiled, int nearest)
{
    const uint32_t *s = run->s + i, *t = run->t + i;
    const int32_t last = count / 2;
    uint32_t sample[SAMPLES];

    for (int32_t j = 0; j < last; j++)
        sample[j] = sample_slopes(pool, s[2 * j], t[2 * j], tiled, nearest);
    sample[last] = sample_slopes(pool, s[count - 1], t[count - 1], tiled, nearest);
    add_samples(sample, run->slope + i, count);
}

static void add_pool_slopes(const tp_shade *shade, const tp_pool_bump *pool, tp_run *run)
{
    TP_ASSERT(pool->slope != NULL && pool->cols > 0 && pool->rows > 0);

    for (int32_t i = 0, stop; i < run->count; i = stop) {
        const int32_t level = cell_level(shade, pool, run->key[i]);
        const pool_block block = pool_block_make(pool, level);
        const bool tiled = block.side_x == 0;
        stop = tp_block_end(run, i);
        if (block.share == 0)
            continue;
        if (level < 0 && tiled)
            add_block_slopes(&block, run, i, stop - i, 1, 0);
        else if (level < 0)
            add_block_slopes(&block, run, i, stop - i, 0, 0);
        else
            add_block_slopes(&block, run, i, stop - i, tiled, 1);
    }
}

void tp_stage_quick_pool_bump(const tp_shade *shade, tp_run *run)
{
    const tp_pool_bumps *bumps = run->mine;

    for (int k = 0; k < TP_POOL_BUMPS; k++)
        if (bumps->pool[k].slope)
            add_pool_slopes(shade, &bumps->pool[k], run);
}
