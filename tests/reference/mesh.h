/* SPDX-License-Identifier: MIT */
/* A mesh and a ray: triangles in a tree of boxes, halved at the median of its longest
 * side.  All in the mesh's own frame, in metres after `scale`.  Of a mesh either what is
 * seen is taken, or its lids (asset.h): faces of opacity 0. */
#ifndef TP_REFERENCE_MESH_H
#define TP_REFERENCE_MESH_H
#include <stdbool.h>
#include "tidepool/assets.h"
#include "vector.h"

typedef struct {
    ref_vec  low, high;
    uint32_t first, count;      /* faces of a leaf; count 0: */
    uint32_t other;             /* the second child; the first is the next box */
} ref_box;

typedef struct {
    const tp_mesh *mesh;        /* NULL: none */
    double    scale;            /* metres of 1.0 of its positions */
    uint32_t *face;
    ref_box  *box;
    uint32_t  boxes;
} ref_mesh;

typedef struct {
    double   t;
    uint32_t face;
    double   share[3];          /* of its corners */
} ref_face_hit;

ref_mesh ref_mesh_of(const tp_mesh *mesh, double scale, bool lids);
void     ref_mesh_free(ref_mesh *mesh);

/* The nearest front face between t0 and t1. */
bool ref_mesh_meets(const ref_mesh *mesh, const ref_ray *ray, double t0, double t1,
                    ref_face_hit *hit);
#endif
