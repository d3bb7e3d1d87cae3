/* SPDX-License-Identifier: MIT */
/*
 * The fast stage of the visible dome, without stars and without light above white, which the
 * quality plan chooses with fast water: the colour is looked up at every 16th column and
 * linear between.
 */
#include "features/sky/sky.h"
#include "shade/env.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

#if TP_DSP
#define FILL tp_gradient_fill_packed
#else
#define FILL tp_gradient_fill_scalar
#endif

/* -- the dome of the quality plan ---------------------------------------------------- */

#define CLOSE (1u << 23)        /* square of 10 degrees: beyond it the glow is smooth */

static uint32_t sample_dome(const tp_shade *shade, tp_ray v)
{
    return tp_env_dome(shade, 0, -v.x, -v.y, -v.z) & 0x00ffffff;
}

static bool is_near_sun(const tp_shade *shade, tp_ray v)
{
    return tp_square_length(v.x + shade->world.lx, v.y + shade->world.ly,
                        v.z + shade->world.lz) < CLOSE;
}

/* Looks up columns [k, end) of the 16 columns from ray a to ray b. */
static void sample_dome_columns(const tp_shade *shade, uint32_t *colour, tp_ray a,
                                tp_ray b, int32_t k, int32_t end)
{
    for (; k < end; k++) {
        tp_ray v = { a.x + ((b.x - a.x) * k >> 4), a.y + ((b.y - a.y) * k >> 4),
                     a.z + ((b.z - a.z) * k >> 4), 0 };
        *colour++ = sample_dome(shade, v);
    }
}

void tp_stage_quick_sky_dome(const tp_shade *shade, tp_run *run)
{
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    int32_t  x = run->x, end = run->x + run->count;
    tp_ray   a = tp_quick_ray(shade, &row, 16 * (x & ~15) + 8);
    uint32_t here = sample_dome(shade, a);

    while (x < end) {
        int32_t  from = x & ~15, stop = from + 16 < end ? from + 16 : end;
        tp_ray   b = tp_quick_ray(shade, &row, 16 * from + 16 * 16 + 8);
        uint32_t there = sample_dome(shade, b), *colour = run->colour + (x - run->x);
        if (is_near_sun(shade, a) || is_near_sun(shade, b))
            sample_dome_columns(shade, colour, a, b, x - from, stop - from);
        else
            FILL(colour, tp_quick_shade_make(here, there), x - from, stop - from);
        x = stop;
        a = b;
        here = there;
    }
}
