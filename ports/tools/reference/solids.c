/* SPDX-License-Identifier: MIT */
/* Intersections of rays and solids; the colours are in solid_colours.c. */
#include "solids.h"

static bool is_nearer(ref_solid *solid, double t0, double t, ref_kind kind,
                      const ref_ray *ray, ref_vec normal)
{
    if (!(t >= t0 && t < solid->t))
        return false;
    solid->kind = kind;
    solid->t = t;
    solid->at = ref_ray_point(ray, t);
    solid->normal = normal;
    return true;
}

static ref_ray in_boat(const ref_scene *s, const ref_ray *ray)
{
    return (ref_ray){ ref_world_to_local(&s->boat_rows, ref_sub(ray->from, s->boat_place)),
                      ref_world_to_local(&s->boat_rows, ray->way) };
}

double ref_find_lid(const ref_scene *s, const ref_ray *ray, double t0, double t1)
{
    const ref_ray own = in_boat(s, ray);
    ref_face_hit face;

    return ref_mesh_meets(&s->lids, &own, t0, t1, &face) ? face.t : t1;
}

static void try_boat(const ref_scene *s, const ref_ray *ray, double t0, ref_solid *solid)
{
    const ref_ray own = in_boat(s, ray);
    ref_face_hit face;

    if (ref_mesh_meets(&s->boat, &own, t0, solid->t, &face)) {
        is_nearer(solid, t0, face.t, REF_BOAT, ray, (ref_vec){ 0, 1, 0 });
        solid->face = face;
    }
}

/* A spheroid is intersected as a sphere, in coordinates scaled by its axes. */
static void try_drop(const ref_drop *drop, const ref_ray *ray, double t0,
                     ref_solid *solid)
{
    const ref_vec off = ref_sub(ray->from, drop->centre);
    const ref_vec p = { off.x / drop->wide, off.y / drop->high, off.z / drop->wide };
    const ref_vec d = { ray->way.x / drop->wide, ray->way.y / drop->high,
                        ray->way.z / drop->wide };
    const double a = ref_dot(d, d), b = ref_dot(p, d), c = ref_dot(p, p) - 1;
    const double root = b * b - a * c;

    if (root < 0)
        return;
    const double t = (-b - sqrt(root)) / a;
    const ref_vec n = ref_plus(p, ref_times_vec(d, t));
    is_nearer(solid, t0, t, REF_DROP, ray,
              ref_unit_vec((ref_vec){ n.x / drop->wide, n.y / drop->high,
                                      n.z / drop->wide }));
}

/* -- the ground ---------------------------------------------------------------------- */

static double over_floor(const ref_scene *s, const ref_ray *ray, double t)
{
    const ref_vec at = ref_ray_point(ray, t);
    return at.y + ref_coastal_floor(s->surface.coastal, at.x, at.z).depth;
}

/* Root of the height over the floor: marched in steps of a quarter of the gap, then halved
 * 50 times. */
static double floor_root(const ref_scene *s, const ref_ray *ray, double t0, double t1)
{
    double t = t0, f = over_floor(s, ray, t);

    while (t < t1 && f > 0) {
        const double next = fmin(t1, t + fmax(f / 4, fmax(0.05, t / 1000)));
        const double g = over_floor(s, ray, next);
        double a = t, b = next;
        for (int n = 0; n < 50 && g <= 0; n++) {
            const double middle = (a + b) / 2;
            if (over_floor(s, ray, middle) > 0)
                a = middle;
            else
                b = middle;
        }
        if (g <= 0)
            return b;
        t = next;
        f = g;
    }
    return HUGE_VAL;
}

static void try_floor(const ref_scene *s, const ref_ray *ray, double t0, ref_solid *solid)
{
    const ref_coastal *o = s->surface.coastal;
    const ref_extent *e = &s->surface.extent;
    double w0 = t0, w1 = fmin(solid->t, 1e5), t;

    if (!o || !o->floored
        || !ref_ray_clip_slab(ray->from.x, ray->way.x, e->x - e->half_x, e->x + e->half_x,
                            &w0, &w1)
        || !ref_ray_clip_slab(ray->from.z, ray->way.z, e->z - e->half_z, e->z + e->half_z,
                            &w0, &w1))
        return;
    if (o->map) {
        t = floor_root(s, ray, w0, w1);
    } else {
        const double fall = over_floor(s, ray, 0) - over_floor(s, ray, 1);
        t = fall > 0 ? over_floor(s, ray, 0) / fall : HUGE_VAL;
    }
    if (!(t <= w1))
        return;
    const ref_vec at = ref_ray_point(ray, t);
    const ref_bed bed = ref_coastal_floor(o, at.x, at.z);
    is_nearer(solid, w0, t, REF_LAND, ray,
              ref_unit_vec((ref_vec){ -bed.rise_x, 1, -bed.rise_z }));
}

static bool in_box(const ref_tank *b, ref_vec at)
{
    const double off = 1e-9;
    return at.x >= b->x0 - off && at.x <= b->x1 + off && at.z >= b->z0 - off
        && at.z <= b->z1 + off && at.y >= -b->depth - off && at.y <= b->rim + off;
}

/* Tests a side of the tank; `normal` is the normal of the inner face. */
static void try_side(const ref_scene *s, const ref_ray *ray, double from, double way,
                     double at, ref_vec normal, double t0, ref_solid *solid)
{
    const double t = (at - from) / way;

    if (ref_dot(ray->way, normal) < 0 && in_box(&s->tank, ref_ray_point(ray, t)))
        is_nearer(solid, t0, t, normal.y > 0 ? REF_BED : REF_WALL, ray, normal);
}

static void try_tank(const ref_scene *s, const ref_ray *ray, double t0, ref_solid *solid)
{
    const ref_tank *b = &s->tank;
    const ref_vec f = ray->from, w = ray->way;

    if (b->kind == TP_TANK_NONE)
        return;
    try_side(s, ray, f.y, w.y, -b->depth, (ref_vec){ 0, 1, 0 }, t0, solid);
    try_side(s, ray, f.x, w.x, b->x0, (ref_vec){ 1, 0, 0 }, t0, solid);
    try_side(s, ray, f.x, w.x, b->x1, (ref_vec){ -1, 0, 0 }, t0, solid);
    try_side(s, ray, f.z, w.z, b->z0, (ref_vec){ 0, 0, 1 }, t0, solid);
    try_side(s, ray, f.z, w.z, b->z1, (ref_vec){ 0, 0, -1 }, t0, solid);
}

/* A ray enters the block at the last of the three near sides. */
static void try_block(const ref_block *b, const ref_ray *ray, double t0,
                      ref_solid *solid)
{
    const ref_vec f = ray->from, w = ray->way;
    double x = -HUGE_VAL, y = -HUGE_VAL, z = -HUGE_VAL, out = HUGE_VAL;

    if (!ref_ray_clip_slab(f.x, w.x, b->x0, b->x1, &x, &out)
        || !ref_ray_clip_slab(f.y, w.y, b->y0, b->y1, &y, &out)
        || !ref_ray_clip_slab(f.z, w.z, b->z0, b->z1, &z, &out))
        return;
    const double t = fmax(x, fmax(y, z));
    if (!(t <= out))
        return;
    is_nearer(solid, t0, t, REF_WALL, ray,
              t == x ? (ref_vec){ w.x > 0 ? -1 : 1, 0, 0 }
            : t == y ? (ref_vec){ 0, w.y > 0 ? -1 : 1, 0 }
                     : (ref_vec){ 0, 0, w.z > 0 ? -1 : 1 });
}

bool ref_solid_meets(const ref_scene *s, const ref_ray *ray, int which, double t0,
                     double t1, ref_solid *solid)
{
    *solid = (ref_solid){ .kind = REF_SKY, .t = t1 };
    if (which & REF_THINGS) {
        try_boat(s, ray, t0, solid);
        for (int i = 0; i < s->drops; i++)
            try_drop(&s->drop[i], ray, t0, solid);
    }
    if (which & REF_FLOOR)
        try_floor(s, ray, t0, solid);
    for (int i = 0; i < s->blocks && (which & REF_BLOCKS); i++)
        try_block(&s->block[i], ray, t0, solid);
    if (which & REF_TANK)
        try_tank(s, ray, t0, solid);
    solid->far = ref_dot(ref_sub(solid->at, s->camera.eye), s->camera.ahead);
    return solid->kind != REF_SKY;
}
