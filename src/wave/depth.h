/* SPDX-License-Identifier: MIT */
/* One wave over a depth, under wind, on a beach: [B1]-[B10], [B14], [B15] and [B20] of
 * the models, formula by formula.
 *
 * Wave numbers are rad/m as Q31.32 (`_q32`), depths 16.16 metres.  A wave keeps its
 * period, so it is named by k_inf, its wave number on deep water: omega^2 / g = 2 pi /
 * L_inf.
 *
 * All functions take any input.  They keep their stated errors for k_inf of 2 pi / 2000
 * to 2 pi / 0.25 rad/m and depths of 1/65536 m and more.  A depth of 0 or less is dry:
 * wave numbers, speeds, Ks and regimes are then those at 1/16 m [B13], heights are 0.
 * The k of a k_inf of 0 or less is 0. */
#ifndef TP_WAVE_DEPTH_H
#define TP_WAVE_DEPTH_H
#include <stddef.h>
#include <stdint.h>
#include "fx/fx.h"

#define TP_DEPTH_LEAST TP_FX(0.0625)    /* m; what is shallower counts as this [B13] */

/* -- length and speed ---------------------------------------------------------------- */

/* 2 pi / length, to half a unit; a length below 1/64 m counts as 1/64. */
int64_t tp_depth_number_deep(tp_fx length);

/* k of k tanh(kh) = k_inf [B2], by four methods; worst relative errors:
 *   Eckart [B4] 4.98 %;  Fenton and McKee [B5] 1.63 %;
 *   Eckart and one Newton step [B6], the usual one, 0.051 %;
 *   three steps, for tables: 2^-26 and half a unit of Q31.32 (2^-24.7 at 2000 m). */
int64_t tp_depth_number_eckart(int64_t k_inf_q32, tp_fx depth);
int64_t tp_depth_number_fenton(int64_t k_inf_q32, tp_fx depth);
int64_t tp_depth_number(int64_t k_inf_q32, tp_fx depth);
int64_t tp_depth_number_exact(int64_t k_inf_q32, tp_fx depth);

/* [B1], by the depth in lengths of the wave there: deep from 1/2, shallow to 1/20. */
typedef enum { TP_DEPTH_SHALLOW, TP_DEPTH_TRANSITION, TP_DEPTH_DEEP } tp_depth_regime;
tp_depth_regime tp_depth_regime_of(int64_t k_q32, tp_fx depth);

/* Of crests, c = sqrt(g k_inf) / k [B3], and of wave groups [B7], m/s; both saturate,
 * k <= 0 gives 0. */
tp_fx tp_depth_speed(int64_t k_inf_q32, int64_t k_q32, tp_fx gravity);
tp_fx tp_depth_group_speed(int64_t k_inf_q32, int64_t k_q32, tp_fx depth, tp_fx gravity);

/* -- height -------------------------------------------------------------------------- */

/* Ks = sqrt(c_inf / 2 cg) [B7]: 0.913 at the least, 48 for 2000 m at 1/65536 m; 1 where a
 * wave number is 0.  Within 2^-16 + 2^-24 Ks. */
tp_fx tp_depth_shoaling(int64_t k_inf_q32, int64_t k_q32, tp_fx depth);

/* Kr = sqrt(cos th_inf / cos th) [B7] of a wave whose number along the shore is kz [B9].
 * Grazing waves are bounded: no cosine counts as less than 1/16 (86.4 degrees), so a k at
 * or above k_inf gives 1/4..1 and any other up to 4. */
tp_fx tp_depth_refraction(int64_t k_inf_q32, int64_t k_q32, int64_t kz_q32);

/* A_inf Ks Kr, no more than 0.39 of the depth [B15]; 0 on land. */
tp_fx tp_depth_amplitude(tp_fx amplitude, tp_fx ks, tp_fx kr, tp_fx depth);

/* -- the phase over a straight coast -------------------------------------------------
 *
 * For any place, to 3e-4 rad: tidepool check holds the tables of [B8] against it.  The
 * ocean has tables of its own, by depth (ocean.h). */

/* h(x) = max(least, depth - slope x), x towards the shore. */
typedef struct {
    int64_t k_inf_q32;      /* 0..1024 rad/m, held there */
    int64_t kz_q32;         /* along the shore: k_inf sin th_inf, of either sign; held
                               within k_inf, where the wave grazes */
    tp_fx   depth;          /* m at x = 0 */
    tp_q30  slope;          /* 0..1; less is 0, a level floor */
    tp_fx   least;          /* m; less than 1/16 is 1/16 */
    tp_fx   x_from, x_to;   /* m; beyond them the depth of the end goes on */
} tp_coast_shape;

typedef struct {
    tp_turn  part;          /* the phase ... */
    int32_t  turns;         /* ... and its whole turns */
    uint32_t rise;          /* turns per node there, Q0.32 */
} tp_coast_node;

/* int_0^x sqrt(k(x)^2 - kz^2) dx [B8] [B9] as a table, whose nodes follow this head.
 * Plain data, no pointers. */
typedef struct {
    tp_fx    x_first, x_last;   /* between them the table, outside of them straight on */
    uint32_t bits;              /* nodes are 2^bits units of 2^-16 m apart */
    uint32_t count;             /* of nodes: none, or two and more */
    int64_t  first, last;       /* turns there, Q32.32 */
    int64_t  rise_first, rise_last;     /* turns per metre outside, Q31.32 */
} tp_coast;

/* Of the block for a shape, aligned to 8; nodes are a 16th of the shortest wave apart or
 * closer, 12 bytes each.  There are none where the wave is deep and behind the beach. */
size_t tp_coast_bytes(const tp_coast_shape *shape);
void   tp_coast_init(tp_coast *coast, const tp_coast_shape *shape);

/* Turns as Q32.32; the low half is a tp_turn.  0 at x = 0. */
int64_t tp_coast_phase(const tp_coast *coast, tp_fx x);

/* -- wind [B10] ---------------------------------------------------------------------- */

/* lambda max(0, D . W): only what travels with the wind is pushed by it. */
tp_fx tp_wind_lambda(tp_fx lambda, tp_q30 along);

/* lambda r, Q2.30, held within +-0.5; and how often to iterate: 1, or 3 above 0.3. */
tp_q30 tp_wind_push(tp_fx lambda, tp_fx radius);
int    tp_wind_iterations(tp_q30 push);

/* Phi = theta + push cos Phi from Phi = theta; after n iterations within |push|^(n+1) of
 * the root.  The push is held within +-0.5 here too. */
tp_turn tp_wind_phase(tp_turn theta, tp_q30 push, int iterations);

/* The largest radius without a loop, 0.95 / sqrt(k^2 + lambda^2), saturated.  For one
 * wave under wind alone; the ocean bounds the sum of all. */
tp_fx tp_wind_radius(int64_t k_q32, tp_fx lambda);

/* -- breaking ------------------------------------------------------------------------ */

enum {
    TP_BREAKING_STEEP = 1,  /* H / L > 1/7 [B14] */
    TP_BREAKING_DEPTH = 2,  /* H / h > 0.78 [B15] */
    TP_BREAKING_MICHE = 4,  /* H > 0.142 L tanh(kh) [B14] */
};
uint32_t tp_breaking_flags(tp_fx height, int64_t k_q32, tp_fx depth);

/* 0.142 L tanh(kh), m; saturates; 0 on land. */
tp_fx tp_miche_height(int64_t k_q32, tp_fx depth);

/* xi0 = slope / sqrt(H0 / L0) [B20] of deep water's height and length; saturates, so that
 * a height of 0 surges; 0 for a slope or length of 0 or less. */
tp_fx tp_iribarren(tp_q30 slope, tp_fx height, tp_fx length);

typedef enum { TP_BREAKER_SPILLING, TP_BREAKER_PLUNGING, TP_BREAKER_SURGING }
    tp_breaker_type;
tp_breaker_type tp_breaker_type_of(tp_fx iribarren);
#endif
