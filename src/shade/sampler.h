/* SPDX-License-Identifier: MIT */
/* Texels of a repeating picture.  The level of detail is chosen once for every 16
 * columns, from the first sample there.  Nearest takes one texel; linear weighs four by
 * 1/256 of a texel.
 *
 * One level is enough: of a still sea's linear texture, drifting 1 cm a frame and seen
 * from 3 m at 640 x 480, no row changes from frame to frame by more than 0.3 levels of
 * 255 beyond what it does if 16 samples a pixel are drawn, and levels show no edges.
 *
 * Sides are powers of two, so a texel's column is the highest bits of a place in repeats:
 * shifts of one word find it.  Indices are signed, as gathers of eight take them. */
#ifndef TP_SHADE_SAMPLER_H
#define TP_SHADE_SAMPLER_H
#include "base/dsp.h"
#include "shade/depth.h"

/* -- one level, and four texels of it ----------------------------------------------- */

typedef struct {
    const uint32_t *texel;
    uint32_t half_s, half_t;    /* of a texel, Q0.32 repeats */
    uint32_t down_s, down_t;    /* 24 - log2 of a side: to 1/256 of a texel */
    uint32_t last_s, last_t;    /* columns and rows less one */
    uint32_t log2_w;
} tp_level;

static inline tp_level tp_level_at(const tp_texture *texture, int l)
{
    uint32_t log2_w = (uint32_t)(texture->log2_w > l ? texture->log2_w - l : 0);
    uint32_t log2_h = (uint32_t)(texture->log2_h > l ? texture->log2_h - l : 0);

    return (tp_level){
        .texel = texture->level[l],
        .half_s = 0x80000000u >> log2_w, .half_t = 0x80000000u >> log2_h,
        .down_s = 24 - log2_w, .down_t = 24 - log2_h,
        .last_s = (1u << log2_w) - 1, .last_t = (1u << log2_h) - 1,
        .log2_w = log2_w,
    };
}

/* Four texels, the upper pair first, and the weights of the right and the lower ones. */
typedef struct {
    uint32_t texel[4], fs, ft;
} tp_four;

/* Below and right of the place, which is half a texel from the one that is meant. */
TP_ALWAYS_INLINE tp_four tp_four_at(const tp_level *l, uint32_t s, uint32_t t)
{
    uint32_t su = s >> l->down_s, tv = t >> l->down_t, u = su >> 8, v = tv >> 8;
    uint32_t u1 = (u + 1) & l->last_s, row = v << l->log2_w;
    uint32_t below = ((v + 1) & l->last_t) << l->log2_w;

    return (tp_four){ { l->texel[(int32_t)(row + u)], l->texel[(int32_t)(row + u1)],
                        l->texel[(int32_t)(below + u)], l->texel[(int32_t)(below + u1)] },
                      su & 0xff, tv & 0xff };
}

/* Around the place.  Weights are the eight bits below a texel. */
TP_ALWAYS_INLINE tp_four tp_four_around(const tp_level *l, uint32_t s, uint32_t t)
{
    return tp_four_at(l, s - l->half_s, t - l->half_t);
}

TP_ALWAYS_INLINE tp_parted tp_four_mean(const tp_four *f)
{
    tp_parted above = tp_parted_mix(tp_parted_of(f->texel[0]), tp_parted_of(f->texel[1]),
                                    f->fs);
    tp_parted below = tp_parted_mix(tp_parted_of(f->texel[2]), tp_parted_of(f->texel[3]),
                                    f->fs);
    return tp_parted_mix(above, below, f->ft);
}

TP_ALWAYS_INLINE uint32_t tp_linear(const tp_level *l, uint32_t s, uint32_t t)
{
    tp_four f = tp_four_around(l, s, t);
    return tp_parted_whole(tp_four_mean(&f));
}

/* -- a layer's level ---------------------------------------------------------------- */

static inline int tp_level_near(const tp_shade *shade, const tp_layer *layer,
                                uint32_t key)
{
    return tp_level_of(layer->lod, tp_log_depth(shade, key), true,
                       layer->texture->levels);
}

/* Samples of a run that have one level: what loops go over. */
typedef struct {
    const uint32_t *s, *t;      /* from the first on */
    int32_t begin, count;
    int     level;
} tp_stretch;

/* The one from `begin`, at which 16 columns or the run begin; s and t are the run's. */
static inline tp_stretch tp_stretch_from(const tp_shade *shade, const tp_run *run,
                                         const tp_layer *layer, const uint32_t *s,
                                         const uint32_t *t, int32_t begin)
{
    int     level = tp_level_near(shade, layer, run->key[begin]);
    int32_t stop = tp_block_end(run, begin);

    while (stop < run->count && tp_level_near(shade, layer, run->key[stop]) == level)
        stop = tp_block_end(run, stop);
    return (tp_stretch){ s + begin, t + begin, begin, stop - begin, level };
}

/* Its places become repeats by a product and a sum. */
typedef struct {
    tp_level level;
    uint32_t per_s, per_t, drift_s, drift_t;
} tp_sampler;

/* For four texels. */
static inline tp_sampler tp_sampler_linear(const tp_layer *layer, int level)
{
    tp_level l = tp_level_at(layer->texture, level);

    return (tp_sampler){ l, layer->per_metre, layer->per_metre,
                         layer->drift_s - l.half_s, layer->drift_t - l.half_t };
}

TP_ALWAYS_INLINE tp_four tp_sampler_four(const tp_sampler *p, uint32_t s, uint32_t t)
{
    return tp_four_at(&p->level, s * p->per_s + p->drift_s, t * p->per_s + p->drift_t);
}

/* For one texel: shifts are to whole ones.  A side of one texel would need 32: all places
 * become 0 instead. */
static inline tp_sampler tp_sampler_nearest(const tp_layer *layer, int level)
{
    tp_level l = tp_level_at(layer->texture, level);
    bool one_s = l.last_s == 0, one_t = l.last_t == 0;

    l.down_s = one_s ? 0 : l.down_s + 8;
    l.down_t = one_t ? 0 : l.down_t + 8;
    return (tp_sampler){
        l, one_s ? 0 : layer->per_metre, one_t ? 0 : layer->per_metre,
        one_s ? 0 : layer->drift_s, one_t ? 0 : layer->drift_t,
    };
}

TP_ALWAYS_INLINE uint32_t tp_sampler_texel(const tp_sampler *p, uint32_t s, uint32_t t)
{
    uint32_t u = (s * p->per_s + p->drift_s) >> p->level.down_s;
    uint32_t v = (t * p->per_t + p->drift_t) >> p->level.down_t;

    return p->level.texel[(int32_t)((v << p->level.log2_w) + u)];
}

/* One texel or the mean of four; `filter` is a literal. */
static inline tp_sampler tp_sampler_for(const tp_layer *layer, int level, int filter)
{
    TP_ASSERT(level >= 0 && level < layer->texture->levels);
    return filter ? tp_sampler_linear(layer, level) : tp_sampler_nearest(layer, level);
}

TP_ALWAYS_INLINE tp_parted tp_sampled(const tp_sampler *p, uint32_t s, uint32_t t,
                                      int filter)
{
    if (!filter)
        return tp_parted_of(tp_sampler_texel(p, s, t));
    tp_four f = tp_sampler_four(p, s, t);
    return tp_four_mean(&f);
}
#endif
