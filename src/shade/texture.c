/* SPDX-License-Identifier: MIT */
/* The water's texture, laid over the places at rest so that it moves with the water.
 *
 * The level of detail is chosen once for every 16 columns, from the first sample there.
 * Nearest takes one texel; linear weighs four by 1/256 of a texel. */
#include "shade/shade.h"

void tp_stage_plain(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = shade->water_colour;
}

/* One level.  A place in repeats, Q0.32, times a side in texels has the texel in its high
 * word: one long multiplication finds it, whatever the side. */
typedef struct {
    const uint32_t *texel;
    uint32_t w, h;
} level;

static level level_for(const tp_shade *shade, const tp_layer *layer, uint32_t key)
{
    const tp_texture *texture = layer->texture;
    int l = tp_level_of(layer->lod, tp_log_depth(shade, key), true, texture->levels);
    return (level){
        .texel = texture->level[l],
        .w = 1u << (texture->log2_w > l ? texture->log2_w - l : 0),
        .h = 1u << (texture->log2_h > l ? texture->log2_h - l : 0),
    };
}

TP_ALWAYS_INLINE uint32_t nearest(const level *l, uint32_t s, uint32_t t)
{
    uint32_t u = (uint32_t)((uint64_t)s * l->w >> 32);
    uint32_t v = (uint32_t)((uint64_t)t * l->h >> 32);
    return l->texel[v * l->w + u];
}

/* Four texels around the place.  Weights are the eight bits below a texel. */
TP_ALWAYS_INLINE uint32_t linear(const level *l, uint32_t s, uint32_t t)
{
    uint64_t su = (uint64_t)s * l->w - 0x80000000u, tv = (uint64_t)t * l->h - 0x80000000u;
    uint32_t u = (uint32_t)(su >> 32) & (l->w - 1), u1 = (u + 1) & (l->w - 1);
    uint32_t v = (uint32_t)(tv >> 32) & (l->h - 1), v1 = (v + 1) & (l->h - 1);
    uint32_t fs = (uint32_t)su >> 24, ft = (uint32_t)tv >> 24;
    const uint32_t *row = l->texel + v * l->w, *below = l->texel + v1 * l->w;
    uint32_t above_mix = tp_colour_mix(row[u], row[u1], fs);

    return tp_colour_mix(above_mix, tp_colour_mix(below[u], below[u1], fs), ft);
}

TP_ALWAYS_INLINE void texture(const tp_shade *shade, tp_run *run, int filter, int tinted)
{
    const tp_layer *layer = &shade->water;
    const uint32_t *rest_s = run->s, *rest_t = run->t;
    uint32_t tint = shade->water_colour, per_metre = layer->per_metre;
    uint32_t drift_s = layer->drift_s, drift_t = layer->drift_t;
    int32_t  count = run->count;

    for (int32_t i = 0; i < count; ) {
        level   l = level_for(shade, layer, run->key[i]);
        int32_t stop = i + 16 - ((run->x + i) & 15);
        stop = stop < count ? stop : count;
        for (; i < stop; i++) {
            uint32_t s = rest_s[i] * per_metre + drift_s;
            uint32_t t = rest_t[i] * per_metre + drift_t;
            uint32_t texel = filter ? linear(&l, s, t) : nearest(&l, s, t);
            run->colour[i] = tinted ? tp_colour_times(texel, tint) : texel & 0xffffff;
        }
    }
}

#define TEXTURE_STAGE(name, filter, tinted) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { texture(shade, run, filter, tinted); }
TP_TEXTURE_STAGES(TEXTURE_STAGE)

/* -- ripples ------------------------------------------------------------------------- */

/* A normal map's texel (nx, ny, nz), green up the picture, is a slope of -nx along s and
 * +ny along t.  nz is taken as 1: a ripple of slope 0.35 comes out 6 % flat. */
void tp_stage_ripple(const tp_shade *shade, tp_run *run)
{
    const tp_layer *layer = &shade->ripple;
    int32_t i = 0;

    while (i < run->count) {
        level   l = level_for(shade, layer, run->key[i]);
        int32_t stop = i + 16 - ((run->x + i) & 15);
        if (stop > run->count)
            stop = run->count;
        for (; i < stop; i++) {
            uint32_t s = run->s[i] * layer->per_metre + layer->drift_s;
            uint32_t t = run->t[i] * layer->per_metre + layer->drift_t;
            uint32_t texel = linear(&l, s, t);
            int32_t  nx = (int32_t)(texel >> 16 & 0xff) - 128;
            int32_t  ny = (int32_t)(texel >> 8 & 0xff) - 128;
            int32_t  sx = (int16_t)(run->n[i] >> 16) - (nx * layer->slope_gain >> 3);
            int32_t  sz = (int16_t)(run->n[i] & 0xffff) + (ny * layer->slope_gain >> 3);
            run->sx[i] = (int16_t)tp_clamp(sx, -32000, 32000);
            run->sz[i] = (int16_t)tp_clamp(sz, -32000, 32000);
        }
    }
}
