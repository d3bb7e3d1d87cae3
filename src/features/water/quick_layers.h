/* SPDX-License-Identifier: MIT */
/* Textures of fast shading: a frame's data.
 *
 * All work that is the same in every frame is done once per texel, in all mipmap levels.
 * A span stage then reads the nearest texel and adds it.
 *  - graded:  a layer's texels with saturation, clamp, colour and, in the base layer, the
 *             water's colour; 0x00RRGGBB
 *  - offsets: the distortion's s:t in 16-bit halves, displacement in 1/1024 m
 *  - slopes:  the ripple's x:z in 16-bit halves, Q3.12
 * A baked texture is square, with a side of 2..256.  Smaller sides are stretched; the
 * finest levels of larger sides are left out.  The level of one texel is not used. */
#ifndef TP_WATER_QUICK_LAYERS_H
#define TP_WATER_QUICK_LAYERS_H
#include "shade/layer.h"
#include "tidepool/modules.h"

#define TP_QUICK_LOG2 8         /* log2 of the longest side */
#define TP_QUICK_LAYERS 3

/* A baked texture in the form read by the loops; see tp_layer. */
typedef struct {
    uint32_t per_metre, drift_s, drift_t;
    int32_t  lod;
    int32_t  last;              /* last level in use */
    uint32_t log2;              /* log2 of the side of level 0 */
    const uint32_t *const *level;       /* NULL: no texture */
} tp_quick_map;

typedef struct {
    tp_quick_map layer[TP_QUICK_LAYERS], bend, ripple;
} tp_quick_layers;

/* Returns the map of a layer; its texture is baked, or NULL. */
tp_quick_map tp_quick_map_make(const tp_layer *layer);

/* -- baking, at a frame's init or beforehand for textures in ROM --------------------- */

/* Returns the size of the baked texture in bytes; memory is aligned to 4. */
size_t tp_quick_bytes(const tp_texture *from);

/* Bake a texture into `mem`.  The base layer's colour is the water's colour times its
 * own. */
void tp_quick_graded(tp_texture *to, const tp_texture *from, tp_fx saturation, tp_fx clamp,
                     uint32_t colour, void *mem);
void tp_quick_offsets(tp_texture *to, const tp_texture *from, tp_fx strength, void *mem);
void tp_quick_slopes(tp_texture *to, const tp_texture *from, tp_fx bump, void *mem);
#endif
