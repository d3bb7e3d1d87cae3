/* SPDX-License-Identifier: MIT */
/* Six pictures of the world around [F7]. */
#include "base/assert.h"
#include "shade/skies.h"

/* A PNG without alpha comes with alpha 255 everywhere; nothing is so bright all over, so
 * such a face has no light beyond white. */
static uint32_t mask_of(const tp_texture *face)
{
    TP_ASSERT(face->levels > 0 && face->levels <= TP_TEXTURE_LEVELS);
    uint32_t mean = face->level[face->levels - 1][0];
    return mean >> 24 == 255 ? 0x00ffffffu : 0xffffffffu;
}

bool tp_cube_init(tp_cube *cube, const tp_texture *const face[TP_CUBE_FACES])
{
    for (int i = 0; i < TP_CUBE_FACES; i++) {
        if (!face[i])
            return false;
        cube->face[i] = face[i];
        cube->mask[i] = mask_of(face[i]);
    }
    cube->lod = 0;
    return true;
}

/* 2^29 / m of m = 8192 + 32 i, and one entry more for what is linear between them. */
void tp_recip_init(uint32_t recip[TP_RECIP + 2])
{
    for (uint32_t i = 0; i < TP_RECIP + 2; i++)
        recip[i] = (1u << 29) / (8192 + 32 * i);
}
