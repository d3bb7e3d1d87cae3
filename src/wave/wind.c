/* SPDX-License-Identifier: MIT */
/* Wind, [B10] of the models: crests run ahead of their phase, troughs lag behind, and the
 * front of a wave steepens.
 *
 * Phi = theta + lambda r cos Phi is a contraction by |lambda r|, iterated from theta.  The
 * source can also be read as a sum of (omega + lambda dy) dt over the ticks.  This reading
 * is not used: it slows waves down by their height and depends on history. */
#include "wave/water_depth.h"
#include "wave/exp.h"

#define PUSH_MOST       TP_Q30(0.5)
#define ITERATIONS_MOST 32              /* 2^-33 of the initial error is left */

tp_fx tp_wind_lambda(tp_fx lambda, tp_q30 along)
{
    return along <= 0 ? 0 : along >= TP_Q30_ONE ? lambda : tp_q30_mul(lambda, along);
}

/* Q32 to Q30. */
tp_q30 tp_wind_push(tp_fx lambda, tp_fx radius)
{
    return (tp_q30)tp_clamp_abs(((int64_t)lambda * radius + 2) >> 2, PUSH_MOST);
}

int tp_wind_iterations(tp_q30 push)
{
    return push > TP_Q30(0.3) || push < -TP_Q30(0.3) ? 3 : 1;
}

/* Returns turns of 2^-32: half a radian is 2^28.35. */
tp_turn tp_wind_phase(tp_turn theta, tp_q30 push, int iterations)
{
    const tp_q30 held = tp_clamp(push, -PUSH_MOST, PUSH_MOST);
    const int32_t turns = tp_q30_mul(TP_OVER_TWO_PI_Q32, held);
    const int n = iterations < ITERATIONS_MOST ? iterations : ITERATIONS_MOST;
    tp_turn phi = theta;

    for (int i = 0; i < n; i++)
        phi = theta + (tp_turn)tp_q30_mul(turns, tp_cos(phi));
    return phi;
}

tp_fx tp_wind_max_radius(int64_t k_q32, tp_fx lambda)
{
    const uint64_t l = (uint64_t)(lambda < 0 ? -(int64_t)lambda : lambda);
    const tp_scaled k = tp_scaled_from_wave_number(k_q32);
    const tp_scaled side = tp_scaled_from_fixed(l, 16);
    const tp_scaled sum = tp_scaled_add(tp_scaled_mul(k, k), tp_scaled_mul(side, side));

    if (sum.m == 0)
        return TP_FX_MAX;
    return tp_scaled_fx(tp_scaled_mul(tp_scaled_rsqrt(sum),
                                      tp_scaled_from_fixed((uint32_t)TP_Q30(0.95), 30)));
}
