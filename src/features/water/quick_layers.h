/* SPDX-License-Identifier: MIT */
/* The quick rung's pictures: what a frame says of them.
 *
 * Whatever can be worked out once for a picture is: it is prepared texel by texel, all of
 * its levels, and a stage takes the nearest texel and adds it.
 *  - graded:  a layer's texels with saturation, clamp, colour and, of the first layer, the
 *             water's colour; 0x00RRGGBB
 *  - offsets: the distortion's, s:t in halves, how far a place is moved, in 1/1024 m
 *  - slopes:  the ripple's, x:z in halves, Q3.12
 * A prepared picture is square, of a side of 2..256; smaller sides are stretched, of
 * larger ones the finest levels are left out.  Its level of one texel is not used. */
#ifndef TP_WATER_QUICK_LAYERS_H
#define TP_WATER_QUICK_LAYERS_H
#include "shade/layer.h"
#include "tidepool/modules.h"

#define TP_QUICK_LOG2 8         /* of the longest side */
#define TP_QUICK_LAYERS 3

/* A prepared picture as a loop looks into it; see tp_layer. */
typedef struct {
    uint32_t per_metre, drift_s, drift_t;
    int32_t  lod;
    int32_t  last;              /* level that is used */
    uint32_t log2;              /* of the side of level 0 */
    const uint32_t *const *level;       /* NULL: it is not there */
} tp_quick_map;

typedef struct {
    tp_quick_map layer[TP_QUICK_LAYERS], bend, ripple;
} tp_quick_layers;

/* The map of a layer; its texture is prepared, or NULL. */
tp_quick_map tp_quick_map_of(const tp_layer *layer);

/* -- preparing: when a frame is made, or beforehand by whoever puts pictures in ROM ----- */

/* Of the prepared picture; 4-byte words. */
size_t tp_quick_bytes(const tp_texture *from);

/* The first layer's colour is the water's times its own. */
void tp_quick_graded(tp_texture *to, const tp_texture *from, tp_fx saturation, tp_fx clamp,
                     uint32_t colour, void *mem);
void tp_quick_offsets(tp_texture *to, const tp_texture *from, tp_fx strength, void *mem);
void tp_quick_slopes(tp_texture *to, const tp_texture *from, tp_fx bump, void *mem);
#endif
