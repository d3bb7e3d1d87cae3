/* SPDX-License-Identifier: MIT */
/* The pattern of bubbles: mipmap levels of a block, ranks of a texture's texels. */
#include "features/foam/foam_lace.h"

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

static void set_ramp_softness(tp_foam_lace *l, int32_t level)
{
    level = level < SOFTS ? level : SOFTS;
    l->soft = softs[level].soft;
    l->span = softs[level].span;
    l->per_soft = softs[level].per_soft;
}

void tp_foam_lace_select(const tp_shade *shade, const tp_shade_foam *f, uint32_t key,
                         tp_foam_lace *l)
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

uint32_t tp_foam_sample_bubbles(const tp_mip_level *level, uint32_t s, uint32_t t)
{
    return tp_foam_mix_bubbles(level, s, t);
}
