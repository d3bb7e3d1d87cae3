/* SPDX-License-Identifier: MIT */
/* Quick light of every second column, and glints of all, for cores with the DSP extension;
 * the bits are those of quick_even_plain.h. */
#ifndef TP_SHADE_QUICK_EVEN_M4_H
#define TP_SHADE_QUICK_EVEN_M4_H
#include "shade/quick_light_m4.h"

#define SPAN TP_QUICK_SPAN(TP_LOBE_BLINN)

/* Columns x to stop of one span: x is even, or the run's first. */
TP_ALWAYS_INLINE void packed_even_span(const tp_shade *shade, tp_run *run,
                                       tp_quick_view v, tp_quick_view step, int32_t x,
                                       int32_t stop, int env)
{
    const struct tp_quick_light *quick = shade->quick;
    const tp_quick_sun sun = tp_quick_sun_of(shade);
    const uint32_t *sky = quick->sky + (env == TP_ENV_CUBE ? 0 : TP_QUICK_HEIGHTS / 2)
                        + (env == TP_ENV_DOME ? tp_quick_column(shade, &v) : 0);
    const uint32_t *slope = run->slope + (x - run->x);
    uint32_t *even = run->even + ((x - run->x + (run->x & 1)) >> 1);

    if (x & (SPAN - 1))
        v = tp_quick_at(v, step, (x & (SPAN - 1)) >> 2);
#define SEEN(i) \
    even[i] = packed_mirrored(quick, sky, sun, v, slope[2 * (i)], even[i], env)
#define WALK() (v.back = tp_sadd16(v.back, step.back), v.y += step.y)
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

/* The half vectors where spans begin and end stay in the run for the glints. */
TP_ALWAYS_INLINE void packed_even(const tp_shade *shade, tp_run *run, int env)
{
    const tp_quick_row row = tp_quick_row_at(shade, run->y);
    int32_t   x = run->x, end = run->x + run->count;
    uint32_t *half = run->half;
    tp_quick_view v = tp_quick_blinn_at(shade, &row, x & -SPAN);

    *half++ = v.half;
    while (x < end) {
        int32_t next = (x & -SPAN) + SPAN, stop = next < end ? next : end;
        const tp_quick_view to = tp_quick_blinn_at(shade, &row, next);
        packed_even_span(shade, run, v, tp_quick_step(v, to, TP_LOBE_BLINN), x, stop, env);
        *half++ = to.half;
        v = to;
        x = stop;
    }
}

/* -- glints -------------------------------------------------------------------------- */

/* Columns x to stop of one span. */
TP_ALWAYS_INLINE void packed_glint_span(const tp_shade *shade, tp_run *run,
                                        tp_quick_view v, tp_quick_view step, int32_t x,
                                        int32_t stop, int lobe)
{
    const struct tp_quick_light *quick = shade->quick;
    const tp_quick_sun sun = tp_quick_sun_of(shade);
    const int width = TP_QUICK_STEP(lobe);
    const uint32_t *slope = run->slope + (x - run->x);
    uint32_t *colour = run->colour + (x - run->x), *const end = colour + (stop - x);
    int32_t begun = x & (TP_QUICK_SPAN(lobe) - 1), left = -x & (width - 1);

    if (begun)
        v = tp_quick_at(v, step, begun / width);
#define GLEAM(i) \
    colour[i] = packed_gleaming(quick, sun, v, slope[i], colour[i], lobe)
#define WALK() \
    (v.back = tp_sadd16(v.back, step.back), v.half = tp_sadd16(v.half, step.half), \
     v.y += step.y, v.lv += step.lv)
    for (; left > 0 && colour < end; colour++, slope++) {
        GLEAM(0);
        if (--left == 0)
            WALK();
    }
    for (; end - colour >= width; colour += width, slope += width) {
        GLEAM(0);
        GLEAM(1);
        if (width == 4) {
            GLEAM(2);
            GLEAM(3);
        }
        WALK();
    }
    for (; colour < end; colour++, slope++)
        GLEAM(0);
#undef GLEAM
#undef WALK
}

TP_ALWAYS_INLINE tp_quick_view packed_half(uint32_t half)
{
    return (tp_quick_view){ .half = half };
}

TP_ALWAYS_INLINE void packed_glint(const tp_shade *shade, tp_run *run, int lobe)
{
    const tp_quick_row row = tp_quick_row_at(shade, run->y);
    const uint32_t *half = run->half;
    int32_t x = run->x, end = run->x + run->count, span = TP_QUICK_SPAN(lobe);
    tp_quick_view v = lobe == TP_LOBE_BLINN ? packed_half(*half++)
                                            : tp_quick_phong_at(shade, &row, x & -span);

    while (x < end) {
        int32_t next = (x & -span) + span, stop = next < end ? next : end;
        const tp_quick_view to = lobe == TP_LOBE_BLINN
                                     ? packed_half(*half++)
                                     : tp_quick_phong_at(shade, &row, next);
        packed_glint_span(shade, run, v, tp_quick_step(v, to, lobe), x, stop, lobe);
        v = to;
        x = stop;
    }
}
#undef SPAN
#endif
