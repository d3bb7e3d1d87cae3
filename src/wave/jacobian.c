/* SPDX-License-Identifier: MIT */
/* The Jacobian of the horizontal displacement: the horizontal compression of the
 * surface. */
#include "wave/wave.h"

/* Bends sum to at most 0.95: the sums fit Q30, and their products fit 64 bits. */
tp_fx tp_deep_water_jacobian(const tp_deep_water *deep, const tp_turn phases[TP_WAVES],
                             tp_fx x, tp_fx z)
{
    TP_ASSERT(deep->count <= TP_WAVES);
    int32_t bxx = 0, bxz = 0, bzz = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        if (w->bend == 0)
            continue;
        tp_q30 s = tp_sin(phases[i] + tp_swell_turns(w->turns_x, x)
                          + tp_swell_turns(w->turns_z, z));
        bxx += tp_q30_mul(w->bend_xx, s);
        bxz += tp_q30_mul(w->bend_xz, s);
        bzz += tp_q30_mul(w->bend_zz, s);
    }
    int64_t jxx = (int64_t)TP_Q30_ONE - bxx, jzz = (int64_t)TP_Q30_ONE - bzz;
    return (tp_fx)((jxx * jzz - (int64_t)bxz * bxz) >> 44);
}
