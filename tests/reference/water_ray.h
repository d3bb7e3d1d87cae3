/* SPDX-License-Identifier: MIT */
/* Rays in a box of water in double precision: refracted at the surface or the glass by
 * Snell's law, then straight to the floor or a wall. */
#ifndef TP_REFERENCE_WATER_RAY_H
#define TP_REFERENCE_WATER_RAY_H
#include <math.h>
#include <stdbool.h>
#include "tools/reference/camera.h"

typedef struct {
    double x0, x1, z0, z1, depth;
} ref_water_box;

typedef enum { REF_NOTHING, REF_FLOOR, REF_WALL_X, REF_WALL_Z, REF_SURFACE } ref_face;

typedef struct {
    ref_face face;
    double   way, next;         /* distance to the hit and to the next hit behind it, m */
    ref_vec  at;
} ref_hit;

static inline ref_vec ref_along(ref_vec from, ref_vec way, double t)
{
    return (ref_vec){ from.x + way.x * t, from.y + way.y * t, from.z + way.z * t };
}

static inline ref_vec ref_unit_vec(ref_vec v)
{
    const double l = sqrt(ref_dot(v, v));
    return (ref_vec){ v.x / l, v.y / l, v.z / l };
}

/* Refraction by angles instead of the vector formula: the sine shrinks in the plane of both
 * vectors. */
static inline ref_vec ref_bent(ref_vec in, ref_vec n, double index)
{
    const double c = -ref_dot(in, n);
    const ref_vec level = ref_along(in, n, c);
    const double sine = sqrt(ref_dot(level, level)) / index;
    const ref_vec side = sine > 0 ? ref_unit_vec(level) : level;
    const ref_vec down = { -n.x * sqrt(1 - sine * sine), -n.y * sqrt(1 - sine * sine),
                           -n.z * sqrt(1 - sine * sine) };
    return ref_along(down, side, sine);
}

static inline void ref_meets(ref_hit *h, ref_face face, double way)
{
    if (way < h->way) {
        h->next = h->way;
        h->way = way;
        h->face = face;
    } else if (way < h->next) {
        h->next = way;
    }
}

static inline ref_hit ref_in_box(const ref_water_box *b, ref_vec from, ref_vec way)
{
    ref_hit h = { REF_NOTHING, 1e9, 1e9, from };

    if (way.y < 0)
        ref_meets(&h, REF_FLOOR, (-b->depth - from.y) / way.y);
    if (way.y > 0)
        ref_meets(&h, REF_SURFACE, -from.y / way.y);
    if (way.x != 0)
        ref_meets(&h, REF_WALL_X, ((way.x > 0 ? b->x1 : b->x0) - from.x) / way.x);
    if (way.z != 0)
        ref_meets(&h, REF_WALL_Z, ((way.z > 0 ? b->z1 : b->z0) - from.z) / way.z);
    h.at = ref_along(from, way, h.way);
    return h;
}

/* View ray through the middle of pixel (x, y); fractions address places within a pixel. */
static inline ref_vec ref_pixel_ray(const ref_camera *c, double x, double y)
{
    const double u = (x + 0.5 - c->u0) / c->focal, v = (c->v0 - y - 0.5) / c->focal;
    return ref_unit_vec((ref_vec){ c->ahead.x + u * c->right.x + v * c->up.x,
                                   c->ahead.y + u * c->right.y + v * c->up.y,
                                   c->ahead.z + u * c->right.z + v * c->up.z });
}

/* Part of the box that an eye outside, above or beside the box, sees in a direction. */
typedef enum { REF_OUTSIDE, REF_TOP_FLOOR, REF_TOP_WALL, REF_SIDE_FLOOR, REF_SIDE_WALL,
               REF_SIDE_UP } ref_sight;

/* Distance to the side of the box that faces an eye outside; 1e9: none. */
static inline double ref_pane(const ref_water_box *b, ref_vec eye, ref_vec way, ref_vec *n)
{
    const double x = eye.x > b->x1 ? b->x1 : b->x0, z = eye.z > b->z1 ? b->z1 : b->z0;
    const double tx = (x - eye.x) / way.x, tz = (z - eye.z) / way.z;
    const ref_vec px = ref_along(eye, way, tx), pz = ref_along(eye, way, tz);

    if ((eye.x > b->x1 || eye.x < b->x0) && tx > 0 && px.z > b->z0 && px.z < b->z1) {
        *n = (ref_vec){ eye.x > b->x1 ? 1 : -1, 0, 0 };
        return tx;
    }
    if ((eye.z > b->z1 || eye.z < b->z0) && tz > 0 && pz.x > b->x0 && pz.x < b->x1) {
        *n = (ref_vec){ 0, 0, eye.z > b->z1 ? 1 : -1 };
        return tz;
    }
    return 1e9;
}

static inline ref_sight ref_look_into(const ref_water_box *b, ref_vec eye, ref_vec way,
                                      double index)
{
    ref_vec n = { 0, 1, 0 };
    const double top = way.y < 0 ? -eye.y / way.y : 1e9;
    const double side = ref_pane(b, eye, way, &n);
    const ref_vec on = ref_along(eye, way, side), level = ref_along(eye, way, top);
    const bool glass = side < 1e8 && on.y < 0 && on.y > -b->depth;

    if (!glass && (top > 1e8 || top < 0 || level.x < b->x0 || level.x > b->x1
                   || level.z < b->z0 || level.z > b->z1))
        return REF_OUTSIDE;
    if (!glass)
        n = (ref_vec){ 0, 1, 0 };
    const ref_hit h = ref_in_box(b, glass ? on : level, ref_bent(way, n, index));
    if (h.face == REF_SURFACE)
        return REF_SIDE_UP;
    if (h.face == REF_FLOOR)
        return glass ? REF_SIDE_FLOOR : REF_TOP_FLOOR;
    return glass ? REF_SIDE_WALL : REF_TOP_WALL;
}
#endif
