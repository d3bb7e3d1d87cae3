/* SPDX-License-Identifier: MIT */
/* A box over flat water in double precision, ray by ray: in the water's mirror, and
 * refracted, where flat water shows objects below at 3 / 4 of their depth [F4]. */
#ifndef TP_REFERENCE_MIRROR_H
#define TP_REFERENCE_MIRROR_H
#include <stdbool.h>
#include "tools/reference/camera.h"

typedef struct {
    ref_vec place;
    double  heading;            /* heading in radians, clockwise */
    double  half[3];            /* half sides across, up, along; m */
} ref_mirror_box;

/* True if the ray p + t d, t > 0, meets the part of the box above (`side` 1) or below
 * (`side` -1) the level y = 0. */
static inline bool ref_meets(const ref_mirror_box *box, ref_vec p, ref_vec d, int side)
{
    const double c = cos(box->heading), s = sin(box->heading);
    const ref_vec axis[3] = { { c, 0, s }, { 0, 1, 0 }, { -s, 0, c } };
    const ref_vec from = ref_sub(p, box->place);
    double first = 1e-9, last = 1e9;

    for (int i = 0; i < 3; i++) {
        const double x = ref_dot(from, axis[i]), v = ref_dot(d, axis[i]);
        const double a = (-box->half[i] - x) / v, b = (box->half[i] - x) / v;
        first = fmax(first, fmin(a, b));
        last = fmin(last, fmax(a, b));
    }
    const double level = -p.y / d.y;        /* t where the ray crosses the level */
    if (side * d.y > 0)
        first = fmax(first, level);
    else
        last = fmin(last, level);
    return first < last;
}

static inline ref_vec ref_ray(const ref_camera *c, double u, double v)
{
    const double x = (u - c->u0) / c->focal, y = (c->v0 - v) / c->focal;
    return (ref_vec){ c->ahead.x + x * c->right.x + y * c->up.x,
                      c->ahead.y + x * c->right.y + y * c->up.y,
                      c->ahead.z + x * c->right.z + y * c->up.z };
}

/* True if p lies inside the box at the level, where there is no water to show the box. */
static inline bool ref_stands(const ref_mirror_box *box, ref_vec p)
{
    const double c = cos(box->heading), s = sin(box->heading);
    const ref_vec d = ref_sub(p, box->place);

    return fabs(d.x * c + d.z * s) < box->half[0] && fabs(d.y) < box->half[1]
        && fabs(d.z * c - d.x * s) < box->half[2];
}

static inline ref_vec ref_water(const ref_camera *c, ref_vec d)
{
    const double t = -c->eye.y / d.y;
    return (ref_vec){ c->eye.x + t * d.x, 0, c->eye.z + t * d.z };
}

/* True if the water at pixel place (u, v) mirrors the box. */
static inline bool ref_mirrors(const ref_camera *c, const ref_mirror_box *box, double u,
                               double v)
{
    const ref_vec d = ref_ray(c, u, v);

    if (d.y >= 0)
        return false;
    const ref_vec p = ref_water(c, d);
    return !ref_stands(box, p) && ref_meets(box, p, (ref_vec){ d.x, -d.y, d.z }, 1);
}

/* True if the box hides the water at pixel place (u, v). */
static inline bool ref_hides(const ref_camera *c, const ref_mirror_box *box, double u,
                             double v)
{
    return ref_meets(box, c->eye, ref_ray(c, u, v), 1);
}

/* True if the water at pixel place (u, v) shows the box below the level, drawn at 1 / 1.333
 * of its depth. */
static inline bool ref_sinks(const ref_camera *c, const ref_mirror_box *box, double u,
                             double v)
{
    const ref_vec d = ref_ray(c, u, v);
    const ref_vec eye = { c->eye.x, 1.333 * c->eye.y, c->eye.z };

    return d.y < 0 && !ref_stands(box, ref_water(c, d))
        && ref_meets(box, eye, (ref_vec){ d.x, 1.333 * d.y, d.z }, -1);
}
#endif
