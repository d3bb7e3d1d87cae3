/* SPDX-License-Identifier: MIT */
/*
 * Span stages that change the water's normals and leave the mesh as it is: the slopes of
 * pools, then capillary waves.
 */
#include "features/water/water.h"
#include "shade/material.h"
#include "shade/slope.h"
#include "view/projection.h"

/* -- bump mapping of pools ----------------------------------------------------------- */

/* Adds the pools' slopes at the rest position of every sample.  The mesh stays flat.
 *
 * Slopes of heights over one plane add up, so no tangent frame is needed.  A slope map with
 * one entry per cell is made at the start of the frame and read bilinearly, with the same
 * result as tp_pool_height_slope.  The map costs 114 instructions per sample on x86-64 and
 * some 60 per cell; a call of tp_pool_height_slope costs 500.  The map also lets the world
 * move on while tiles are drawn.
 *
 * The waves of a pool are a few cells long.  At two cells per pixel they begin to fade;
 * at four cells per pixel they are gone. */

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
TP_ALWAYS_INLINE int32_t interpolate_bilinear(int32_t a, int32_t b, int32_t c, int32_t d,
                                              int32_t fs, int32_t ft)
{
    int32_t above = a * 256 + (b - a) * fs, below = c * 256 + (d - c) * fs;
    return (above * 256 + (below - above) * ft + 0x8000) >> 16;
}

/* Converts a distance from the middle of the pool, m, to a distance from the corner, in
 * turns (a turn is the pool's side), Q0.32; whole turns wrap away. */
TP_ALWAYS_INLINE uint32_t pool_corner_distance_in_turns(uint32_t from_pool_middle,
                                                        uint64_t turns_per_metre)
{
    uint64_t way = (uint64_t)(int64_t)(int32_t)from_pool_middle * turns_per_metre;
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
    uint64_t su = (uint64_t)pool_corner_distance_in_turns(x, pool->turns_x) * pool->cols
                  - 0x80000000u;
    uint64_t tv = (uint64_t)pool_corner_distance_in_turns(z, pool->turns_z) * pool->rows
                  - 0x80000000u;
    uint32_t u = (uint32_t)(su >> 32) + 1, v = (uint32_t)(tv >> 32) + 1;
    int32_t  fs = (int32_t)((uint32_t)su >> 24), ft = (int32_t)((uint32_t)tv >> 24);
    const tp_pool_slope *a = pool->slope + (size_t)v * (pool->cols + 2) + u;
    const tp_pool_slope *c = a + pool->cols + 2;
    int32_t  sx = interpolate_bilinear(a[0].x, a[1].x, c[0].x, c[1].x, fs, ft);
    int32_t  sz = interpolate_bilinear(a[0].z, a[1].z, c[0].z, c[1].z, fs, ft);

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

/* -- capillary waves ----------------------------------------------------------------- */

/* A normal map in the surface's tangent space [F6].
 *
 * A texel m = (nx, ny, nz), green up the picture, is nx T - ny B + nz N.  For slopes sx
 * and sz, T is along (1, sx, 0), N along (-sx, 1, -sz), and B = T x N is (0, sz, 1) made
 * orthogonal to T.  With a = sqrt(1 + sx^2) and w = sqrt(1 + sx^2 + sz^2), the vector
 * times a w is
 *     U = a nz - sz ny,   M = w nx,   Z = a ny + sz nz,
 *     x = M - sx U,   y = U + sx M,   z = -a Z,
 * and the new slopes are -x / y and -z / y.  y is at least 1/8, so no ripple turns the
 * water upside down.  A filtered normal is shorter than 1; only its direction matters.
 *
 * On a gentle surface the map's slopes are added to the surface's, with 2 - nz in place
 * of 1 / nz: 141 instructions per sample on x86-64 instead of 230.
 * tests/unit/test_features_water_ripple.c compares both with the exact matrix in double;
 * rms of the normals in 1/255:
 *     surface's slope up to   0    .25   .5    1      (ripple's up to .35; at 1 to .7)
 *     turned                 .2    .2    .2    .3
 *     added                  .2    .8   3.6    18 */

#define UP_LEAST 512    /* lower bound of nz and of y, Q12 */

/* Components in Q12; nx and ny times the gain. */
typedef struct {
    int32_t nx, ny, nz;
} bump;

/* Mixes two 16-bit values by ft / 256 and subtracts 128; Q16. */
TP_ALWAYS_INLINE int32_t signed_mix(uint32_t above, uint32_t below, uint32_t ft)
{
    return ((int32_t)(above * (256 - ft) + below * ft) - (128 << 16)) >> 8;
}

/* Returns the filtered normal.  The first mixes fill halves of a word, the second mixes
 * have 24 bits: with 8 bits a ripple near the eye would have steps of half a degree. */
TP_ALWAYS_INLINE bump filter_bump(const tp_four *f, int32_t gain)
{
    const uint32_t fs = f->fs, gs = 256 - fs;
    uint32_t rb = tp_even_bytes(f->texel[0]) * gs + tp_even_bytes(f->texel[1]) * fs;
    uint32_t rb_below = tp_even_bytes(f->texel[2]) * gs + tp_even_bytes(f->texel[3]) * fs;
    uint32_t g = (f->texel[0] >> 8 & 0xff) * gs + (f->texel[1] >> 8 & 0xff) * fs;
    uint32_t g_below = (f->texel[2] >> 8 & 0xff) * gs + (f->texel[3] >> 8 & 0xff) * fs;
    int32_t  up = signed_mix(rb & 0xffff, rb_below & 0xffff, f->ft) >> 3;

    return (bump){
        .nx = signed_mix(rb >> 16, rb_below >> 16, f->ft) * gain >> 11,
        .ny = signed_mix(g, g_below, f->ft) * gain >> 11,
        .nz = up < UP_LEAST ? UP_LEAST : up,
    };
}

/* Returns x y / 2^n; |x| < 2^17, n <= 13.  Products of steep slopes and ripples have 34
 * bits; with y split in two parts each product fits a word. */
TP_ALWAYS_INLINE int32_t multiply_shift(int32_t x, int32_t y, int n)
{
    if (TP_WIDE)
        return x * (y >> n) + (x * (y & ((1 << n) - 1)) >> n);
    return (int32_t)((int64_t)x * y >> n);
}

/* Returns sqrt(1 + q), Q13, from the table of the inverse root. */
TP_ALWAYS_INLINE int32_t sqrt_one_plus(uint32_t q)
{
    return (int32_t)((((1u << 24) + q) >> 10) * (uint32_t)tp_rsqrt_one_plus_nearest(q)
                     >> 15);
}

/* Clamps a slope to +-32000.  One test passes the usual case. */
TP_ALWAYS_INLINE int32_t clamp_slope(int32_t slope)
{
    if (!TP_WIDE && (uint32_t)slope + 32000 <= 64000)
        return slope;
    return tp_clamp(slope, -32000, 32000);
}

/* Returns n / y in Q12; n and y are below 2^21 and have the same scale. */
TP_ALWAYS_INLINE int32_t divide_slope(int32_t n, int32_t recip, int shift)
{
    return clamp_slope(tp_mul_upper(n * 1024, recip) >> (28 - shift));
}

/* Returns tp_clz of y in [2^9, 2^21), for vector units without such an instruction. */
TP_ALWAYS_INLINE int leading_zeros(uint32_t y)
{
    if (!TP_WIDE)
        return tp_clz(y);
    int n = 11;
    n += y << n >> 24 ? 0 : 8;
    n += y << n >> 28 ? 0 : 4;
    n += y << n >> 30 ? 0 : 2;
    return n + (y << n >> 31 ? 0 : 1);
}

/* Slopes along x and z. */
typedef struct {
    int32_t x, z;
} slopes;

/* Returns the slopes of the texel turned into the tangent space.  Slopes are below 8, nx
 * and ny within 4, so sums are below 2^21. */
TP_ALWAYS_INLINE slopes turn_bump_onto_slopes(int32_t surface_x, int32_t surface_z, bump m)
{
    uint32_t qx = (uint32_t)(surface_x * surface_x), qz = (uint32_t)(surface_z * surface_z);
    int32_t  a = sqrt_one_plus(qx), w = sqrt_one_plus(qx + qz);
    int32_t  up = (a * m.nz >> 13) - (surface_z * m.ny >> 12);
    int32_t  side = (a * m.ny >> 13) + (surface_z * m.nz >> 12);
    int32_t  along = w * (m.nx >> 1) >> 12;
    int32_t  y = up + multiply_shift(surface_x, along, 12);

    y = y < UP_LEAST ? UP_LEAST : y;
    int      shift = leading_zeros((uint32_t)y);
    int32_t  recip = tp_recip_rough((uint32_t)y << shift);
    return (slopes){ divide_slope(multiply_shift(surface_x, up, 12) - along, recip, shift),
                     divide_slope(multiply_shift(a, side, 13), recip, shift) };
}

/* Returns the sum of the slopes: -nx / nz along s and ny / nz along t, with 2 - nz for
 * 1 / nz. */
TP_ALWAYS_INLINE slopes add_slopes(int32_t sx, int32_t sz, bump m)
{
    sx -= m.nx * (2 * 4096 - m.nz) >> 12;
    sz += m.ny * (2 * 4096 - m.nz) >> 12;
    return (slopes){ clamp_slope(sx), clamp_slope(sz) };
}

enum { TURNED, OVER, GENTLE };

/* Bends the slopes of one stretch.  TURNED and GENTLE read the slopes n as sampled, x:z,
 * and write sx and sz.  OVER reads and writes sx and sz. */
TP_ALWAYS_INLINE void ripple_stretch(const tp_sampler *sampler, int32_t gain,
                                     const tp_stretch *over, const uint32_t *restrict n,
                                     int16_t *restrict sx, int16_t *restrict sz, int how)
{
    const tp_sampler p = *sampler;
    const uint32_t *restrict s = over->s, *restrict t = over->t;
    const int32_t count = over->count;

    for (int32_t i = 0; i < count; i++) {
        tp_four f = tp_sampler_four(&p, s[i], t[i]);
        bump    m = filter_bump(&f, gain);
        int32_t x = how == OVER ? sx[i] : (int32_t)n[i] >> 16;
        int32_t z = how == OVER ? sz[i] : (int16_t)(n[i] & 0xffff);
        slopes  to = how == GENTLE ? add_slopes(x, z, m) : turn_bump_onto_slopes(x, z, m);
        sx[i] = (int16_t)to.x;
        sz[i] = (int16_t)to.z;
    }
}

TP_ALWAYS_INLINE void ripple(const tp_shade *shade, tp_run *run, int how)
{
    const tp_ripple *own = run->mine;
    const tp_layer *layer = &own->layer;
    tp_stretch w;

    for (int32_t i = 0; i < run->count; i += w.count) {
        w = tp_stretch_find(shade, run, layer, run->s, run->t, i);
        const tp_sampler p = tp_sampler_linear(layer, w.level);
        ripple_stretch(&p, own->gain, &w, run->n + i, run->sx + i, run->sz + i, how);
    }
}

void tp_stage_ripple(const tp_shade *shade, tp_run *run)
{
    ripple(shade, run, TURNED);
}

void tp_stage_ripple_pool_slopes(const tp_shade *shade, tp_run *run)
{
    ripple(shade, run, OVER);
}

void tp_stage_ripple_gentle(const tp_shade *shade, tp_run *run)
{
    ripple(shade, run, GENTLE);
}

const tp_stage tp_ripple_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_ripple(X)
#undef X
};
