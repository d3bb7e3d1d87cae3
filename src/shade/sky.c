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

void tp_stage_sky(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++) {
        int32_t sine = -run->vy[i] >> 6;        /* view points down to the eye */
        run->colour[i] = shade->sky[tp_clamp(sine, 0, TP_SKY)];
    }
}
