/* SPDX-License-Identifier: MIT */
/* Where in its table a lobe is looked up: Phong's at R.V, Blinn's at 2 (N.H)^2 - 1, the
 * same angle for one and the same mirrored light.
 *
 * H is L + V made a unit, and |L + V|^2 = 2 + 2 L.V.  So (N.H)^2 = (N.L + N.V)^2 /
 * (2 + 2 L.V): neither vector nor root, only a reciprocal [F5]. */
#ifndef TP_SHADE_LOBE_H
#define TP_SHADE_LOBE_H
#include "shade/shade.h"

/* All Q1.14.  The sum's square is below 2^30, the reciprocal 2^32; without a half vector
 * (light from behind what is seen through) the lobe is at its middle. */
TP_ALWAYS_INLINE int32_t tp_blinn_at(int32_t nl, int32_t nv, int32_t lv)
{
    uint32_t sum = (uint32_t)tp_clamp(nl + nv, 0, 32767);
    uint32_t w = (uint32_t)tp_clamp(16384 + lv, 2, 32768);
    int      up = tp_clz(w);
    uint64_t square = (uint64_t)(sum * sum) * tp_recip_norm(w << up) >> (63 - up);

    return square < 32768 ? (int32_t)square - 16384 : 16384;
}

TP_ALWAYS_INLINE int32_t tp_lobe_at(int32_t nl, int32_t nv, int32_t lv, int blinn)
{
    return blinn ? tp_blinn_at(nl, nv, lv) : (2 * nl * nv >> 14) - lv;
}
#endif
