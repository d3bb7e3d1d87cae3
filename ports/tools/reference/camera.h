/* SPDX-License-Identifier: MIT */
/* The camera in double precision: a pinhole with axes from heading and pitch. */
#ifndef TP_TOOLS_REFERENCE_CAMERA_H
#define TP_TOOLS_REFERENCE_CAMERA_H
#include <math.h>
#include "tidepool/fixed.h"

typedef struct {
    double x, y, z;
} ref_vec;

typedef struct {
    ref_vec eye, right, up, ahead;
    double  focal, near;        /* focal length, pixels; near plane, m */
    double  u0, v0;             /* centre of the picture, pixels */
} ref_camera;

static inline double ref_dot(ref_vec a, ref_vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline ref_vec ref_sub(ref_vec a, ref_vec b)
{
    return (ref_vec){ a.x - b.x, a.y - b.y, a.z - b.z };
}

static inline ref_vec ref_vec_make(tp_vec3 v)
{
    return (ref_vec){ v.x / 65536.0, v.y / 65536.0, v.z / 65536.0 };
}

static inline ref_camera ref_camera_make(tp_vec3 eye, tp_turn heading, tp_turn pitch,
                                         tp_fx fov, tp_fx near, uint32_t width,
                                         uint32_t height)
{
    const double turn = 6.283185307179586476925 / 4294967296.0;
    const double h = heading * turn, p = pitch * turn;
    const double half = fov / 65536.0 / 2 * 3.14159265358979323846 / 180;

    return (ref_camera){
        .eye = ref_vec_make(eye),
        .right = { cos(h), 0, sin(h) },
        .up = { -sin(h) * sin(p), cos(p), cos(h) * sin(p) },
        .ahead = { sin(h) * cos(p), sin(p), -cos(h) * cos(p) },
        .focal = height / 2.0 / tan(half),
        .near = near / 65536.0,
        .u0 = width / 2.0, .v0 = height / 2.0,
    };
}

/* World to view space: x right, y up, z depth ahead, m. */
static inline ref_vec ref_view(const ref_camera *c, ref_vec p)
{
    const ref_vec d = ref_sub(p, c->eye);
    return (ref_vec){ ref_dot(d, c->right), ref_dot(d, c->up), ref_dot(d, c->ahead) };
}

static inline double ref_u(const ref_camera *c, ref_vec view)
{
    return c->u0 + c->focal * view.x / view.z;
}

static inline double ref_v(const ref_camera *c, ref_vec view)
{
    return c->v0 - c->focal * view.y / view.z;
}
#endif
