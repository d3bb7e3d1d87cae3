/* SPDX-License-Identifier: MIT */
/* Environments in double precision, by the definitions of src/shade/env.h and skies.c. */
#ifndef TP_TOOLS_REFERENCE_ENV_H
#define TP_TOOLS_REFERENCE_ENV_H
#include "shading.h"

/* Colour with an alpha of 0..255: brightness above white. */
typedef struct {
    ref_colour colour;
    double     alpha;
} ref_light;

static inline ref_light ref_light_unpack(uint32_t light)
{
    return (ref_light){ ref_colour_unpack(light), light >> 24 };
}

/* Colour with its brightness above white, not clamped: an alpha of 255 adds 16 times white,
 * and `share` of that counts. */
static inline ref_colour ref_unclamped_colour(ref_light light, double share)
{
    return ref_scale(light.colour, 1 + light.alpha / 255 * 16 * share);
}

/* -- the dome ------------------------------------------------------------------------ */

/* Halo with a peak and a width; `square` and `width` are squared chords with 28 binary
 * places. */
static inline double ref_halo(double peak, double width, double square)
{
    const double far = 1073741824.0;
    return fmax(0, peak / (1 + square / width) - peak / (1 + far / width));
}

/* Glow around the light; `kind`: 0 day, 1 dusk, 2 night. */
static inline ref_light ref_glow(int kind, uint32_t light, double sun, double square)
{
    static const double peak[3][2] = { { 96, 72 }, { 88, 96 }, { 80, 52 } };
    static const double width[3][2] = { { 1048576, 16777216 }, { 1048576, 33554432 },
                                        { 262144, 8388608 } };
    const double share = ref_halo(peak[kind][0], width[kind][0], square)
                       + ref_halo(peak[kind][1], width[kind][1], square);
    const double cover = ref_clamp((131072 - square) / (131072 - 98000), 0, 1);
    const ref_colour c = ref_colour_unpack(light);

    return (ref_light){ ref_add(ref_scale(c, share / 256),
                                ref_scale(c, fmin(1, sun) * cover)),
                        255 * sun / 16 * cover };
}

/* Share of the gradient on the light's side, from the squared chord to the light. */
static inline double ref_towards(double square)
{
    const double t = ref_clamp(1 - square / 1073741824.0, 0, 1);
    return t * t;
}

/* -- the cube ------------------------------------------------------------------------ */

typedef struct {
    int    face;
    double s, t;                /* 0..1 from the picture's top left corner */
} ref_place;

/* Axes of each face for a viewer inside the cube: ahead, right, up. */
static const ref_dir ref_cube_axes[6][3] = {
    { { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 } },
    { { -1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } },
    { { 0, 1, 0 }, { -1, 0, 0 }, { 0, 0, -1 } },
    { { 0, -1, 0 }, { -1, 0, 0 }, { 0, 0, 1 } },
    { { 0, 0, 1 }, { -1, 0, 0 }, { 0, 1, 0 } },
    { { 0, 0, -1 }, { 1, 0, 0 }, { 0, 1, 0 } },
};

static inline ref_place ref_cube_place(ref_dir d)
{
    ref_place p = { 0, 0, 0 };
    double most = -1;

    for (int i = 0; i < 6; i++) {
        const double ahead = ref_dir_dot(d, ref_cube_axes[i][0]);
        if (ahead <= most)
            continue;
        most = ahead;
        p.face = i;
        p.s = 0.5 + ref_dir_dot(d, ref_cube_axes[i][1]) / ahead / 2;
        p.t = 0.5 - ref_dir_dot(d, ref_cube_axes[i][2]) / ahead / 2;
    }
    return p;
}

/* Direction of a place on a face. */
static inline ref_dir ref_cube_direction(int face, double s, double t)
{
    const ref_dir *a = ref_cube_axes[face];
    const double u = 2 * s - 1, v = 1 - 2 * t;

    return ref_unit((ref_dir){ a[0].x + u * a[1].x + v * a[2].x,
                               a[0].y + u * a[1].y + v * a[2].y,
                               a[0].z + u * a[1].z + v * a[2].z });
}

/* Bilinear sample of a picture of w x h texels, clamped at the edges. */
static inline ref_light ref_face_texel(const uint32_t *texel, int w, int h, double s,
                                       double t)
{
    const double u = ref_clamp(s * w - 0.5, 0, w - 1);
    const double v = ref_clamp(t * h - 0.5, 0, h - 1);
    const int u0 = (int)u, v0 = (int)v, u1 = u0 + (u0 < w - 1), v1 = v0 + (v0 < h - 1);
    const ref_light at[4] = {
        ref_light_unpack(texel[v0 * w + u0]), ref_light_unpack(texel[v0 * w + u1]),
        ref_light_unpack(texel[v1 * w + u0]), ref_light_unpack(texel[v1 * w + u1]),
    };
    const double part[4] = { (1 - u + u0) * (1 - v + v0), (u - u0) * (1 - v + v0),
                             (1 - u + u0) * (v - v0), (u - u0) * (v - v0) };
    ref_light sum = { { { 0, 0, 0 } }, 0 };

    for (int k = 0; k < 4; k++) {
        for (int c = 0; c < 3; c++)
            sum.colour.c[c] += part[k] * at[k].colour.c[c];
        sum.alpha += part[k] * at[k].alpha;
    }
    return sum;
}
#endif
