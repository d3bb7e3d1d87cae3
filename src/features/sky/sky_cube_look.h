/* SPDX-License-Identifier: MIT */
/* Cube map look-ups along many directions at one mipmap level, with the result of env.h.
 * The faces' data at the level are found once.  On processors with SIMD, steps for eight
 * directions at once are separate loops. */
#ifndef TP_SKY_CUBE_LOOK_H
#define TP_SKY_CUBE_LOOK_H
#include "shade/env.h"

typedef struct {
    int level;                  /* mipmap level of `side`; -1: not set */
    tp_cube_face_level side[TP_CUBE_FACES];
} tp_cube_sides;

TP_ALWAYS_INLINE void tp_cube_sides_select(tp_cube_sides *sides, const tp_cube *cube,
                                           int level)
{
    if (sides->level == level)
        return;
    sides->level = level;
    for (int i = 0; i < TP_CUBE_FACES; i++)
        sides->side[i] = tp_cube_face_level_select(cube->face[i], level);
}

#define TP_CUBE_ROW 16

/* Looks up to TP_CUBE_ROW directions.  The faces and coordinates are computed eight at a
 * time, the texels are read one by one, the colours are mixed eight at a time. */
TP_ALWAYS_INLINE void tp_cube_sample_wide(const tp_shade *restrict shade,
                                          const tp_cube_face_level *restrict side,
                                          const int32_t *restrict x,
                                          const int32_t *restrict y,
                                          const int32_t *restrict z, int32_t count,
                                          uint32_t *restrict out)
{
    int32_t  face[TP_CUBE_ROW], first[TP_CUBE_ROW];
    int32_t  right[TP_CUBE_ROW], below[TP_CUBE_ROW];
    uint32_t fu[TP_CUBE_ROW], fv[TP_CUBE_ROW], four[4][TP_CUBE_ROW];

    for (int32_t i = 0; i < count; i++) {
        tp_cube_ray  c = tp_cube_face(x[i], y[i], z[i]);
        tp_cube_four f = tp_cube_gather(shade->env.recip, c.m, c.right, c.down,
                                        side[c.face].log2_w, side[c.face].log2_h);
        face[i] = c.face;
        first[i] = f.first;
        right[i] = f.right;
        below[i] = f.below;
        fu[i] = f.fu;
        fv[i] = f.fv;
    }
    for (int32_t i = 0; i < count; i++) {
        const uint32_t *at = side[face[i]].texel + first[i], *low = at + below[i];
        four[0][i] = at[0];
        four[1][i] = at[right[i]];
        four[2][i] = low[0];
        four[3][i] = low[right[i]];
    }
    for (int32_t i = 0; i < count; i++)
        out[i] = tp_cube_mix(four[0][i], four[1][i], four[2][i], four[3][i], fu[i], fv[i])
               & shade->env.cube->mask[face[i]];
}
#endif
