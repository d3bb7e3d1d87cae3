/* SPDX-License-Identifier: MIT */
/* The default sky, used by every scene without another sky: a gradient from horizon to
 * zenith by the sine of the elevation. */
#include "shade/shade.h"
#include "tidepool/modules.h"

/* Entry i is the colour at sine i / 256.  The zenith's share grows as 1 - (1 - sine)^2:
 * fast near the horizon, where the air is thick. */
void tp_shade_sky(tp_shade *shade, uint32_t horizon, uint32_t zenith)
{
    for (uint32_t i = 0; i <= TP_SKY; i++) {
        uint32_t left = TP_SKY - i;
        shade->sky[i] = tp_colour_mix(horizon, zenith, 256 - left * left / TP_SKY);
    }
}

#define STEP 32

/* The height of the view vector is exact at every 32nd column and linear between: the
 * error is below two of the 256 entries at 128 pixels a row, below one at 320.  The view
 * vector points down to the eye: its negative is the height in the sky. */
void tp_stage_sky(const tp_shade *shade, tp_run *run)
{
    const uint32_t *sky = shade->sky;
    int32_t x = run->x, end = run->x + run->count;
    int32_t a = tp_view_ray(shade, &shade->world, x & -STEP, run->y).y;

    for (int32_t i = 0; x < end; ) {
        int32_t from = x & -STEP, next = from + STEP;
        int32_t b = tp_view_ray(shade, &shade->world, next, run->y).y;
        int32_t stop = next < end ? next : end;
        int32_t step = a - b, sine = -STEP * a + step * (x - from);     /* Q14 x 32 */
        for (; x < stop; x++, i++, sine += step)
            run->colour[i] = sky[sine < 0 ? 0 : sine >> 11];
        a = b;
    }
}
