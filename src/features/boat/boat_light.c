/* SPDX-License-Identifier: MIT */
/* The light of the mesh's vertices in a view, for the fast rung of solids.
 *
 * A lit vertex stands in the place of its normal: the first component is N.L, the second
 * the cosine for the table of the specular lobe, both as Q9 in 10 bits.  Triangles and
 * outlines interpolate both as they interpolate a normal; the fast stage then needs
 * neither a view vector nor a root. */
#include "features/boat/boat.h"
#include "mesh/mesh.h"
#include "shade/material.h"

#define MOST  504                           /* rounding in a plane adds a few */
#define UNLIT ((tp_packed_dir)1 << 31)      /* no packed light has this bit */

typedef struct {
    const tp_boat_view *view;
    const tp_view_axes *axes;
    tp_boat_lobe        lobe;
} lights;

/* Returns the unit vector from a vertex to the eye, Q1.14, within 1/256: its components
 * are cut to 10 bits. */
static tp_vec_q14 find_way_to_eye(const tp_boat_view *b, tp_vec3 at)
{
    const tp_vec3 eye = b->projection.eye;
    const int64_t x = eye.x - ((int64_t)at.x * b->metres >> 16),
                  y = eye.y - ((int64_t)at.y * b->metres >> 16),
                  z = eye.z - ((int64_t)at.z * b->metres >> 16);
    const int32_t q = (int32_t)tp_clamp_abs(x >> 4, INT32_MAX),
                  r = (int32_t)tp_clamp_abs(y >> 4, INT32_MAX),
                  s = (int32_t)tp_clamp_abs(z >> 4, INT32_MAX);
    const uint32_t most = (uint32_t)(tp_abs(q) | tp_abs(r) | tp_abs(s)) | 256;
    const int shift = 23 - tp_clz(most);

    return tp_vec_q14_unpack(((uint32_t)(q >> shift) & 1023)
                             | ((uint32_t)(r >> shift) & 1023) << 10
                             | ((uint32_t)(s >> shift) & 1023) << 20);
}

/* Returns the light of a vertex.  The components of a packed normal are at most 511, those
 * of the light's direction 16384: a sum of three products is below 2^25. */
static tp_packed_dir find_light(const lights *l, const tp_mesh_vertex *vertex)
{
    const tp_view_axes *axes = l->axes;
    const int32_t x = tp_dir_x(vertex->normal), y = tp_dir_y(vertex->normal),
                  z = tp_dir_z(vertex->normal);
    const int32_t nl = tp_clamp((x * axes->lx + y * axes->ly + z * axes->lz) >> 14, -MOST,
                                MOST);

    if (l->lobe == TP_BOAT_MATT)
        return ((uint32_t)nl & 1023) | ((uint32_t)-MOST & 1023) << 10;
    const tp_vec_q14 v = find_way_to_eye(l->view, vertex->position);
    const int32_t nv = (x * v.x + y * v.y + z * v.z) >> 9,
                  lv = (axes->lx * v.x + axes->ly * v.y + axes->lz * v.z) >> 14,
                  lobe = tp_lobe_table_cosine(nl > 0 ? 32 * nl : 0, nv, lv,
                                              l->lobe == TP_BOAT_BLINN);

    return ((uint32_t)nl & 1023) | ((uint32_t)tp_clamp(lobe >> 5, -MOST, MOST) & 1023) << 10;
}

static void light_faces(const lights *l, const tp_boat_faces *faces, uint32_t first,
                        uint32_t end, tp_packed_dir *light)
{
    const tp_mesh *mesh = l->view->mesh;

    for (uint32_t i = first; i < end; i++) {
        const uint32_t *v =
            mesh->faces[tp_boat_face_number(faces, faces->entry[i])].vertex;
        for (int k = 0; k < 3; k++)
            if (light[v[k]] == UNLIT)
                light[v[k]] = find_light(l, &mesh->vertices[v[k]]);
    }
}

static void light_listed_faces(const tp_boat_view *b, const tp_view_axes *axes,
                               tp_boat_lobe lobe, const tp_boat_faces *faces,
                               tp_packed_dir *light)
{
    const lights l = { b, axes, lobe };

    for (uint32_t i = 0; i < b->mesh->n_vertices; i++)
        light[i] = UNLIT;
    light_faces(&l, faces, 0, faces->count, light);
}

const struct tp_draw_fast_solids tp_draw_fast_solids = {
    tp_tri_solid_fast, tp_outline_draw_edge_fast, light_listed_faces,
};
