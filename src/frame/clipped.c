/* SPDX-License-Identifier: MIT */
/* Triangles clipped by the near plane, the frustum or a level; shared by all solids. */
#include "frame/sight.h"

tp_view_corner tp_clipped_corner(const tp_lens *lens, tp_vec3 at, const int16_t n[3])
{
    tp_view_corner c;

    tp_lens_view(lens, at, &c);
    c.s = c.t = 0;
    for (int k = 0; k < 3; k++)
        c.n[k] = n[k];
    return c;
}

int tp_clipped_corners(const tp_lens *lens, const tp_view_plane *level,
                       const tp_view_corner in[3], tp_corner to[TP_CLIP_CORNERS])
{
    tp_view_corner out[TP_CLIP_CORNERS];
    int count = tp_clip_triangle_plane(lens, level, in, out);

    for (int k = 0; k < count; k++)
        tp_corner_project(lens, &out[k], &to[k]);
    return count;
}

void tp_clipped_draw(const tp_lens *lens, const tp_view_plane *level,
                     const tp_samples *tile, const tp_view_corner in[3], uint32_t mark,
                     uint32_t t)
{
    tp_corner corner[TP_CLIP_CORNERS];
    int count = tp_clipped_corners(lens, level, in, corner);

    for (int k = 2; k < count; k++)
        tp_tri_solid(tile, &corner[0], &corner[k - 1], &corner[k], mark, t, 16);
}
