/* SPDX-License-Identifier: MIT */
/*
 * Rough water: the slope variance of waves that the drawn surface does not show, for the
 * light (MODELS V).  A wave of amplitude A and wave number k that a grid row keeps by a
 * weight w of 0..1 leaves (k A)^2 (1 - w^2) / 2 along its direction: times the squared
 * cosine of the angle to the axis, for each of the two axes.  What a row keeps is drawn by
 * normals interpolated between vertices, whose mean square is less by (2 + cos k d) / 3 for
 * a spacing d, along and across: that loss counts too.
 *
 * Rows of a grid lie across the heading; the variance is stored by the logarithm of the
 * view depth, so a sample finds it by its key alone, in any tile and by any renderer.
 *
 * Use: tp_filtered_waves_clear, then tp_filtered_waves_add_row from near to far, then
 * tp_filtered_waves_finish, before any tile is drawn.
 */
#ifndef TP_VIEW_ROUGH_H
#define TP_VIEW_ROUGH_H
#include <stdbool.h>
#include <stdint.h>
#include "base/base.h"
#include "fixed/arithmetic.h"

/* Variance of slopes, rise over run, Q24: along the camera's heading, and across it.
 * left: the part, both axes together, of waves that weights take away; the rest is the loss
 * of linear interpolation between vertices.  At most 2^24 each. */
typedef struct {
    uint32_t along, across, left;
} tp_slope_variance;

#define TP_ROUGH_ONE   (1u << 24)       /* variance of 1, the largest */
#define TP_ROUGH_FIRST (-2 * 256)       /* log2 of the depth at entry 0, 1/4 m; Q8 */
#define TP_ROUGH_STEP  64               /* log2 of the depth between entries, Q8 */
#define TP_ROUGH_STEPS 64               /* steps up to 16 km */

typedef struct tp_filtered_waves {
    tp_slope_variance at[TP_ROUGH_STEPS + 1];
    tp_slope_variance last;             /* of the row added last */
    int32_t  last_log;                  /* log2 of its depth, Q8 */
    uint32_t filled;                    /* entries that are final */
    bool     has_row;
} tp_filtered_waves;

void tp_filtered_waves_clear(tp_filtered_waves *waves);

/* Adds a row at a view depth, m, at least as far as the row before.  Entries between two
 * rows are interpolated by the logarithm of the depth; entries nearer than the first row
 * take the first row's variance. */
void tp_filtered_waves_add_row(tp_filtered_waves *waves, tp_fx depth,
                               tp_slope_variance variance);

/* Fills the entries beyond the last row with the last row's variance; with no row, 0. */
void tp_filtered_waves_finish(tp_filtered_waves *waves);

/* Returns a + (b - a) part / 64; a and b up to 2^24. */
static inline uint32_t tp_variance_interpolate(uint32_t a, uint32_t b, int32_t part)
{
    return (uint32_t)((int32_t)a + ((int32_t)(b - a) * part + 32) / 64);
}

/* Returns the variance at log2 of a depth, m, Q8; NULL: 0. */
static inline tp_slope_variance tp_filtered_waves_lookup(const tp_filtered_waves *waves,
                                                     int32_t log_depth)
{
    int32_t at = tp_clamp(log_depth - TP_ROUGH_FIRST, 0,
                          TP_ROUGH_STEP * TP_ROUGH_STEPS - 1);
    int32_t part = at % TP_ROUGH_STEP;

    if (!waves)
        return (tp_slope_variance){ 0, 0, 0 };
    const tp_slope_variance *v = &waves->at[at / TP_ROUGH_STEP];
    return (tp_slope_variance){ tp_variance_interpolate(v[0].along, v[1].along, part),
                                tp_variance_interpolate(v[0].across, v[1].across, part),
                                tp_variance_interpolate(v[0].left, v[1].left, part) };
}

#endif
