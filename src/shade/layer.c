/* SPDX-License-Identifier: MIT */
/* The water's pictures beyond the plain case of texture.c: those that are added to the
 * first, and any that are brought to another saturation or clamped (see grade.h). */
#include "shade/grade.h"
#include "shade/sampler.h"

/* The span is no less than 12 levels. */
tp_grade tp_grade_of(tp_fx saturation, tp_fx clamp, uint32_t colour)
{
    tp_grade grade = { .saturation = saturation >> 8,
                       .clamp = (int32_t)((int64_t)clamp * 255 >> 8) };

    grade.span = 255 * 256 - grade.clamp;
    for (int c = 0; c < 3; c++)
        grade.gain[c] = ((colour >> (16 - 8 * c) & 0xff) << 24) / (uint32_t)grade.span;
    return grade;
}

enum { TINTED, GRADED };

/* `filter`, `how` and `add` are literals. */
TP_ALWAYS_INLINE void lay(const tp_shade *shade, tp_run *run, const tp_layer *layer,
                          const tp_grade *grade, uint32_t tint, int filter, int how,
                          int add)
{
    const uint32_t *place_s = run->ls, *place_t = run->lt;
    const tp_grade  g = *grade;

    for (int32_t i = 0; i < run->count; ) {
        tp_level l = tp_level_for(shade, layer, run->key[i]);
        int32_t  stop = tp_block_end(run, i);
        for (; i < stop; i++) {
            uint32_t s = place_s[i] * layer->per_metre + layer->drift_s;
            uint32_t t = place_t[i] * layer->per_metre + layer->drift_t;
            uint32_t texel = filter ? tp_linear(&l, s, t) : tp_nearest(&l, s, t);
            texel = how == GRADED ? tp_graded(&g, texel) : tp_colour_times(texel, tint);
            run->colour[i] = add ? tp_colour_add(run->colour[i], texel) : texel;
        }
    }
}

void tp_stage_texture_graded(const tp_shade *shade, tp_run *run)
{
    lay(shade, run, &shade->water, &shade->layers.grade[0], 0, 0, GRADED, 0);
}

void tp_stage_texture_linear_graded(const tp_shade *shade, tp_run *run)
{
    lay(shade, run, &shade->water, &shade->layers.grade[0], 0, 1, GRADED, 0);
}

TP_ALWAYS_INLINE void lay_added(const tp_shade *shade, tp_run *run, int filter)
{
    const tp_layers *layers = &shade->layers;

    for (int k = 0; k < TP_LAYERS_ADDED; k++) {
        const tp_layer *layer = &layers->added[k];
        const tp_grade *grade = &layers->grade[1 + k];
        if (layer->texture && layers->graded[k])
            lay(shade, run, layer, grade, 0, filter, GRADED, 1);
        else if (layer->texture)
            lay(shade, run, layer, grade, layers->colour[k], filter, TINTED, 1);
    }
}

void tp_stage_layers(const tp_shade *shade, tp_run *run)
{
    lay_added(shade, run, 0);
}

void tp_stage_layers_linear(const tp_shade *shade, tp_run *run)
{
    lay_added(shade, run, 1);
}
