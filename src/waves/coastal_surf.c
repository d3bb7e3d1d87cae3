/* SPDX-License-Identifier: MIT */
/* Means of the surf over time, by depth alone: for places where nobody follows the single
 * crests. */
#include "waves/coastal_tables.h"

#define NOISE TP_FX(0.74)       /* the noise's spread 0.43, times the root of 3 */

/* Returns the mean of the gate over the noise, 16.16: by three points with the spread of
 * the noise, of weights 1, 4 and 1 over 6. */
static tp_fx mean_gate(const tp_coastal_water *coastal, tp_fx ratio)
{
    const tp_fx part = tp_fx_mul(coastal->irregular, NOISE) / 2;
    const tp_fx more = tp_fx_mul(ratio, part);

    if (ratio < TP_COASTAL_RATIO_LEAST)
        return 0;
    return (tp_breaking_gate(ratio - more) + 4 * tp_breaking_gate(ratio)
            + tp_breaking_gate(ratio + more)) / 6;
}

/* Waves of other lengths meet by chance: the largest of their foam is about 1 less the
 * product of 1 less the foam of each.  A wave's foam over its period is a sixth of that at
 * the crest, the mean of a square over half of the period. */
tp_coastal_surf tp_coastal_mean_surf(const tp_coastal_water *coastal, tp_fx depth)
{
    tp_coastal_surf surf = { 0, 0 };
    tp_fx calm = TP_FX_ONE;

    if (depth <= 0)
        return surf;
    const tp_coastal_table_place at = tp_coastal_table_find(depth);
    const int32_t part = at.depth_fraction;
    for (uint32_t i = 0; i < coastal->count; i++) {
        const tp_coastal_depth_entry *d = tp_coastal_tables(coastal)[i].depth + at.depth;
        const tp_fx gate = mean_gate(coastal, tp_coastal_mix(d[0].ratio, d[1].ratio, part));
        const tp_fx steep = tp_coastal_mix(d[0].steep, d[1].steep, part) * 4;
        const uint32_t most = (uint32_t)(gate > steep ? gate : steep);
        calm = tp_fx_mul(calm, TP_FX_ONE - (tp_fx)(most * coastal->wave[i].foam / 1536));
        surf.lift += tp_fx_mul(tp_coastal_mix(d[0].up, d[1].up, part), TP_FX(0.6366));
    }
    surf.breaking = TP_FX_ONE - calm;
    return surf;
}
