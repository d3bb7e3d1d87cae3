/* SPDX-License-Identifier: MIT */
/*
 * Fast light at half rate, glints too (quality.light=fast): the even columns of the picture
 * and a run's first column are lit, the others are means of their neighbours.  One body
 * serves all machines.  A column has the same colour as at full rate.
 */
#include "features/water/fast_light_m4.h"

/* Returns the view in column k of a span; in most spans k is 0. */
TP_ALWAYS_INLINE tp_quick_view column_view(tp_quick_view from, tp_quick_view step,
                                           int32_t k, int lobe)
{
    uint32_t half = 0;
    if (lobe == TP_LOBE_BLINN)
        half = tp_quick_half_first(from.half, tp_quick_walk_make(step.half));
    if (k) {
        from = tp_quick_view_advance(from, step, k / TP_QUICK_STEP(lobe));
        if (lobe == TP_LOBE_BLINN)
            half = tp_quick_half_advance(half, step.half, k);
    }
    from.half = half;
    return from;
}

/* Lights columns x to stop of a span, both even, from the view in column x on.  Phong's
 * lobe has a step of the view for each two columns, the others for each four: h is also
 * stepped after two, by two truncated quarters. */
TP_ALWAYS_INLINE void light_even_columns(const tp_quick_rough *rough, const uint32_t *sky,
                                         tp_quick_offset row, tp_quick_sun sun, tp_quick_view v,
                                         tp_quick_view step, const uint32_t *slope,
                                         uint32_t *even, int32_t x, int32_t stop, int env,
                                         int lobe)
{
    const uint32_t *const end = slope + (stop - x);
    const uint32_t quarter =
        lobe == TP_LOBE_BLINN ? tp_quick_walk_make(step.half).quarter : 0;
    const uint32_t middle = tp_sadd16(quarter, quarter);
    const uint32_t rest = tp_ssub16(step.half, middle);
    uint32_t back = v.back, half = v.half;
    int32_t  y = v.y, lv = v.lv;

#define SEEN(i) \
    even[i] = packed_shade_column(rough, sky, row, sun, \
                                  (tp_quick_view){ back, half, y, lv }, slope[2 * (i)], \
                                  even[i], env, lobe)
#define WALK() (back = tp_sadd16(back, step.back), y += step.y, lv += step.lv)
#define TO_NEXT(by) (half = lobe == TP_LOBE_BLINN ? tp_sadd16(half, by) : 0)
    if (lobe == TP_LOBE_PHONG) {
        for (; slope != end; slope += 2, even++) {
            SEEN(0);
            WALK();
        }
        return;
    }
    if ((x & 2) && slope != end) {
        SEEN(0);
        TO_NEXT(rest);
        WALK();
        slope += 2, even++;
    }
    for (const uint32_t *last = end - 2; slope < last; slope += 4, even += 2) {
        SEEN(0);
        TO_NEXT(middle);
        SEEN(1);
        TO_NEXT(rest);
        WALK();
    }
    if (slope != end)
        SEEN(0);
#undef SEEN
#undef WALK
#undef TO_NEXT
}

/* Lights columns x to stop of a span; x is even, or the run's first column.  Returns the
 * next place in the run's even columns. */
TP_ALWAYS_INLINE uint32_t *light_span(const tp_shade *shade, tp_quick_sun sun,
                                      const tp_run *run, tp_quick_view from,
                                      tp_quick_view step, int32_t x, int32_t stop,
                                      uint32_t *even, int env, int lobe)
{
    const tp_quick_water water = tp_quick_water_make(shade, &from, env);
    const tp_quick_rough *rough = &shade->quick->rough[water.level];
    const uint32_t *sky = shade->quick->sky + water.sky, *slope = run->slope + (x - run->x);
    const tp_quick_offset row = tp_quick_row_offset(run->y);
    const int32_t begin = x & -TP_QUICK_SPAN(lobe);

    sun = tp_quick_sun_seen(sun, water.seen);
    from.y -= rough->least;
    if (x & 1) {
        const tp_quick_view v = column_view(from, step, x - begin, lobe);
        *even = packed_shade_column(rough, sky, row, sun, v, *slope, *even, env, lobe);
        even++, slope++, x++;
    }
    stop += stop & 1;           /* columns after the last even one are not read */
    if (x < stop)
        light_even_columns(rough, sky, row, sun, column_view(from, step, x - begin, lobe),
                           step, slope, even, x, stop, env, lobe);
    return even + (stop > x ? (stop - x) >> 1 : 0);
}

TP_ALWAYS_INLINE void light_half(const tp_shade *shade, tp_run *run, int env, int lobe)
{
    const tp_quick_sun sun = tp_quick_sun_make(shade);
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    int32_t x = run->x, end = run->x + run->count, span = TP_QUICK_SPAN(lobe);
    tp_quick_view v = tp_quick_view_sample(shade, &row, x & -span, lobe);
    uint32_t *even = run->even;

    while (x < end) {
        const int32_t from = x & -span, next = from + span, stop = next < end ? next : end;
        const tp_quick_view to = tp_quick_view_sample(shade, &row, next, lobe);
        even = light_span(shade, sun, run, v, tp_quick_step(v, to, lobe), x, stop, even,
                          env, lobe);
        v = to;
        x = stop;
    }
    if (!shade->evens_only)
        tp_quick_odd_fill(run);
}

#define STAGE(name, env, lobe) \
    void tp_stage_quick_##name##_half(const tp_shade *shade, tp_run *run) \
    { light_half(shade, run, env, lobe); }
TP_QUICK_LIGHT_STAGES(STAGE)
