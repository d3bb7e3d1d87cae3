/* SPDX-License-Identifier: MIT */
/*
 * A single wave over a depth, under wind, on a beach: [B1]-[B10], [B14], [B15] and [B20] of
 * the models, formula by formula; water_depth.c.
 *
 * Wave numbers are rad/m in Q31.32 (`_q32`), depths are metres in 16.16.  A wave keeps its
 * period: the functions identify a wave by k_inf, its wave number in deep water, omega^2 /
 * g = 2 pi / L_inf.
 *
 * All functions accept any input.  The stated errors hold for k_inf of 2 pi / 2000 to 2 pi
 * / 0.25 rad/m and depths of 1/65536 m and more.  A depth of 0 or less is dry land: wave
 * numbers, speeds, Ks and regimes are then the values at 1/16 m [B13], heights are 0.  For
 * k_inf of 0 or less k is 0.
 */
#ifndef TP_WAVES_WATER_DEPTH_H
#define TP_WAVES_WATER_DEPTH_H
#include <stdint.h>
#include "fixed/arithmetic.h"

#define TP_DEPTH_LEAST TP_FX(0.0625)    /* m; a smaller depth counts as 1/16 m [B13] */

/* -- length and speed ---------------------------------------------------------------- */

/* Returns 2 pi / length, rounded to nearest; a length below 1/64 m counts as 1/64 m. */
int64_t tp_depth_wave_number_deep(tp_fx length);

/* Solve k tanh(kh) = k_inf for k [B2], by four methods.  Worst relative errors:
 *   Eckart [B4] 4.98 %;  Fenton and McKee [B5] 1.63 %;
 *   Eckart and one Newton step [B6], the usual one, 0.051 %;
 *   three steps, for tables: 2^-26 and half a unit of Q31.32 (2^-24.7 at 2000 m). */
int64_t tp_depth_wave_number_eckart(int64_t k_inf_q32, tp_fx depth);
int64_t tp_depth_wave_number_fenton(int64_t k_inf_q32, tp_fx depth);
int64_t tp_depth_wave_number(int64_t k_inf_q32, tp_fx depth);
int64_t tp_depth_wave_number_exact(int64_t k_inf_q32, tp_fx depth);

/* Regime [B1] by depth / local wave length: deep from 1/2 on, shallow up to 1/20. */
typedef enum { TP_DEPTH_SHALLOW, TP_DEPTH_TRANSITION, TP_DEPTH_DEEP } tp_depth_regime;
tp_depth_regime tp_depth_classify(int64_t k_q32, tp_fx depth);

/* Phase speed c = sqrt(g k_inf) / k [B3] and group speed [B7], m/s; both
 * saturate.  k <= 0 gives 0. */
tp_fx tp_depth_speed(int64_t k_inf_q32, int64_t k_q32, tp_fx gravity);
tp_fx tp_depth_group_speed(int64_t k_inf_q32, int64_t k_q32, tp_fx depth, tp_fx gravity);

/* -- height -------------------------------------------------------------------------- */

/* Shoaling factor Ks = sqrt(c_inf / 2 cg) [B7]: 0.913 at the least, 48 for 2000 m waves at
 * 1/65536 m; 1 if a wave number is 0.  Error below 2^-16 + 2^-24 Ks. */
tp_fx tp_depth_shoaling_factor(int64_t k_inf_q32, int64_t k_q32, tp_fx depth);

/* Refraction factor Kr = sqrt(cos th_inf / cos th) [B7] of a wave with the wave number kz
 * along the shore [B9].  Grazing waves are bounded: no cosine counts as less than 1/16
 * (86.4 degrees).  A k at or above k_inf gives 1/4..1, any other k up to 4. */
tp_fx tp_depth_refraction_factor(int64_t k_inf_q32, int64_t k_q32, int64_t k_shore_q32);

/* Returns A_inf Ks Kr, at most 0.39 of the depth [B15]; 0 on land. */
tp_fx tp_depth_amplitude(tp_fx amplitude, tp_fx ks, tp_fx kr, tp_fx depth);

/* -- wind [B10] ---------------------------------------------------------------------- */

/* Returns lambda max(0, D . W): the wind pushes only waves with a component along the
 * wind. */
tp_fx tp_wind_lambda(tp_fx lambda, tp_q30 wind_cosine);

/* tp_wind_phase_shift returns lambda r, Q2.30, clamped to +-0.5.  tp_wind_iterations
 * returns the number of iterations for a shift: 1, or 3 for |shift| above 0.3. */
tp_q30 tp_wind_phase_shift(tp_fx lambda, tp_fx orbit_radius);
int    tp_wind_iterations(tp_q30 shift);

/* Solves Phi = theta + shift cos Phi, starting from Phi = theta.  After n iterations the
 * error is at most |shift|^(n+1).  The shift is clamped to +-0.5 here too. */
tp_turn tp_wind_phase(tp_turn theta, tp_q30 shift, int iterations);

/* Returns the largest radius without a loop, 0.95 / sqrt(k^2 + lambda^2), saturated.  Valid
 * for one wave under wind alone; coastal water bounds the sum of all waves. */
tp_fx tp_wind_max_radius(int64_t k_q32, tp_fx lambda);

/* -- breaking ------------------------------------------------------------------------ */

enum {
    TP_BREAKING_STEEP = 1,  /* H / L > 1/7 [B14] */
    TP_BREAKING_DEPTH = 2,  /* H / h > 0.78 [B15] */
    TP_BREAKING_MICHE = 4,  /* H > 0.142 L tanh(kh) [B14] */
};
uint32_t tp_breaking_flags(tp_fx height, int64_t k_q32, tp_fx depth);

/* Returns Miche's limit 0.142 L tanh(kh), m; saturates; 0 on land. */
tp_fx tp_miche_height(int64_t k_q32, tp_fx depth);

/* Returns the Iribarren number xi0 = slope / sqrt(H0 / L0) [B20] from the height and length
 * in deep water.  Saturates: a height of 0 gives a surging breaker.  Returns 0 for a slope
 * or length of 0 or less. */
tp_fx tp_iribarren(tp_q30 slope, tp_fx height, tp_fx length);

typedef enum { TP_BREAKER_SPILLING, TP_BREAKER_PLUNGING, TP_BREAKER_SURGING }
    tp_breaker_type;
tp_breaker_type tp_breaker_classify(tp_fx iribarren);

#endif
