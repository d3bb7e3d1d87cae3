/* SPDX-License-Identifier: MIT */
/* Span stages of the water's textures beyond the plain case of base_layer_stage.c: layers
 * added to the base layer, and layers with another saturation or a clamp.  grade.h has
 * the arithmetic of saturation, clamp and colour. */
#include "features/water/water.h"
#include "shade/sampler.h"

/* The span is at least 12 levels of 255. */
tp_grade tp_grade_make(tp_fx saturation, tp_fx clamp, uint32_t colour)
{
    TP_ASSERT(saturation >= 0 && saturation <= 4 * TP_FX_ONE);
    TP_ASSERT(clamp >= 0 && clamp < TP_FX_ONE);
    tp_grade grade = { .saturation = saturation >> 8,
                       .clamp = (int32_t)((int64_t)clamp * 255 >> 8) };

    grade.range = 255 * 256 - grade.clamp;
    for (int c = 0; c < 3; c++)
        grade.gain[c] = ((colour >> (16 - 8 * c) & 0xff) << 24) / (uint32_t)grade.range;
    return grade;
}

enum { TINTED, GRADED };

/* Shades one stretch; `filter`, `how` and `add` are literals. */
TP_ALWAYS_INLINE void shade_stretch(const tp_sampler *sampler, const tp_grade *grade,
                                    uint32_t tint, const tp_stretch *over,
                                    uint32_t *restrict colour, int filter, int how,
                                    int add)
{
    const tp_sampler p = *sampler;
    const tp_grade   g = *grade;
    const tp_split_rgb  with = tp_split_rgb_make(tint);
    const uint32_t *restrict s = over->s, *restrict t = over->t;
    const int32_t count = over->count;

    for (int32_t i = 0; i < count; i++) {
        tp_split_rgb texel = tp_sampled(&p, s[i], t[i], filter);
        uint32_t c =
            how == GRADED ? tp_graded(&g, texel) : tp_split_rgb_multiply(texel, with);
        colour[i] = add ? tp_colour_add(colour[i], c) : c;
    }
}

TP_ALWAYS_INLINE void shade_layer(const tp_shade *shade, tp_run *run, const tp_layer *layer,
                              const tp_grade *grade, uint32_t tint, int filter, int how,
                              int add)
{
    TP_ASSERT(layer->texture != NULL);
    tp_stretch w;

    for (int32_t i = 0; i < run->count; i += w.count) {
        w = tp_stretch_find(shade, run, layer, run->ls, run->lt, i);
        const tp_sampler p = tp_sampler_choose(layer, w.level, filter);
        shade_stretch(&p, grade, tint, &w, run->colour + i, filter, how, add);
    }
}

void tp_stage_texture_graded(const tp_shade *shade, tp_run *run)
{
    const tp_base_layer *base = run->mine;

    shade_layer(shade, run, &base->layer, &base->grade, 0, 0, GRADED, 0);
}

void tp_stage_texture_linear_graded(const tp_shade *shade, tp_run *run)
{
    const tp_base_layer *base = run->mine;

    shade_layer(shade, run, &base->layer, &base->grade, 0, 1, GRADED, 0);
}

TP_ALWAYS_INLINE void shade_added_layers(const tp_shade *shade, tp_run *run, int filter)
{
    const tp_layers *layers = run->mine;

    for (int k = 0; k < TP_LAYERS_ADDED; k++) {
        const tp_layer *layer = &layers->added[k];
        const tp_grade *grade = &layers->grade[k];
        if (layer->texture && layers->graded[k])
            shade_layer(shade, run, layer, grade, 0, filter, GRADED, 1);
        else if (layer->texture)
            shade_layer(shade, run, layer, grade, layers->colour[k], filter, TINTED, 1);
    }
}

void tp_stage_layers(const tp_shade *shade, tp_run *run)
{
    shade_added_layers(shade, run, 0);
}

void tp_stage_layers_linear(const tp_shade *shade, tp_run *run)
{
    shade_added_layers(shade, run, 1);
}

const tp_stage tp_layers_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_layers(X)
#undef X
};
