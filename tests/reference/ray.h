/* SPDX-License-Identifier: MIT */
/* Where a ray meets the water: the first root of F(t) = ray.y - h(ray.x, ray.z).
 *
 * The ray is marched through the slab between the highest crest and the deepest trough in
 * steps of |F| over a bound of |dF/dt|, so that no step passes a root but where that is
 * below a least step: 1/128 of the shortest wave, at a distance t no less than t / 4000.
 * What lies within one such step, the tip of a crest that a grazing ray only shaves
 * (by less than k A k s^2 / 8 of a step s), is missed.  Slopes above 6 count as 6 in the
 * bound.  The root is then closed in by regula falsi (Illinois) to |F| < surface->close,
 * with heights a hundred times as sharp. */
#ifndef TP_REFERENCE_RAY_H
#define TP_REFERENCE_RAY_H
#include "surface.h"

typedef struct {
    double    t;
    ref_water water;
    bool      from_below;
} ref_meeting;

/* Between t0 and t1; `below`: undersides count, else they are not there. */
bool ref_ray_meets(const ref_surface *s, const ref_ray *ray, double t0, double t1,
                   bool below, ref_meeting *meeting);

/* The part of a ray between two planes square to an axis; false: none. */
static inline bool ref_ray_between(double from, double way, double low, double high,
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
