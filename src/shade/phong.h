/* SPDX-License-Identifier: MIT */
/*
 * Phong or Blinn lighting of solids: their normals, unpacked from samples, the argument of
 * the table of a specular lobe, and the lit colour.
 */
#ifndef TP_SHADE_PHONG_H
#define TP_SHADE_PHONG_H
#include "fixed/arithmetic.h"
#include "mesh/mesh.h"
#include "shade/env.h"
#include "shade/shade.h"

/* -- normals of solids --------------------------------------------------------------- */

typedef struct {
    int32_t x, y, z;            /* Q1.14 unless a comment names another format */
} tp_vec_q14;

static inline int32_t tp_vec_q14_dot(tp_vec_q14 a, tp_vec_q14 b)
{
    return (a.x * b.x + a.y * b.y + a.z * b.z) >> 14;
}

/* Returns the unit vector along a vector of any length but 0. */
static inline tp_vec_q14 tp_vec_q14_unit(int32_t x, int32_t y, int32_t z)
{
    tp_dir3 d = tp_normalise(x, y, z);
    return (tp_vec_q14){ d.x >> 16, d.y >> 16, d.z >> 16 };
}

static inline tp_vec_q14 tp_vec_q14_unpack(tp_packed_dir n)
{
    return tp_vec_q14_unit(tp_dir_x(n), tp_dir_y(n), tp_dir_z(n));
}

/* -- the specular lobe --------------------------------------------------------------- */

/*
 * Argument of the lobe's table: R.V for Phong, 2 (N.H)^2 - 1 for Blinn, the same angle for
 * the same mirrored light.
 *
 * H is L + V normalised, and |L + V|^2 = 2 + 2 L.V.  Hence (N.H)^2 = (N.L + N.V)^2 / (2 +
 * 2 L.V): no vector and no root, only a reciprocal [F5].
 */

/* All arguments and the result are Q1.14.  The square of the sum is below 2^30, the
 * reciprocal at most 2^32.  Where L is nearly -V (light from straight behind) hardly any
 * half vector exists; a result beyond the lobe's peak is clamped to the peak. */
TP_ALWAYS_INLINE int32_t tp_blinn_double_angle_cosine(int32_t nl, int32_t nv, int32_t lv)
{
    uint32_t sum = (uint32_t)tp_clamp(nl + nv, 0, 32767);
    uint32_t w = (uint32_t)tp_clamp(16384 + lv, 2, 32768);
    int      up = tp_clz(w);
    uint64_t square = (uint64_t)(sum * sum) * tp_recip_norm(w << up) >> (63 - up);

    return square < 32768 ? (int32_t)square - 16384 : 16384;
}

TP_ALWAYS_INLINE int32_t tp_lobe_cosine(int32_t nl, int32_t nv, int32_t lv, int blinn)
{
    return blinn ? tp_blinn_double_angle_cosine(nl, nv, lv) : (2 * nl * nv >> 14) - lv;
}

/* -- the lit colour ------------------------------------------------------------------ */

/* The specular lobe at R.V, interpolated between table entries: near the peak of a sharp
 * lobe neighbouring entries differ much. */
static inline uint32_t tp_gloss_lookup(const tp_solid *solid, int32_t rv)
{
    int32_t at = rv * (TP_GLOSS - 1), i = at >> 14, part = (at & 16383) >> 6;
    int32_t here = solid->gloss[i], next = solid->gloss[i + 1 < TP_GLOSS ? i + 1 : i];

    return (uint32_t)(here + ((next - here) * part >> 8));
}

/* Lit colour of a normal and a view vector in the given axes; lv is light . view. */
TP_ALWAYS_INLINE uint32_t tp_phong(const tp_shade *shade, const tp_view_axes *axes,
                                   const tp_solid *solid, uint32_t diffuse,
                                   tp_vec_q14 n, tp_vec_q14 v, int32_t lv, int blinn)
{
    tp_vec_q14 light = { axes->lx, axes->ly, axes->lz };
    int32_t nl = tp_clamp(tp_vec_q14_dot(n, light), 0, 16384);
    int32_t rv = tp_clamp(tp_lobe_cosine(nl, tp_vec_q14_dot(n, v), lv, blinn), 0, 16384);
    uint32_t bright = (uint32_t)tp_lit_share(shade->ambient, nl);
    uint32_t gloss = nl > 0 ? tp_gloss_lookup(solid, rv) : 0;
    uint32_t shine = tp_colour_times(solid->specular, shade->light_colour);

    return tp_colour_add(tp_colour_scale(diffuse, bright), tp_colour_scale(shine, gloss));
}

#endif
