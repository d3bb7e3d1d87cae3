/* SPDX-License-Identifier: MIT */
/* Elliptic orbits over a floor, [B11]-[B13] of the models: circles that flatten towards the
 * floor and tilt with the floor.
 *
 * Only a floor that rises along the direction of travel tilts the orbits: no wave breaks
 * backwards.  Sx grows without bound towards the shore.  The major axis is clamped to 0.95
 * / k, where the surface would fold into loops; Sy uses the ratio before the clamp. */
#include "wave/ocean_tables.h"
#include "wave/exp.h"

#define AXIS_MAX TP_FX(0.95)
#define R_MAX    TP_FX(64)      /* m; times Sx, 2^37 in 8.24: 59 bits */

static tp_fx clamp_depth(tp_fx depth)
{
    return depth < TP_DEPTH_LEAST ? TP_DEPTH_LEAST : depth;
}

uint32_t tp_orbit_depth_decay(tp_fx rate, tp_fx depth)
{
    const int64_t x = ((int64_t)(rate > 0 ? rate : 0) * clamp_depth(depth) + 0x80) >> 8;
    return x >= (int64_t)23 << 24 ? 0 : tp_exp_neg((uint32_t)x);
}

/* The exponentials are within 2^-30.  1 - e^-Kx h is at least 0.0068 with the usual rates
 * and has a relative error below 2^-22. */
tp_orbit_scale tp_orbit_scale_make(tp_fx depth, tp_fx kx, tp_fx ky)
{
    const int64_t one = (int64_t)1 << 32, most = (int64_t)1 << 37, two = 1 << 25;
    const int64_t lack_x = one - tp_orbit_depth_decay(kx, depth);
    const int64_t lack_y = one - tp_orbit_depth_decay(ky, depth);
    const int64_t x = ((one << 24) + lack_x / 2) / lack_x;
    const int64_t y = ((lack_y << 24) + lack_x / 2) / lack_x;

    return (tp_orbit_scale){ x < most ? x : most, y < two ? y : two };
}

tp_q30 tp_cos_of_sin(tp_q30 sin)
{
    TP_ASSERT(tp_abs(sin) <= TP_Q30_ONE);
    return (tp_q30)tp_isqrt64(((uint64_t)1 << 60) - (uint64_t)((int64_t)sin * sin));
}

/* Returns 0.95 / k, saturated. */
static tp_fx axis_most(int64_t k_q32)
{
    if (k_q32 <= 0)
        return TP_FX_MAX;
    const int64_t most = ((int64_t)AXIS_MAX << 32) / k_q32;
    return tp_fx_saturate(most);
}

tp_ellipse tp_orbit_ellipse(tp_fx r, tp_fx depth, tp_turn gamma, int64_t k_q32, tp_fx k0,
                            tp_fx kx, tp_fx ky)
{
    const tp_fx most = axis_most(k_q32);
    const tp_fx held = tp_clamp(r, 0, most < R_MAX ? most : R_MAX);
    const tp_orbit_scale s = tp_orbit_scale_make(depth, kx, ky);
    const int64_t half = 1 << 23;
    const int64_t along = (held * s.x_q24 + half) >> 24;
    const tp_q30 rise = tp_sin(gamma);
    const tp_q30 fall = (tp_q30)((tp_orbit_depth_decay(k0, depth) + (uint64_t)2) >> 2);
    const tp_q30 sin = rise > 0 ? tp_q30_mul(rise, fall) : 0;

    return (tp_ellipse){
        .along = along < most ? (tp_fx)along : most,
        .up = (tp_fx)((held * s.y_q24 + half) >> 24),
        .sin = sin, .cos = tp_cos_of_sin(sin),
    };
}

tp_offset tp_orbit_evaluate(const tp_ellipse *orbit, tp_turn phi)
{
    return tp_orbit_offset(orbit, phi);
}
