/* SPDX-License-Identifier: MIT */
/* Clips triangles in view space, side after side (Sutherland and Hodgman): first the near
 * plane, then an optional plane of the caller, then the guard band.  The guard band is a
 * square of 2 x 8192 px around the picture's centre, far larger than any picture; it
 * keeps the rasterizer's numbers small.
 *
 * A cut is always computed from the inside vertex to the outside vertex, in either order
 * of the triangle's vertices.  Two triangles with a shared edge therefore get the same
 * new vertex. */
#include "geom/geom.h"

enum { SIDE_NEAR, SIDE_LEFT, SIDE_RIGHT, SIDE_BOTTOM, SIDE_TOP, SIDE_PLANE };

/* The inputs of all sides. */
typedef struct {
    const tp_projection       *projection;
    const tp_view_plane *plane;
} sides;

/* Returns the distance inside a side, without a fixed unit; >= 0 is inside.  Five cuts
 * round by one each; the margin of four keeps the new vertices within the strict test of
 * tp_projection_contains. */
static int64_t side_distance(const sides *of, const tp_view_vertex *c, int side)
{
    const tp_projection *projection = of->projection;
    int64_t band = ((int64_t)c->depth - 4) * (1 << (TP_GUARD_LOG2 - projection->m)) - 4;

    switch (side) {
    case SIDE_NEAR:   return (int64_t)c->depth - projection->near;
    case SIDE_LEFT:   return band + c->x;
    case SIDE_RIGHT:  return band - c->x;
    case SIDE_BOTTOM: return band + c->y;
    case SIDE_PLANE:  return tp_view_plane_distance(of->plane, c);
    default:          return band - c->y;
    }
}

/* Interpolates from a to b by `share`, Q0.30; |b - a| < 2^32. */
static int32_t interpolate(int32_t a, int32_t b, int64_t share)
{
    return (int32_t)(a + ((((int64_t)b - a) * share) >> 30));
}

static tp_view_vertex intersect_edge(const tp_projection *projection,
                                     const tp_view_vertex *in, const tp_view_vertex *out,
                                     int64_t d_in, int64_t d_out)
{
    TP_ASSERT(d_in >= 0 && d_out < 0);
    uint64_t span = (uint64_t)(d_in - d_out);           /* > 0, below 2^48 */
    int      shift = 0;
    tp_view_vertex c;

    while (span >> shift >= (uint64_t)1 << 32)
        shift++;
    int64_t share = (int64_t)((((uint64_t)d_in >> shift) << 30) / (span >> shift));
    c.x = interpolate(in->x, out->x, share);
    c.y = interpolate(in->y, out->y, share);
    c.depth = interpolate(in->depth, out->depth, share);
    if (c.depth < projection->near)
        c.depth = projection->near;
    c.s = interpolate(in->s, out->s, share);
    c.t = interpolate(in->t, out->t, share);
    for (int i = 0; i < 3; i++)
        c.n[i] = (int16_t)interpolate(in->n[i], out->n[i], share);
    return c;
}

static int clip_side(const sides *of, const tp_view_vertex *in, int count,
                     tp_view_vertex *out, int side)
{
    int kept = 0;

    for (int i = 0; i < count; i++) {
        const tp_view_vertex *a = &in[i], *b = &in[i + 1 < count ? i + 1 : 0];
        int64_t da = side_distance(of, a, side), db = side_distance(of, b, side);
        if (da >= 0)
            out[kept++] = *a;
        if (da >= 0 && db < 0)
            out[kept++] = intersect_edge(of->projection, a, b, da, db);
        else if (da < 0 && db >= 0)
            out[kept++] = intersect_edge(of->projection, b, a, db, da);
    }
    TP_ASSERT(kept <= TP_CLIP_VERTICES);
    return kept;
}

int tp_clip_triangle_plane(const tp_projection *projection, const tp_view_plane *plane,
                        const tp_view_vertex in[3], tp_view_vertex out[TP_CLIP_VERTICES])
{
    const sides of = { projection, plane };
    tp_view_vertex other[TP_CLIP_VERTICES];
    int count = clip_side(&of, in, 3, other, SIDE_NEAR);        /* <= 4 vertices */

    if (plane) {
        count = clip_side(&of, other, count, out, SIDE_PLANE);  /* adds <= 1 vertex */
        for (int i = 0; i < count; i++)
            other[i] = out[i];
    }
    count = clip_side(&of, other, count, out, SIDE_LEFT);
    count = clip_side(&of, out, count, other, SIDE_RIGHT);
    count = clip_side(&of, other, count, out, SIDE_BOTTOM);
    count = clip_side(&of, out, count, other, SIDE_TOP);        /* <= 9 vertices */
    for (int i = 0; i < count; i++)
        out[i] = other[i];
    return count >= 3 ? count : 0;
}

int tp_clip_triangle(const tp_projection *projection, const tp_view_vertex in[3],
                     tp_view_vertex out[TP_CLIP_VERTICES])
{
    return tp_clip_triangle_plane(projection, NULL, in, out);
}
