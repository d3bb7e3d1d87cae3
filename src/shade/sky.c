/* SPDX-License-Identifier: MIT */
/* The sky as a gradient from horizon to zenith, by the sine of the elevation. */
#include "shade/shade.h"

/* Entry i is sine i / 256; the zenith's share grows as 1 - (1 - sine)^2: fast near the
 * horizon, where the air is thick. */
void tp_shade_sky(tp_shade *shade, uint32_t horizon, uint32_t zenith)
{
    for (uint32_t i = 0; i <= TP_SKY; i++) {
        uint32_t left = TP_SKY - i;
        shade->sky[i] = tp_colour_mix(horizon, zenith, 256 - left * left / TP_SKY);
    }
}

/* The view's height is exact at every 64th column and linear between: 0.0016 short in
 * the middle at most, at 640 pixels and 60 degrees, less than half an entry.  The view
 * points down to the eye, so the sky's height is the negative. */
void tp_stage_sky(const tp_shade *shade, tp_run *run)
{
    int32_t from = run->x & -TP_RUN;        /* a run lies within one such step */
    int32_t a = tp_view_ray(shade, &shade->world, from, run->y).y;
    int32_t b = tp_view_ray(shade, &shade->world, from + TP_RUN, run->y).y;
    int32_t sine = -TP_RUN * a - (b - a) * (run->x - from);     /* Q14 x 64 */

    for (int32_t i = 0; i < run->count; i++, sine -= b - a)
        run->colour[i] = shade->sky[sine < 0 ? 0 : sine >> 12];
}
