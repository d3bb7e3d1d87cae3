/* SPDX-License-Identifier: MIT */
/* Wave culling: finds waves too small to be visible, to be omitted or drawn lower. */
#ifndef TP_QUALITY_WAVE_CULLING_H
#define TP_QUALITY_WAVE_CULLING_H
#include "waves/deep_water.h"

#define TP_WAVE_CULL_SHARE 4        /* part of the error budget for wave culling, 1/4 */

/* Visibility thresholds of a wave: `px` for its height at the nearest water in pixels,
 * `slope` for its slope.  The other fields convert a height from metres to pixels. */
typedef struct {
    tp_fx   px;
    tp_fx   slope;              /* slope k A */
    int32_t focal;              /* size in px of 1 m at a distance of 1 m */
    tp_fx   near;               /* distance to the nearest water in view, m; > 0 */
} tp_wave_cull_limits;

typedef struct {
    uint32_t left;              /* number of waves drawn */
    bool     any;               /* true if a wave is drawn lower or omitted */
    tp_fx    px, colour;        /* errors caused by culling, all waves together */
} tp_wave_cull;

/* `waves`: number of waves with an amplitude.  `slope_colour`: rms colour error (of 255)
 * caused by slopes of rms 1; 0 means unknown, and no wave is culled. */
tp_wave_cull_limits tp_wave_cull_limits_make(const tp_scene *scene, uint32_t waves,
                                             tp_fx slope_colour);

/* Returns the distance to the nearest water in view, for a camera `height` m above the
 * crests: the point where the lowest ray of the view meets the crest level. */
tp_fx tp_nearest_water_distance(tp_fx height, const tp_rotation *turn, tp_fx fov);

/* Returns the factor, 0..1, for the height of a drawn wave.  The factor is 0 if both
 * height and slope are below their limits, and 1 if either is at least twice its limit.
 * The ramp between the limits prevents sudden appearance or disappearance. */
tp_fx tp_wave_cull_weight(const tp_wave_cull_limits *limits, tp_fx amplitude, tp_fx slope);

tp_wave_cull tp_wave_cull_evaluate(const tp_scene *scene, const tp_wave_cull_limits *limits,
                           tp_fx slope_colour);

/* Writes the culled deep water and its phases to `culled` and `culled_phases`.
 * Returns false and writes nothing if no wave is culled.  The bounds in `culled` stay
 * the bounds of `whole`. */
bool tp_wave_cull_deep_water(tp_deep_water *culled, tp_turn culled_phases[TP_WAVES],
                             const tp_deep_water *whole, const tp_turn phases[TP_WAVES],
                             const tp_wave_cull_limits *limits);
#endif
