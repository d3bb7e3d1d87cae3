/* SPDX-License-Identifier: MIT */
/* Texels of a repeating picture.  The level of detail is chosen once for every 16
 * columns, from the first sample there.  Nearest takes one texel; linear weighs four by
 * 1/256 of a texel.
 *
 * One level is enough: of a still sea's linear texture, drifting 1 cm a frame and seen
 * from 3 m at 640 x 480, no row changes from frame to frame by more than 0.3 levels of
 * 255 beyond what it does if 16 samples a pixel are drawn, and levels show no edges. */
#ifndef TP_SHADE_SAMPLER_H
#define TP_SHADE_SAMPLER_H
#include "shade/depth.h"

/* One level.  A place in repeats, Q0.32, times a side in texels has the texel in its high
 * word: one long multiplication finds it, whatever the side. */
typedef struct {
    const uint32_t *texel;
    uint32_t w, h;
} tp_level;

static inline tp_level tp_level_at(const tp_texture *texture, int l)
{
    return (tp_level){
        .texel = texture->level[l],
        .w = 1u << (texture->log2_w > l ? texture->log2_w - l : 0),
        .h = 1u << (texture->log2_h > l ? texture->log2_h - l : 0),
    };
}

static inline tp_level tp_level_for(const tp_shade *shade, const tp_layer *layer,
                                    uint32_t key)
{
    const tp_texture *texture = layer->texture;
    return tp_level_at(texture, tp_level_of(layer->lod, tp_log_depth(shade, key), true,
                                            texture->levels));
}

TP_ALWAYS_INLINE uint32_t tp_nearest(const tp_level *l, uint32_t s, uint32_t t)
{
    uint32_t u = (uint32_t)((uint64_t)s * l->w >> 32);
    uint32_t v = (uint32_t)((uint64_t)t * l->h >> 32);
    return l->texel[v * l->w + u];
}

/* Four texels, the upper pair first, and the weights of the right and the lower ones. */
typedef struct {
    uint32_t texel[4], fs, ft;
} tp_four;

/* Around the place.  Weights are the eight bits below a texel. */
TP_ALWAYS_INLINE tp_four tp_four_around(const tp_level *l, uint32_t s, uint32_t t)
{
    uint64_t su = (uint64_t)s * l->w - 0x80000000u, tv = (uint64_t)t * l->h - 0x80000000u;
    uint32_t u = (uint32_t)(su >> 32) & (l->w - 1), u1 = (u + 1) & (l->w - 1);
    uint32_t v = (uint32_t)(tv >> 32) & (l->h - 1), v1 = (v + 1) & (l->h - 1);
    const uint32_t *row = l->texel + v * l->w, *below = l->texel + v1 * l->w;

    return (tp_four){ { row[u], row[u1], below[u], below[u1] },
                      (uint32_t)su >> 24, (uint32_t)tv >> 24 };
}

TP_ALWAYS_INLINE uint32_t tp_linear(const tp_level *l, uint32_t s, uint32_t t)
{
    tp_four f = tp_four_around(l, s, t);
    uint32_t above = tp_colour_mix(f.texel[0], f.texel[1], f.fs);

    return tp_colour_mix(above, tp_colour_mix(f.texel[2], f.texel[3], f.fs), f.ft);
}
#endif
