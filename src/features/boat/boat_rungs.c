/* SPDX-License-Identifier: MIT */
/* Cost estimate of the boat: its faces in the main view and in the planar reflection. */
#include "features/boat/boat.h"
#include "mesh/mesh.h"
#include "quality/prices.h"
#include "view/projection.h"

/* Counts for one view of the boat: the main view, or the reflection at reduced size. */
typedef struct {
    tp_projection projection;               /* projection in the mesh's own axes */
    bool     mirrored;
    tp_view_plane level;
    int32_t  rows, cols, band;
    int32_t  top, bottom;       /* range of rows with faces */
    uint32_t faces, cut;
    int64_t  pieces, back, fill;
} boat_view;

static tp_dir3 turned(const tp_rotation *r, tp_dir3 d)
{
    tp_vec3 v = tp_rotate(r, (tp_vec3){ d.x, d.y, d.z });
    return (tp_dir3){ v.x, v.y, v.z };
}

/* Returns the projection of the planar reflection: the eye mirrored at the water's level,
 * the picture upside down. */
static tp_projection mirrored_projection(const tp_projection *projection, const tp_scene *s,
                                         uint32_t width, uint32_t height)
{
    const tp_dir3 r = projection->turn.x, up = projection->turn.y,
                  back = projection->turn.z;
    const tp_rotation turn = { { r.x, -r.y, r.z }, { -up.x, up.y, -up.z },
                               { back.x, -back.y, back.z } };
    tp_projection to;

    tp_projection_init_turned(
        &to, (tp_vec3){ projection->eye.x, -projection->eye.y, projection->eye.z }, turn,
        s->camera.fov, s->camera.near, width, height);
    for (uint32_t n = tp_mirror_halvings(s, width, height); n > 0; n--)
        to = tp_projection_halve(&to);
    return to;
}

/* Sets the clip plane of the reflection: the deepest trough, lowered by two pixels of the
 * map. */
static void set_clip_level(boat_view *l, const tp_scene *s)
{
    int64_t trough = 0;

    for (int i = 0; i < TP_WAVES; i++)
        trough -= s->wave[i].amplitude > 0 ? s->wave[i].amplitude : 0;
    l->level = tp_projection_level_plane(&l->projection,
                                         tp_has_tank(s) ? 0 : tp_fx_saturate(trough), 1);
    l->level.depth += (int32_t)(((int64_t)2 << 43) / l->projection.focal);
}

static void set_mesh_projection(boat_view *l, const tp_scene *s)
{
    const tp_rotation turn =
        tp_rotation_from_angles(tp_turn_of_degrees(s->boat.heading), 0, 0);
    const tp_vec3 place = { s->boat.x, s->boat.lift, s->boat.z };

    set_clip_level(l, s);
    l->projection.eye =
        tp_rotate(&turn, tp_start_view_clamped_vector(place, l->projection.eye));
    l->projection.right = turned(&turn, l->projection.right);
    l->projection.up = turned(&turn, l->projection.up);
    l->projection.ahead = turned(&turn, l->projection.ahead);
}

/* Transforms a mesh position to view space.  `scale`: metres per 1.0 of the mesh's
 * positions, Q16.16. */
static tp_view_vertex transform_point(const boat_view *l, int64_t scale, tp_vec3 at)
{
    const int64_t most = 4000 * TP_FX_ONE;
    tp_view_vertex c;

    tp_projection_view_vertex(&l->projection,
                              (tp_vec3){ (tp_fx)tp_clamp_abs(at.x * scale >> 16, most),
                                         (tp_fx)tp_clamp_abs(at.y * scale >> 16, most),
                                         (tp_fx)tp_clamp_abs(at.z * scale >> 16, most) },
                              &c);
    return c;
}

typedef struct {
    int32_t u[3], v[3];
} outline;

static int32_t least(const int32_t of[3])
{
    const int32_t n = of[0] < of[1] ? of[0] : of[1];
    return n < of[2] ? n : of[2];
}

static int32_t most(const int32_t of[3])
{
    const int32_t n = of[0] > of[1] ? of[0] : of[1];
    return n > of[2] ? n : of[2];
}

/* True if (u, v) is inside a front face. */
static bool contains_point(const outline *o, int32_t u, int32_t v)
{
    for (int k = 0; k < 3; k++) {
        const int n = k < 2 ? k + 1 : 0;
        if ((int64_t)(o->u[n] - o->u[k]) * (v - o->v[k])
            > (int64_t)(o->v[n] - o->v[k]) * (u - o->u[k]))
            return false;
    }
    return true;
}

/* Marks the lattice rays inside a front face as stopped by a solid. */
static void mark_stopped_rays(tp_site *w, const boat_view *l, const outline *o)
{
    const int32_t left = least(o->u), right = most(o->u), top = least(o->v),
                  bottom = most(o->v);

    for (int32_t j = 0; j < TP_RAYS; j++) {
        const int32_t v = 16 * l->rows - (2 * j + 1) * l->rows * 8 / TP_RAYS;
        for (int32_t i = 0; v >= top && v <= bottom && i < TP_RAYS; i++) {
            const int32_t u = (2 * i + 1) * l->cols * 8 / TP_RAYS;
            if (u >= left && u <= right)
                w->solid[j] |= (uint32_t)contains_point(o, u, v) << i;
        }
    }
}

/* Counts one face: its setup in each band, and its filled pixels if the face is a front
 * face. */
static void count_face(tp_site *w, boat_view *l, const outline *o)
{
    const int32_t low = least(o->v) >> 4, high = most(o->v) >> 4;
    const int32_t top = tp_clamp(low, 0, l->rows), end = tp_clamp(high + 1, 0, l->rows);
    const int64_t area = (int64_t)(o->u[1] - o->u[0]) * (o->v[2] - o->v[0])
                       - (int64_t)(o->v[1] - o->v[0]) * (o->u[2] - o->u[0]);

    l->top = top < l->top ? top : l->top;
    l->bottom = end > l->bottom ? end : l->bottom;
    if (top >= end || most(o->u) < 0 || least(o->u) >> 4 >= l->cols)
        return;
    const int64_t bands = (end - 1) / l->band - top / l->band + 1;
    l->pieces += area < 0 ? bands : 0;
    l->back += area < 0 ? 0 : bands;
    l->fill += area < 0 ? -area / 512 : 0;
    if (area < 0 && !l->mirrored)
        mark_stopped_rays(w, l, o);
}

static void count_faces(tp_site *w, boat_view *l)
{
    const tp_mesh *mesh = w->assets->boat;
    const tp_fx metres = tp_mesh_metres_per_unit(mesh, w->scene->boat.scale);

    l->top = l->rows;
    for (uint32_t f = 0; f < mesh->n_faces; f++) {
        outline o;
        int low = 0, cut = 0;
        for (int k = 0; k < 3; k++) {
            const tp_view_vertex c = transform_point(
                l, metres, mesh->vertices[mesh->faces[f].vertex[k]].position);
            uint32_t zi;
            const bool under = l->mirrored && tp_view_plane_distance(&l->level, &c) < 0;
            low += under;
            cut += under || !tp_projection_can_project(&l->projection, &c);
            if (cut == 0)
                tp_projection_project(&l->projection, &c, &o.u[k], &o.v[k], &zi);
            if (l->mirrored && !under && c.depth > w->far)
                w->far = c.depth;
        }
        if (cut == 0)
            count_face(w, l, &o);
        l->cut += cut > 0 && low < 3;
    }
}

static void add_view_work(tp_site *w, boat_view *l)
{
    const tp_mesh *mesh = w->assets->boat;
    uint32_t *work = w->fixed_cost.of;
    uint32_t passes = 1;

    for (uint32_t i = 0; !l->mirrored && passes == 1 && i < mesh->n_materials; i++)
        passes += mesh->materials[i].opacity == 0;
    const int32_t rows = l->bottom > l->top ? l->bottom - l->top : 0;
    const uint32_t bands = (uint32_t)(rows + l->band - 1) / (uint32_t)l->band
                         + (!l->mirrored && rows > 0);
    work[TP_WORK_boat_face] += mesh->n_faces;
    work[TP_WORK_boat_scan] += mesh->n_faces * bands * passes;
    work[TP_WORK_boat_back] += (uint32_t)l->back;
    work[TP_WORK_boat_piece] += (uint32_t)l->pieces;
    work[TP_WORK_boat_fill] += (uint32_t)l->fill;
    work[TP_WORK_boat_cut] += l->cut * (bands + 1);
    if (l->mirrored)
        work[TP_WORK_mirror_fill] += (uint32_t)l->fill;
}

/* Counts the boat in the main view, then in the reflection. */
static void count_work(tp_site *w)
{
    const tp_scene *s = w->scene;
    boat_view l = { .rows = (int32_t)w->height, .cols = (int32_t)w->width,
               .band = TP_WORK_BAND };
    tp_projection projection;

    tp_projection_init_turned(&projection, w->at.eye, w->at.turn, s->camera.fov,
                              s->camera.near, w->width, w->height);
    l.projection = projection;
    set_mesh_projection(&l, s);
    count_faces(w, &l);
    add_view_work(w, &l);
    if (!w->mirrors)
        return;
    const uint32_t halvings = tp_mirror_halvings(s, w->width, w->height);
    l = (boat_view){ .rows = (int32_t)(w->height >> halvings),
                .cols = (int32_t)(w->width >> halvings), .band = TP_WORK_STRIP,
                .mirrored = true,
                .projection = mirrored_projection(&projection, s, w->width, w->height) };
    set_mesh_projection(&l, s);
    count_faces(w, &l);
    add_view_work(w, &l);
}

const tp_cost tp_boat_cost = { .work = count_work };
