/* SPDX-License-Identifier: MIT */
/* Span stage of the water's base texture.  The texture is fixed to rest positions, so it
 * moves with the water. */
#include "features/water/water.h"
#include "shade/sampler.h"

/* Shades one stretch; `filter` and `tinted` are literals. */
TP_ALWAYS_INLINE void shade_stretch(const tp_sampler *sampler, uint32_t tint,
                          const tp_stretch *over, uint32_t *restrict colour, int filter,
                          int tinted)
{
    const tp_sampler p = *sampler;
    const tp_split_rgb  with = tp_split_rgb_make(tint);
    const uint32_t *restrict s = over->s, *restrict t = over->t;
    const int32_t count = over->count;

    for (int32_t i = 0; i < count; i++) {
        tp_split_rgb texel = tp_sampled(&p, s[i], t[i], filter);
        colour[i] = tinted ? tp_split_rgb_multiply(texel, with) : tp_split_rgb_join(texel);
    }
}

TP_ALWAYS_INLINE void texture(const tp_shade *shade, tp_run *run, int filter, int tinted)
{
    const tp_layer *layer = &((const tp_base_layer *)run->mine)->layer;
    TP_ASSERT(layer->texture != NULL);
    tp_stretch w;

    for (int32_t i = 0; i < run->count; i += w.count) {
        w = tp_stretch_find(shade, run, layer, run->ls, run->lt, i);
        const tp_sampler p = tp_sampler_choose(layer, w.level, filter);
        shade_stretch(&p, shade->water_colour, &w, run->colour + i, filter, tinted);
    }
}

#define TEXTURE_STAGE(name, filter, tinted) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { texture(shade, run, filter, tinted); }
TP_TEXTURE_STAGES(TEXTURE_STAGE)

const tp_stage tp_base_layer_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_base_layer(X)
#undef X
};
