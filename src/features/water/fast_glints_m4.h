/* SPDX-License-Identifier: MIT */
/*
 * Glints of every column at half rate, for cores with the DSP extension: they follow
 * fast_light_m4.h, which lights the even columns.  The results equal those of
 * fast_light_plain.h bit for bit.
 */
#ifndef TP_FEATURES_WATER_FAST_GLINTS_M4_H
#define TP_FEATURES_WATER_FAST_GLINTS_M4_H
#include "features/water/fast_light_m4.h"

/* -- glints -------------------------------------------------------------------------- */

/* Adds Phong's glints to columns x to stop of one span; half rate colours are filled in
 * already. */
TP_ALWAYS_INLINE void packed_add_phong_glints_span(const tp_shade *shade,
                                                   tp_quick_sun sun, tp_run *run,
                                                   tp_quick_view v, tp_quick_view step,
                                                   int32_t x, int32_t stop)
{
    const uint32_t *slope = run->slope + (x - run->x);
    const tp_quick_rough *rough =
        &shade->quick->rough[tp_quick_water_make(shade, &v, TP_ENV_CUBE).level];
    uint32_t *colour = run->colour + (x - run->x);

    v = tp_quick_view_advance(v, step, (x & (TP_QUICK_SPAN(TP_LOBE_PHONG) - 1)) >> 1);
    for (; x < stop; x++) {
        *colour = packed_add_glint(rough, 0, sun, v, *slope++, *colour, TP_LOBE_PHONG);
        colour++;
        if (x & 1)
            v = tp_quick_view_advance(v, step, 1);
    }
}

TP_ALWAYS_INLINE void packed_add_phong_glints(const tp_shade *shade, tp_run *run)
{
    const tp_quick_sun sun = tp_quick_sun_make(shade);
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    const int32_t end = run->x + run->count, span = TP_QUICK_SPAN(TP_LOBE_PHONG);
    int32_t x = run->x;
    tp_quick_view v = tp_quick_phong_sample(shade, &row, x & -span);

    tp_quick_odd_fill(run);
    while (x < end) {
        int32_t next = (x & -span) + span, stop = next < end ? next : end;
        const tp_quick_view to = tp_quick_phong_sample(shade, &row, next);
        packed_add_phong_glints_span(shade, sun, run, v,
                                     tp_quick_step(v, to, TP_LOBE_PHONG), x, stop);
        v = to;
        x = stop;
    }
}

TP_ALWAYS_INLINE uint32_t packed_add_blinn_glint(const uint32_t *lobe, uint32_t slope,
                                                 uint32_t half_vector, uint32_t colour)
{
    uint32_t away = tp_shsub16(slope, half_vector);
    return tp_uqadd8(colour, lobe[tp_usat(tp_smuad(away, away), 11, 9)]);
}

/* Writes four columns with Blinn's glints.  a and b are the colours of the even columns,
 * c the next even colour; odd columns get means.  `half` is the half vector of the first
 * column.  Returns the half vector of the column after the four.  SLOPES is the distance
 * in words from a colour to its slope. */
#define SLOPES ((int)((offsetof(tp_run, slope) - offsetof(tp_run, colour)) / 4))
TP_ALWAYS_INLINE uint32_t packed_upsample_add_glints_four(
    const uint32_t *lobe, uint32_t half_vector, tp_quick_walk walk, uint32_t *colour,
    uint32_t first_even, uint32_t second_even, uint32_t next_even)
{
    const tp_word_pair s = tp_load_pair(colour, SLOPES);
    const tp_word_pair t = tp_load_pair(colour, SLOPES + 2);
    const uint32_t second = tp_sadd16(half_vector, walk.quarter);
    const uint32_t third = tp_sadd16(second, walk.quarter);
    const uint32_t fourth = tp_sadd16(third, walk.quarter);

    tp_store_pair(colour, 0, packed_add_blinn_glint(lobe, s.first, half_vector, first_even),
                  packed_add_blinn_glint(lobe, s.second, second,
                                         tp_uhadd8(first_even, second_even)));
    tp_store_pair(colour, 2, packed_add_blinn_glint(lobe, t.first, third, second_even),
                  packed_add_blinn_glint(lobe, t.second, fourth,
                                         tp_uhadd8(second_even, next_even)));
    return tp_sadd16(fourth, walk.rest);
}

/* Returns the colour of column i, like tp_quick_odd_fill. */
TP_ALWAYS_INLINE uint32_t packed_upsampled_colour(const tp_run *run, int32_t i)
{
    const int32_t odd = run->x & 1, x = run->x + i;
    const uint32_t *even = run->even + ((i + odd) >> 1);

    if (i == 0 || (x & 1) == 0)
        return even[0];
    even = run->even + ((i - 1 + odd) >> 1);
    return (x & 15) == 15 || i + 1 == run->count ? even[0] : tp_uhadd8(even[0], even[1]);
}

/* Returns the half vector of column x, and its steps in *walk, from the half vectors left
 * in the run at the ends of spans. */
TP_ALWAYS_INLINE uint32_t packed_sample_half_vector(const tp_run *run, int32_t x,
                                                    tp_quick_walk *steps)
{
    const uint32_t *half = run->half + ((x >> 5) - (run->x >> 5));
    const uint32_t step = tp_quick_eighth(half[0], half[1]);

    *steps = tp_quick_walk_make(step);
    return tp_quick_half_advance(tp_quick_half_first(half[0], *steps), step,
                                 x & (TP_QUICK_SPAN(TP_LOBE_BLINN) - 1));
}

/* Returns the lobe of the span of column x. */
TP_ALWAYS_INLINE const uint32_t *packed_sample_lobe(const tp_shade *shade,
                                                    const tp_run *run, int32_t x)
{
    const int32_t span = (x >> 5) - (run->x >> 5);
    return shade->quick->rough[run->span[span].mip_offset].lobe;
}

/* Adds glints to the columns of an incomplete block. */
TP_LOOP packed_upsample_add_glints_columns(const tp_shade *shade, tp_run *run, int32_t i,
                                           int32_t end)
{
    if (i >= end)
        return;
    const uint32_t *lobe = packed_sample_lobe(shade, run, run->x + i);
    for (; i < end; i++) {
        tp_quick_walk walk;
        uint32_t half = packed_sample_half_vector(run, run->x + i, &walk);
        run->colour[i] = packed_add_blinn_glint(lobe, run->slope[i], half,
                                                packed_upsampled_colour(run, i));
    }
}

/* Adds glints to complete blocks of 16 columns, [i, end). */
TP_ALWAYS_INLINE void packed_upsample_add_glints_blocks(const tp_shade *shade, tp_run *run,
                                                        int32_t i, int32_t end)
{
    const uint32_t *lobe = NULL;
    const uint32_t *even = run->even + ((i + (run->x & 1)) >> 1);
    uint32_t *colour = run->colour + i, half = 0;
    tp_quick_walk walk = { 0 };

    for (bool begun = false; i < end; i += 16, begun = true) {
        if (!begun || ((run->x + i) & (TP_QUICK_SPAN(TP_LOBE_BLINN) - 1)) == 0) {
            half = packed_sample_half_vector(run, run->x + i, &walk);
            lobe = packed_sample_lobe(shade, run, run->x + i);
#if TP_DSP
            __asm__("" : "+r"(lobe));   /* keeps the address in its own register */
#endif
        }
        uint32_t a = even[0];
        for (uint32_t *const last = colour + 12; colour != last; colour += 4, even += 2) {
            const uint32_t b = even[1], c = even[2];
            half = packed_upsample_add_glints_four(lobe, half, walk, colour, a, b, c);
            a = c;
        }
        half = packed_upsample_add_glints_four(lobe, half, walk, colour, a, even[1],
                                               even[1]);
        colour += 4;
        even += 2;
    }
}

TP_ALWAYS_INLINE void packed_upsample_add_glints_run(const tp_shade *shade, tp_run *run)
{
    const int32_t begin = -run->x & 15, end = run->count - ((run->x + run->count) & 15);

    if (begin >= end) {
        packed_upsample_add_glints_columns(shade, run, 0, run->count);
        return;
    }
    packed_upsample_add_glints_columns(shade, run, 0, begin);
    packed_upsample_add_glints_blocks(shade, run, begin, end);
    packed_upsample_add_glints_columns(shade, run, end, run->count);
}

TP_ALWAYS_INLINE void packed_glint(const tp_shade *shade, tp_run *run, int lobe)
{
    if (lobe == TP_LOBE_PHONG)
        packed_add_phong_glints(shade, run);
    else
        packed_upsample_add_glints_run(shade, run);
}
#undef SLOPES

#endif
