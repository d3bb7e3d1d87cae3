/* SPDX-License-Identifier: MIT */
/* Shading in double precision: Phong [F5], Fresnel [F1], haze and sky by the formulas at
 * the heads of the engine's stages. Colours in levels of 255, shares 0..1. */
#ifndef TP_TOOLS_REFERENCE_SHADING_H
#define TP_TOOLS_REFERENCE_SHADING_H
#include <math.h>
#include <stdint.h>

typedef struct {
    double x, y, z;
} ref_dir;

typedef struct {
    double c[3];                /* red, green, blue */
} ref_colour;

static inline double ref_dir_dot(ref_dir a, ref_dir b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline ref_dir ref_unit(ref_dir v)
{
    const double n = sqrt(ref_dir_dot(v, v));
    return (ref_dir){ v.x / n, v.y / n, v.z / n };
}

static inline double ref_clamp(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

static inline ref_colour ref_colour_unpack(uint32_t colour)
{
    return (ref_colour){ { colour >> 16 & 0xff, colour >> 8 & 0xff, colour & 0xff } };
}

static inline ref_colour ref_scale(ref_colour a, double share)
{
    return (ref_colour){ { a.c[0] * share, a.c[1] * share, a.c[2] * share } };
}

static inline ref_colour ref_mix(ref_colour a, ref_colour b, double share)
{
    ref_colour r;
    for (int i = 0; i < 3; i++)
        r.c[i] = a.c[i] + share * (b.c[i] - a.c[i]);
    return r;
}

static inline ref_colour ref_times(ref_colour a, ref_colour b)
{
    ref_colour r;
    for (int i = 0; i < 3; i++)
        r.c[i] = a.c[i] * b.c[i] / 255;
    return r;
}

static inline ref_colour ref_add(ref_colour a, ref_colour b)
{
    ref_colour r;
    for (int i = 0; i < 3; i++)
        r.c[i] = fmin(255, a.c[i] + b.c[i]);
    return r;
}

/* Normal of a surface with the slopes sx and sz. */
static inline ref_dir ref_normal(double sx, double sz)
{
    return ref_unit((ref_dir){ -sx, 1, -sz });
}

/* Fresnel reflectance from air into water, mean of both polarisations. */
static inline double ref_fresnel(double c)
{
    const double e = 1.333, ct = sqrt(1 - (1 - c * c) / (e * e));
    const double rs = (c - e * ct) / (c + e * ct), rp = (ct - e * c) / (ct + e * c);
    return (rs * rs + rp * rp) / 2;
}

/* Gradient sky at the sine of an elevation. */
static inline ref_colour ref_sky(uint32_t horizon, uint32_t zenith, double sine)
{
    const double left = 1 - ref_clamp(sine, 0, 1);
    return ref_mix(ref_colour_unpack(horizon), ref_colour_unpack(zenith), 1 - left * left);
}

/* Largest difference of the three channels. */
static inline double ref_colour_difference(uint32_t got, ref_colour want)
{
    const ref_colour g = ref_colour_unpack(got);
    double off = 0;
    for (int i = 0; i < 3; i++)
        off = fmax(off, fabs(g.c[i] - want.c[i]));
    return off;
}
#endif
