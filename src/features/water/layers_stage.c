/* SPDX-License-Identifier: MIT */
/*
 * Span stages of the water's textures.  The base texture is fixed to rest positions, so
 * it moves with the water.  Layers are added to the base layer; a layer may have another
 * saturation or a clamp.  water.h has the arithmetic of saturation, clamp and colour.  A
 * distortion moves the places at which layers are sampled.
 */
#include "features/water/water.h"
#include "shade/material.h"

/* -- the base layer ------------------------------------------------------------------ */

/* Shades one stretch; `filter` and `tinted` are literals. */
TP_ALWAYS_INLINE void shade_base_stretch(const tp_sampler *sampler, uint32_t tint,
                                         const tp_stretch *over,
                                         uint32_t *restrict colour, int filter,
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

TP_ALWAYS_INLINE void shade_base_layer(const tp_shade *shade, tp_run *run, int filter,
                                       int tinted)
{
    const tp_layer *layer = &((const tp_base_layer *)run->mine)->layer;
    TP_ASSERT(layer->texture != NULL);
    tp_stretch w;

    for (int32_t i = 0; i < run->count; i += w.count) {
        w = tp_stretch_find(shade, run, layer, run->ls, run->lt, i);
        const tp_sampler p = tp_sampler_choose(layer, w.level, filter);
        shade_base_stretch(&p, shade->water_colour, &w, run->colour + i, filter, tinted);
    }
}

#define TEXTURE_STAGE(name, filter, tinted) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { shade_base_layer(shade, run, filter, tinted); }
TP_TEXTURE_STAGES(TEXTURE_STAGE)

const tp_stage tp_base_layer_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_base_layer(X)
#undef X
};

/* -- added and graded layers --------------------------------------------------------- */

/* The range is at least 12 levels of 255. */
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
            how == GRADED ? tp_grade_texel(&g, texel) : tp_split_rgb_multiply(texel, with);
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

/* -- the distortion ------------------------------------------------------------------ */

/* A drifting texture moves the places at which layers are sampled.  Red moves along s,
 * green along t; 128 is no offset, 0 is the full negative strength.
 *
 * Ripples are not distorted: their normals would have to be turned as well.
 *
 * The texture is always filtered, to 24 bits: with 8 bits a strength of 1 m would give
 * steps of a texel or more.  In the distance small mipmap levels are near the mean, so
 * the places come to rest. */

/* Returns red and green in the halves of a word; after one mix each fills its half. */
TP_ALWAYS_INLINE uint32_t red_green(uint32_t texel)
{
    return (texel & 0xff0000) | (texel >> 8 & 0xff);
}

/* Mixes two 16-bit values by the weight ft / 256, and subtracts the offset of 128.  The
 * result has 24 significant bits at the top of the word. */
TP_ALWAYS_INLINE int32_t signed_mix(uint32_t above, uint32_t below, uint32_t ft)
{
    return (int32_t)((above * (256 - ft) + below * ft - (128u << 16)) << 8);
}

static void distort_stretch(const tp_sampler *sampler, int32_t strength,
                            const tp_stretch *over, uint32_t *restrict bent_s,
                            uint32_t *restrict bent_t)
{
    const tp_sampler p = *sampler;
    const uint32_t *restrict s = over->s, *restrict t = over->t;
    const int32_t count = over->count;

    for (int32_t i = 0; i < count; i++) {
        tp_four  f = tp_sampler_four(&p, s[i], t[i]);
        uint32_t above = red_green(f.texel[0]) * (256 - f.fs)
                       + red_green(f.texel[1]) * f.fs;
        uint32_t below = red_green(f.texel[2]) * (256 - f.fs)
                       + red_green(f.texel[3]) * f.fs;
        int32_t  red = signed_mix(above >> 16, below >> 16, f.ft);
        int32_t  green = signed_mix(above & 0xffff, below & 0xffff, f.ft);
        bent_s[i] = s[i] + (uint32_t)tp_mul_upper(red, strength);
        bent_t[i] = t[i] + (uint32_t)tp_mul_upper(green, strength);
    }
}

/* Distorts a run.  The 32 bits of an offset span twice the strength, at most 40 m. */
void tp_stage_bend(const tp_shade *shade, tp_run *run)
{
    const tp_layers *layers = run->mine;
    const tp_layer *layer = &layers->bend;
    tp_stretch w;

    for (int32_t i = 0; i < run->count; i += w.count) {
        w = tp_stretch_find(shade, run, layer, run->s, run->t, i);
        const tp_sampler p = tp_sampler_linear(layer, w.level);
        distort_stretch(&p, 2 * layers->strength, &w, run->bent_s + i, run->bent_t + i);
    }
    run->ls = run->bent_s;
    run->lt = run->bent_t;
}
