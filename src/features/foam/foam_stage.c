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
#include "shade/material.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

#define OPAQUE 240              /* of 256: maximal opacity */
#define LACE   236              /* of 256: white share of full cover */
#define BAND   64               /* of 256: opacity of the bubbles below full cover */

void tp_shade_foam_make_ranks(tp_shade_foam *foam, const tp_texture *texture)
{
    TP_ASSERT(texture->levels > 0);
    uint32_t count[256] = { 0 }, total = 1u << (texture->log2_w + texture->log2_h);
    uint64_t below = 0;

    for (uint32_t i = 0; i < total; i++)
        count[texture->level[0][i] >> 8 & 0xff]++;
    for (int v = 0; v < 256; v++) {
        foam->rank[v] = (uint8_t)(((below + count[v] / 2) * 255 + total / 2) / total);
        below += count[v];
    }
    foam->mean = (int16_t)foam->rank[texture->level[texture->levels - 1][0] >> 8 & 0xff];
}

/* -- cover --------------------------------------------------------------------------- */

/* Returns the cover 0..255, bilinear between cell centres.  u and w: cells from the
 * window's low corner, Q16. */
TP_ALWAYS_INLINE uint32_t sample_cover(const tp_shade_foam *f, uint32_t u, uint32_t w)
{
    uint32_t n = f->cells;
    uint32_t a = u + 32768, b = w + 32768;      /* half a cell back, and one cell ahead */
    uint32_t i = (a >> 16) + f->col, j = (b >> 16) + f->row;

    i -= i >= n ? n : 0;
    j -= j >= n ? n : 0;
    uint32_t i1 = i + 1 < n ? i + 1 : 0, j1 = j + 1 < n ? j + 1 : 0;
    const uint8_t *here = f->cover + (size_t)j * n, *below = f->cover + (size_t)j1 * n;
    if ((here[i] | here[i1] | below[i] | below[i1]) == 0)
        return 0;
    uint32_t fs = a >> 8 & 0xff, ft = b >> 8 & 0xff;
    uint32_t over = here[i] * (256 - fs) + here[i1] * fs;
    uint32_t under = below[i] * (256 - fs) + below[i1] * fs;
    return (over * (256 - ft) + under * ft + 0x8000) >> 16;
}

/* Returns the weight of the cover against the mean: 256 inside, 0 from the window's
 * inscribed circle on.  The weight falls with the square of the distance, from 3/4 of the
 * radius on. */
TP_ALWAYS_INLINE uint32_t window_weight(const tp_shade_foam *f, uint32_t u, uint32_t w)
{
    const uint32_t r = f->cells * 128;
    const int32_t du = (int32_t)(u >> 8) - (int32_t)r, dw = (int32_t)(w >> 8) - (int32_t)r;
    const uint32_t square = (uint32_t)(du * du) + (uint32_t)(dw * dw);

    if (square <= (r * r >> 4) * 9 || f->edge == UINT32_MAX)
        return 256;
    if (square >= r * r)
        return 0;
    const uint64_t share = (uint64_t)(r * r - square) * f->edge >> 32;
    return share < 256 ? (uint32_t)share : 256;
}

/* Returns the cover 0..255 at a place and its weight, 0 outside of the window. */
TP_ALWAYS_INLINE uint32_t sample_window(const tp_shade_foam *f, uint32_t s, uint32_t t,
                                        uint32_t *weight)
{
    uint32_t ds = s - (uint32_t)f->low_s, dt = t - (uint32_t)f->low_t;

    *weight = 0;
    if (ds >= f->side || dt >= f->side)
        return 0;
    uint32_t u = (uint32_t)(ds * f->per_metre >> 32);
    uint32_t w = (uint32_t)(dt * f->per_metre >> 32);
    *weight = window_weight(f, u, w);
    return *weight ? sample_cover(f, u, w) : 0;
}

/* Returns the window's cover at a place, times its weight. */
TP_ALWAYS_INLINE uint32_t weigh_cover(const tp_shade_foam *f, uint32_t s, uint32_t t)
{
    uint32_t weight, cover = sample_window(f, s, t, &weight);
    return (cover * weight + 128) >> 8;
}

/* Returns the cover beyond the window along a straight beach: the stretch around the
 * window's middle repeats, at the same distance from the water's line.  Over the last eighth
 * of a stretch the cover passes into that before the stretch's beginning, so no seam
 * shows. */
static uint32_t shore_cover(const tp_shade_foam *f, uint32_t s, uint32_t t)
{
    const int32_t ds = (int32_t)(s - (uint32_t)f->low_s - f->side / 2);
    const int32_t dt = (int32_t)(t - (uint32_t)f->low_t - f->side / 2);
    const int64_t across = ((int64_t)dt * f->shore_x - (int64_t)ds * f->shore_z) >> 13;

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

/* -- bubbles ------------------------------------------------------------------------- */

typedef struct {
    tp_mip_level level, wide;   /* mipmap levels of both scales; texel NULL: not read */
    int32_t  wide_middle;       /* rank of the mean of the level `wide` */
    int32_t  soft, middle;      /* width of the ramp; rank of its centre */
    int32_t  span;              /* shift of the ramp by full or no cover */
    uint32_t per_soft;          /* 2^16 / soft */
} lace;

/* Softness by mipmap level; the last entry serves all smaller levels. */
static const struct { int16_t soft, span; uint16_t per_soft; } softs[] = {
    { 80, 168, 819 }, { 115, 160, 569 }, { 150, 152, 436 }, { 186, 144, 352 },
    { 221, 136, 296 }, { 256, 128, 256 },
};
#define SOFTS (int32_t)(sizeof softs / sizeof softs[0] - 1)

/* Returns the rank of a level's mean. */
static int32_t level_middle(const tp_shade_foam *f, int32_t level)
{
    return 128 + (f->mean - 128) * (level < SOFTS ? level : SOFTS) * 51 / 256;
}

static void set_ramp_softness(lace *l, int32_t level)
{
    level = level < SOFTS ? level : SOFTS;
    l->soft = softs[level].soft;
    l->span = softs[level].span;
    l->per_soft = softs[level].per_soft;
}

/* Selects the mipmap levels of a block.  The texture of the large scale is two levels
 * finer. */
static void select_bubble_levels(const tp_shade *shade, const tp_shade_foam *f,
                                 uint32_t key, lace *l)
{
    const tp_texture *texture = f->texture;
    const int32_t depth = tp_log_depth(shade, key);

    l->level.texel = l->wide.texel = NULL;
    set_ramp_softness(l, SOFTS);
    l->middle = 128;
    if (!texture)
        return;
    const int n = tp_mip_level_choose(f->lod, depth, true, texture->levels);
    const int far = tp_mip_level_choose(f->lod - 512, depth, true, texture->levels);
    if (far < SOFTS)
        l->wide = tp_mip_level_select(texture, far);
    l->wide_middle = level_middle(f, far);
    if (n >= SOFTS)
        return;
    l->level = tp_mip_level_select(texture, n);
    set_ramp_softness(l, n);
    l->middle = level_middle(f, n);
}

static uint32_t green(uint32_t texel)
{
    return texel >> 8 & 0xff;
}

/* Returns the bilinear green of four texels; s, t in repeats, Q0.32. */
TP_ALWAYS_INLINE uint32_t mix_bubbles(const tp_mip_level *level, uint32_t s, uint32_t t)
{
    tp_four  f = tp_four_gather_centred(level, s, t);
    uint32_t over = green(f.texel[0]) * (256 - f.fs) + green(f.texel[1]) * f.fs;
    uint32_t under = green(f.texel[2]) * (256 - f.fs) + green(f.texel[3]) * f.fs;

    return (over * (256 - f.ft) + under * f.ft + 0x8000) >> 16;
}

static uint32_t sample_bubbles(const tp_mip_level *level, uint32_t s, uint32_t t)
{
    return mix_bubbles(level, s, t);
}

/* Returns the cover, more or less by the difference of a rank to the mean's, by at most 4/5
 * of cover (1 - cover). */
TP_ALWAYS_INLINE uint32_t spread_cover(uint32_t cover, int32_t above)
{
    const int32_t spread = (int32_t)(cover * (255 - cover) >> 6);
    return (uint32_t)((int32_t)cover + above * spread * 103 / 65536);
}

/* Returns the cover after the large scale. */
static uint32_t patch_cover(const tp_shade_foam *f, const lace *l, uint32_t cover,
                            uint32_t s, uint32_t t)
{
    if (!l->wide.texel)
        return cover;
    const int32_t rank = (int32_t)f->rank[sample_bubbles(&l->wide, s * f->wide_repeats
                                                          + f->wide_drift_s,
                                                t * f->wide_repeats + f->wide_drift_t)];
    return spread_cover(cover, rank - l->wide_middle);
}

/* Returns the whiteness 0..256 of a place with this cover.  The mean over all ranks of a
 * texture equals the cover, if the ramp is centred on the texture's mean.  The
 * result is at most four times the cover, so foam appears and vanishes without a jump. */
TP_ALWAYS_INLINE uint32_t rank_whiteness(const lace *l, uint32_t cover, int32_t rank)
{
    int32_t most = (int32_t)(cover * LACE >> 8);
    int32_t up = rank - l->middle + l->soft / 2 - (l->span * (128 - most) >> 7);

    if (up <= 0)
        return 0;
    uint32_t share = (uint32_t)up * l->per_soft >> 8;
    share = share < 4 * cover ? share : 4 * cover;
    return share < 256 ? share : 256;
}

/* Returns the opacity 0..256 of lace of a whiteness over the bubbles of a cover. */
static uint32_t lace_opacity(uint32_t white, uint32_t cover)
{
    const uint32_t solid = white * OPAQUE >> 8;
    return solid + ((256 - solid) * cover * BAND >> 16);
}

/* -- the stage ----------------------------------------------------------------------- */

/* Returns the lighting 128..256 of foam: ambient and direct light on the water's slope,
 * raised by half of the difference to white, because bubbles scatter light.  Slopes above
 * 2 (63 degrees) count as 2. */
TP_ALWAYS_INLINE uint32_t foam_light_share(const tp_shade *shade, const tp_run *run,
                                           int32_t i, int rippled)
{
    int32_t sx = tp_slope_x(run, i, rippled), sz = tp_slope_z(run, i, rippled);
    uint32_t q = tp_slope_square(sx, sz);
    int32_t ny = (int32_t)tp_steep_table[(q < TP_SLOPE_END ? q : TP_SLOPE_END - 1) >> 17];
    int32_t nl = shade->world.ly - ((sx * shade->world.lx + sz * shade->world.lz) >> 12);

    nl = tp_clamp(nl * (ny >> 2) >> 12, 0, 16384);
    return (uint32_t)(256 + tp_lit_share(shade->ambient, nl)) / 2;
}

#define FAINT     10            /* less cover towards the edge and beyond shows no lace */
#define FAINT_SHARE 286         /* of 256: LACE OPAQUE + BAND, its opacity over the cover */

/* Returns the variance of slopes of the waves that the grid leaves out at a depth, over
 * the mean square, Q8. */
static uint32_t filtered_variance(const tp_shade *shade, const tp_shade_foam *f,
                                  uint32_t key)
{
    if (!shade->filtered)
        return 0;
    const tp_slope_variance v =
        tp_filtered_waves_lookup(shade->filtered, tp_log_depth(shade, key));
    return tp_foam_relative_square(f, v.left);
}

/* Returns the cover 0..255 beyond the window over a floor. */
static uint32_t floor_cover(const tp_shade_foam *f, const tp_run *run, int32_t i, uint32_t v)
{
    return f->floor == TP_FOAM_DEPTH ? tp_foam_surf_cover(f, run, i, v)
                                   : shore_cover(f, run->s[i], run->t[i]);
}

/* Returns the cover 0..255 beyond the window. */
TP_ALWAYS_INLINE uint32_t far_cover(const tp_shade_foam *f, const tp_run *run, int32_t i,
                                    uint32_t v)
{
    if (!f->far_fresh)
        return f->floor ? floor_cover(f, run, i, v) : 0;
    return tp_foam_open_cover(f, f->far_fresh, f->far_old, run, i, v);
}

TP_ALWAYS_INLINE uint32_t laced_opacity(const tp_shade_foam *f, const lace *l,
                                        uint32_t cover, uint32_t s, uint32_t t)
{
    cover = patch_cover(f, l, cover, s, t);
    int32_t rank = 128;
    if (l->level.texel)
        rank = (int32_t)f->rank[sample_bubbles(&l->level, s * f->repeats + f->drift_s,
                                               t * f->repeats + f->drift_t)];
    return lace_opacity(rank_whiteness(l, cover, rank), cover);
}

#include "features/foam/foam_wide.h"

TP_ALWAYS_INLINE void foam_run(const tp_shade *shade, tp_run *run, int rippled,
                               int has_glint)
{
    const tp_shade_foam *f = run->mine;

    TP_ASSERT(f->cover != NULL && f->cells > 0);

    for (int32_t i = 0; i < run->count; ) {
        int32_t first = i, stop = tp_block_end(run, i);
        lace    l;
        bool    laced = false, far = false;
        uint32_t filtered = 0;
        if (TP_WIDE) {
            foam_columns_wide(shade, run, i, stop - i, rippled, has_glint);
            i = stop;
        }
        for (; i < stop; i++) {
            uint32_t share, weight, cover = sample_window(f, run->s[i], run->t[i], &weight);
            if (weight < 256) {
                if (!far)
                    filtered = filtered_variance(shade, f, run->key[first]);
                far = true;
                cover = (cover * weight
                         + far_cover(f, run, i, filtered) * (256 - weight) + 128) >> 8;
            }
            if (cover == 0)     /* the case of most water pixels */
                continue;
            if (weight < 256 && cover < FAINT) {
                share = (cover * FAINT_SHARE + 128) >> 8;
            } else {
                if (!laced)
                    select_bubble_levels(shade, f, run->key[first], &l);
                laced = true;
                share = laced_opacity(f, &l, cover, run->s[i], run->t[i]);
            }
            const uint32_t colour =
                tp_colour_scale(f->colour, foam_light_share(shade, run, i, rippled));
            run->colour[i] = tp_colour_mix(run->colour[i], colour, share);
            if (has_glint)
                run->glint[i] = (uint16_t)(run->glint[i] * (256 - share) >> 8);
        }
    }
}

#define FOAM_STAGE(name, rippled, shiny) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { foam_run(shade, run, rippled, shiny); }
TP_FOAM_STAGES(FOAM_STAGE)

const tp_stage tp_foam_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_foam(X)
#undef X
};
