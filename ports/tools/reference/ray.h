/* SPDX-License-Identifier: MIT */
/* Intersection of a ray and the water: the first root of F(t) = ray.y - h(ray.x, ray.z).
 *
 * The ray is marched through the slab between the highest crest and the deepest trough in
 * steps of |F| over a bound of |dF/dt|. Such a step passes no root unless it is below the
 * least step: 1/128 of the shortest wave, and at a distance t at least t / 4000. The march
 * may miss a feature within one least step: the tip of a crest that a grazing ray only
 * shaves (by less than k A k s^2 / 8 for a step s). The bound counts slopes above 6 as 6.
 * Regula falsi (Illinois) then closes in on the root to |F| < surface->close, with heights
 * a hundred times more accurate. */
#ifndef TP_TOOLS_REFERENCE_RAY_H
#define TP_TOOLS_REFERENCE_RAY_H
#include "surface.h"

typedef struct {
    double    t;
    ref_water water;
    bool      from_below;
} ref_meeting;

/* Intersections found before, for further pictures of the same surface: set as a surface's
 * `memory`, zeroed. Not for several threads. */
enum { REF_MEMORY = 1 << 18 };

typedef struct ref_memory {
    struct {
        ref_ray     ray;
        double      t0, t1;
        bool        filled, below, met;
        ref_meeting meeting;
    } place[REF_MEMORY];
} ref_memory;

/* Finds the first intersection between t0 and t1; `below`: undersides count, else the ray
 * passes through undersides. */
bool ref_ray_meets(const ref_surface *s, const ref_ray *ray, double t0, double t1,
                   bool below, ref_meeting *meeting);

/* Clips the interval of a ray to the space between two planes perpendicular to an axis.
 * Returns false if nothing is left. */
static inline bool ref_ray_clip_slab(double from, double way, double low, double high,
                                     double *t0, double *t1)
{
    if (way == 0)
        return from >= low && from <= high;
    const double a = (low - from) / way, b = (high - from) / way;
    *t0 = fmax(*t0, fmin(a, b));
    *t1 = fmin(*t1, fmax(a, b));
    return *t0 <= *t1;
}
#endif
