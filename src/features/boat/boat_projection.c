/* SPDX-License-Identifier: MIT */
/* Projects the mesh's vertices into a render view, and clips its faces.
 *
 * The camera is turned into the mesh's own frame, instead of the mesh into the world.  A
 * vertex then costs as much as a vertex of the world. */
#include "features/boat/boat.h"
#include "mesh/mesh.h"

#define POSITION_MOST (4000 * TP_FX_ONE)    /* the eye may be 24 km away, and the
                                             * difference must fit Q16.16 */

/* Scales a mesh position to metres, rounded. */
TP_ALWAYS_INLINE int64_t scaled(tp_fx x, tp_fx scale)
{
    return ((int64_t)x * scale + 0x8000) >> 16;
}

/* Sets the view coordinates of a position of any mesh: the position in metres is clamped to
 * +-4 km. */
TP_NEVER_INLINE void set_clamped(const tp_boat_view *b, tp_vec3 at, tp_view_vertex *to)
{
    const tp_vec3 p = {
        (tp_fx)tp_clamp_abs(scaled(at.x, b->metres), POSITION_MOST),
        (tp_fx)tp_clamp_abs(scaled(at.y, b->metres), POSITION_MOST),
        (tp_fx)tp_clamp_abs(scaled(at.z, b->metres), POSITION_MOST),
    };

    tp_projection_view_vertex(&b->projection, p, to);
}

static void widen(tp_fx *low, tp_fx *high, tp_fx x)
{
    *low = x < *low ? x : *low;
    *high = x > *high ? x : *high;
}

void tp_boat_view_init(tp_boat_view *b, const tp_mesh *mesh)
{
    b->mesh = mesh;
    b->light = NULL;
    b->low = (tp_vec3){ TP_FX_MAX, TP_FX_MAX, TP_FX_MAX };
    b->high = (tp_vec3){ TP_FX_MIN, TP_FX_MIN, TP_FX_MIN };
    for (uint32_t i = 0; i < mesh->n_vertices; i++) {
        const tp_vec3 at = mesh->vertices[i].position;
        widen(&b->low.x, &b->high.x, at.x);
        widen(&b->low.y, &b->high.y, at.y);
        widen(&b->low.z, &b->high.z, at.z);
    }
}

/* Adds the larger distance of two scaled coordinates from the eye to *sum.  False: a
 * coordinate needs the clamp. */
static bool add_distance(int64_t *sum, int64_t low, int64_t high, tp_fx eye)
{
    const int64_t before = eye - low, behind = high - eye;

    *sum += before > behind ? before : behind;
    return low >= -POSITION_MOST && high <= POSITION_MOST;
}

/* True if neither a position nor a view coordinate of the mesh needs its clamp.  The rows
 * of a projection are at most 1, so a coordinate is below the sum of the three distances;
 * tp_dot_dir_clamped clamps to 32 km. */
static bool is_bounded(const tp_boat_view *b)
{
    const tp_vec3 low = b->low, high = b->high, eye = b->projection.eye;
    int64_t sum = 0;
    const bool fits =
        add_distance(&sum, scaled(low.x, b->metres), scaled(high.x, b->metres), eye.x)
        && add_distance(&sum, scaled(low.y, b->metres), scaled(high.y, b->metres), eye.y)
        && add_distance(&sum, scaled(low.z, b->metres), scaled(high.z, b->metres), eye.z);

    return fits && sum < 31000 * (int64_t)TP_FX_ONE;
}

TP_ALWAYS_INLINE int32_t dot(tp_vec3 d, tp_dir3 axis)
{
    return (int32_t)(((int64_t)d.x * axis.x + (int64_t)d.y * axis.y + (int64_t)d.z * axis.z
                      + (1 << 29)) >> 30);
}

/* The same as set_clamped, if is_bounded. */
TP_ALWAYS_INLINE void set_bounded(const tp_boat_view *b, tp_vec3 at, tp_view_vertex *to)
{
    if (b->metres != TP_FX_ONE)
        at = (tp_vec3){ (tp_fx)scaled(at.x, b->metres), (tp_fx)scaled(at.y, b->metres),
                        (tp_fx)scaled(at.z, b->metres) };
    const tp_vec3 d = tp_vec3_sub(at, b->projection.eye);

    to->x = dot(d, b->projection.right);
    to->y = dot(d, b->projection.up);
    to->depth = dot(d, b->projection.ahead);
}

/* Projects a vertex, or marks it as outside or as one that needs clipping. */
TP_ALWAYS_INLINE void project_vertex(const tp_boat_view *b, const tp_view_plane *plane,
                                     tp_vec3 at, tp_boat_vertex *to, bool bounded)
{
    tp_view_vertex c;

    if (bounded)
        set_bounded(b, at, &c);
    else
        set_clamped(b, at, &c);
    if (plane && tp_view_plane_distance(plane, &c) < 0)
        to->u = TP_BOAT_OUTSIDE;
    else if (tp_projection_can_project(&b->projection, &c))
        tp_projection_project(&b->projection, &c, &to->u, &to->v, &to->zi);
    else
        to->u = TP_GRID_NEEDS_CLIP;
}

tp_grid_box tp_boat_project_vertices(const tp_boat_view *b, const tp_view_plane *plane,
                                     tp_boat_vertex *vertex)
{
    const bool bounded = is_bounded(b);
    int32_t left = INT32_MAX, right = INT32_MIN, top = INT32_MAX, bottom = INT32_MIN;
    tp_grid_box box = TP_BOX_NONE;

    for (uint32_t i = 0; i < b->mesh->n_vertices; i++) {
        tp_boat_vertex *to = &vertex[i];
        project_vertex(b, plane, b->mesh->vertices[i].position, to, bounded);
        if (to->u <= TP_BOAT_OUTSIDE)
            continue;
        left = to->u < left ? to->u : left;
        right = to->u > right ? to->u : right;
        top = to->v < top ? to->v : top;
        bottom = to->v > bottom ? to->v : bottom;
    }
    if (left <= right) {
        tp_box_widen(&box, left, top);
        tp_box_widen(&box, right, bottom);
    }
    return box;
}

static tp_view_vertex transform_vertex(const tp_boat_view *b, uint32_t i)
{
    const tp_mesh_vertex *vertex = &b->mesh->vertices[i];
    const tp_packed_dir normal = tp_boat_vertex_normal(b, i);
    tp_view_vertex c;

    set_clamped(b, vertex->position, &c);
    c.s = vertex->s;
    c.t = vertex->t;
    c.n[0] = (int16_t)tp_dir_x(normal);
    c.n[1] = (int16_t)tp_dir_y(normal);
    c.n[2] = (int16_t)tp_dir_z(normal);
    return c;
}

int tp_boat_clip_face(const tp_boat_view *b, const tp_view_plane *plane, uint32_t f,
                      tp_screen_vertex corner[TP_CLIP_VERTICES])
{
    const uint32_t *v = b->mesh->faces[f].vertex;
    tp_view_vertex in[3];

    for (int k = 0; k < 3; k++)
        in[k] = transform_vertex(b, v[k]);
    return tp_clipped_corners(&b->projection, plane, in, corner);
}
