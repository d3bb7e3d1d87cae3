/* SPDX-License-Identifier: MIT */
/* Triangles clipped by the near plane, the frustum or a level; shared by all solids. */
#include "frame/render_view.h"

tp_view_vertex tp_solid_vertex_make(const tp_projection *projection, tp_vec3 at,
                                    const int16_t n[3])
{
    tp_view_vertex c;

    tp_projection_view_vertex(projection, at, &c);
    c.s = c.t = 0;
    for (int k = 0; k < 3; k++)
        c.n[k] = n[k];
    return c;
}

int tp_clipped_corners(const tp_projection *projection, const tp_view_plane *level,
                       const tp_view_vertex in[3], tp_screen_vertex to[TP_CLIP_VERTICES])
{
    tp_view_vertex out[TP_CLIP_VERTICES];
    int count = tp_clip_triangle_plane(projection, level, in, out);

    for (int k = 0; k < count; k++)
        tp_view_vertex_project(projection, &out[k], &to[k]);
    return count;
}

void tp_clipped_draw(const tp_projection *projection, const tp_view_plane *level,
                     const tp_gbuffer *tile, const tp_view_vertex in[3], uint32_t mark,
                     uint32_t t)
{
    tp_screen_vertex corner[TP_CLIP_VERTICES];
    int count = tp_clipped_corners(projection, level, in, corner);

    for (int k = 2; k < count; k++)
        tp_tri_solid(tile, &corner[0], &corner[k - 1], &corner[k], mark, t, 16);
}
