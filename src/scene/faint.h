/* SPDX-License-Identifier: MIT */
/* Waves too faint to be seen, which need not be drawn. */
#ifndef TP_SCENE_FAINT_H
#define TP_SCENE_FAINT_H
#include "wave/wave.h"

#define TP_FAINT_SHARE 4        /* of the budget one part in so many is theirs */

/* Where a wave begins to be seen: by its height at the nearest water, by its slope. */
typedef struct {
    tp_fx   px;
    tp_fx   slope;              /* k A */
    int32_t focal;              /* pixels of a metre, a metre away */
    tp_fx   near;               /* m to the nearest water in view; > 0 */
} tp_faint_limits;

typedef struct {
    uint32_t left;              /* waves that are drawn */
    bool     any;               /* some wave is fainter than it is, or gone */
    tp_fx    px, colour;        /* errors that this makes, all waves together */
} tp_faint;

/* `waves` with amplitudes; slope_colour: rms of 255 that slopes of rms 1 make, 0: not
 * known, and no wave is faint. */
tp_faint_limits tp_faint_limits_of(const tp_scene *scene, uint32_t waves,
                                   tp_fx slope_colour);

/* The nearest water that a camera sees, so high above its crests: where its lowest ray
 * meets them. */
tp_fx tp_faint_near(tp_fx height, const tp_rotation *turn, tp_fx fov);

/* Share of its height that a wave is drawn with, 0..1: nothing where both limits are not
 * reached, all of it from twice one of them.  So it neither comes nor goes at once. */
tp_fx tp_faint_weight(const tp_faint_limits *limits, tp_fx amplitude, tp_fx slope);

tp_faint tp_faint_of(const tp_scene *scene, const tp_faint_limits *limits,
                     tp_fx slope_colour);

/* The sea that is drawn, without what is not seen; returns false, and writes nothing, if
 * that is the whole.  Bounds stay the whole's. */
bool tp_faint_sea(tp_sea *thin, tp_turn thin_phases[TP_WAVES], const tp_sea *whole,
                  const tp_turn phases[TP_WAVES], const tp_faint_limits *limits);
#endif
