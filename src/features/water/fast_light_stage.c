/* SPDX-License-Identifier: MIT */
/*
 * Span stages of fast light, and the view (shade/slope.h) step by step.  The file
 * selects one of two implementations with identical results.
 */
#include "features/water/fast_shading.h"
#include "view/projection.h"

/* -- the view ------------------------------------------------------------------------ */

/* Returns the slopes of L + V, both Q1.14, clamped to +-4.  The sum's y is at least
 * 1/16. */
TP_ALWAYS_INLINE uint32_t half_vector_slopes(const tp_view_axes *a, int32_t x, int32_t y,
                                             int32_t z)
{
    uint32_t hy = (uint32_t)tp_clamp(a->ly + y, 1024, 32767);
    int      shift = tp_clz(hy);                        /* 17..21 */
    int32_t  recip = tp_recip_rough(hy << shift) >> 16; /* 2^46 / (hy << shift) */
    int32_t  sx = (-a->lx - x) * recip >> (34 - shift);
    int32_t  sz = (-a->lz - z) * recip >> (34 - shift);

    return tp_pair16(tp_clamp(sx, -16384, 16383), tp_clamp(sz, -16384, 16383));
}

TP_ALWAYS_INLINE tp_quick_view make_view(const tp_shade *shade, const tp_quick_ray_row *row,
                                         int32_t x, int lobe)
{
    const tp_view_axes *a = &shade->world;
    const tp_ray r = tp_quick_ray_inline(shade, row, 16 * x + 8 * TP_QUICK_STEP(lobe));
    tp_quick_view v = { tp_pair16(-r.x, -r.z), 0, r.l, 0 };

    if (lobe == TP_LOBE_BLINN) {
        v.half = half_vector_slopes(a, r.x, r.y, r.z);
    } else {
        int32_t lv = r.x * a->lx + r.y * a->ly + r.z * a->lz;
        v.lv = tp_clamp((1 << 28) + lv, 0, (1 << 29) - 1) * 4;
    }
    return v;
}

tp_quick_view tp_quick_phong_sample(const tp_shade *shade, const tp_quick_ray_row *row,
                                    int32_t x)
{
    return make_view(shade, row, x, TP_LOBE_PHONG);
}

tp_quick_view tp_quick_blinn_sample(const tp_shade *shade, const tp_quick_ray_row *row,
                                    int32_t x)
{
    return make_view(shade, row, x, TP_LOBE_BLINN);
}

/* Fills a span's part of the arrays, from column k on, in one vectorizable loop.
 * water: tp_quick_water's seen and sky, in one word. */
TP_ALWAYS_INLINE void fill_span_views(tp_run *restrict run, int32_t i, int32_t stop,
                                      int32_t k, const tp_quick_view *restrict v,
                                      const tp_quick_view *restrict step, uint32_t water,
                                      int lobe)
{
    uint32_t *restrict back = run->back, *restrict half = run->half;
    int32_t  *restrict y = run->view_y, *restrict lv = run->view_l;
    uint32_t *restrict waters = run->water;
    const uint32_t first = tp_quick_half_first(v->half,
                                               tp_quick_walk_make(step->half));

    for (; i < stop; i++, k++) {
        tp_quick_view at =
            tp_quick_view_advance(*v, *step, k >> (lobe == TP_LOBE_PHONG ? 1 : 2));
        back[i] = at.back;
        y[i] = at.y;
        waters[i] = water;
        if (lobe == TP_LOBE_BLINN)
            half[i] = tp_quick_half_advance(first, step->half, k);
        if (lobe == TP_LOBE_PHONG)
            lv[i] = at.lv;
    }
}

/* Fills the arrays of a whole run. */
TP_ALWAYS_INLINE void fill_run_views(const tp_shade *shade, tp_run *run, int env, int lobe)
{
    tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    int32_t       x = run->x, end = run->x + run->count, span = TP_QUICK_SPAN(lobe);
    tp_quick_view a = tp_quick_view_sample(shade, &row, x & -span, lobe);
    uint32_t spans = 0;

    while (x < end) {
        int32_t from = x & -span, stop = from + span < end ? from + span : end;
        tp_quick_view b = tp_quick_view_sample(shade, &row, from + span, lobe);
        tp_quick_view step = tp_quick_step(a, b, lobe);
        const tp_quick_water water = tp_quick_water_make(shade, &a, env);
        run->span[spans++].mip_offset = (int16_t)water.level;
        a.y -= shade->quick->rough[water.level].least;
        fill_span_views(run, x - run->x, stop - run->x, x - from, &a, &step,
                        tp_pair16(water.seen, (int32_t)water.sky), lobe);
        x = stop;
        a = b;
    }
}

void tp_quick_view_run(const tp_shade *shade, tp_run *run, int env, int lobe)
{
    if (lobe == TP_LOBE_PHONG)
        fill_run_views(shade, run, env, TP_LOBE_PHONG);
    else
        fill_run_views(shade, run, env, TP_LOBE_BLINN);
}

/* -- every column -------------------------------------------------------------------- */

#if TP_DSP
#include "features/water/fast_glints_m4.h"
#define LIGHT packed_light
#else
#include "features/water/fast_light_plain.h"
#define LIGHT plain_light
#endif

#define STAGE(name, env, lobe) \
    void tp_stage_quick_##name(const tp_shade *shade, tp_run *run) \
    { LIGHT(shade, run, env, lobe); }
TP_QUICK_LIGHT_STAGES(STAGE)

/* -- diffuse light alone --------------------------------------------------------------- */

/* Constants of the loops, in registers. */
typedef struct {
    tp_quick_sun sun;
    uint32_t ends, end;         /* 255 of 256 in both halves, in the lower one */
} diffuse_light;

static diffuse_light diffuse_light_make(const tp_shade *shade)
{
    return (diffuse_light){ tp_quick_sun_make(shade), tp_keep_in_register(0x00ff00ff),
                            tp_keep_in_register(0xff) };
}

/* Returns the colour of water that neither glitters nor mirrors.  A channel rounds up: as
 * for the other lights, 255/256 are added before the cut. */
TP_ALWAYS_INLINE uint32_t light_diffuse(const diffuse_light *light, uint32_t slope,
                                        uint32_t colour)
{
    const tp_quick_sun *sun = &light->sun;
    const int32_t l = tp_smlad(slope, sun->back, sun->y);
    const uint32_t lit = (uint32_t)(sun->ambient + sun->direct * tp_usat(l, 18, 8)) >> 8;
    const uint32_t rb = tp_even_bytes(colour) * lit + light->ends;
    const uint32_t g = (tp_odd_bytes(colour) & 0xff) * lit + light->end;

    return tp_halves_add_odd_bytes(g & 0xff00, rb);
}

void tp_stage_quick_diffuse(const tp_shade *shade, tp_run *run)
{
    const diffuse_light light = diffuse_light_make(shade);
    const uint32_t *slope = run->slope;
    uint32_t *colour = run->colour;
    int32_t left = run->count;

    for (; left >= 2; left -= 2, colour += 2) {
        const tp_word_pair s = tp_load_next_pair(&slope), c = tp_load_pair(colour, 0);
        tp_store_pair(colour, 0, light_diffuse(&light, s.first, c.first),
                      light_diffuse(&light, s.second, c.second));
    }
    if (left)
        *colour = light_diffuse(&light, *slope, *colour);
}

/* The same for the even columns and the run's first column, at half rate. */
void tp_stage_quick_diffuse_half(const tp_shade *shade, tp_run *run)
{
    const diffuse_light light = diffuse_light_make(shade);
    const int32_t odd = run->x & 1;
    const uint32_t *slope = run->slope;
    uint32_t *even = run->even, *const end = even + ((run->count + odd + 1) >> 1);

    if (odd) {
        *even = light_diffuse(&light, *slope++, *even);
        even++;
    }
    for (; even != end; even++, slope += 2)
        *even = light_diffuse(&light, *slope, *even);
    if (!shade->evens_only)
        tp_quick_odd_fill(run);
}

const tp_stage tp_fast_water_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_fast_water(X)
#undef X
};

/* -- half rate ----------------------------------------------------------------------- */

/* Light and reflection are computed for even columns and the run's first column.  Glints
 * are computed for every column by its own slope, because glints are what an eye
 * follows. */

#if TP_DSP
#define BODY(name) packed_##name
#else
#include "features/water/fast_light_plain.h"
#define BODY(name) plain_##name
#endif

void tp_stage_quick_gradient_even(const tp_shade *shade, tp_run *run)
{
    BODY(light_even_columns)(shade, run, TP_ENV_GRADIENT);
}

void tp_stage_quick_dome_even(const tp_shade *shade, tp_run *run)
{
    BODY(light_even_columns)(shade, run, TP_ENV_DOME);
}

void tp_stage_quick_cube_even(const tp_shade *shade, tp_run *run)
{
    BODY(light_even_columns)(shade, run, TP_ENV_CUBE);
}

void tp_stage_quick_glint_phong(const tp_shade *shade, tp_run *run)
{
    BODY(glint)(shade, run, TP_LOBE_PHONG);
}

void tp_stage_quick_glint_blinn(const tp_shade *shade, tp_run *run)
{
    BODY(glint)(shade, run, TP_LOBE_BLINN);
}
