/* SPDX-License-Identifier: MIT */
/*
 * Fast light for cores with the DSP extension.  Slopes and views stay packed in pairs;
 * the view is stepped in registers, several columns per iteration.  The results equal
 * those of fast_light_plain.h bit for bit; its comments apply here too.  Glints of all
 * columns at half rate are in fast_glints_m4.h.
 */
#ifndef TP_FEATURES_WATER_FAST_LIGHT_M4_H
#define TP_FEATURES_WATER_FAST_LIGHT_M4_H
#include "features/water/fast_shading.h"
#include "fixed/arithmetic.h"
#include "tidepool/modules.h"

/* -- every column -------------------------------------------------------------------- */

TP_ALWAYS_INLINE uint32_t packed_cube_colour(const uint32_t *sky, uint32_t slope,
                                             uint32_t back, int32_t n, int32_t up,
                                             tp_quick_offset row)
{
    int32_t twice = tp_usat(n, 12, 14);
    int32_t x = (twice * tp_high16(slope) >> 11) - tp_high16(back);
    int32_t z = (twice * tp_low16(slope) >> 11) - tp_low16(back);
    int32_t in = 16384 - tp_usat(up, 13, 13);
    int32_t u = tp_clamp((x * (in >> 2) + row.u) >> 22, -16, 15);
    int32_t v = tp_clamp((z * (in >> 2) + row.v) >> 22, -16, 15);

    return sky[(v + 16) * TP_QUICK_SIDE + u + 16];
}

/* Returns light and reflection of one column. */
TP_ALWAYS_INLINE uint32_t packed_light_and_reflect(const tp_quick_rough *rough,
                                                   const uint32_t *sky,
                                                   tp_quick_offset row, tp_quick_sun sun,
                                                   tp_quick_view v, uint32_t slope,
                                                   uint32_t colour, int env)
{
    int32_t  n = tp_smlad(slope, v.back, v.y), up = 2 * tp_usat(n, 0, 27) - v.y;
    int32_t  l = tp_smlad(slope, sun.back, sun.y);
    int32_t  lit = sun.ambient + sun.direct * tp_usat(l, 18, 8);
    uint32_t light = env == TP_ENV_CUBE
                         ? packed_cube_colour(sky, slope, v.back, n + rough->least, up, row)
                         : sky[tp_ssat(up, 21, 6)];
    uint32_t share = rough->share[tp_usat(n, 18, 8)];
    uint32_t keeps = (uint32_t)tp_smulwt(lit, share), mirrors = share & 0xffff;
    uint32_t rb = tp_even_bytes(colour) * keeps + tp_even_bytes(light) * mirrors;
    uint32_t g = tp_odd_bytes(colour) * keeps + tp_odd_bytes(light) * mirrors;

    colour = tp_halves_add_odd_bytes(g & 0xff00ff00, rb);
    return env == TP_ENV_CUBE && light >> 24
               ? tp_quick_add_bright(colour, light, mirrors, rough->beyond)
               : colour;
}

/* Adds the glint of one column. */
TP_ALWAYS_INLINE uint32_t packed_add_glint(const tp_quick_rough *rough, int32_t least,
                                           tp_quick_sun sun, tp_quick_view v,
                                           uint32_t slope, uint32_t colour, int lobe)
{
    if (lobe == TP_LOBE_PHONG) {
        int32_t n = tp_smlad(slope, v.back, v.y), l = tp_smlad(slope, sun.back, sun.y);
        int32_t way = tp_smulwt(tp_smlad(slope, slope, 1 << 24), (uint32_t)v.lv)
                    - (tp_smulwb(n + least, (uint32_t)tp_usat(l, 12, 14)) >> 1);
        return tp_uqadd8(colour, rough->lobe[tp_usat(way, 11, 9)]);
    }
    if (lobe == TP_LOBE_BLINN) {
        uint32_t away = tp_shsub16(slope, v.half);
        return tp_uqadd8(colour, rough->lobe[tp_usat(tp_smuad(away, away), 11, 9)]);
    }
    return colour;
}

/* Returns the full colour of one column. */
TP_ALWAYS_INLINE uint32_t packed_shade_column(const tp_quick_rough *rough,
                                              const uint32_t *sky, tp_quick_offset row,
                                              tp_quick_sun sun, tp_quick_view v,
                                              uint32_t slope, uint32_t colour, int env,
                                              int lobe)
{
    colour = packed_light_and_reflect(rough, sky, row, sun, v, slope, colour, env);
    return packed_add_glint(rough, rough->least, sun, v, slope, colour, lobe);
}

/* Returns the address of a word in a run: `sample` is the run plus 4 bytes per column,
 * `offset` the offset of an array. */
TP_ALWAYS_INLINE uint32_t *packed_word_pointer(char *sample, size_t offset)
{
    return (uint32_t *)(void *)(sample + offset);
}

#define COLOUR(sample, i) packed_word_pointer(sample, offsetof(tp_run, colour))[i]
#define SLOPE(sample, i)  packed_word_pointer(sample, offsetof(tp_run, slope))[i]

/* Shades columns x to stop of one span.  One pointer serves all arrays, because registers
 * are few.  Half vectors are computed for Blinn's lobe only; the lane instructions set
 * flags, so compilers would keep them even without a reader. */
TP_ALWAYS_INLINE void packed_shade_span(const tp_shade *shade, tp_quick_sun sun,
                                        tp_run *run, tp_quick_view v, tp_quick_view step,
                                        int32_t x, int32_t stop, int env, int lobe)
{
    const struct tp_quick_light *quick = shade->quick;
    const tp_quick_water water = tp_quick_water_make(shade, &v, env);
    const uint32_t *sky = quick->sky + water.sky;
    const tp_quick_offset row = tp_quick_row_offset(run->y);
    const tp_quick_rough *rough = &quick->rough[water.level];
    sun = tp_quick_sun_seen(sun, water.seen);
    const int width = TP_QUICK_STEP(lobe);
    char *at = (char *)run + 4 * (x - run->x), *end = at + 4 * (stop - x);
    int32_t begun = x & (TP_QUICK_SPAN(lobe) - 1), left = -x & (width - 1);

    tp_quick_walk walk = { 0 };
    uint32_t half = 0;
    if (lobe == TP_LOBE_BLINN) {
        walk = tp_quick_walk_make(step.half);
        half = tp_quick_half_first(v.half, walk);
        if (begun)
            half = tp_quick_half_advance(half, step.half, begun);
    }
    if (begun)
        v = tp_quick_view_advance(v, step, begun / width);
    uint32_t back = v.back;
    int32_t  y = v.y - rough->least, lv = v.lv;

#define SEEN(i) \
    COLOUR(at, i) = packed_shade_column(rough, sky, row, sun, \
                                        (tp_quick_view){ back, half, y, lv }, \
                                        SLOPE(at, i), COLOUR(at, i), env, lobe)
#define TO_NEXT(by) (half = lobe == TP_LOBE_BLINN ? tp_sadd16(half, by) : 0)
#define SEEN_AND_ON(i) (SEEN(i), TO_NEXT(walk.quarter))
#define SEEN_LAST(i) \
    (SEEN(i), TO_NEXT(walk.rest), back = tp_sadd16(back, step.back), y += step.y, \
     lv += step.lv)
    for (; left > 1 && at < end; left--, at += 4)
        SEEN_AND_ON(0);
    if (left == 1 && at < end) {
        SEEN_LAST(0);
        at += 4;
    }
    for (; at + 4 * width <= end; at += 4 * width) {
        SEEN_AND_ON(0);
        if (width == 4) {
            SEEN_AND_ON(1);
            SEEN_AND_ON(2);
        }
        SEEN_LAST(width - 1);
    }
    for (; at < end; at += 4)
        SEEN_AND_ON(0);
#undef SEEN
#undef TO_NEXT
#undef SEEN_AND_ON
#undef SEEN_LAST
}

TP_ALWAYS_INLINE void packed_light(const tp_shade *shade, tp_run *run, int env, int lobe)
{
    const tp_quick_sun sun = tp_quick_sun_make(shade);
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    int32_t x = run->x, end = run->x + run->count, span = TP_QUICK_SPAN(lobe);
    tp_quick_view v = tp_quick_view_sample(shade, &row, x & -span, lobe);

    while (x < end) {
        int32_t next = (x & -span) + span, stop = next < end ? next : end;
        const tp_quick_view to = tp_quick_view_sample(shade, &row, next, lobe);
        packed_shade_span(shade, sun, run, v, tp_quick_step(v, to, lobe), x, stop, env,
                          lobe);
        v = to;
        x = stop;
    }
}

/* -- every second column -------------------------------------------------------------- */

#define SPAN TP_QUICK_SPAN(TP_LOBE_BLINN)

/* Lights columns x to stop of one span; x is even, or the run's first column. */
TP_ALWAYS_INLINE void packed_light_span_even_columns(const tp_shade *shade,
                                                     tp_quick_sun sun, tp_run *run,
                                                     tp_quick_view v, tp_quick_view step,
                                                     int32_t x, int32_t stop, int env,
                                                     tp_quick_water water)
{
    const struct tp_quick_light *quick = shade->quick;
    const uint32_t *sky = quick->sky + water.sky;
    const tp_quick_offset row = tp_quick_row_offset(run->y);
    const tp_quick_rough *rough = &quick->rough[water.level];
    const uint32_t *slope = run->slope + (x - run->x);
    uint32_t *even = run->even + ((x - run->x + (run->x & 1)) >> 1);

    sun = tp_quick_sun_seen(sun, water.seen);
    if (x & (SPAN - 1))
        v = tp_quick_view_advance(v, step, (x & (SPAN - 1)) >> 2);
    uint32_t back = v.back;
    int32_t  y = v.y - rough->least;
#define SEEN(i) \
    even[i] = packed_light_and_reflect(rough, sky, row, sun, \
                                       (tp_quick_view){ .back = back, .y = y }, \
                                       slope[2 * (i)], even[i], env)
#define WALK() (back = tp_sadd16(back, step.back), y += step.y)
    if (x & 1) {
        SEEN(0);
        even++, slope++;
        if ((++x & 3) == 0)
            WALK();
    }
    if ((x & 2) && x < stop) {
        SEEN(0);
        even++, slope += 2, x += 2;
        WALK();
    }
    const int32_t left = stop > x ? stop - x : 0;
    for (const uint32_t *end = slope + (left & ~3); slope != end; slope += 4, even += 2) {
        SEEN(0);
        SEEN(1);
        WALK();
    }
    if (left & 3)
        SEEN(0);
    if ((left & 3) == 3)
        SEEN(1);
#undef SEEN
#undef WALK
}

/* Lights the even columns of a run.  The half vectors at the ends of spans and the spans'
 * levels stay in the run, for the glints. */
TP_ALWAYS_INLINE void packed_light_even_columns(const tp_shade *shade, tp_run *run, int env)
{
    const tp_quick_sun sun = tp_quick_sun_make(shade);
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    int32_t   x = run->x, end = run->x + run->count;
    uint32_t *half = run->half;
    tp_quick_view v = tp_quick_blinn_sample(shade, &row, x & -SPAN);

    uint32_t span = 0;
    *half++ = v.half;
    while (x < end) {
        const tp_quick_water water = tp_quick_water_make(shade, &v, env);
        run->span[span++].mip_offset = (int16_t)water.level;
        int32_t next = (x & -SPAN) + SPAN, stop = next < end ? next : end;
        const tp_quick_view to = tp_quick_blinn_sample(shade, &row, next);
        packed_light_span_even_columns(shade, sun, run, v,
                                       tp_quick_step(v, to, TP_LOBE_NONE), x, stop, env,
                                       water);
        *half++ = to.half;
        v = to;
        x = stop;
    }
}

#undef SPAN

#endif
