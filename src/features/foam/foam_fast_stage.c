/* SPDX-License-Identifier: MIT */
/* Foam for less: cover at every eighth column and at the ends of a block, linear between;
 * the lace from the nearest texel; one light for a block.  A block whose ends and cells
 * between have no foam to be seen costs two places.  Plain foam leaves out the lace: its
 * opacity is the mean opacity of lace.
 *
 * Blocks and the columns of the cover are counted in the picture; where a run begins within
 * a block, the picture says so: the result does not depend on the tile. */
#include "features/foam/foam_cover.h"
#include "features/foam/foam_lace.h"
#include "features/foam/foam_window.h"
#include "tidepool/modules.h"

#define LEAST 24                /* cover below this is left out */

/* -- kinds of blocks ----------------------------------------------------------------- */

/* The place of a sample in the window, cells Q16, and its weight; 0 outside. */
typedef struct {
    uint32_t u, w, weight;
} window_place;

TP_ALWAYS_INLINE window_place find_place(const tp_shade_foam *f, const tp_run *run, int32_t i)
{
    const uint32_t ds = run->s[i] - (uint32_t)f->low_s, dt = run->t[i] - (uint32_t)f->low_t;
    window_place p = { 0, 0, 0 };

    if (ds >= f->side || dt >= f->side)
        return p;
    p.u = tp_foam_cells(f, ds);
    p.w = tp_foam_cells(f, dt);
    p.weight = tp_foam_window_weight(f, p.u, p.w);
    return p;
}

TP_ALWAYS_INLINE void set_range(uint32_t range[2], uint32_t a, uint32_t b)
{
    range[0] = a < b ? a : b;
    range[1] = a < b ? b : a;
}

/* True if a block from one place to another has no foam: no cover lies between, and none
 * beyond the window. */
static bool is_block_empty(const tp_shade_foam *f, const window_place *a,
                           const window_place *b)
{
    const bool far = f->far_fresh || f->floor;
    uint32_t u[2], w[2];

    if (a->weight == 0 || b->weight == 0)
        return !far && a->weight == b->weight;
    if (far && (a->weight < 256 || b->weight < 256))
        return false;
    set_range(u, a->u, b->u);
    set_range(w, a->w, b->w);
    return tp_foam_is_range_empty(f, u, w);
}

/* -- opacity and colour -------------------------------------------------------------- */

#define FAINT 6                 /* of 256: opacities of lace below this are left out */

/* Mixes the colour, in the block's light, into sample i. */
TP_ALWAYS_INLINE void mix(tp_run *run, int32_t i, uint32_t colour, uint32_t share,
                          int has_glint)
{
    run->colour[i] = tp_colour_mix(run->colour[i], colour, share);
    if (has_glint)
        run->glint[i] = (uint16_t)(run->glint[i] * (256 - share) >> 8);
}

/* The samples i..stop, over which the cover goes from `cover` by `step` a column, Q16. */
typedef struct {
    int32_t i, stop, cover, step;
} segment;

/* Lace of a block.  The ramp is linear in the cover: `up` is its height at rank 0 without
 * cover, Q16, per_cover its rise; per_up the opacity 0..240 over the height, Q16. */
typedef struct {
    const uint32_t *texel;
    uint32_t repeats, drift_s, drift_t, down_s, down_t, log2_w;
    int32_t  up, per_cover, per_up;
} ramp;

static ramp make_ramp(const tp_shade_foam *f, const tp_foam_lace *l)
{
    return (ramp){
        l->level.texel, f->repeats, f->drift_s, f->drift_t, l->level.down_s,
        l->level.down_t, l->level.log2_w,
        (l->soft / 2 - l->middle - l->span + (l->level.texel ? 0 : 128)) * 65536,
        l->span * TP_FOAM_LACE / 128, (int32_t)l->per_soft * TP_FOAM_OPAQUE >> 8
    };
}

/* Returns the rank of the nearest texel, 0..255. */
TP_ALWAYS_INLINE int32_t nearest_rank(const ramp *r, const tp_entry8 *rank, uint32_t s,
                                      uint32_t t)
{
    const uint32_t u = (s * r->repeats + r->drift_s) >> 8 >> r->down_s,
                   v = (t * r->repeats + r->drift_t) >> 8 >> r->down_t;

    return (int32_t)rank[r->texel[(v << r->log2_w) + u] >> 8 & 0xff];
}

/* Returns the opacity 0..256: white by the ramp, at most 15/4 of the cover, over bubbles. */
TP_ALWAYS_INLINE uint32_t ramp_opacity(int32_t up, int32_t per_up, uint32_t cover)
{
    const uint32_t most = cover < 64 ? cover * 15 / 4 : TP_FOAM_OPAQUE;
    const uint32_t white = up > 0 ? (uint32_t)(up * per_up) >> 8 : 0;
    const uint32_t solid = white < most ? white : most;

    return solid + ((256 - solid) * cover * TP_FOAM_BAND >> 16);
}

TP_ALWAYS_INLINE void mix_laced_segment(tp_run *run, const segment *g, const ramp *block,
                                        uint32_t colour, int has_glint)
{
    const tp_shade_foam *f = run->mine;
    const ramp r = *block;
    int32_t cover = g->cover, up = r.up + (g->cover >> 8) * r.per_cover;
    const int32_t rise = (g->step >> 8) * r.per_cover;

    for (int32_t i = g->i; i < g->stop; i++, cover += g->step, up += rise) {
        const int32_t rank =
            r.texel ? nearest_rank(&r, f->rank, run->s[i], run->t[i]) : 0;
        const uint32_t share =
            ramp_opacity((up >> 16) + rank, r.per_up, (uint32_t)cover >> 16);

        if (share >= FAINT)
            mix(run, i, colour, share, has_glint);
    }
}

TP_ALWAYS_INLINE void mix_plain_segment(tp_run *run, const segment *g, uint32_t colour,
                                        int has_glint)
{
    int32_t cover = g->cover;

    for (int32_t i = g->i; i < g->stop; i++, cover += g->step)
        mix(run, i, colour, (uint32_t)cover / 256 * TP_FOAM_MEAN_SHARE >> 16, has_glint);
}

/* -- blocks -------------------------------------------------------------------------- */

/* A block of samples: its ends, values shared by the samples, and their colour of foam. */
typedef struct {
    window_place begin, end;
    int32_t  first, last;       /* the first sample gives the depth */
    bool     ready, far;        /* lace and colour are set; `filtered` is */
    uint32_t colour, filtered;
    tp_foam_lace lace;
    ramp     ramp;
} block;

/* Sets the lace and the colour in the light of the block's middle. */
static void prepare_block(const tp_shade *shade, const tp_run *run, int32_t middle,
                          int has_lace, block *b)
{
    const tp_shade_foam *f = run->mine;
    const uint32_t n = run->n[middle];
    const uint32_t light =
        tp_foam_light_share(shade, (int16_t)(n >> 16), (int16_t)(n & 0xffff));

    b->ready = true;
    b->colour = tp_colour_scale(f->colour, light);
    if (has_lace)
        tp_foam_lace_select(shade, f, run->key[b->first], &b->lace);
    if (has_lace)
        b->ramp = make_ramp(f, &b->lace);
}

/* Returns the cover 0..255 at sample i. */
static uint32_t sample_block_cover(const tp_shade *shade, const tp_run *run, int32_t i,
                                   block *b)
{
    const tp_shade_foam *f = run->mine;
    const window_place p = i == b->first ? b->begin : i == b->last ? b->end
                         : find_place(f, run, i);
    const uint32_t cover = p.weight ? tp_foam_sample_cover(f, p.u, p.w) : 0;

    if (p.weight == 256 || !(f->far_fresh || f->floor))
        return (cover * p.weight + 128) >> 8;
    if (!b->far)
        b->filtered = tp_foam_filtered_variance(shade, f, run->key[b->first]);
    b->far = true;
    return (cover * p.weight
            + tp_foam_far_cover(f, run, i, b->filtered) * (256 - p.weight) + 128) >> 8;
}

/* Returns the cover at sample i after the large scale of lace. */
TP_ALWAYS_INLINE uint32_t sample_patched_cover(const tp_shade *shade, const tp_run *run,
                                           int32_t i, int32_t stop, int has_lace, block *b)
{
    const uint32_t cover = sample_block_cover(shade, run, i, b);

    if (cover < LEAST)
        return 0;
    if (!b->ready)
        prepare_block(shade, run, (b->first + stop) / 2, has_lace, b);
    return has_lace
         ? tp_foam_patch_cover(run->mine, &b->lace, cover, run->s[i], run->t[i]) : cover;
}

/* Sets the rise of cover from sample g->i to sample `to`, and the end: the block's if `to`
 * is its last sample. */
static void end_segment(segment *g, int32_t to, int32_t stop, uint32_t cover)
{
    const int32_t rise = (int32_t)cover * 65536 - g->cover;

    g->stop = to + 1 < stop ? to : stop;
    g->step = to > g->i ? rise / (to - g->i) : 0;
}

TP_ALWAYS_INLINE void mix_block(const tp_shade *shade, tp_run *run, int32_t stop, block *b,
                                int has_lace, int has_glint)
{
    segment g = { .i = b->first };
    uint32_t cover = sample_patched_cover(shade, run, g.i, stop, has_lace, b);

    for (; g.i < stop; g.i = g.stop) {
        const int32_t next = g.i + 8 - ((run->x + g.i) & 7);
        const int32_t to = next < stop - 1 ? next : stop - 1;
        g.cover = (int32_t)cover * 65536;
        cover = sample_patched_cover(shade, run, to, stop, has_lace, b);
        end_segment(&g, to, stop, cover);
        if (!(g.cover | g.step))
            continue;
        if (has_lace)
            mix_laced_segment(run, &g, &b->ramp, b->colour, has_glint);
        else
            mix_plain_segment(run, &g, b->colour, has_glint);
    }
}

TP_ALWAYS_INLINE void fast_run(const tp_shade *shade, tp_run *run, int has_lace,
                               int has_glint)
{
    const tp_shade_foam *f = run->mine;

    TP_ASSERT(f->cover != NULL && f->cells > 0);

    for (int32_t i = f->none ? run->count : 0, stop; i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        const window_place begin = find_place(f, run, i), end = find_place(f, run, stop - 1);
        block b;
        if (is_block_empty(f, &begin, &end))
            continue;
        b.begin = begin;
        b.end = end;
        b.first = i;
        b.last = stop - 1;
        b.ready = b.far = false;
        mix_block(shade, run, stop, &b, has_lace, has_glint);
    }
}

#define FOAM_STAGE(name, lace, shiny) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { fast_run(shade, run, lace, shiny); }
TP_FOAM_FAST_STAGES(FOAM_STAGE)
