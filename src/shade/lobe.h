/* SPDX-License-Identifier: MIT */
/* Argument of the table of a specular lobe: R.V for Phong, 2 (N.H)^2 - 1 for Blinn, the
 * same angle for the same mirrored light.
 *
 * H is L + V normalised, and |L + V|^2 = 2 + 2 L.V.  Hence (N.H)^2 = (N.L + N.V)^2 / (2 +
 * 2 L.V): no vector and no root, only a reciprocal [F5]. */
#ifndef TP_SHADE_LOBE_H
#define TP_SHADE_LOBE_H
#include "shade/shade.h"

/* All arguments and the result are Q1.14.  The square of the sum is below 2^30, the
 * reciprocal at most 2^32.  Where L is nearly -V (light from straight behind) hardly any
 * half vector exists; a result beyond the lobe's peak is clamped to the peak. */
TP_ALWAYS_INLINE int32_t tp_blinn_cosine(int32_t nl, int32_t nv, int32_t lv)
{
    uint32_t sum = (uint32_t)tp_clamp(nl + nv, 0, 32767);
    uint32_t w = (uint32_t)tp_clamp(16384 + lv, 2, 32768);
    int      up = tp_clz(w);
    uint64_t square = (uint64_t)(sum * sum) * tp_recip_norm(w << up) >> (63 - up);

    return square < 32768 ? (int32_t)square - 16384 : 16384;
}

TP_ALWAYS_INLINE int32_t tp_lobe_cosine(int32_t nl, int32_t nv, int32_t lv, int blinn)
{
    return blinn ? tp_blinn_cosine(nl, nv, lv) : (2 * nl * nv >> 14) - lv;
}
#endif
