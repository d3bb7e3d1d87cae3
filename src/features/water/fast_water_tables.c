/* SPDX-License-Identifier: MIT */
/* Bakes the textures of fast shading.  See fast_shading.h. */
#include "features/water/fast_shading.h"
#include "features/water/water.h"
#include "shade/colour.h"
#include "world/world.h"

/* -- baked textures ------------------------------------------------------------------ */

/* Parameters of the baking of a texel. */
typedef struct {
    tp_grade grade;
    uint32_t tint;
    bool     graded;
    int32_t  gain;              /* of normals, Q8; of offsets, 16.16 m */
} bake_work;

typedef uint32_t (*texel_work)(const bake_work *w, uint32_t texel);

static uint32_t longer_side_log2(const tp_texture *t)
{
    return t->log2_w > t->log2_h ? t->log2_w : t->log2_h;
}

/* Returns log2 of the baked side, 1..TP_QUICK_LOG2. */
static uint32_t baked_side_log2(const tp_texture *from)
{
    return (uint32_t)tp_clamp((int32_t)longer_side_log2(from), 1, TP_QUICK_LOG2);
}

/* Sum of 4^n words for n of 0..side. */
size_t tp_quick_bytes(const tp_texture *from)
{
    return ((4u << 2 * baked_side_log2(from)) - 1) / 3 * sizeof(uint32_t);
}

static uint32_t level_log2(uint32_t log2, uint32_t level)
{
    return log2 > level ? log2 - level : 0;
}

static void bake_level(uint32_t *to, uint32_t log2, const tp_texture *from,
                       uint32_t level, texel_work texel, const bake_work *w)
{
    const uint32_t log2_w = level_log2(from->log2_w, level);
    const uint32_t log2_h = level_log2(from->log2_h, level);
    const uint32_t right = log2 - log2_w, down = log2 - log2_h;

    for (uint32_t y = 0; y < 1u << log2; y++) {
        const uint32_t *row = from->level[level] + ((size_t)(y >> down) << log2_w);
        for (uint32_t x = 0; x < 1u << log2; x++)
            *to++ = texel(w, row[x >> right]);
    }
}

static void bake_levels(tp_texture *to, const tp_texture *from, texel_work texel,
                        const bake_work *w, uint32_t *mem)
{
    TP_ASSERT(from->levels > 0 && (uintptr_t)mem % 4 == 0);
    const uint32_t side = baked_side_log2(from), whole = longer_side_log2(from);
    const uint32_t left_out = whole > side ? whole - side : 0;

    *to = (tp_texture){ .log2_w = (uint8_t)side, .log2_h = (uint8_t)side,
                        .levels = (uint8_t)(side + 1) };
    for (uint32_t l = 0; l <= side; l++) {
        const uint32_t level = l + left_out;
        to->level[l] = mem;
        bake_level(mem, side - l, from, level <= whole ? level : whole, texel, w);
        mem += (size_t)1 << 2 * (side - l);
    }
}

tp_quick_map tp_quick_map_make(const tp_layer *layer)
{
    const tp_texture *texture = layer->texture;

    if (!texture)
        return (tp_quick_map){ .level = NULL };
    return (tp_quick_map){ layer->per_metre, layer->drift_s, layer->drift_t, layer->lod,
                           texture->levels - 2, texture->log2_w, texture->level };
}

/* -- layers: as in layers_stage.c ---------------------------------------------------- */

static uint32_t graded_texel(const bake_work *w, uint32_t texel)
{
    return w->graded ? tp_grade_texel(&w->grade, tp_split_rgb_make(texel))
                     : tp_colour_times(texel, w->tint);
}

void tp_quick_graded(tp_texture *to, const tp_texture *from, tp_fx saturation, tp_fx clamp,
                     uint32_t colour, void *mem)
{
    const bake_work w = { .grade = tp_grade_make(saturation, clamp, colour), .tint = colour,
                     .graded = tp_is_graded(saturation, clamp) };
    bake_levels(to, from, graded_texel, &w, mem);
}

/* -- distortion: red along s, green along t; 128 is 0, 0 full negative strength ------ */

/* Returns an offset in 1/1024 m.  2^7 x 20 m is below 2^28. */
static uint32_t channel_offset(const bake_work *w, uint32_t channel)
{
    int32_t m = ((int32_t)channel - 128) * w->gain;
    return (uint32_t)((m + (1 << 12)) >> 13);
}

static uint32_t offset_texel(const bake_work *w, uint32_t texel)
{
    return channel_offset(w, texel >> 16 & 0xff) << 16
           | (channel_offset(w, texel >> 8 & 0xff) & 0xffff);
}

void tp_quick_offsets(tp_texture *to, const tp_texture *from, tp_fx strength, void *mem)
{
    const bake_work w = { .gain = strength };
    bake_levels(to, from, offset_texel, &w, mem);
}

/* -- ripples: slopes -nx / nz along s and ny / nz along t ---------------------------- */

/* Returns n / nz in Q3.12, rounded.  nz is at least 1/8; n is below 2^18. */
static uint32_t slope(int32_t n, int32_t nz)
{
    int32_t twice = 32 * n + (n < 0 ? -nz : nz);
    return (uint32_t)tp_clamp(twice / (2 * nz), -32000, 32000);
}

static uint32_t slope_texel(const bake_work *w, uint32_t texel)
{
    int32_t nx = (int32_t)(texel >> 16 & 0xff) - 128,
            ny = (int32_t)(texel >> 8 & 0xff) - 128;
    int32_t nz = (int32_t)(texel & 0xff) - 128;

    nz = nz < 16 ? 16 : nz;
    return slope(-nx * w->gain, nz) << 16 | (slope(ny * w->gain, nz) & 0xffff);
}

void tp_quick_slopes(tp_texture *to, const tp_texture *from, tp_fx bump, void *mem)
{
    const bake_work w = { .gain = bump >> 8 };
    bake_levels(to, from, slope_texel, &w, mem);
}
