/* SPDX-License-Identifier: MIT */
/* From the world to the picture: camera, projection, clipping, the water's grid.
 *
 * World axes are right-handed: x right, y up, z towards the viewer; heading 0 looks
 * along -z; front faces are counter-clockwise.  In the view x points right, y up and
 * depth ahead.  On the screen u grows right and v down, in 28.4 pixels from the
 * picture's top left corner; the centre of pixel (x, y) is (16 x + 8, 16 y + 8).
 * A front face therefore has a negative area there.
 *
 * Rows right and up of the camera are scaled by focal / 2^m, 2^m >= focal, so that a
 * view x or y times 2^m over depth is already in pixels: projecting takes one
 * reciprocal and two multiplications. */
#ifndef TP_GEOM_H
#define TP_GEOM_H
#include <stdbool.h>
#include "base/base.h"
#include "fx/fx.h"

/* A corner as the rasterizer takes it. */
typedef struct {
    int32_t  u, v;              /* 28.4 pixels, inside the guard band */
    uint32_t zi;                /* 255/256 near / depth, Q1.31: rounding stays below 1 */
    int32_t  s, t;              /* metres or repeats, 16.16 */
    int16_t  n[3];              /* water: slopes Q3.12; solids: normal, 511 is 1 */
} tp_corner;

/* A corner before projection. */
typedef struct {
    int32_t x, y;               /* scaled view coordinates, 16.16 metres x focal / 2^m */
    int32_t depth;              /* m ahead of the eye, 16.16 */
    int32_t s, t;
    int16_t n[3];
} tp_view_corner;

#define TP_GUARD_LOG2 13        /* +-8192 pixels around the picture's centre */

typedef struct {
    tp_vec3 eye;
    tp_dir3 right, up;          /* scaled by focal / 2^m */
    tp_dir3 ahead;
    tp_q30  lean;               /* right.y: heights of water go so far to the right */
    tp_rotation turn;           /* the same unscaled: right, up, backward */
    tp_fx   focal;              /* pixels to the tangent 1 */
    int     m;
    tp_fx   near;
    tp_fx   zi_near;            /* 255/256 near: depth = zi_near / zi */
    int32_t u0, v0;             /* the picture's centre, 28.4 */
} tp_lens;

void tp_lens_init(tp_lens *lens, tp_vec3 eye, tp_turn heading, tp_turn pitch, tp_fx fov,
                  tp_fx near, uint32_t width, uint32_t height);

/* The same with any turn, also a rolled one: rows right, up, backward. */
void tp_lens_turned(tp_lens *lens, tp_vec3 eye, tp_rotation turn, tp_fx fov, tp_fx near,
                    uint32_t width, uint32_t height);

/* d.axis, held within +-32000 m: water and boats can be farther apart than 16.16 tells,
 * corner to corner, and must not come out on the other side. */
TP_ALWAYS_INLINE int32_t tp_lens_along(tp_vec3 d, tp_dir3 axis)
{
    const int32_t most = 32000 * TP_FX_ONE;
    int64_t way = ((int64_t)d.x * axis.x + (int64_t)d.y * axis.y + (int64_t)d.z * axis.z
                   + (1 << 29)) >> 30;
    return (int32_t)(way > most ? most : way < -most ? -most : way);
}

/* World point to scaled view coordinates; the three of s, t and n are left alone.
 * |p - eye| < 32768 m along each axis of the world. */
TP_ALWAYS_INLINE void tp_lens_view(const tp_lens *lens, tp_vec3 p, tp_view_corner *c)
{
    tp_vec3 d = tp_vec3_sub(p, lens->eye);
    c->x = tp_lens_along(d, lens->right);
    c->y = tp_lens_along(d, lens->up);
    c->depth = tp_lens_along(d, lens->ahead);
}

/* In front of the near plane and inside the guard band: may be projected. */
TP_ALWAYS_INLINE bool tp_lens_holds(const tp_lens *lens, const tp_view_corner *c)
{
    int shift = TP_GUARD_LOG2 - lens->m;
    int32_t ax = c->x < 0 ? -c->x : c->x, ay = c->y < 0 ? -c->y : c->y;
    int32_t most = (ax > ay ? ax : ay) >> shift;
    return c->depth >= lens->near && most < c->depth;
}

/* The upper word of a product, rounded down: one instruction of a Cortex-M4.  By way of
 * unsigned numbers, since gcc makes of the signed shift a number of 64 bits again. */
TP_ALWAYS_INLINE int32_t tp_upper(int64_t product)
{
    return (int32_t)(uint32_t)((uint64_t)product >> 32);
}

TP_ALWAYS_INLINE int32_t tp_mul_upper(int32_t a, int32_t b)
{
    return tp_upper((int64_t)a * b);
}

/* 2^62 / n in the middle of 128 parts of [2^31, 2^32): within 2^-8 of all of a part's. */
extern const uint32_t tp_recip_seed[128];

/* 2^62 / n of n >= 2^31 within 2^-16, below 2^31: r (2 - n r) never comes out above the
 * quotient, and where that is 2^31 it stays 2^-16 short.  n r is 1 in Q.30. */
TP_ALWAYS_INLINE int32_t tp_recip_rough(uint32_t n)
{
    int32_t r = (int32_t)tp_recip_seed[n >> 24 & 0x7f];
    int32_t e = (1 << 30) - tp_upper((int64_t)((uint64_t)n * (uint32_t)r));
    return r + tp_mul_upper(r, e) * 4;
}

/* The same within 2^-28.9 and below 2^31.  |e| < 2^15 here, so 8 bits more of it fit, and
 * the 1 that is 2^38 then is shifted out; ~ for - holds what was rounded down below. */
TP_ALWAYS_INLINE int32_t tp_recip_fine(uint32_t n)
{
    int32_t  r = tp_recip_rough(n);
    uint32_t product = (uint32_t)((uint64_t)n * (uint32_t)r >> 32);
    return r + (tp_mul_upper(r, (int32_t)(~product << 8)) >> 6);
}

/* x r / 2^(32 + down), rounded half up.  A positive `down` takes the product's upper word
 * alone: floors of floors are floors. */
TP_ALWAYS_INLINE int32_t tp_lens_scaled(int32_t x, int32_t r, int down, bool far)
{
    if (far || down > 0)
        return (tp_mul_upper(x, r) + (1 << (down - 1))) >> down;
    return (int32_t)(((int64_t)x * r + ((int64_t)1 << (31 + down))) >> (32 + down));
}

/* View coordinates that the lens holds; `far`: depth >= 2^(6 + m).  r is 2^62 over
 * depth x 2^shift; near is 1/20 m and m at most 13, so down >= -7.  zi_near <= depth loses
 * nothing by the shift. */
TP_ALWAYS_INLINE void tp_lens_project_as(const tp_lens *lens, int32_t x, int32_t y,
                                         int32_t depth, bool far, int32_t *u, int32_t *v,
                                         uint32_t *zi)
{
    int shift = tp_clz((uint32_t)depth), down = 26 - lens->m - shift;
    int32_t r = tp_recip_fine((uint32_t)depth << shift);

    *u = lens->u0 + tp_lens_scaled(x, r, down, far);
    *v = lens->v0 - tp_lens_scaled(y, r, down, far);
    *zi = (uint32_t)((uint64_t)((uint32_t)lens->zi_near << shift) * ((uint32_t)r << 1)
                     >> 32);
}

/* Only of a corner that the lens holds. */
TP_ALWAYS_INLINE void tp_lens_project(const tp_lens *lens, const tp_view_corner *c,
                                      int32_t *u, int32_t *v, uint32_t *zi)
{
    tp_lens_project_as(lens, c->x, c->y, c->depth, false, u, v, zi);
}

void tp_corner_project(const tp_lens *lens, const tp_view_corner *from, tp_corner *to);

/* Cuts a triangle by the near plane and the guard band's four sides; writes up to
 * TP_CLIP_CORNERS corners of a convex polygon and returns how many (0: nothing left).
 * A cut edge gives the same corner whichever of its two triangles is cut. */
#define TP_CLIP_CORNERS 9
int tp_clip_triangle(const tp_lens *lens, const tp_view_corner in[3],
                     tp_view_corner out[TP_CLIP_CORNERS]);

/* A plane of the world as the view's coordinates see it: how far x, y and depth lead
 * to its inner side, Q4.28, and where the eye is, 16.16. */
typedef struct {
    int32_t x, y, depth;
    tp_fx   eye;
} tp_view_plane;

/* The level plane y = `level`, inside above it or, with `side` -1, below. */
tp_view_plane tp_lens_level(const tp_lens *lens, tp_fx level, int side);

/* >= 0 on the inner side; metres in Q.32.  Coordinates are below 2^31 and the rows below
 * 2^29, so three products and the eye's 2^59 stay in 63 bits. */
TP_ALWAYS_INLINE int64_t tp_view_height(const tp_view_plane *plane,
                                        const tp_view_corner *c)
{
    return ((int64_t)plane->x * c->x + (int64_t)plane->y * c->y
            + (int64_t)plane->depth * c->depth + (int64_t)plane->eye * (1 << 28)) >> 12;
}

/* The same cut by a plane besides, unless that is NULL. */
int tp_clip_triangle_at(const tp_lens *lens, const tp_view_plane *plane,
                        const tp_view_corner in[3], tp_view_corner out[TP_CLIP_CORNERS]);

/* The same view in a picture of half as many pixels a side, exactly: it halves the power
 * of two that view coordinates are scaled by. */
tp_lens tp_lens_halved(const tp_lens *lens);

/* A side of the view as a half-space: inside where n.p + d >= 0, p in world metres. */
typedef struct {
    tp_dir3 n;
    tp_fx   d;
} tp_plane;

#define TP_LENS_PLANES 5        /* near, left, right, bottom, top */
void tp_lens_planes(const tp_lens *lens, uint32_t width, uint32_t height,
                    tp_plane planes[TP_LENS_PLANES]);
#endif
