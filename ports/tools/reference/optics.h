/* SPDX-License-Identifier: MIT */
/* Light at a surface in double precision, in both directions: [F1]-[F4] as printed, with
 * total reflection, and absorption by distance (Beer). */
#ifndef TP_TOOLS_REFERENCE_OPTICS_H
#define TP_TOOLS_REFERENCE_OPTICS_H
#include <stdbool.h>
#include "shading.h"
#include "vector.h"

#define REF_INDEX 1.333

/* Fresnel reflectance at an angle with cosine `c`; `e` is the index beyond the surface over
 * the index before it. Returns 1 for total reflection. */
static inline double ref_fresnel_reflectance(double c, double e)
{
    const double s2 = (1 - c * c) / (e * e);
    if (s2 >= 1)
        return 1;
    const double ct = sqrt(1 - s2);
    const double rs = (c - e * ct) / (c + e * ct), rp = (ct - e * c) / (ct + e * c);
    return (rs * rs + rp * rp) / 2;
}

/* Schlick's approximation of the reflectance [F2]. */
static inline double ref_schlick(double c)
{
    const double r0 = (REF_INDEX - 1) / (REF_INDEX + 1), m = 1 - c;
    return r0 * r0 + (1 - r0 * r0) * m * m * m * m * m;
}

/* Reflected ray [F3]; `n` points against the ray. */
static inline ref_vec ref_reflected(ref_vec way, ref_vec n)
{
    return ref_plus(way, ref_times_vec(n, -2 * ref_dot(way, n)));
}

/* Refracted ray [F4]; `n` points against the ray. Returns false for total reflection. */
static inline bool ref_refracted(ref_vec way, ref_vec n, double e, ref_vec *to)
{
    const double c = -ref_dot(way, n), s2 = (1 - c * c) / (e * e);
    if (s2 >= 1)
        return false;
    *to = ref_unit_vec(ref_plus(ref_times_vec(way, 1 / e),
                                ref_times_vec(n, c / e - sqrt(1 - s2))));
    return true;
}

/* Colour `seen` through `way` m of water that turns white into `tint` after `clear` m; the
 * absorbed part is replaced by the water's own light, `deep`. */
static inline ref_colour ref_shade_absorption(ref_colour seen, ref_colour deep,
                                              ref_colour tint, double clear, double way)
{
    ref_colour r;
    for (int i = 0; i < 3; i++) {
        const double left = pow(tint.c[i] / 255, way / clear);
        r.c[i] = deep.c[i] + left * (seen.c[i] - deep.c[i]);
    }
    return r;
}
#endif
