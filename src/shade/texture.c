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

/* One level: its texels and how to find one from a place in repeats, Q0.32. */
typedef struct {
    const uint32_t *texel;
    int w, h;                   /* log2 */
} level;

static level level_for(const tp_shade *shade, const tp_layer *layer, uint32_t key)
{
    const tp_texture *texture = layer->texture;
    int l = tp_lod_of(shade, layer->lod, key, texture->levels);
    return (level){ texture->level[l], texture->log2_w > l ? texture->log2_w - l : 0,
                    texture->log2_h > l ? texture->log2_h - l : 0 };
}

/* Shifts by 32 do not exist: one side of 1 texel takes two shifts. */
TP_ALWAYS_INLINE uint32_t texel_index(const level *l, uint32_t s, uint32_t t)
{
    uint32_t u = s >> 1 >> (31 - l->w), v = t >> 1 >> (31 - l->h);
    return v << l->w | u;
}

TP_ALWAYS_INLINE uint32_t nearest(const level *l, uint32_t s, uint32_t t)
{
    return l->texel[texel_index(l, s, t)];
}

/* Four texels around the place.  Weights are the eight bits below a texel. */
TP_ALWAYS_INLINE uint32_t linear(const level *l, uint32_t s, uint32_t t)
{
    s -= (uint32_t)0x80000000u >> l->w;
    t -= (uint32_t)0x80000000u >> l->h;
    uint32_t u = s >> 1 >> (31 - l->w), v = t >> 1 >> (31 - l->h);
    uint32_t u1 = (u + 1) & ((1u << l->w) - 1), v1 = (v + 1) & ((1u << l->h) - 1);
    uint32_t fs = (s << l->w) >> 24, ft = (t << l->h) >> 24;
    const uint32_t *row = l->texel + (v << l->w), *below = l->texel + (v1 << l->w);
    uint32_t above_mix = tp_colour_mix(row[u], row[u1], fs);

    return tp_colour_mix(above_mix, tp_colour_mix(below[u], below[u1], fs), ft);
}

TP_ALWAYS_INLINE void texture(const tp_shade *shade, tp_run *run, int filter, int tinted)
{
    const tp_layer *layer = &shade->water;
    uint32_t tint = shade->water_colour, per_metre = layer->per_metre;
    uint32_t drift_s = layer->drift_s, drift_t = layer->drift_t;
    int32_t  i = 0;

    while (i < run->count) {
        level   l = level_for(shade, layer, run->key[i]);
        int32_t stop = i + 16 - ((run->x + i) & 15);
        if (stop > run->count)
            stop = run->count;
        for (; i < stop; i++) {
            uint32_t s = run->s[i] * per_metre + drift_s;
            uint32_t t = run->t[i] * per_metre + drift_t;
            uint32_t texel = filter ? linear(&l, s, t) : nearest(&l, s, t);
            run->colour[i] = tinted ? tp_colour_times(texel, tint) : texel & 0xffffff;
        }
    }
}

#define TEXTURE_STAGE(name, filter, tinted) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { texture(shade, run, filter, tinted); }
TP_TEXTURE_STAGES(TEXTURE_STAGE)

/* -- ripples -------------------------------------------------------------------------- */

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
