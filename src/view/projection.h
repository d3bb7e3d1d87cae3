/* SPDX-License-Identifier: MIT */
/* From world to picture: camera, projection, clipping.
 *
 * World axes are right-handed: x right, y up, z towards the viewer.  Heading 0 looks
 * along -z.  Front faces are counter-clockwise.  In view space x points right, y up, and
 * depth ahead.  On the screen u increases to the right and v downwards, 28.4 px from the
 * top left corner of the picture; the centre of pixel (x, y) is (16 x + 8, 16 y + 8).  A
 * front face therefore has a negative area on the screen.
 *
 * The camera rows right and up are scaled by focal / 2^m, 2^m >= focal.  A view x or y
 * times 2^m / depth is then already in pixels: a projection needs a reciprocal and two
 * multiplications. */
#ifndef TP_VIEW_PROJECTION_H
#define TP_VIEW_PROJECTION_H
#include <stdbool.h>
#include "base/base.h"
#include "fixed/arithmetic.h"

/* A screen vertex, the input of the rasterizer. */
typedef struct {
    int32_t  u, v;              /* position, 28.4 px, inside the guard band */
    uint32_t zi;                /* 255/256 near / depth, Q1.31; rounding cannot reach 1 */
    int32_t  s, t;              /* texture position, m or repeats, 16.16 */
    int16_t  n[3];              /* water: slopes Q3.12; solids: normal, 511 is 1 */
} tp_screen_vertex;

/* A vertex in view space. */
typedef struct {
    int32_t x, y;               /* scaled view coordinates, 16.16 m x focal / 2^m */
    int32_t depth;              /* distance ahead of the eye, 16.16 m */
    int32_t s, t;
    int16_t n[3];
} tp_view_vertex;

#define TP_GUARD_LOG2 13        /* +-8192 px around the picture's centre */

typedef struct {
    tp_vec3 eye;
    tp_dir3 right, up;          /* rows, scaled by focal / 2^m */
    tp_dir3 ahead;
    tp_q30  lean;               /* right.y: shift to the right per height; 0 without roll */
    tp_rotation turn;           /* unscaled rows: right, up, backward */
    tp_fx   focal;              /* focal length, px, 16.16 */
    int     m;
    tp_fx   near;
    tp_fx   zi_near;            /* 255/256 near: depth = zi_near / zi */
    int32_t u0, v0;             /* centre of the picture, 28.4 px */
} tp_projection;

void tp_projection_init(tp_projection *projection, tp_vec3 eye, tp_turn heading,
                        tp_turn pitch, tp_fx fov, tp_fx near, uint32_t width,
                        uint32_t height);

/* Same as tp_projection_init for any rotation, including roll; rows of `turn`: right, up,
 * backward. */
void tp_projection_init_turned(tp_projection *projection, tp_vec3 eye, tp_rotation turn,
                               tp_fx fov, tp_fx near, uint32_t width, uint32_t height);

/* Returns the length in the picture, px, 16.16, of a length at a depth, both m.  focal: px,
 * up to 2^13. */
static inline int64_t tp_length_px(tp_fx length, int32_t focal, tp_fx depth)
{
    TP_ASSERT(depth > 0);
    return (int64_t)length * focal * TP_FX_ONE / depth;
}

/* Returns the length at a depth, m, that has so many px in the picture, 16.16: the inverse of
 * tp_length_px. */
static inline tp_fx tp_length_of_px(tp_fx px, int32_t focal, tp_fx depth)
{
    TP_ASSERT(focal > 0);
    return tp_fx_saturate(((int64_t)px * depth >> 16) / focal);
}

/* Returns 0 up to `limit`, 1 from 2 limit on, linear between: a thing fades in. */
static inline tp_fx tp_fade_in_share(int64_t x, tp_fx limit)
{
    const int64_t over = x - limit;
    if (over <= 0)
        return 0;
    if (over >= limit)
        return TP_FX_ONE;
    return over < TP_FX_ONE ? (tp_fx)(((uint32_t)over << 16) / (uint32_t)limit)
                            : (tp_fx)((over << 16) / limit);
}

/* Returns d . axis, clamped to +-32000 m.  From corner to corner, water and boats can be
 * farther apart than the range of 16.16; without the clamp they would wrap to the
 * opposite side. */
TP_ALWAYS_INLINE int32_t tp_dot_dir_clamped(tp_vec3 d, tp_dir3 axis)
{
    const int32_t most = 32000 * TP_FX_ONE;
    int64_t way = ((int64_t)d.x * axis.x + (int64_t)d.y * axis.y + (int64_t)d.z * axis.z
                   + (1 << 29)) >> 30;
    return (int32_t)(way > most ? most : way < -most ? -most : way);
}

/* Transforms a world point to scaled view coordinates; does not write s, t and n.
 * |p - eye| < 32768 m along each world axis. */
TP_ALWAYS_INLINE void tp_projection_view_vertex(const tp_projection *projection,
                                                tp_vec3 p, tp_view_vertex *c)
{
    tp_vec3 d = tp_vec3_sub(p, projection->eye);
    c->x = tp_dot_dir_clamped(d, projection->right);
    c->y = tp_dot_dir_clamped(d, projection->up);
    c->depth = tp_dot_dir_clamped(d, projection->ahead);
}

/* True if the vertex can be projected without a clip: beyond the near plane and inside the
 * guard band, a square much larger than the picture.  There is no test of the far plane. */
TP_ALWAYS_INLINE bool tp_projection_can_project(const tp_projection *projection,
                                                const tp_view_vertex *c)
{
    int shift = TP_GUARD_LOG2 - projection->m;
    int32_t ax = c->x < 0 ? -c->x : c->x, ay = c->y < 0 ? -c->y : c->y;
    int32_t most = (ax > ay ? ax : ay) >> shift;
    return c->depth >= projection->near && most < c->depth;
}

/* Returns the upper word of a product, rounded down; a single instruction on a Cortex-M4.
 * The shift is unsigned, because gcc widens the signed shift to 64 bits again. */
TP_ALWAYS_INLINE int32_t tp_upper(int64_t product)
{
    return (int32_t)(uint32_t)((uint64_t)product >> 32);
}

TP_ALWAYS_INLINE int32_t tp_mul_upper(int32_t a, int32_t b)
{
    return tp_upper((int64_t)a * b);
}

/* Table of 2^62 / n at the middle of 128 equal parts of [2^31, 2^32); within 2^-8 over
 * each part. */
extern const uint32_t tp_recip_seed[128];

/* Returns 2^62 / n for n >= 2^31, within 2^-16, below 2^31.  The Newton step r (2 - n r)
 * never exceeds the quotient; for a quotient of 2^31 the result is short by 2^-16.  In
 * Q.30 n r is 1. */
TP_ALWAYS_INLINE int32_t tp_recip_rough(uint32_t n)
{
    int32_t r = (int32_t)tp_recip_seed[n >> 24 & 0x7f];
    int32_t e = (1 << 30) - tp_upper((int64_t)((uint64_t)n * (uint32_t)r));
    return r + tp_mul_upper(r, e) * 4;
}

/* Same as tp_recip_rough, but within 2^-28.9 and below 2^31.  The error e of the first
 * step is below 2^15, so e is kept with 8 more bits, and the 1 of n r, now 2^38, is
 * shifted out of the word.  The operator ~ instead of - keeps the rounded-down product
 * below the exact value. */
TP_ALWAYS_INLINE int32_t tp_recip_fine(uint32_t n)
{
    int32_t  r = tp_recip_rough(n);
    uint32_t product = (uint32_t)((uint64_t)n * (uint32_t)r >> 32);
    return r + (tp_mul_upper(r, (int32_t)(~product << 8)) >> 6);
}

/* Returns x r / 2^(32 + down), rounded half up.  For a positive `down` the upper word of
 * the product is enough, because a floor of a floor is exact. */
TP_ALWAYS_INLINE int32_t tp_projection_screen_offset(int32_t x, int32_t reciprocal,
                                                     int down, bool far)
{
    if (far || down > 0)
        return (tp_mul_upper(x, reciprocal) + (1 << (down - 1))) >> down;
    return (int32_t)(((int64_t)x * reciprocal + ((int64_t)1 << (31 + down)))
                     >> (32 + down));
}

/* Projects view coordinates that tp_projection_can_project accepts.  `far`: depth is at
 * least 2^(6 + m).
 * r is 2^62 / (depth x 2^shift); near >= 1/20 m and m <= 13, so down >= -7.  The shift of
 * zi_near loses no bits, because zi_near <= depth. */
TP_ALWAYS_INLINE void tp_projection_project_scaled(const tp_projection *projection,
                                                   int32_t x, int32_t y, int32_t depth,
                                                   bool far, int32_t *u, int32_t *v,
                                                   uint32_t *zi)
{
    int shift = tp_clz((uint32_t)depth), down = 26 - projection->m - shift;
    int32_t r = tp_recip_fine((uint32_t)depth << shift);

    *u = projection->u0 + tp_projection_screen_offset(x, r, down, far);
    *v = projection->v0 - tp_projection_screen_offset(y, r, down, far);
    *zi = (uint32_t)((uint64_t)((uint32_t)projection->zi_near << shift) * ((uint32_t)r << 1)
                     >> 32);
}

/* Projects a vertex that tp_projection_can_project accepts. */
TP_ALWAYS_INLINE void tp_projection_project(const tp_projection *projection,
                                            const tp_view_vertex *c, int32_t *u,
                                            int32_t *v, uint32_t *zi)
{
    tp_projection_project_scaled(projection, c->x, c->y, c->depth, false, u, v, zi);
}

void tp_view_vertex_project(const tp_projection *projection, const tp_view_vertex *from,
                            tp_screen_vertex *to);

/* Clips a triangle by the near plane and the four sides of the guard band.  Writes up to
 * TP_CLIP_VERTICES vertices of a convex polygon and returns their number (0: nothing
 * left).  Both triangles of a cut edge get the same new vertex. */
#define TP_CLIP_VERTICES 9
int tp_clip_triangle(const tp_projection *projection, const tp_view_vertex in[3],
                     tp_view_vertex out[TP_CLIP_VERTICES]);

/* A world plane in view coordinates: weights of x, y and depth towards the inner side,
 * Q4.28, and the signed distance of the eye, 16.16 m. */
typedef struct {
    int32_t x, y, depth;
    tp_fx   eye;
} tp_view_plane;

/* Returns the horizontal plane y = `level`; inside is above, or below for `side` = -1. */
tp_view_plane tp_projection_level_plane(const tp_projection *projection, tp_fx level,
                                        int side);

/* Returns the signed distance to the plane, Q.32 m; >= 0 on the inner side.  Coordinates
 * are below 2^31 and weights below 2^29, so three products and the eye's 2^59 stay within
 * 63 bits. */
TP_ALWAYS_INLINE int64_t tp_view_plane_distance(const tp_view_plane *plane,
                                                const tp_view_vertex *c)
{
    return ((int64_t)plane->x * c->x + (int64_t)plane->y * c->y
            + (int64_t)plane->depth * c->depth + (int64_t)plane->eye * (1 << 28)) >> 12;
}

/* Same as tp_clip_triangle, also clipped by `plane` unless `plane` is NULL. */
int tp_clip_triangle_view_and_plane(const tp_projection *projection,
                                    const tp_view_plane *plane,
                                    const tp_view_vertex in[3],
                                    tp_view_vertex out[TP_CLIP_VERTICES]);

/* Returns the same view for a picture of half the width and height.  The result is exact,
 * because only the power of two in the view coordinates is halved. */
tp_projection tp_projection_halve(const tp_projection *projection);

/* A side of the view frustum as a half-space: a point p (world, m) is inside if
 * n . p + d >= 0. */
typedef struct {
    tp_dir3 n;
    tp_fx   d;
} tp_plane;

#define TP_PROJECTION_PLANES 5        /* near, left, right, bottom, top */
void tp_projection_planes(const tp_projection *projection, uint32_t width, uint32_t height,
                          tp_plane planes[TP_PROJECTION_PLANES]);
#endif
