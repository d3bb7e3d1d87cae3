/* SPDX-License-Identifier: MIT */
/* Vector operations for rays, in addition to the camera's, in double precision. */
#ifndef TP_TOOLS_REFERENCE_VECTOR_H
#define TP_TOOLS_REFERENCE_VECTOR_H
#include "camera.h"

typedef struct {
    ref_vec from, way;          /* way: unit vector */
} ref_ray;

static inline ref_vec ref_plus(ref_vec a, ref_vec b)
{
    return (ref_vec){ a.x + b.x, a.y + b.y, a.z + b.z };
}

static inline ref_vec ref_times_vec(ref_vec a, double by)
{
    return (ref_vec){ a.x * by, a.y * by, a.z * by };
}

static inline ref_vec ref_cross(ref_vec a, ref_vec b)
{
    return (ref_vec){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                      a.x * b.y - a.y * b.x };
}

static inline ref_vec ref_unit_vec(ref_vec a)
{
    return ref_times_vec(a, 1 / sqrt(ref_dot(a, a)));
}

static inline ref_vec ref_ray_point(const ref_ray *ray, double t)
{
    return ref_plus(ray->from, ref_times_vec(ray->way, t));
}

/* Rotation as three rows of unit vectors: right, up and back of a frame that is turned by
 * its heading about y, lifted by its pitch about its right axis, then rolled about its back
 * axis. */
typedef struct {
    ref_vec x, y, z;
} ref_rows;

static inline ref_rows ref_rows_make(tp_turn heading, tp_turn pitch, tp_turn roll)
{
    const double turn = 6.283185307179586476925 / 4294967296.0;
    const double h = heading * turn, p = pitch * turn, r = roll * turn;
    const ref_vec right = { cos(h), 0, sin(h) };
    const ref_vec up = { -sin(h) * sin(p), cos(p), cos(h) * sin(p) };

    return (ref_rows){
        ref_plus(ref_times_vec(right, cos(r)), ref_times_vec(up, -sin(r))),
        ref_plus(ref_times_vec(up, cos(r)), ref_times_vec(right, sin(r))),
        { -sin(h) * cos(p), -sin(p), cos(h) * cos(p) },
    };
}

/* From the world's axes into the frame's axes, and back. */
static inline ref_vec ref_world_to_local(const ref_rows *r, ref_vec v)
{
    return (ref_vec){ ref_dot(v, r->x), ref_dot(v, r->y), ref_dot(v, r->z) };
}

static inline ref_vec ref_local_to_world(const ref_rows *r, ref_vec v)
{
    return ref_plus(ref_plus(ref_times_vec(r->x, v.x), ref_times_vec(r->y, v.y)),
                    ref_times_vec(r->z, v.z));
}
#endif
