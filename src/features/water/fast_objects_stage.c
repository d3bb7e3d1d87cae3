/* SPDX-License-Identifier: MIT */
/*
 * Mirrored objects in place of the sky that fast light has reflected, in the blocks that
 * have any.  The stage repeats the look-ups of the reflected sky for the pixels that mirror
 * an object, and adds the difference: light and glints, which are in the colour already,
 * stay.
 */
#include "features/water/fast_light_plain.h"

#define SPAN TP_QUICK_SPAN(TP_LOBE_BLINN)

/* Returns a channel after the change of the reflected light.  `over` is premultiplied by
 * its alpha; covers: 256 where it is opaque. */
TP_ALWAYS_INLINE uint32_t change_channel(uint32_t colour, uint32_t sky, uint32_t over,
                                         int32_t covers, int32_t mirrors, int shift)
{
    const int32_t hidden = (int32_t)(sky >> shift & 255) * covers >> 8;
    const int32_t more = ((int32_t)(over >> shift & 255) - hidden) * mirrors;
    const int32_t sum = (int32_t)(colour >> shift & 255) + (more >> 8);
    return (uint32_t)tp_clamp(sum, 0, 255) << shift;
}

TP_ALWAYS_INLINE uint32_t replace_sky(uint32_t colour, uint32_t sky, uint32_t over,
                                      int32_t mirrors)
{
    const int32_t covers = (int32_t)((over >> 24) + (over >> 31));

    return change_channel(colour, sky, over, covers, mirrors, 16)
         | change_channel(colour, sky, over, covers, mirrors, 8)
         | change_channel(colour, sky, over, covers, mirrors, 0);
}

/* Changes samples [i, stop), which lie in one block. */
TP_ALWAYS_INLINE void lay_block(const tp_shade *shade, tp_run *run, int32_t i, int32_t stop,
                                int env)
{
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    const int32_t from = (run->x + i) & -SPAN;
    const tp_quick_view a = tp_quick_blinn_sample(shade, &row, from);
    const tp_quick_view b = tp_quick_blinn_sample(shade, &row, from + SPAN);
    const tp_quick_view step = tp_quick_step(a, b, TP_LOBE_NONE);
    const tp_quick_water water = tp_quick_water_make(shade, &a, env);
    const plain_tables tables = plain_tables_make(shade, (int32_t)water.level, run->y);

    for (; i < stop; i++) {
        if (run->mirror[i] == 0)
            continue;
        const tp_quick_view v = tp_quick_view_advance(a, step, (run->x + i - from) >> 2);
        const plain_column c = plain_column_make(&tables, run->slope[i], v.back,
                                                 v.y - tables.least);
        const int32_t up = 2 * tp_usat(c.n, 0, 27) - c.y;
        const int32_t place =
            env == TP_ENV_CUBE
                ? plain_cube_index(c.sx, c.sz, c.vx, c.vz, c.n + tables.least, up,
                                   tables.row)
                : (int32_t)water.sky + tp_ssat(up, 21, 6);
        const uint32_t share = tables.shares[tp_usat(c.n, 18, 8)];
        run->colour[i] = replace_sky(run->colour[i], tables.sky[place], run->mirror[i],
                                     (int32_t)(share & 0xffff));
    }
}

TP_ALWAYS_INLINE void lay_objects(const tp_shade *shade, tp_run *run, int env)
{
    for (int32_t i = 0, stop; run->objects && i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        if (run->objects >> tp_block_number(run, i) & 1)
            lay_block(shade, run, i, stop, env);
    }
}

void tp_stage_quick_over_gradient(const tp_shade *shade, tp_run *run)
{
    lay_objects(shade, run, TP_ENV_GRADIENT);
}

void tp_stage_quick_over_dome(const tp_shade *shade, tp_run *run)
{
    lay_objects(shade, run, TP_ENV_DOME);
}

void tp_stage_quick_over_cube(const tp_shade *shade, tp_run *run)
{
    lay_objects(shade, run, TP_ENV_CUBE);
}
