/* SPDX-License-Identifier: MIT */
/* Bounding box tree over triangles; see the header. */
#include "mesh.h"
#include <stdlib.h>

enum { LEAF = 4, DEPTH = 64 };

static ref_vec corner(const ref_mesh *m, uint32_t face, int k)
{
    const tp_mesh_face *f = &m->mesh->faces[face];
    return ref_times_vec(ref_vec_make(m->mesh->vertices[f->vertex[k]].position), m->scale);
}

/* -- building ------------------------------------------------------------------------ */

static double axis_component(ref_vec v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static double middle(const ref_mesh *m, uint32_t face, int axis)
{
    return axis_component(corner(m, face, 0), axis)
           + axis_component(corner(m, face, 1), axis)
           + axis_component(corner(m, face, 2), axis);
}

static void widen(ref_box *box, ref_vec p)
{
    box->low = (ref_vec){ fmin(box->low.x, p.x), fmin(box->low.y, p.y),
                          fmin(box->low.z, p.z) };
    box->high = (ref_vec){ fmax(box->high.x, p.x), fmax(box->high.y, p.y),
                           fmax(box->high.z, p.z) };
}

/* Quickselect (Hoare): moves the face that belongs at index `want` by order along the axis
 * to that index, with no greater face before it. */
static void split_part(const ref_mesh *m, uint32_t *face, int64_t low, int64_t high,
                       int64_t want, int axis)
{
    while (low < high) {
        const double pivot = middle(m, face[(low + high) / 2], axis);
        int64_t i = low, j = high;
        while (i <= j) {
            while (middle(m, face[i], axis) < pivot)
                i++;
            while (middle(m, face[j], axis) > pivot)
                j--;
            if (i <= j) {
                const uint32_t keep = face[i];
                face[i++] = face[j];
                face[j--] = keep;
            }
        }
        if (want <= j)
            high = j;
        else if (want >= i)
            low = i;
        else
            return;
    }
}

static uint32_t build(ref_mesh *m, uint32_t first, uint32_t count)
{
    const uint32_t here = m->boxes++;
    ref_box box = { .low = { 1e9, 1e9, 1e9 }, .high = { -1e9, -1e9, -1e9 },
                    .first = first, .count = count };

    for (uint32_t i = first; i < first + count; i++)
        for (int k = 0; k < 3; k++)
            widen(&box, corner(m, m->face[i], k));
    if (count > LEAF) {
        const ref_vec side = ref_sub(box.high, box.low);
        const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1
                                                                                     : 2;
        split_part(m, m->face, first, (int64_t)first + count - 1, first + count / 2, axis);
        box.count = 0;
        build(m, first, count / 2);
        box.other = build(m, first + count / 2, count - count / 2);
    }
    m->box[here] = box;
    return here;
}

ref_mesh ref_mesh_make(const tp_mesh *mesh, double scale, bool lids)
{
    ref_mesh m = { .mesh = mesh, .scale = scale };
    uint32_t count = 0;

    if (!mesh || mesh->n_faces == 0)
        return (ref_mesh){ .mesh = NULL };
    m.face = malloc(mesh->n_faces * sizeof *m.face);
    m.box = malloc(2 * (size_t)mesh->n_faces * sizeof *m.box);
    if (!m.face || !m.box)
        abort();
    for (uint32_t i = 0; i < mesh->n_faces; i++)
        if ((mesh->materials[mesh->faces[i].material].opacity == 0) == lids)
            m.face[count++] = i;
    if (count > 0)
        build(&m, 0, count);
    return m;
}

void ref_mesh_free(ref_mesh *mesh)
{
    free(mesh->face);
    free(mesh->box);
}

/* -- rays ---------------------------------------------------------------------------- */

/* Intersection by Moeller and Trumbore; back faces do not count. */
static void try_face(const ref_mesh *m, uint32_t face, const ref_ray *ray, double t0,
                     ref_face_hit *hit)
{
    const ref_vec a = corner(m, face, 0);
    const ref_vec ab = ref_sub(corner(m, face, 1), a);
    const ref_vec ac = ref_sub(corner(m, face, 2), a);
    const ref_vec n = ref_cross(ab, ac), from = ref_sub(ray->from, a);
    const double det = -ref_dot(ray->way, n);

    if (det <= 0)
        return;
    const ref_vec q = ref_cross(from, ray->way);
    const double t = ref_dot(from, n) / det, v = ref_dot(ac, q) / det;
    const double w = -ref_dot(ab, q) / det;
    if (t < t0 || t >= hit->t || v < 0 || w < 0 || v + w > 1)
        return;
    *hit = (ref_face_hit){ t, face, { 1 - v - w, v, w } };
}

static bool meets_box(const ref_box *box, const ref_ray *ray, double t0, double t1)
{
    for (int axis = 0; axis < 3; axis++) {
        const double from = axis_component(ray->from, axis),
                     over = 1 / axis_component(ray->way, axis);
        const double a = (axis_component(box->low, axis) - from) * over;
        const double b = (axis_component(box->high, axis) - from) * over;
        t0 = fmax(t0, fmin(a, b) - 1e-9);
        t1 = fmin(t1, fmax(a, b) + 1e-9);
    }
    return t0 <= t1;
}

bool ref_mesh_meets(const ref_mesh *mesh, const ref_ray *ray, double t0, double t1,
                    ref_face_hit *hit)
{
    uint32_t stack[DEPTH], top = 0;

    *hit = (ref_face_hit){ .t = t1 };
    if (!mesh->mesh || mesh->boxes == 0)
        return false;
    stack[top++] = 0;
    while (top > 0) {
        const uint32_t at = stack[--top];
        const ref_box *box = &mesh->box[at];
        if (!meets_box(box, ray, t0, hit->t))
            continue;
        for (uint32_t i = box->first; i < box->first + box->count; i++)
            try_face(mesh, mesh->face[i], ray, t0, hit);
        if (box->count == 0) {
            stack[top++] = box->other;
            stack[top++] = at + 1;
        }
    }
    return hit->t < t1;
}
