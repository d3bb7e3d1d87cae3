/* SPDX-License-Identifier: MIT */
/*
 * Fast light at half rate, glints too (quality.light=fast): the even columns of the picture
 * and a run's first column are lit, the others are means of their neighbours.  One body
 * serves all machines.  A column has the same colour as at full rate.
 */
#include "features/water/fast_light_m4.h"

/* The view in an even column, stepped from column to column. */
typedef struct {
    tp_quick_view from, step;
    uint32_t      half;         /* of column 0 of the span, for Blinn's lobe */
} span_view;

TP_ALWAYS_INLINE tp_quick_view column_view(const span_view *view, int32_t k, int lobe)
{
    tp_quick_view v = tp_quick_view_advance(view->from, view->step,
                                            k / TP_QUICK_STEP(lobe));
    if (lobe == TP_LOBE_BLINN)
        v.half = tp_quick_half_advance(view->half, view->step.half, k);
    return v;
}

/* Lights columns x to stop of a span that begins at `from`; x is even, or the run's first
 * column.  Returns the next place in the run's even columns. */
TP_ALWAYS_INLINE uint32_t *light_span(const tp_shade *shade, tp_quick_sun sun,
                                      const tp_run *run, span_view view, int32_t from,
                                      int32_t x, int32_t stop, uint32_t *even, int env,
                                      int lobe)
{
    const struct tp_quick_light *quick = shade->quick;
    const tp_quick_water water = tp_quick_water_make(shade, &view.from, env);
    const tp_quick_rough *rough = &quick->rough[water.level];
    const uint32_t *sky = quick->sky + water.sky;
    const tp_quick_offset row = tp_quick_row_offset(run->y);

    sun = tp_quick_sun_seen(sun, water.seen);
    view.from.y -= rough->least;
    if (lobe == TP_LOBE_BLINN)
        view.half = tp_quick_half_first(view.from.half,
                                        tp_quick_walk_make(view.step.half));
    tp_quick_view v = column_view(&view, x - from, lobe);
    while (x < stop) {
        *even = packed_shade_column(rough, sky, row, sun, v, run->slope[x - run->x], *even,
                                    env, lobe);
        even++;
        x += 2 - (x & 1);
        if (lobe == TP_LOBE_PHONG) {
            v.back = tp_sadd16(v.back, view.step.back);
            v.y += view.step.y;
            v.lv += view.step.lv;
        } else {
            v = column_view(&view, x - from, lobe);
        }
    }
    return even;
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
        const span_view view = { v, tp_quick_step(v, to, lobe), 0 };
        even = light_span(shade, sun, run, view, from, x, stop, even, env, lobe);
        v = to;
        x = stop;
    }
    tp_quick_odd_fill(run);
}

#define STAGE(name, env, lobe) \
    void tp_stage_quick_##name##_half(const tp_shade *shade, tp_run *run) \
    { light_half(shade, run, env, lobe); }
TP_QUICK_LIGHT_STAGES(STAGE)
