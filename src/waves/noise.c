/* SPDX-License-Identifier: MIT */
/* The noise that makes breaking crests irregular: value noise in integers.  A hash of the
 * grid coordinates gives heights at grid points, and smoothsteps interpolate. */
#include "waves/coastal_tables.h"

#define V_CELLS 8

/* Two rounds of multiply and shift after Wang.  Only the high bits need to be well
 * mixed. */
static tp_fx hash_height(uint32_t u, uint32_t v, uint32_t seed)
{
    uint32_t h = (u & 0xffff) * 0x9e3779b1u ^ (v % V_CELLS) * 0x85ebca77u ^ seed;

    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (tp_fx)(h >> 15) - TP_FX_ONE;        /* 17 bits: -1..1 */
}

tp_fx tp_noise(uint32_t u_q16, uint32_t v_q16, uint32_t seed)
{
    const uint32_t u = u_q16 >> 16, v = v_q16 >> 16;
    const tp_fx s = tp_smoothstep((tp_fx)(u_q16 & 0xffff));
    const tp_fx t = tp_smoothstep((tp_fx)(v_q16 & 0xffff));
    const tp_fx near =
        tp_coastal_mix(hash_height(u, v, seed), hash_height(u + 1, v, seed), s);
    const tp_fx far =
        tp_coastal_mix(hash_height(u, v + 1, seed), hash_height(u + 1, v + 1, seed), s);
    return tp_coastal_mix(near, far, t);
}
