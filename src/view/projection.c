/* SPDX-License-Identifier: MIT */
/*
 * The projection of a camera, and the clipping of triangles in view space, side after side
 * (Sutherland and Hodgman): first the near plane, then an optional plane of the caller,
 * then the guard band.  The guard band is a square of 2 x 8192 px around the picture's
 * centre, far larger than any picture; it keeps the rasterizer's numbers small.
 *
 * A cut is always computed from the inside vertex to the outside vertex, in either order
 * of the triangle's vertices.  Two triangles with a shared edge therefore get the same
 * new vertex.
 */
#include "view/projection.h"

const uint32_t tp_recip_seed[128] = {
#include "view/recip_table.inc"
};

/* Scales a row. focal <= 2^m and row entries are <= 1, so the result fits Q2.30. */
static tp_dir3 dir_scaled(tp_dir3 d, tp_fx focal, int m)
{
    int32_t by = (int32_t)((int64_t)focal * (1 << 14) >> m);    /* factor, Q2.30 */
    return (tp_dir3){ tp_q30_mul(d.x, by), tp_q30_mul(d.y, by), tp_q30_mul(d.z, by) };
}

void tp_projection_init(tp_projection *projection, tp_vec3 eye, tp_turn heading,
                        tp_turn pitch, tp_fx fov, tp_fx near, uint32_t width,
                        uint32_t height)
{
    tp_projection_init_turned(projection, eye, tp_rotation_from_angles(heading, pitch, 0),
                              fov, near, width, height);
}

void tp_projection_init_turned(tp_projection *projection, tp_vec3 eye, tp_rotation turn,
                               tp_fx fov, tp_fx near, uint32_t width, uint32_t height)
{
    tp_dir3 half =
        tp_rotation_from_angles(tp_turn_of_degrees(fov) / 2, 0, 0).x; /* cos, 0, sin */

    TP_ASSERT(width > 0 && height > 0 && near > 0 && half.z > 0);
    projection->eye = eye;
    projection->turn = turn;
    projection->near = near;
    projection->zi_near = near - (near >> 8);
    projection->focal = (tp_fx)tp_quotient((int64_t)height * (1 << 15) * half.x, half.z);
    projection->m = 0;
    while (projection->m < TP_GUARD_LOG2 && projection->focal > TP_FX_ONE << projection->m)
        projection->m++;
    projection->right = dir_scaled(turn.x, projection->focal, projection->m);
    projection->up = dir_scaled(turn.y, projection->focal, projection->m);
    projection->lean = projection->right.y;
    projection->ahead = (tp_dir3){ -turn.z.x, -turn.z.y, -turn.z.z };
    projection->u0 = (int32_t)(width * 8);
    projection->v0 = (int32_t)(height * 8);
}

/* focal is above 2^(m-1) and m is above 0, because a picture has at least 16 rows and a
 * view at most 100 degrees. */
tp_projection tp_projection_halve(const tp_projection *projection)
{
    TP_ASSERT(projection->m > 0);
    tp_projection half = *projection;

    half.focal = projection->focal >> 1;
    half.m = projection->m - 1;
    half.u0 = projection->u0 / 2;
    half.v0 = projection->v0 / 2;
    return half;
}

/* Scales the view's rows by 2^m / focal, 1..2 (0.7 if m is at its limit).  A scaled view
 * coordinate times this factor is in metres. */
tp_view_plane tp_projection_level_plane(const tp_projection *projection, tp_fx level,
                                        int side)
{
    TP_ASSERT(projection->focal > 0 && (side == 1 || side == -1));
    int64_t one =
        ((int64_t)1 << (44 + projection->m)) / projection->focal; /* 2^m / focal, Q.28 */
    tp_fx up = projection->eye.y - level;

    return (tp_view_plane){
        (int32_t)(side * (projection->turn.x.y * one >> 30)),
        (int32_t)(side * (projection->turn.y.y * one >> 30)),
        side * (projection->ahead.y >> 2), side > 0 ? up : -up,
    };
}

void tp_view_vertex_project(const tp_projection *projection, const tp_view_vertex *from,
                            tp_screen_vertex *to)
{
    TP_ASSERT(tp_projection_can_project(projection, from));
    tp_projection_project(projection, from, &to->u, &to->v, &to->zi);
    to->s = from->s;
    to->t = from->t;
    for (int i = 0; i < 3; i++)
        to->n[i] = from->n[i];
}

/* Returns the plane through the eye and the screen column or row `edge_distance` px
 * from the centre: normal = side x focal + ahead x half; the inside faces the centre.  Two
 * units more make up for the rounding, where a pixel near the eye is smaller than a unit. */
static tp_plane side_plane(const tp_projection *projection, tp_dir3 side, int sign,
                           uint32_t edge_distance)
{
    int32_t f = projection->focal >> 4, h = (int32_t)edge_distance << 12;      /* Q20.12 */
    tp_dir3 a = projection->ahead;
    tp_dir3 n = tp_normalise(
        (int32_t)(((int64_t)sign * side.x * f + (int64_t)a.x * h) >> 28),
        (int32_t)(((int64_t)sign * side.y * f + (int64_t)a.y * h) >> 28),
        (int32_t)(((int64_t)sign * side.z * f + (int64_t)a.z * h) >> 28));
    return (tp_plane){ n, 2 - tp_dot_dir(projection->eye, n) };
}

void tp_projection_planes(const tp_projection *projection, uint32_t width, uint32_t height,
                          tp_plane planes[TP_PROJECTION_PLANES])
{
    uint32_t half_w = width / 2 + 1, half_h = height / 2 + 1;

    planes[0] =
        (tp_plane){ projection->ahead,
                    -tp_dot_dir(projection->eye, projection->ahead) - projection->near };
    planes[1] = side_plane(projection, projection->turn.x, 1, half_w);
    planes[2] = side_plane(projection, projection->turn.x, -1, half_w);
    planes[3] = side_plane(projection, projection->turn.y, 1, half_h);
    planes[4] = side_plane(projection, projection->turn.y, -1, half_h);
}

/* -- clipped triangles --------------------------------------------------------------- */

enum { SIDE_NEAR, SIDE_LEFT, SIDE_RIGHT, SIDE_BOTTOM, SIDE_TOP, SIDE_PLANE };

/* The inputs of all sides. */
typedef struct {
    const tp_projection       *projection;
    const tp_view_plane *plane;
} sides;

/* Returns the distance inside a side, without a fixed unit; >= 0 is inside.  Five cuts
 * round by one each; the margin of four keeps the new vertices within the strict test of
 * tp_projection_can_project. */
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
    int64_t share = tp_quotient((d_in >> shift) << 30, (int64_t)(span >> shift));
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

/* True if a vertex lies within the near plane and the guard band: |x|, |y| <= band. */
static bool is_within_view(const tp_projection *projection, const tp_view_vertex *c)
{
    const int64_t band = ((int64_t)c->depth - 4) * (1 << (TP_GUARD_LOG2 - projection->m)) - 4;

    return c->depth >= projection->near && c->x <= band && c->x >= -band && c->y <= band
           && c->y >= -band;
}

/* True if no side cuts a triangle. */
static bool is_whole(const tp_projection *projection, const tp_view_plane *plane,
                     const tp_view_vertex in[3])
{
    for (int i = 0; i < 3; i++)
        if (!is_within_view(projection, &in[i])
            || (plane && tp_view_plane_distance(plane, &in[i]) < 0))
            return false;
    return true;
}

int tp_clip_triangle_view_and_plane(const tp_projection *projection,
                                    const tp_view_plane *plane,
                                    const tp_view_vertex in[3],
                                    tp_view_vertex out[TP_CLIP_VERTICES])
{
    const sides of = { projection, plane };
    tp_view_vertex other[TP_CLIP_VERTICES];

    if (is_whole(projection, plane, in)) {
        for (int i = 0; i < 3; i++)
            out[i] = in[i];
        return 3;
    }
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
    return tp_clip_triangle_view_and_plane(projection, NULL, in, out);
}
