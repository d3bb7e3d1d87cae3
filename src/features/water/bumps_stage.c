/* SPDX-License-Identifier: MIT */
/* Bump mapping of pools: adds the pools' slopes at the rest position of every sample.
 * The mesh stays flat.
 *
 * Slopes of heights over one plane add up, so no tangent frame is needed.  A slope map
 * with one entry per cell is made at the start of the frame and read bilinearly, with the
 * same result as tp_pool_height_slope.  The map costs 114 instructions per sample on
 * x86-64 and some 60 per cell; a call of tp_pool_height_slope costs 500.  The map also
 * lets the world move on while tiles are drawn.
 *
 * The waves of a pool are a few cells long.  At two cells per pixel they begin to fade;
 * at four cells per pixel they are gone. */
#include "features/water/bumps.h"
#include "shade/sampler.h"

tp_pool_bump tp_pool_bump_make(const tp_pool *pool, const tp_pool_slope *slope)
{
    const bool tiled = pool->edges == TP_EDGES_TILE;

    return (tp_pool_bump){
        .slope = slope, .cols = pool->cols, .rows = pool->rows,
        .x = pool->x, .z = pool->z,
        .turns_x = pool->turns_x >> 16, .turns_z = pool->turns_z >> 16,
        .side_x = tiled ? 0 : (uint32_t)pool->cell * pool->cols,
        .side_z = tiled ? 0 : (uint32_t)pool->cell * pool->rows,
    };
}

/* Returns the bilinear mean of four values, |a| < 2^14: a sum has 30 bits. */
TP_ALWAYS_INLINE int32_t bilinear_mean(int32_t a, int32_t b, int32_t c, int32_t d,
                                       int32_t fs, int32_t ft)
{
    int32_t above = a * 256 + (b - a) * fs, below = c * 256 + (d - c) * fs;
    return (above * 256 + (below - above) * ft + 0x8000) >> 16;
}

/* Returns a place in turns of the field, Q0.32, from its corner; whole turns wrap away. */
TP_ALWAYS_INLINE uint32_t place_in_turns(uint32_t from_middle, uint64_t turns)
{
    uint64_t way = (uint64_t)(int64_t)(int32_t)from_middle * turns;
    return (uint32_t)(way >> 16) + 0x80000000u;
}

TP_ALWAYS_INLINE bool is_within_side(uint32_t from_middle, uint32_t side)
{
    return side == 0 || from_middle + side / 2 < side;
}

/* Returns the weight 0..256 of the slopes, for a block of 16 columns. */
static int32_t bump_share(const tp_shade *shade, const tp_pool_bump *pool, uint32_t key)
{
    int32_t depth = tp_log_depth(shade, key);
    int32_t level = pool->lod + depth + (depth > 0 ? depth / 2 : 0);

    return tp_clamp(512 - level, 0, 256);
}

TP_ALWAYS_INLINE void add_bump_slopes(const tp_pool_bump *pool, tp_run *run, int32_t i,
                                      int32_t share)
{
    uint32_t x = run->s[i] - (uint32_t)pool->x, z = run->t[i] - (uint32_t)pool->z;

    if (!is_within_side(x, pool->side_x) || !is_within_side(z, pool->side_z))
        return;
    uint64_t su = (uint64_t)place_in_turns(x, pool->turns_x) * pool->cols - 0x80000000u;
    uint64_t tv = (uint64_t)place_in_turns(z, pool->turns_z) * pool->rows - 0x80000000u;
    uint32_t u = (uint32_t)(su >> 32) + 1, v = (uint32_t)(tv >> 32) + 1;
    int32_t  fs = (int32_t)((uint32_t)su >> 24), ft = (int32_t)((uint32_t)tv >> 24);
    const tp_pool_slope *a = pool->slope + (size_t)v * (pool->cols + 2) + u;
    const tp_pool_slope *c = a + pool->cols + 2;
    int32_t  sx = bilinear_mean(a[0].x, a[1].x, c[0].x, c[1].x, fs, ft);
    int32_t  sz = bilinear_mean(a[0].z, a[1].z, c[0].z, c[1].z, fs, ft);

    run->sx[i] = (int16_t)tp_clamp(run->sx[i] + (sx * share >> 8), -32000, 32000);
    run->sz[i] = (int16_t)tp_clamp(run->sz[i] + (sz * share >> 8), -32000, 32000);
}

static void bump_run(const tp_shade *shade, const tp_pool_bump *pool, tp_run *run)
{
    TP_ASSERT(pool->slope != NULL && pool->cols > 0 && pool->rows > 0);
    const tp_pool_bump own = *pool;

    for (int32_t i = 0; i < run->count; ) {
        int32_t share = bump_share(shade, &own, run->key[i]), stop = tp_block_end(run, i);
        if (share == 0) {
            i = stop;
            continue;
        }
        for (; i < stop; i++)
            add_bump_slopes(&own, run, i, share);
    }
}

void tp_stage_pool_bump(const tp_shade *shade, tp_run *run)
{
    const tp_pool_bumps *bumps = run->mine;

    tp_stage_slopes(shade, run);
    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        if (bumps->pool[k].slope)
            bump_run(shade, &bumps->pool[k], run);
    }
}

const tp_stage tp_bumps_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_bumps(X)
#undef X
};
