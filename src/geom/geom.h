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
#include "tidepool/fx.h"

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
    tp_rotation turn;           /* the same unscaled: right, up, backward */
    tp_fx   focal;              /* pixels to the tangent 1 */
    int     m;
    tp_fx   near;
    tp_fx   zi_near;            /* 255/256 near: depth = zi_near / zi */
    int32_t u0, v0;             /* the picture's centre, 28.4 */
} tp_lens;

void tp_lens_init(tp_lens *lens, tp_vec3 eye, tp_turn heading, tp_turn pitch, tp_fx fov,
                  tp_fx near, uint32_t width, uint32_t height);

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

/* Only of a corner that the lens holds.  |x| <= 32000 m and the reciprocal is below 2^32:
 * their product leaves 2^57 for `half`. */
TP_ALWAYS_INLINE void tp_lens_project(const tp_lens *lens, const tp_view_corner *c,
                                      int32_t *u, int32_t *v, uint32_t *zi)
{
    int shift = tp_clz((uint32_t)c->depth);
    int64_t r = tp_recip_norm((uint32_t)c->depth << shift);     /* 2^63 / that */
    int back = 59 - shift - lens->m;
    int64_t half = (int64_t)1 << (back - 1);

    *u = lens->u0 + (int32_t)((c->x * r + half) >> back);
    *v = lens->v0 - (int32_t)((c->y * r + half) >> back);
    *zi = (uint32_t)(lens->zi_near * r >> (32 - shift));
}

void tp_corner_project(const tp_lens *lens, const tp_view_corner *from, tp_corner *to);

/* Cuts a triangle by the near plane and the guard band's four sides; writes up to
 * TP_CLIP_CORNERS corners of a convex polygon and returns how many (0: nothing left).
 * A cut edge gives the same corner whichever of its two triangles is cut. */
#define TP_CLIP_CORNERS 8
int tp_clip_triangle(const tp_lens *lens, const tp_view_corner in[3],
                     tp_view_corner out[TP_CLIP_CORNERS]);

/* A side of the view as a half-space: inside where n.p + d >= 0, p in world metres. */
typedef struct {
    tp_dir3 n;
    tp_fx   d;
} tp_plane;

#define TP_LENS_PLANES 5        /* near, left, right, bottom, top */
void tp_lens_planes(const tp_lens *lens, uint32_t width, uint32_t height,
                    tp_plane planes[TP_LENS_PLANES]);
#endif
