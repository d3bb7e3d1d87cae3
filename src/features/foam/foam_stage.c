/* SPDX-License-Identifier: MIT */
/* Foam on water.  The field gives the cover, which is the foam's age: fresh foam has full
 * cover, old foam little.  A texture of bubbles gives the pattern of white.  A texel is
 * white if its rank among all texels, 0..1, is above 1 - cover.  Fresh foam therefore is
 * white nearly all over; with age the foam breaks up into lace, into specks, and vanishes.
 * The same texture, four times as large, moves the cover up and down first: patches and
 * holes of the lace.  Every texture turns white by the share in the field.  The threshold
 * is soft, over a third of the ranks.  Smaller mipmap levels, whose texels are more alike, use
 * a wider threshold, and small levels are not read: far foam shows the cover itself.
 * Bubbles below the lace lighten the water by BAND of the cover.
 *
 * Foam is matt: it reflects diffuse light only and hides the glitter under it.
 *
 * In the outer part of the round window the cover passes into the cover beyond.  There the
 * waves' backs have old foam, and by the fourth power of their slope fresh foam; the mean
 * over the sea is the mean of the field, so no disc shows from above.  The field itself,
 * repeated as the torus that it is, shows more of its shapes, but repeats a boat's wake and
 * the large waves' crests in every square.  Along a straight beach the field does repeat:
 * crests run along the beach.  Over a map of the floor the depth gives the cover of the
 * surf: see foam_surf.c. */
#include "features/foam/foam_cover.h"
#include "features/foam/foam_lace.h"
#include "features/foam/foam_window.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

/* -- cover along a beach ------------------------------------------------------------- */

/* Returns the window's cover at a place, times its weight. */
TP_ALWAYS_INLINE uint32_t weigh_cover(const tp_shade_foam *f, uint32_t s, uint32_t t)
{
    uint32_t weight, cover = tp_foam_sample_window(f, s, t, &weight);
    return (cover * weight + 128) >> 8;
}

/* Returns the cover beyond the window along a straight beach: the stretch around the
 * window's middle repeats, at the same distance from the water's line.  Over the last eighth
 * of a stretch the cover passes into that before the stretch's beginning, so no seam
 * shows. */
uint32_t tp_foam_shore_cover(const tp_shade_foam *f, const tp_run *run, int32_t i,
                             uint32_t v)
{
    uint32_t s = run->s[i], t = run->t[i];
    const int32_t ds = (int32_t)(s - (uint32_t)f->low_s - f->side / 2);
    const int32_t dt = (int32_t)(t - (uint32_t)f->low_t - f->side / 2);
    const int64_t across = ((int64_t)dt * f->shore_x - (int64_t)ds * f->shore_z) >> 13;

    (void)v;
    if (across >= f->side || -across >= f->side)
        return 0;
    const int32_t along = (int32_t)(((int64_t)ds * f->shore_x + (int64_t)dt * f->shore_z)
                                    >> 14);
    const int32_t far = along / 2 + f->stretch / 4;     /* halves: the sum stays in range */
    const int32_t turns = far / (f->stretch / 2) - (far % (f->stretch / 2) < 0);
    const int64_t back = (int64_t)turns * f->stretch;
    const int32_t left = (int32_t)(back + f->stretch / 2 - along);
    const int32_t seam = f->stretch / 8;

    s -= (uint32_t)(back * f->shore_x >> 14);
    t -= (uint32_t)(back * f->shore_z >> 14);
    const uint32_t cover = weigh_cover(f, s, t);
    if (left >= seam)
        return cover;
    s -= (uint32_t)((int64_t)f->stretch * f->shore_x >> 14);
    t -= (uint32_t)((int64_t)f->stretch * f->shore_z >> 14);
    const uint32_t share = (uint32_t)(left < 0 ? 0 : left) / 64 * 256
                         / ((uint32_t)seam / 64 + 1);
    return (cover * share + weigh_cover(f, s, t) * (256 - share) + 128) >> 8;
}

/* -- cover beyond the window --------------------------------------------------------- */

uint32_t tp_foam_filtered_variance(const tp_shade *shade, const tp_shade_foam *f,
                                   uint32_t key)
{
    if (!shade->filtered)
        return 0;
    const tp_slope_variance v =
        tp_filtered_waves_lookup(shade->filtered, tp_log_depth(shade, key));
    return tp_foam_relative_square(f, v.left);
}

TP_ALWAYS_INLINE uint32_t far_cover(const tp_shade_foam *f, const tp_run *run, int32_t i,
                                    uint32_t v)
{
    if (!f->far_fresh)
        return f->floor ? f->floor_cover(f, run, i, v) : 0;
    return tp_foam_open_cover(f, f->far_fresh, f->far_old, run, i, v);
}

uint32_t tp_foam_far_cover(const tp_shade_foam *f, const tp_run *run, int32_t i, uint32_t v)
{
    return far_cover(f, run, i, v);
}

/* -- the stage ----------------------------------------------------------------------- */

enum { UNBENT, BENT, PACKED };  /* slopes: the G-buffer's, sx and sz, or run->slope */

TP_ALWAYS_INLINE uint32_t slope_light(const tp_shade *shade, const tp_run *run, int32_t i,
                                      int slopes)
{
    if (slopes == PACKED)
        return tp_foam_light_share(shade, (int16_t)(run->slope[i] >> 16),
                                   (int16_t)(run->slope[i] & 0xffff));
    return tp_foam_light_share(shade, tp_slope_x(run, i, slopes),
                               tp_slope_z(run, i, slopes));
}

TP_ALWAYS_INLINE uint32_t laced_opacity(const tp_shade_foam *f, const tp_foam_lace *l,
                                        uint32_t cover, uint32_t s, uint32_t t)
{
    int32_t rank = 128;

    cover = tp_foam_patch_cover(f, l, cover, s, t);
    if (l->level.texel)
        rank = (int32_t)f->rank[tp_foam_sample_bubbles(&l->level, s * f->repeats + f->drift_s,
                                              t * f->repeats + f->drift_t)];
    return tp_foam_lace_opacity(tp_foam_whiteness(l, rank, cover), cover);
}

/* A block of samples: values shared by them. */
typedef struct {
    tp_foam_block_kind kind;
    bool     laced, far;        /* lace and filtered are set */
    uint32_t filtered;
    tp_foam_lace lace;
} block;

/* Returns the cover 0..255 of a sample and its window's weight. */
TP_ALWAYS_INLINE uint32_t sample_cover(const tp_shade *shade, const tp_run *run, int32_t i,
                                       int32_t first, block *b, uint32_t *weight)
{
    const tp_shade_foam *f = run->mine;
    uint32_t cover = 0;

    *weight = b->kind == TP_FOAM_BLOCK_INSIDE ? 256 : 0;
    if (b->kind == TP_FOAM_BLOCK_INSIDE)
        return tp_foam_sample_cover(f, tp_foam_cells(f, run->s[i] - (uint32_t)f->low_s),
                                    tp_foam_cells(f, run->t[i] - (uint32_t)f->low_t));
    if (b->kind == TP_FOAM_BLOCK_MIXED)
        cover = tp_foam_sample_window(f, run->s[i], run->t[i], weight);
    if (*weight == 256)
        return cover;
    if (!b->far)
        b->filtered = tp_foam_filtered_variance(shade, f, run->key[first]);
    b->far = true;
    return (cover * *weight + far_cover(f, run, i, b->filtered) * (256 - *weight) + 128) >> 8;
}

/* Returns the opacity 0..256 of a sample's foam. */
TP_ALWAYS_INLINE uint32_t sample_opacity(const tp_shade *shade, const tp_run *run, int32_t i,
                                         int32_t first, block *b)
{
    const tp_shade_foam *f = run->mine;
    uint32_t weight, cover = sample_cover(shade, run, i, first, b, &weight);

    if (cover == 0)
        return 0;
    if (weight < 256 && cover < TP_FOAM_FAINT)
        return (cover * TP_FOAM_MEAN_SHARE + 128) >> 8;
    if (!b->laced)
        tp_foam_lace_select(shade, f, run->key[first], &b->lace);
    b->laced = true;
    return laced_opacity(f, &b->lace, cover, run->s[i], run->t[i]);
}

#include "features/foam/foam_wide.h"

TP_ALWAYS_INLINE void foam_run(const tp_shade *shade, tp_run *run, int slopes, int has_glint)
{
    const tp_shade_foam *f = run->mine;

    TP_ASSERT(f->cover != NULL && f->cells > 0);

    for (int32_t i = f->none ? run->count : 0; i < run->count; ) {
        const int32_t first = i, stop = tp_block_end(run, i);
        block b = { .kind = tp_foam_block_classify(f, run, i, stop) };
        if (b.kind == TP_FOAM_BLOCK_EMPTY)      /* the case of most water */
            i = stop;
        if (TP_WIDE && i < stop) {
            foam_columns_wide(shade, run, i, stop - i, slopes, has_glint);
            i = stop;
        }
        for (; i < stop; i++) {
            const uint32_t share = sample_opacity(shade, run, i, first, &b);
            if (share == 0)
                continue;
            const uint32_t colour =
                tp_colour_scale(f->colour, slope_light(shade, run, i, slopes));
            run->colour[i] = tp_colour_mix(run->colour[i], colour, share);
            if (has_glint)
                run->glint[i] = (uint16_t)(run->glint[i] * (256 - share) >> 8);
        }
    }
}

#define FOAM_STAGE(name, slopes, shiny) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { foam_run(shade, run, slopes, shiny); }
TP_FOAM_STAGES(FOAM_STAGE)

const tp_stage tp_foam_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_foam(X)
#undef X
};
