/* SPDX-License-Identifier: MIT */
/* How far away a sample lies, as its key tells; and which level of a picture is seen so
 * far away. */
#ifndef TP_SHADE_DEPTH_H
#define TP_SHADE_DEPTH_H
#include "geom/geom.h"
#include "shade/shade.h"

/* log2 of n != 0 in Q8, to 1/12: clz and the next eight bits taken as they are. */
static inline int32_t tp_log2_q8(uint32_t n)
{
    int shift = tp_clz(n);
    return (31 - shift) * 256 + (int32_t)((n << shift) >> 23 & 0xff);
}

/* 1 / depth of a sample, in near planes, Q1.31; its kind is left in the low bits, which
 * do not count, and it is never 0. */
static inline uint32_t tp_key_zi(uint32_t key)
{
    return key >> 1 | 0x80;
}

/* The depth that zi != 0 stands for: 16.16 m, within 2^-16 of it. */
static inline int64_t tp_depth_of(tp_fx zi_near, uint32_t zi)
{
    int shift = tp_clz(zi);
    return (int64_t)zi_near * tp_recip_rough(zi << shift) >> (31 - shift);
}

/* log2 of the depth in metres, Q8. */
static inline int32_t tp_log_depth(const tp_shade *shade, uint32_t key)
{
    return shade->zi_log - tp_log2_q8(tp_key_zi(key));
}

/* The level for `lod`, that of a texture seen at 1 m, at another depth; Q8.  Upright
 * things get texels a pixel in proportion to the depth; level ground gets them across
 * so and along by its square, of which the mean counts. */
static inline int32_t tp_level_of(int32_t lod, int32_t log_depth, bool ground, int levels)
{
    int32_t level = lod + log_depth + (ground && log_depth > 0 ? log_depth / 2 : 0);
    return tp_clamp(level >> 8, 0, levels - 1);
}
#endif
