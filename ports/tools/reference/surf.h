/* SPDX-License-Identifier: MIT */
/* Orbits over a floor and breaking crests in double precision: [B11]-[B13] and [B16]-[B19]
 * of the models as printed. */
#ifndef TP_TOOLS_REFERENCE_SURF_H
#define TP_TOOLS_REFERENCE_SURF_H
#include <math.h>

#ifndef PI
#define PI 3.14159265358979323846
#endif

typedef struct {
    double along, up, sin, cos;
} ref_ellipse;

typedef struct {
    double along, up;
} ref_offset;

static inline ref_ellipse ref_orbit_make(double r, double h, double gamma, double k,
                                         double k0, double kx, double ky)
{
    h = fmax(h, 1 / 16.0);
    r = fmin(r, 0.95 / k);
    const double sx = 1 / -expm1(-kx * h), sy = sx * -expm1(-ky * h);
    const double sine = fmax(0, sin(gamma)) * exp(-k0 * h);
    return (ref_ellipse){ fmin(r * sx, 0.95 / k), r * sy, sine, sqrt(1 - sine * sine) };
}

static inline ref_offset ref_orbit(const ref_ellipse *o, double phi)
{
    const double a = o->along * sin(phi), b = -o->up * cos(phi);
    return (ref_offset){ o->cos * a - o->sin * b, o->sin * a + o->cos * b };
}

static inline double ref_smoothstep(double low, double high, double x)
{
    const double u = fmin(1, fmax(0, (x - low) / (high - low)));
    return u * u * (3 - 2 * u);
}
#endif
