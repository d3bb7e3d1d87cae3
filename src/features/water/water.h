/* SPDX-License-Identifier: MIT */
/*
 * The water's modules: the data of their stages in tp_run.mine, and their parameters.
 *
 *     water_module.c         the modules: their conditions
 *     water_drawing.c        the data of a frame, and the choice of stages
 *     layers_stage.c         textures: base layer, added layers, distortion
 *     ripple_stage.c         normals: capillary waves, and pools that leave the mesh flat
 *     fast_bumps_stage.c     the same of pools, by fast shading
 *     lighting_stage.c       light, reflected sky, glints
 *     fast_water_drawing.c   the same by fast shading, see fast_shading.h
 */
#ifndef TP_FEATURES_WATER_WATER_H
#define TP_FEATURES_WATER_WATER_H
#include <stdbool.h>
#include "fixed/arithmetic.h"
#include "pool/pool.h"
#include "shade/colour.h"
#include "shade/shade.h"
#include "tidepool/modules.h"
#include "world/module.h"

/* -- pools that bend the normals and leave the mesh flat ----------------------------- */

#define TP_BUMPS_ID TP_MODULE_ID('b', 'u', 'm', 'p')

typedef struct {
    const tp_pool_slope *slope; /* see tp_pool_slopes; NULL: no such pool */
    uint32_t cols, rows;
    tp_fx    x, z;              /* centre of the field, m */
    uint64_t turns_x, turns_z;  /* fields per metre, Q48 over Q16.16 */
    uint32_t side_x, side_z;    /* sides, m, 16.16; 0: tiled */
    int32_t  lod;               /* mipmap level of the cells at 1 m, as in tp_layer */
} tp_pool_bump;

/* Returns the data of a pool, except the lod. */
tp_pool_bump tp_pool_bump_make(const tp_pool *pool, const tp_pool_slope *slope);

#define TP_POOL_BUMPS 2         /* the scene's pool and field */

typedef struct {
    tp_pool_bump pool[TP_POOL_BUMPS];
} tp_pool_bumps;

/* -- grading of a texel -------------------------------------------------------------- */

/* Saturation, clamp and colour.
 *
 * A channel c becomes v = y + (c - y) saturation, y its grey (.30 .59 .11), clamped to
 * 0..1, then (v - clamp) / (1 - clamp), clamped at 0, times the colour.  Both clamps
 * together equal one clamp of v - clamp to 0..1 - clamp, so the division becomes a part
 * of the colour's gain.  The arithmetic is in Q8 and rounds once. */

/* The grading of a layer's texels.  Levels of 255 are stored in Q8. */
typedef struct {
    int32_t  saturation;        /* 0: grey; 256: unchanged; at most 1024 */
    int32_t  clamp;             /* darker values become black, 0..0.95 of white */
    int32_t  range;             /* white minus the clamp, Q8 */
    uint32_t gain[3];           /* red, green, blue of the colour / range, Q24 */
} tp_grade;

/* layers_stage.c.  Returns the grading for saturation 0..4, clamp 0..0.95. */
tp_grade tp_grade_make(tp_fx saturation, tp_fx clamp, uint32_t colour);

/* True if a layer needs grading; false if a multiplication by the colour is enough. */
static inline bool tp_is_graded(tp_fx saturation, tp_fx clamp)
{
    return saturation != TP_FX_ONE || clamp > 0;
}

/* Returns a graded channel, 0..255, from v: the channel times the saturation, plus the part
 * shared by all channels, Q8: the texel's grey times (1 - saturation), minus the clamp.
 * v <= range, and the gain is rounded down: v x gain <= 255 << 24, and adding a half
 * still fits 32 bits. */
TP_ALWAYS_INLINE uint32_t tp_grade_channel(const tp_grade *grade, int32_t v, int channel)
{
    v = tp_clamp(v, 0, grade->range);
    return ((uint32_t)v * grade->gain[channel] + (1u << 23)) >> 24;
}

/* Grades with packed products. */
TP_ALWAYS_INLINE uint32_t tp_grade_texel_packed(const tp_grade *grade, tp_split_rgb texel)
{
    const uint32_t saturation = (uint32_t)grade->saturation;
    int32_t grey = tp_smlad(texel.rb, 77u << 16 | 29, (int32_t)(150 * texel.g));

    grey = (grey * (256 - grade->saturation) >> 8) - grade->clamp;
    return tp_grade_channel(grade, (int32_t)tp_smlatb(texel.rb, saturation,
                                                      (uint32_t)grey), 0) << 16
         | tp_grade_channel(grade, grey + (int32_t)(texel.g * saturation), 1) << 8
         | tp_grade_channel(grade, (int32_t)tp_smlabb(texel.rb, saturation,
                                                      (uint32_t)grey), 2);
}

TP_ALWAYS_INLINE uint32_t tp_grade_texel(const tp_grade *grade, tp_split_rgb texel)
{
    uint32_t r = texel.rb >> 16, g = texel.g, b = texel.rb & 0xff;
    int32_t  grey = (int32_t)(77 * r + 150 * g + 29 * b), s = grade->saturation;

    if (TP_DSP)
        return tp_grade_texel_packed(grade, texel);
    grey = (grey * (256 - s) >> 8) - grade->clamp;
    return tp_grade_channel(grade, grey + (int32_t)r * s, 0) << 16
         | tp_grade_channel(grade, grey + (int32_t)g * s, 1) << 8
         | tp_grade_channel(grade, grey + (int32_t)b * s, 2);
}

/* -- data of the stages -------------------------------------------------------------- */

#define TP_RIPPLE_ID TP_MODULE_ID('r', 'i', 'p', 'l')

typedef struct {
    tp_layer layer;
    tp_grade grade;
} tp_base_layer;

#define TP_LAYERS_ADDED 2       /* layers added to the base layer */

typedef struct {
    tp_layer added[TP_LAYERS_ADDED];            /* texture NULL: no such layer */
    uint32_t colour[TP_LAYERS_ADDED];
    bool     graded[TP_LAYERS_ADDED];           /* false: only times the colour */
    tp_grade grade[TP_LAYERS_ADDED];
    tp_layer bend;                              /* the distortion */
    tp_fx    strength;                          /* largest displacement, m */
} tp_layers;

/* Coarser levels of the ripples' map, Q8, in fast stages: mean normals lose the glitter.
 * Exact stages spread the light of the normals that a level has lost, and take the level
 * of the other textures. */
#define TP_RIPPLE_LOD 224

typedef struct {
    tp_layer layer;
    int32_t  gain;              /* of its slopes; 256: as drawn */
} tp_ripple;

/* name, linear filter, tinted by the water's colour */
#define TP_TEXTURE_STAGES(X) \
    X(texture,              0, 0) \
    X(texture_tinted,       0, 1) \
    X(texture_linear,       1, 0) \
    X(texture_linear_tinted, 1, 1)

/* -- parameters ---------------------------------------------------------------------- */

#define TP_WATER_ROWS \
    TP_ROW_COLOUR("water.colour", water.colour, 0x2a5a6e, \
        "colour that multiplies the first layer"), \
    TP_ROW_CHOICE("water.filter", water.filter, "nearest|linear", TP_FILTER_LINEAR, \
        TP_FILTER_LINEAR, "filter of the layers' textures"), \
    TP_ROW_NUMBER("water.specular", water.specular, "", 0, 4, 1, \
        "brightness of the sun's glitter"), \
    TP_ROW_NUMBER("water.shininess", water.shininess, "", 1, 1000, 80, \
        "exponent of the glitter: higher is smaller and sharper"), \
    TP_ROW_NUMBER("water.reflection", water.reflection, "", 0, 1, 0.6, \
        "share of sky in the colour at grazing angles"), \
    TP_ROW_CHOICE("water.fresnel", water.fresnel, "table|schlick", TP_FRESNEL_SCHLICK, \
        TP_FRESNEL_TABLE, \
        "exact Fresnel reflection from a table, or Schlick's approximation"), \
    TP_ROW_SWITCH("water.rough", water.rough, 1, \
        "light of ripples and waves too small to draw; off: cheaper, as smooth")

#define TP_BUMPS_ROWS \
    TP_ROW_NUMBER("water.pool_normal_strength", water.pool_normal_strength, "", 0, 4, 0, \
        "above 0: pools bend normals with this strength, not the mesh")

#define TP_ROW_LAYER(n, help) \
    TP_ROW_MAP("layer" #n, layer[n].map, 8, help), \
    TP_ROW_NUMBER("layer" #n ".saturation", layer[n].saturation, "", 0, 4, 1, \
        "0: grey; 1: the PNG's own colours"), \
    TP_ROW_NUMBER("layer" #n ".clamp", layer[n].clamp, "", 0, 0.95, 0, \
        "darker texels turn black, brighter texels fill the whole range"), \
    TP_ROW_COLOUR("layer" #n ".colour", layer[n].colour, 0xffffff, \
        "colour that multiplies the layer")

#define TP_LAYERS_ROWS \
    TP_ROW_LAYER(0, "PNG over the water; empty: none"), \
    TP_ROW_LAYER(1, "PNG added to the first; empty: none"), \
    TP_ROW_LAYER(2, "PNG added to the first; empty: none"), \
    TP_ROW_MAP("distortion", distortion.map, 8, \
        "PNG whose red and green shift the layers; empty: none"), \
    TP_ROW_NUMBER("distortion.strength", distortion.strength, "m", 0, 20, 0.5, \
        "greatest shift of the layers")

#define TP_RIPPLE_ROWS \
    TP_ROW_MAP("ripple", ripple.map, 4, \
        "PNG normal map of capillary waves; empty: none"), \
    TP_ROW_NUMBER("ripple.bump", ripple.bump, "", 0, 4, 1, \
        "strength of ripples; 1: as steep as the PNG says")

/* -- baked textures ------------------------------------------------------------------ */

/* Bakes the textures of fast shading in advance, for storage in ROM.  Index i:
 * assets.baked_layer by the layer, then baked_offset, then baked_slope.
 * tp_baked_layer_bytes returns 0 if the scene has no such texture.  Memory is aligned
 * to 4. */
#define TP_BAKED_LAYERS (TP_LAYERS + 2)
size_t tp_baked_layer_bytes(const tp_assets *assets, int i);
void tp_bake_layer(tp_texture *to, const tp_scene *scene, const tp_assets *assets, int i,
                   void *memory);

#endif
