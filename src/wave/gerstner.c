/* SPDX-License-Identifier: MIT */
/* Gerstner waves, [A7]-[A10] of the models; steepness 0 gives plain sines [A1].
 *
 * Normals are the exact normals of [A10], as slopes:  N = (hz Jxz - hx Jzz, det, hx Jxz -
 * hz Jxx), and dy/dx = -Nx/Ny = (hx Jzz - hz Jxz) / det.  The clamp of [A11] keeps the
 * smallest eigenvalue of J at 0.05 or above: det > 0, and the quotient exists.  Gentle
 * seas, with tp_deep_water.crossed false, use N = (-hx, 1 - sum QkA sin th, -hz).  All
 * terms are evaluated at the rest point.  The form printed with the displaced point
 * inside the sine is a different, wrong surface ([A10]).
 *
 * Derivation of the error bounds of normals in wave.h.  Errors dh and dJ turn the
 * normal of the slopes g = J^-1 h by |J^-1 (dh - dJ g)| / sqrt(1 + g^2) <= hypot(|dh|,
 * |dJ|) / (1 - q).  Sine and cosine are too small by up to 4.71e-6 of their value and
 * are cut to Q24, and slopes are rounded to 16.16: 1.08e-5 both together.  For one
 * trochoid, J = 1 - S sin and h = S cos.  The error of the cosine has the factor h J /
 * (J^2 + h^2) <= 1/2, the error of the sine h S / (J^2 + h^2) <= S / 2 (1 - S);
 * together 2.36e-6 / (1 - S).  The error of the phase has the factor S / (1 - S), the
 * rate of turn of the normal on the crest. */
#include "wave/wave.h"

tp_surface_point tp_swell_sum_point(const tp_swell_sum *sum, tp_fx x0, tp_fx z0, tp_fx fade)
{
    return tp_swell_sum_point_as(sum, x0, z0, fade, 1);
}

TP_ALWAYS_INLINE tp_surface_point point_as(const tp_deep_water *deep,
                                           const tp_turn *phases, tp_fx x0, tp_fx z0,
                                           int sharpened, int crossed)
{
    tp_swell_sum sum = { 0 };

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        tp_turn th = phases[i] + tp_swell_turns(w->turns_x, x0)
                               + tp_swell_turns(w->turns_z, z0);
        tp_swell_add_as(&sum, w, th, sharpened, crossed);
    }
    return tp_swell_sum_point_as(&sum, x0, z0, TP_FX_ONE, crossed);
}

tp_surface_point tp_deep_water_displace_point(const tp_deep_water *deep,
                                              const tp_turn phases[TP_WAVES], tp_fx x0,
                                              tp_fx z0)
{
    TP_ASSERT(deep->count <= TP_WAVES);
    if (deep->sharpened)
        return deep->crossed ? point_as(deep, phases, x0, z0, 1, 1)
                             : point_as(deep, phases, x0, z0, 1, 0);
    return deep->crossed ? point_as(deep, phases, x0, z0, 0, 1)
                         : point_as(deep, phases, x0, z0, 0, 0);
}
