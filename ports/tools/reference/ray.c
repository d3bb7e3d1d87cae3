/* SPDX-License-Identifier: MIT */
/* Intersection of rays and water; see the header. */
#include "ray.h"
#include <string.h>

#define STEEPEST 6
#define ROUGH    1e-4           /* accuracy of the rest point while marching, m along */

typedef struct {
    const ref_surface *surface;
    const ref_ray *ray;
    double rest[2];
    double x, z;                /* place above the rest point */
} ray_probe;

static double surface_offset(ray_probe *p, double t, double along)
{
    const ref_vec at = ref_ray_point(p->ray, t);

    /* The search for the rest point begins as far from the last one as the places are
     * apart. */
    p->rest[0] += at.x - p->x;
    p->rest[1] += at.z - p->z;
    p->x = at.x;
    p->z = at.z;
    return at.y - ref_surface_height(p->surface, at.x, at.z, p->rest, along);
}

/* F with the right sign: near a root F is computed again with full accuracy. */
static double surface_sign(ray_probe *p, double t)
{
    const double f = surface_offset(p, t, ROUGH);
    return fabs(f) < 20 * ROUGH ? surface_offset(p, t, p->surface->close / 100) : f;
}

/* Root between a and b, where F has different signs: regula falsi with the Illinois rule,
 * and bisection if three steps do not at least halve the interval. */
static double find_root(ray_probe *p, double a, double b, double fa, double fb)
{
    double wide = b - a;

    for (int n = 0; n < 200 && fa != fb; n++) {
        const bool halve = n % 3 == 2 && b - a > wide / 2;
        const double t = halve ? (a + b) / 2 : (a * fb - b * fa) / (fb - fa);
        const double f = surface_offset(p, t, p->surface->close / 100);
        if (n % 3 == 2)
            wide = b - a;
        if (fabs(f) < p->surface->close || b - a < 1e-13 * (1 + b))
            return t;
        if ((f < 0) == (fa < 0)) {
            a = t;
            fa = f;
            fb /= halve ? 1 : 2;
        } else {
            b = t;
            fb = f;
            fa /= halve ? 1 : 2;
        }
    }
    return (a + b) / 2;
}

static bool accept(ray_probe *p, double t, bool from_below, ref_meeting *m)
{
    const ref_vec at = ref_ray_point(p->ray, t);

    *m = (ref_meeting){ t, ref_surface_sample(p->surface, at.x, at.z, p->rest),
                        from_below };
    return m->water.wet;
}

/* Marches through moving water. */
static bool march(ray_probe *p, double t0, double t1, bool below, ref_meeting *m)
{
    const ref_surface *s = p->surface;
    const double rate = fabs(p->ray->way.y)
                      + fmin(s->steep, STEEPEST) * hypot(p->ray->way.x, p->ray->way.z);
    double t = t0, f = surface_sign(p, t);

    while (t < t1) {
        const double least = fmax(fmax(s->fine / 128, t / 4000), 1e-4);
        const double next = fmin(t1, t + fmax(fabs(f) / rate, least));
        const double g = surface_sign(p, next);
        if ((f >= 0) != (g >= 0) && (below || f >= 0)
            && accept(p, find_root(p, t, next, f, g), f < 0, m))
            return true;
        t = next;
        f = g;
    }
    return false;
}

/* Intersection with level water. */
static bool meets_level(ray_probe *p, double t0, double t1, bool below, ref_meeting *m)
{
    const double t = -p->ray->from.y / p->ray->way.y;

    return p->ray->way.y != 0 && t >= t0 && t <= t1 && (below || p->ray->way.y < 0)
        && accept(p, t, p->ray->way.y > 0, m);
}

static bool find(const ref_surface *s, const ref_ray *ray, double t0, double t1, bool below,
                 ref_meeting *meeting)
{
    const ref_extent *e = &s->extent;
    ray_probe p = { s, ray, { ray->from.x, ray->from.z }, ray->from.x, ray->from.z };
    const double high = s->high, reach = s->reach;

    if (!ref_ray_clip_slab(ray->from.x, ray->way.x, e->x - e->half_x - reach,
                         e->x + e->half_x + reach, &t0, &t1)
        || !ref_ray_clip_slab(ray->from.z, ray->way.z, e->z - e->half_z - reach,
                            e->z + e->half_z + reach, &t0, &t1)
        || !ref_ray_clip_slab(ray->from.y, ray->way.y, -high, high, &t0, &t1))
        return false;
    if (high < 1e-8)
        return meets_level(&p, t0, t1, below, meeting);
    return march(&p, t0, t1, below, meeting);
}

/* Place of a ray in the memory, by a hash of its bits. */
static uint32_t memory_place(const ref_ray *ray)
{
    const unsigned char *byte = (const unsigned char *)ray;
    uint64_t hash = 0;

    for (size_t i = 0; i < sizeof *ray; i += sizeof hash) {
        uint64_t bits;
        memcpy(&bits, byte + i, sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
    }
    return (uint32_t)(hash % REF_MEMORY);
}

bool ref_ray_meets(const ref_surface *s, const ref_ray *ray, double t0, double t1,
                   bool below, ref_meeting *meeting)
{
    ref_memory *m = s->memory;

    if (!m)
        return find(s, ray, t0, t1, below, meeting);
    const uint32_t i = memory_place(ray);
    if (!m->place[i].filled || memcmp(&m->place[i].ray, ray, sizeof *ray) != 0
        || memcmp(&m->place[i].t0, &t0, sizeof t0) != 0
        || memcmp(&m->place[i].t1, &t1, sizeof t1) != 0 || m->place[i].below != below) {
        m->place[i].ray = *ray;
        m->place[i].t0 = t0;
        m->place[i].t1 = t1;
        m->place[i].filled = true;
        m->place[i].below = below;
        m->place[i].met = find(s, ray, t0, t1, below, &m->place[i].meeting);
    }
    if (m->place[i].met)
        *meeting = m->place[i].meeting;
    return m->place[i].met;
}
