/* SPDX-License-Identifier: MIT */
/* Depth of a sample from its key, and the mipmap level of a picture at that depth. */
#ifndef TP_SHADE_DEPTH_H
#define TP_SHADE_DEPTH_H
#include "geom/geom.h"
#include "shade/shade.h"

/* Returns log2(n) of n != 0, Q8, within 1/12: the exponent by clz, the fraction from the
 * next eight bits. */
static inline int32_t tp_log2_q8(uint32_t n)
{
    int shift = tp_clz(n);
    return (31 - shift) * 256 + (int32_t)((n << shift) >> 23 & 0xff);
}

/* Inverse depth of a sample: near plane / depth, Q1.31.  The low bits keep the sample's
 * mark; they are below the precision.  The result is never 0. */
static inline uint32_t tp_key_zi(uint32_t key)
{
    return key >> 1 | 0x80;
}

/* Returns the depth for zi != 0 in m, 16.16, within a relative error of 2^-16. */
static inline int64_t tp_depth_from_zi(tp_fx zi_near, uint32_t zi)
{
    int shift = tp_clz(zi);
    return (int64_t)zi_near * tp_recip_rough(zi << shift) >> (31 - shift);
}

/* Returns log2 of the depth in metres, Q8. */
static inline int32_t tp_log_depth(const tp_shade *shade, uint32_t key)
{
    return shade->zi_log - tp_log2_q8(tp_key_zi(key));
}

/* Mipmap level at a depth, from `lod`, the texture's level at 1 m; Q8.  On upright
 * surfaces texels per pixel grow in proportion to the depth.  On level ground they grow in
 * proportion across the view and by the square along the view; the geometric mean
 * counts. */
static inline int32_t tp_mip_level_choose(int32_t lod, int32_t log_depth, bool ground,
                                          int levels)
{
    int32_t level = lod + log_depth + (ground && log_depth > 0 ? log_depth / 2 : 0);
    return tp_clamp(level >> 8, 0, levels - 1);
}
#endif
