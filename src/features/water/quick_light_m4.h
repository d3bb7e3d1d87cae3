/* SPDX-License-Identifier: MIT */
/* Fast light for cores with the DSP extension.  Slopes and views stay packed in pairs;
 * the view is stepped in registers, several columns per iteration.  The results equal
 * those of quick_light_plain.h bit for bit; its comments apply here too. */
#ifndef TP_WATER_QUICK_LIGHT_M4_H
#define TP_WATER_QUICK_LIGHT_M4_H
#include "features/water/quick_light.h"
#include "fx/fx.h"

TP_ALWAYS_INLINE uint32_t packed_cube_colour(const uint32_t *sky, uint32_t slope,
                                             uint32_t back, int32_t n, int32_t up)
{
    int32_t twice = tp_usat(n, 12, 14);
    int32_t x = (twice * tp_high16(slope) >> 11) - tp_high16(back);
    int32_t z = (twice * tp_low16(slope) >> 11) - tp_low16(back);
    int32_t in = 16384 - tp_usat(up, 13, 13);
    int32_t u = tp_clamp(x * (in >> 2) >> 22, -16, 15);
    int32_t v = tp_clamp(z * (in >> 2) >> 22, -16, 15);

    return sky[(v + 16) * TP_QUICK_SIDE + u + 16];
}

/* Returns light and reflection of one column. */
TP_ALWAYS_INLINE uint32_t packed_light_and_reflect(const struct tp_quick_light *quick,
                                                   const uint32_t *sky, tp_quick_sun sun,
                                                   tp_quick_view v, uint32_t slope,
                                                   uint32_t colour, int env)
{
    int32_t  n = tp_smlad(slope, v.back, v.y), up = 2 * tp_usat(n, 0, 27) - v.y;
    int32_t  l = tp_smlad(slope, sun.back, sun.y);
    int32_t  lit = sun.ambient + sun.direct * tp_usat(l, 18, 8);
    uint32_t light = env == TP_ENV_CUBE
                         ? packed_cube_colour(sky, slope, v.back, n + quick->least, up)
                         : sky[tp_ssat(up, 21, 6)];
    uint32_t share = quick->share[tp_usat(n, 18, 8)];
    uint32_t keeps = (uint32_t)tp_smulwt(lit, share), mirrors = share & 0xffff;
    uint32_t rb = tp_even_bytes(colour) * keeps + tp_even_bytes(light) * mirrors;
    uint32_t g = tp_odd_bytes(colour) * keeps + tp_odd_bytes(light) * mirrors;

    return tp_add_odd_bytes(g & 0xff00ff00, rb);
}

/* Adds the glint of one column. */
TP_ALWAYS_INLINE uint32_t packed_add_glint(const struct tp_quick_light *quick,
                                           tp_quick_sun sun, tp_quick_view v,
                                           uint32_t slope, uint32_t colour, int lobe)
{
    if (lobe == TP_LOBE_PHONG) {
        int32_t n = tp_smlad(slope, v.back, v.y), l = tp_smlad(slope, sun.back, sun.y);
        int32_t way = tp_smulwt(tp_smlad(slope, slope, 1 << 24), (uint32_t)v.lv)
                    - (tp_smulwb(n + quick->least, (uint32_t)tp_usat(l, 12, 14)) >> 1);
        return tp_uqadd8(colour, quick->lobe[tp_usat(way, 11, 9)]);
    }
    if (lobe == TP_LOBE_BLINN) {
        uint32_t away = tp_shsub16(slope, v.half);
        return tp_uqadd8(colour, quick->lobe[tp_usat(tp_smuad(away, away), 11, 9)]);
    }
    return colour;
}

/* Returns the full colour of one column. */
TP_ALWAYS_INLINE uint32_t packed_shade_column(const struct tp_quick_light *quick,
                                      const uint32_t *sky, tp_quick_sun sun,
                                      tp_quick_view v, uint32_t slope, uint32_t colour,
                                      int env, int lobe)
{
    colour = packed_light_and_reflect(quick, sky, sun, v, slope, colour, env);
    return packed_add_glint(quick, sun, v, slope, colour, lobe);
}

/* Returns the address of a word in a run: `sample` is the run plus 4 bytes per column,
 * `place` the offset of an array. */
TP_ALWAYS_INLINE uint32_t *packed_word_pointer(char *sample, size_t place)
{
    return (uint32_t *)(void *)(sample + place);
}

#define COLOUR(sample, i) packed_word_pointer(sample, offsetof(tp_run, colour))[i]
#define SLOPE(sample, i)  packed_word_pointer(sample, offsetof(tp_run, slope))[i]

/* Shades columns x to stop of one span.  One pointer serves all arrays, because registers
 * are few.  Half vectors are computed for Blinn's lobe only; the lane instructions set
 * flags, so compilers would keep them even without a reader. */
TP_ALWAYS_INLINE void packed_span(const tp_shade *shade, tp_quick_sun sun, tp_run *run,
                                  tp_quick_view v, tp_quick_view step, int32_t x,
                                  int32_t stop, int env, int lobe)
{
    const struct tp_quick_light *quick = shade->quick;
    const uint32_t *sky = quick->sky + (env == TP_ENV_CUBE ? 0 : TP_QUICK_HEIGHTS / 2)
                        + (env == TP_ENV_DOME ? tp_quick_column(shade, &v) : 0);
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
    int32_t  y = v.y, lv = v.lv;

#define SEEN(i) \
    COLOUR(at, i) = packed_shade_column(quick, sky, sun, (tp_quick_view){ back, half, y, lv }, \
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
    const tp_quick_row row = tp_quick_row_make(shade, run->y);
    int32_t x = run->x, end = run->x + run->count, span = TP_QUICK_SPAN(lobe);
    tp_quick_view v = tp_quick_view_sample(shade, &row, x & -span, lobe);

    while (x < end) {
        int32_t next = (x & -span) + span, stop = next < end ? next : end;
        const tp_quick_view to = tp_quick_view_sample(shade, &row, next, lobe);
        packed_span(shade, sun, run, v, tp_quick_step(v, to, lobe), x, stop, env, lobe);
        v = to;
        x = stop;
    }
}
#endif
