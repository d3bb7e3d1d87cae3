/* SPDX-License-Identifier: MIT */
/* The pattern of bubbles: from cover to opacity by a texture's ranks at two scales. */
#ifndef TP_FEATURES_FOAM_FOAM_LACE_H
#define TP_FEATURES_FOAM_FOAM_LACE_H
#include "features/foam/foam.h"
#include "shade/material.h"

#define TP_FOAM_OPAQUE 240      /* of 256: maximal opacity */
#define TP_FOAM_LACE   236      /* of 256: white share of full cover */
#define TP_FOAM_BAND   64       /* of 256: opacity of the bubbles below full cover */
#define TP_FOAM_MEAN_SHARE 286  /* of 256: LACE OPAQUE + BAND, the mean opacity over the
                                 * cover */

typedef struct {
    tp_mip_level level, wide;   /* mipmap levels of both scales; texel NULL: not read */
    int32_t  wide_middle;       /* rank of the mean of the level `wide` */
    int32_t  soft, middle;      /* width of the ramp; rank of its centre */
    int32_t  span;              /* shift of the ramp by full or no cover */
    uint32_t per_soft;          /* 2^16 / soft */
} tp_foam_lace;

/* Selects the mipmap levels of a block by the key of a sample.  The texture of the large
 * scale is two levels finer. */
void tp_foam_lace_select(const tp_shade *shade, const tp_shade_foam *f, uint32_t key,
                         tp_foam_lace *l);

TP_ALWAYS_INLINE uint32_t tp_foam_green(uint32_t texel)
{
    return texel >> 8 & 0xff;
}

/* Return the bilinear green of four texels; s, t in repeats, Q0.32; inline in wide loops. */
TP_ALWAYS_INLINE uint32_t tp_foam_mix_bubbles(const tp_mip_level *level, uint32_t s,
                                              uint32_t t)
{
    tp_four  f = tp_four_gather_centred(level, s, t);
    uint32_t over = tp_foam_green(f.texel[0]) * (256 - f.fs)
                  + tp_foam_green(f.texel[1]) * f.fs;
    uint32_t under = tp_foam_green(f.texel[2]) * (256 - f.fs)
                   + tp_foam_green(f.texel[3]) * f.fs;

    return (over * (256 - f.ft) + under * f.ft + 0x8000) >> 16;
}
uint32_t tp_foam_sample_bubbles(const tp_mip_level *level, uint32_t s, uint32_t t);

/* Returns the cover, more or less by the difference of a rank to the mean's, by at most 4/5
 * of cover (1 - cover). */
TP_ALWAYS_INLINE uint32_t tp_foam_spread_cover(uint32_t cover, int32_t above)
{
    const int32_t spread = (int32_t)(cover * (255 - cover) >> 6);
    return (uint32_t)((int32_t)cover + above * spread * 103 / 65536);
}

/* Returns the cover after the large scale. */
static inline uint32_t tp_foam_patch_cover(const tp_shade_foam *f, const tp_foam_lace *l,
                                           uint32_t cover, uint32_t s, uint32_t t)
{
    if (!l->wide.texel)
        return cover;
    const int32_t rank = (int32_t)f->rank[tp_foam_sample_bubbles(
        &l->wide, s * f->wide_repeats + f->wide_drift_s,
        t * f->wide_repeats + f->wide_drift_t)];
    return tp_foam_spread_cover(cover, rank - l->wide_middle);
}

/* Returns the whiteness 0..256 of a place with this cover, by the rank of its texel.  The
 * mean over all ranks of a texture equals the cover, if the ramp is centred on the texture's
 * mean.  The result is at most four times the cover, so foam appears and vanishes without a
 * jump. */
TP_ALWAYS_INLINE uint32_t tp_foam_whiteness(const tp_foam_lace *l, int32_t rank,
                                            uint32_t cover)
{
    int32_t most = (int32_t)(cover * TP_FOAM_LACE >> 8);
    int32_t up = rank - l->middle + l->soft / 2 - (l->span * (128 - most) >> 7);

    if (up <= 0)
        return 0;
    uint32_t share = (uint32_t)up * l->per_soft >> 8;
    share = share < 4 * cover ? share : 4 * cover;
    return share < 256 ? share : 256;
}

/* Returns the opacity 0..256 of lace of a whiteness over the bubbles of a cover. */
static inline uint32_t tp_foam_lace_opacity(uint32_t white, uint32_t cover)
{
    const uint32_t solid = white * TP_FOAM_OPAQUE >> 8;
    return solid + ((256 - solid) * cover * TP_FOAM_BAND >> 16);
}

#endif
