/* SPDX-License-Identifier: MIT */
/* The environment: what light comes from a direction.
 *
 * There are three kinds: the gradient by elevation; the dome, a generated sky, which is
 * two gradients mixed by the way to the light, and the glow around it; the cube of six
 * pictures [F7].  Directions are unit vectors in Q1.14 that point away from the eye; a
 * few hundredths too long or short do no harm.  Colours are 0xAARRGGBB, alpha being light
 * beyond white [F8].  Stages are written once for all kinds (TP_ENV_KINDS), so that no
 * loop asks which it is.
 *
 * A cube's pictures are seen from inside.  The four sides stand upright; the lower edge of
 * the one overhead joins the south, and so does the upper edge of the one underfoot. */
#ifndef TP_SHADE_ENV_H
#define TP_SHADE_ENV_H
#include "shade/depth.h"

/* -- the gradient: below the horizon it is the horizon's -------------------------------- */

TP_ALWAYS_INLINE uint32_t tp_env_gradient(const tp_shade *shade, int32_t y)
{
    return shade->sky[tp_clamp(y >> 6, 0, TP_SKY)];
}

/* -- the dome ----------------------------------------------------------------------------- */

/* The square of a way on the unit sphere, Q28: 2 - 2 cos. */
TP_ALWAYS_INLINE uint32_t tp_square_of(int32_t dx, int32_t dy, int32_t dz)
{
    return (uint32_t)(dx * dx) + (uint32_t)(dy * dy) + (uint32_t)(dz * dz);
}

TP_ALWAYS_INLINE uint32_t tp_glow_entry(uint32_t square)
{
    int32_t i = (tp_log2_q8(square | 1) >> 3) - TP_GLOW_STEP * TP_GLOW_LOG2;
    return (uint32_t)tp_clamp(i, 0, TP_GLOW);
}

/* The share of the side of the light, (1 + cos)^2 / 4 in 256ths. */
TP_ALWAYS_INLINE uint32_t tp_towards_light(uint32_t square)
{
    uint32_t t = square >> 22;
    t = t < 256 ? 256 - t : 0;
    return t * t >> 8;
}

/* Below the horizon it grows dark, to a quarter within 11 degrees.  Squares count as
 * `least` at the least, which leaves the disc out. */
TP_ALWAYS_INLINE uint32_t tp_env_dome(const tp_shade *shade, uint32_t least, int32_t x,
                                      int32_t y, int32_t z)
{
    const tp_dome *dome = shade->env.dome;
    uint32_t square = tp_square_of(x - shade->world.lx, y - shade->world.ly,
                                   z - shade->world.lz);
    int32_t  sine = y >> 6, i = tp_clamp(sine, 0, TP_SKY);
    uint32_t base = tp_colour_mix(dome->away[i], dome->towards[i],
                                  tp_towards_light(square));
    uint32_t glow = dome->glow[tp_glow_entry(square > least ? square : least)];

    if (sine < 0) {
        uint32_t left = (uint32_t)tp_clamp(256 + 4 * sine, 64, 256);
        return tp_colour_scale(tp_colour_add(base, glow), left);
    }
    return tp_colour_add(base, glow) | (glow & 0xff000000u);
}

/* -- the cube ----------------------------------------------------------------------------- */

/* A face, and where on it: right and down over m, the largest component. */
typedef struct {
    int     face;
    int32_t right, down, m;
} tp_cube_ray;

TP_ALWAYS_INLINE tp_cube_ray tp_cube_face(int32_t x, int32_t y, int32_t z)
{
    int32_t ax = x < 0 ? -x : x, ay = y < 0 ? -y : y, az = z < 0 ? -z : z;

    if (ax >= ay && ax >= az)
        return (tp_cube_ray){ x < 0, x < 0 ? -z : z, -y, ax };
    if (ay >= az)
        return (tp_cube_ray){ 2 + (y < 0), -x, y < 0 ? -z : z, ay };
    return (tp_cube_ray){ 4 + (z < 0), z < 0 ? x : -x, -y, az };
}

/* 2^29 / m for m of 8192..16383, linear between entries: within 2^-17. */
TP_ALWAYS_INLINE int32_t tp_cube_recip(const uint32_t *recip, int32_t m)
{
    uint32_t at = (uint32_t)(tp_clamp(m, 8192, 16383) - 8192);
    uint32_t a = recip[at >> 5], b = recip[(at >> 5) + 1];
    return (int32_t)(a - ((a - b) * (at & 31) >> 5));
}

typedef struct {
    int     face;
    int32_t s, t;               /* 0..65535, from the picture's top left corner */
    int32_t m;
} tp_cube_place;

/* Face by the largest component, place by the others over it [F7]. */
TP_ALWAYS_INLINE tp_cube_place tp_cube_at(const uint32_t *recip, int32_t x, int32_t y,
                                          int32_t z)
{
    tp_cube_ray c = tp_cube_face(x, y, z);
    int32_t r = tp_cube_recip(recip, c.m);

    return (tp_cube_place){
        c.face, tp_clamp(32768 + (c.right * r >> 14), 0, 65535),
        tp_clamp(32768 + (c.down * r >> 14), 0, 65535), c.m,
    };
}

/* Four texels, held at the picture's edges. */
TP_ALWAYS_INLINE uint32_t tp_env_cube(const tp_shade *shade, int level, int32_t x,
                                      int32_t y, int32_t z)
{
    const tp_cube *cube = shade->env.cube;
    tp_cube_place p = tp_cube_at(shade->env.recip, x, y, z);
    const tp_texture *face = cube->face[p.face];
    int l = level < face->levels ? level : face->levels - 1;
    int lw = face->log2_w > l ? face->log2_w - l : 0;
    int lh = face->log2_h > l ? face->log2_h - l : 0;
    int32_t last_u = (1 << lw) - 1, last_v = (1 << lh) - 1;
    int32_t u = tp_clamp((p.s << lw >> 8) - 128, 0, last_u << 8);
    int32_t v = tp_clamp((p.t << lh >> 8) - 128, 0, last_v << 8);
    int32_t u0 = u >> 8, u1 = u0 < last_u ? u0 + 1 : u0;
    int32_t v0 = v >> 8, v1 = v0 < last_v ? v0 + 1 : v0;
    const uint32_t *row = face->level[l] + ((size_t)v0 << lw);
    const uint32_t *below = face->level[l] + ((size_t)v1 << lw);
    uint32_t fu = (uint32_t)u & 255, fv = (uint32_t)v & 255;

    return tp_light_mix(tp_light_mix(row[u0], row[u1], fu),
                        tp_light_mix(below[u0], below[u1], fu), fv)
         & cube->mask[p.face];
}

/* -- whichever -------------------------------------------------------------------------- */

#define TP_ENV_KINDS(X) \
    X(gradient, TP_ENV_GRADIENT) \
    X(dome,     TP_ENV_DOME) \
    X(cube,     TP_ENV_CUBE)

/* `kind` a literal, or shade->env.kind; `level` is a cube's. */
TP_ALWAYS_INLINE uint32_t tp_env_of(const tp_shade *shade, tp_env_kind kind, int level,
                                    int32_t x, int32_t y, int32_t z)
{
    return kind == TP_ENV_DOME ? tp_env_dome(shade, 0, x, y, z)
         : kind == TP_ENV_CUBE ? tp_env_cube(shade, level, x, y, z)
                               : tp_env_gradient(shade, y);
}

/* A cube's level for its pictures as the eye sees them, and this much coarser, Q8. */
TP_ALWAYS_INLINE int tp_env_level(const tp_shade *shade, tp_env_kind kind, int32_t coarser)
{
    if (kind != TP_ENV_CUBE)
        return 0;
    return tp_clamp((shade->env.cube->lod + coarser) >> 8, 0, TP_TEXTURE_LEVELS - 1);
}

/* 0xAARRGGBB from the world's direction (x, y, z). */
static inline uint32_t tp_env_at(const tp_shade *shade, int32_t x, int32_t y, int32_t z)
{
    return tp_env_of(shade, shade->env.kind, tp_env_level(shade, shade->env.kind, 0),
                     x, y, z);
}

/* Times 256: how bright light with this alpha is [F8]. */
TP_ALWAYS_INLINE uint32_t tp_light_gain(const tp_shade *shade, uint32_t light)
{
    return 256 + ((light >> 24) * shade->env.beyond >> 8);
}

/* The same as a colour, each channel held at white. */
TP_ALWAYS_INLINE uint32_t tp_light_colour(const tp_shade *shade, uint32_t light)
{
    return tp_colour_brighten(light, tp_light_gain(shade, light));
}
#endif
