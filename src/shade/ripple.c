/* SPDX-License-Identifier: MIT */
/* Capillary waves: a normal map in the surface's tangent space [F6].
 *
 * A texel m = (nx, ny, nz), green up the picture, is nx T - ny B + nz N with, for slopes
 * sx and sz, T along (1, sx, 0), N along (-sx, 1, -sz) and B = T x N, which is (0, sz, 1)
 * made orthogonal to T.  With a = sqrt(1 + sx^2) and w = sqrt(1 + sx^2 + sz^2), and all
 * of it times a w, that is
 *     U = a nz - sz ny,   M = w nx,   Z = a ny + sz nz,
 *     x = M - sx U,   y = U + sx M,   z = -a Z,
 * and the new slopes are -x / y and -z / y.  y is held at 1/8: no ripple turns the water
 * upside down.  A mean of normals is short, but only its direction counts.
 *
 * Where the surface is gentle the map's slopes are added to its own, 1 / nz taken as
 * 2 - nz: 141 instructions a sample on x86-64 instead of 230.  Both are compared with the
 * exact matrix in double by tests/unit/test_shade_ripple.c; rms of the normals in 1/255:
 *     surface's slope up to   0    .25   .5    1      (ripple's up to .35; at 1 to .7)
 *     turned                 .2    .2    .2    .3
 *     added                  .2    .8   3.6    18 */
#include "geom/geom.h"
#include "shade/sampler.h"
#include "shade/slope.h"

#define UP_LEAST 512    /* of nz and of y, Q12 */

/* Components in Q12, nx and ny times the gain. */
typedef struct {
    int32_t nx, ny, nz;
} bump;

/* Q16 of two mixes of 16 bits, less 128. */
TP_ALWAYS_INLINE int32_t signed_mix(uint32_t above, uint32_t below, uint32_t ft)
{
    return ((int32_t)(above * (256 - ft) + below * ft) - (128 << 16)) >> 8;
}

/* The first mixes fill halves of a word, the second ones 24 bits: with 8 a ripple near
 * the eye would have steps of half a degree. */
TP_ALWAYS_INLINE bump bump_at(const tp_level *l, uint32_t s, uint32_t t, int32_t gain)
{
    tp_four  f = tp_four_around(l, s, t);
    uint32_t rb[2], g[2];

    for (int k = 0; k < 2; k++) {
        uint32_t left = f.texel[2 * k], right = f.texel[2 * k + 1];
        rb[k] = (left & 0xff00ff) * (256 - f.fs) + (right & 0xff00ff) * f.fs;
        g[k] = (left >> 8 & 0xff) * (256 - f.fs) + (right >> 8 & 0xff) * f.fs;
    }
    int32_t up = signed_mix(rb[0] & 0xffff, rb[1] & 0xffff, f.ft) >> 3;
    return (bump){
        .nx = signed_mix(rb[0] >> 16, rb[1] >> 16, f.ft) * gain >> 11,
        .ny = signed_mix(g[0], g[1], f.ft) * gain >> 11,
        .nz = up < UP_LEAST ? UP_LEAST : up,
    };
}

/* x y / 2^n: products of steep slopes and ripples have 33 bits. */
TP_ALWAYS_INLINE int32_t times(int32_t x, int32_t y, int n)
{
    return (int32_t)((int64_t)x * y >> n);
}

/* sqrt(1 + q), Q13, from the table of its inverse. */
TP_ALWAYS_INLINE int32_t root_of(const tp_shade *shade, uint32_t q)
{
    return (int32_t)((((1u << 24) + q) >> 10) * (uint32_t)tp_steep_near(shade, q) >> 15);
}

/* n / y in Q12, both below 2^21 and of one scale. */
TP_ALWAYS_INLINE int16_t slope_of(int32_t n, int32_t recip, int shift)
{
    return (int16_t)tp_clamp(tp_mul_upper(n * 1024, recip) >> (28 - shift), -32000,
                             32000);
}

/* Slopes are below 8, nx and ny within 4: sums are below 2^21. */
TP_ALWAYS_INLINE void turn(const tp_shade *shade, tp_run *run, int32_t i, int32_t sx,
                           int32_t sz, bump m)
{
    uint32_t qx = (uint32_t)(sx * sx), qz = (uint32_t)(sz * sz);
    int32_t  a = root_of(shade, qx), w = root_of(shade, qx + qz);
    int32_t  up = (a * m.nz >> 13) - (sz * m.ny >> 12);
    int32_t  side = (a * m.ny >> 13) + (sz * m.nz >> 12);
    int32_t  along = w * (m.nx >> 1) >> 12;
    int32_t  y = up + times(sx, along, 12);

    y = y < UP_LEAST ? UP_LEAST : y;
    int      shift = tp_clz((uint32_t)y);
    int32_t  recip = tp_recip_rough((uint32_t)y << shift);
    run->sx[i] = slope_of(times(sx, up, 12) - along, recip, shift);
    run->sz[i] = slope_of(times(a, side, 13), recip, shift);
}

TP_ALWAYS_INLINE void ripple(const tp_shade *shade, tp_run *run, int over)
{
    const tp_layer *layer = &shade->ripple;

    for (int32_t i = 0; i < run->count; ) {
        tp_level l = tp_level_for(shade, layer, run->key[i]);
        int32_t  stop = tp_block_end(run, i);
        for (; i < stop; i++) {
            uint32_t s = run->s[i] * layer->per_metre + layer->drift_s;
            uint32_t t = run->t[i] * layer->per_metre + layer->drift_t;
            int32_t  sx = tp_slope_x(run, i, over), sz = tp_slope_z(run, i, over);
            turn(shade, run, i, sx, sz, bump_at(&l, s, t, layer->slope_gain));
        }
    }
}

void tp_stage_ripple(const tp_shade *shade, tp_run *run)
{
    ripple(shade, run, 0);
}

void tp_stage_ripple_over(const tp_shade *shade, tp_run *run)
{
    ripple(shade, run, 1);
}

/* Slopes of -nx / nz along s and ny / nz along t; 1 / nz is taken as 2 - nz. */
void tp_stage_ripple_gentle(const tp_shade *shade, tp_run *run)
{
    const tp_layer *layer = &shade->ripple;

    for (int32_t i = 0; i < run->count; ) {
        tp_level l = tp_level_for(shade, layer, run->key[i]);
        int32_t  stop = tp_block_end(run, i);
        for (; i < stop; i++) {
            uint32_t s = run->s[i] * layer->per_metre + layer->drift_s;
            uint32_t t = run->t[i] * layer->per_metre + layer->drift_t;
            bump     m = bump_at(&l, s, t, layer->slope_gain);
            int32_t  sx = tp_slope_x(run, i, 0), sz = tp_slope_z(run, i, 0);
            sx -= m.nx * (2 * 4096 - m.nz) >> 12;
            sz += m.ny * (2 * 4096 - m.nz) >> 12;
            run->sx[i] = (int16_t)tp_clamp(sx, -32000, 32000);
            run->sz[i] = (int16_t)tp_clamp(sz, -32000, 32000);
        }
    }
}
