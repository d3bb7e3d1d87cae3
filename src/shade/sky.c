/* SPDX-License-Identifier: MIT */
/* The sky where nothing stands before it: a gradient from horizon to zenith by the sine
 * of the elevation; or a dome or cube, looked up along each pixel's view. */
#include "shade/cubes.h"

/* Entry i is sine i / 256; the zenith's share grows as 1 - (1 - sine)^2: fast near the
 * horizon, where the air is thick. */
void tp_shade_sky(tp_shade *shade, uint32_t horizon, uint32_t zenith)
{
    for (uint32_t i = 0; i <= TP_SKY; i++) {
        uint32_t left = TP_SKY - i;
        shade->sky[i] = tp_colour_mix(horizon, zenith, 256 - left * left / TP_SKY);
    }
}

#define STEP 32

/* The view's height is exact at every 32nd column and linear between: less than two of
 * the 256 entries off at 128 pixels a row, less than one at 320.  The view points down
 * to the eye, so the sky's height is the negative. */
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

TP_ALWAYS_INLINE uint32_t as_colour(const tp_shade *shade, uint32_t light, int hdr)
{
    return hdr ? tp_light_colour(shade, light) : light & 0x00ffffffu;
}

TP_ALWAYS_INLINE void empty_dome(const tp_shade *shade, tp_run *run, int hdr)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t light = tp_env_dome(shade, 0, -run->vx[i], -run->vy[i], -run->vz[i]);
        run->colour[i] = as_colour(shade, light, hdr);
    }
}

/* Samples [i, stop), no more than TP_CUBE_ROW. */
TP_ALWAYS_INLINE void empty_wide(const tp_shade *restrict shade, tp_run *restrict run,
                                 const tp_cube_side *side, int32_t i, int32_t stop,
                                 int hdr)
{
    int32_t  x[TP_CUBE_ROW], y[TP_CUBE_ROW], z[TP_CUBE_ROW], count = stop - i;
    uint32_t light[TP_CUBE_ROW];

    for (int32_t k = 0; k < count; k++) {
        x[k] = -run->vx[i + k];
        y[k] = -run->vy[i + k];
        z[k] = -run->vz[i + k];
    }
    tp_cube_row_wide(shade, side, x, y, z, count, light);
    for (int32_t k = 0; k < count; k++)
        run->colour[i + k] = as_colour(shade, light[k], hdr);
}

TP_ALWAYS_INLINE void empty_cube(const tp_shade *shade, tp_run *run, int hdr)
{
    tp_cube_sides sides = { .level = -1 };

    tp_cube_sides_at(&sides, shade->env.cube, tp_env_level(shade, TP_ENV_CUBE, 0));
    for (int32_t i = 0; i < run->count; ) {
        int32_t stop = tp_block_end(run, i);
        if (TP_WIDE) {
            empty_wide(shade, run, sides.side, i, stop, hdr);
            i = stop;
        }
        for (; i < stop; i++) {
            tp_cube_ray ray = tp_cube_face(-run->vx[i], -run->vy[i], -run->vz[i]);
            uint32_t    light = tp_cube_look(shade, &ray, &sides.side[ray.face]);
            run->colour[i] = as_colour(shade, light, hdr);
        }
    }
}

TP_ALWAYS_INLINE void empty(const tp_shade *shade, tp_run *run, tp_env_kind kind, int hdr)
{
    TP_ASSERT(kind == TP_ENV_DOME ? shade->env.dome != NULL : shade->env.cube != NULL);
    tp_view_run(shade, &shade->world, run);
    if (kind == TP_ENV_DOME)
        empty_dome(shade, run, hdr);
    else
        empty_cube(shade, run, hdr);
}

#define SKY_STAGE(name, kind, hdr) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { empty(shade, run, kind, hdr); }
TP_SKY_STAGES(SKY_STAGE)
