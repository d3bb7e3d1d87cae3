/* SPDX-License-Identifier: MIT */
/* Phong or Blinn lighting of solids. */
#ifndef TP_SHADE_PHONG_H
#define TP_SHADE_PHONG_H
#include "shade/env.h"
#include "shade/lobe.h"
#include "shade/normal.h"

/* The specular lobe at R.V, interpolated between table entries: near the peak of a sharp
 * lobe neighbouring entries differ much. */
static inline uint32_t tp_gloss_lookup(const tp_solid *solid, int32_t rv)
{
    int32_t at = rv * (TP_GLOSS - 1), i = at >> 14, part = (at & 16383) >> 6;
    int32_t here = solid->gloss[i], next = solid->gloss[i + 1 < TP_GLOSS ? i + 1 : i];

    return (uint32_t)(here + ((next - here) * part >> 8));
}

/* Lit colour of a normal and a view vector in the given axes; lv is light . view. */
TP_ALWAYS_INLINE uint32_t tp_phong(const tp_shade *shade, const tp_view_axes *axes,
                                   const tp_solid *solid, uint32_t diffuse,
                                   tp_vec_q14 n, tp_vec_q14 v, int32_t lv, int blinn)
{
    tp_vec_q14 light = { axes->lx, axes->ly, axes->lz };
    int32_t nl = tp_clamp(tp_vec_q14_dot(n, light), 0, 16384);
    int32_t rv = tp_clamp(tp_lobe_cosine(nl, tp_vec_q14_dot(n, v), lv, blinn), 0, 16384);
    uint32_t bright = (uint32_t)tp_lit_share(shade->ambient, nl);
    uint32_t gloss = nl > 0 ? tp_gloss_lookup(solid, rv) : 0;
    uint32_t shine = tp_colour_times(solid->specular, shade->light_colour);

    return tp_colour_add(tp_colour_scale(diffuse, bright), tp_colour_scale(shine, gloss));
}
#endif
