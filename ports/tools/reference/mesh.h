/* SPDX-License-Identifier: MIT */
/* Intersection of a mesh and a ray: a tree of bounding boxes, split at the median along the
 * longest side. Positions are in the mesh's frame, in metres after `scale`. A tree holds
 * either the visible faces or the lids (tidepool/assets.h): faces of opacity 0. */
#ifndef TP_TOOLS_REFERENCE_MESH_H
#define TP_TOOLS_REFERENCE_MESH_H
#include <stdbool.h>
#include "tidepool/assets.h"
#include "vector.h"

typedef struct {
    ref_vec  low, high;
    uint32_t first, count;      /* faces of a leaf; count 0: inner node */
    uint32_t other;             /* index of the second child; the first is the next box */
} ref_box;

typedef struct {
    const tp_mesh *mesh;        /* NULL: no mesh */
    double    scale;            /* metres per 1.0 of a position */
    uint32_t *face;
    ref_box  *box;
    uint32_t  boxes;
} ref_mesh;

typedef struct {
    double   t;
    uint32_t face;
    double   share[3];          /* barycentric weights of the corners */
} ref_face_hit;

ref_mesh ref_mesh_make(const tp_mesh *mesh, double scale, bool lids);
void     ref_mesh_free(ref_mesh *mesh);

/* Finds the nearest front face between t0 and t1. */
bool ref_mesh_meets(const ref_mesh *mesh, const ref_ray *ray, double t0, double t1,
                    ref_face_hit *hit);
#endif
