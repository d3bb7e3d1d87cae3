/* SPDX-License-Identifier: MIT */
/* Cube map of the surroundings, six pictures [F7]. */
#include "base/assert.h"
#include "shade/skies.h"

/* Returns the mask of a face's texels.  A PNG without alpha loads with alpha 255 in each
 * texel.  No real face is that bright all over: such a face has no light beyond white. */
static uint32_t alpha_mask(const tp_texture *face)
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
        cube->mask[i] = alpha_mask(face[i]);
    }
    cube->lod = 0;
    return true;
}

/* Entry i is 2^29 / m for m = 8192 + 32 i.  One extra entry serves linear interpolation. */
void tp_recip_init(uint32_t recip[TP_RECIP + 2])
{
    for (uint32_t i = 0; i < TP_RECIP + 2; i++)
        recip[i] = (1u << 29) / (8192 + 32 * i);
}
