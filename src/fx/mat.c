/* SPDX-License-Identifier: MIT */
/* Rotations, stored as three rows of unit vectors.
 *
 * A frame first looks along -z.  Its heading turns the frame about y, its pitch lifts
 * the frame about the frame's own right, its roll turns the frame about its own back
 * axis.  A rotation is built once a frame and moves every vertex: its sine has 27 good
 * bits where tp_sin has 17. */
#include "fx/fx.h"

typedef struct { tp_q30 sin, cos; } sine_cosine;

/* Starts from the nearest of the 1024 knots of the sine table, where tp_sin is exact.  d is
 * the distance to the knot in radians:
 *     sin(a + d) = sin a + d cos a - d^2/2 sin a
 * |d| <= pi/1024; the first omitted term is d^3/6 < 5e-9. */
static sine_cosine sine_pair(tp_turn angle)
{
    const tp_turn knot = (angle + (1u << 21)) & ~((1u << 22) - 1);
    const int32_t turns = (int32_t)(angle - knot);
    const tp_q30 d = (tp_q30)((turns * (int64_t)TP_Q30(1.5707963267948966)
                               + (1 << 29)) >> 30);     /* 2 pi 2^30 / 2^32 = pi/2 */
    const tp_q30 half_square = (tp_q30)(((int64_t)d * d + (1 << 30)) >> 31);
    const tp_q30 s = tp_sin(knot), c = tp_cos(knot);
    return (sine_cosine){
        s + tp_q30_mul(c, d) - tp_q30_mul(s, half_square),
        c - tp_q30_mul(s, d) - tp_q30_mul(c, half_square),
    };
}

/* Returns a s + b t, rounded half up once. */
static tp_dir3 blend(tp_dir3 a, tp_q30 s, tp_dir3 b, tp_q30 t)
{
    const int64_t half = 1 << 29;
    return (tp_dir3){
        (tp_q30)(((int64_t)a.x * s + (int64_t)b.x * t + half) >> 30),
        (tp_q30)(((int64_t)a.y * s + (int64_t)b.y * t + half) >> 30),
        (tp_q30)(((int64_t)a.z * s + (int64_t)b.z * t + half) >> 30),
    };
}

tp_rotation tp_rotation_from_angles(tp_turn heading, tp_turn pitch, tp_turn roll)
{
    const sine_cosine h = sine_pair(heading), p = sine_pair(pitch), r = sine_pair(roll);
    const tp_dir3 world_up = { 0, TP_Q30_ONE, 0 };
    const tp_dir3 level_right = { h.cos, 0, h.sin };
    const tp_dir3 level_back = { -h.sin, 0, h.cos };
    const tp_dir3 lifted_up = blend(world_up, p.cos, level_back, p.sin);
    return (tp_rotation){
        .x = blend(level_right, r.cos, lifted_up, -r.sin),
        .y = blend(lifted_up, r.cos, level_right, r.sin),
        .z = blend(level_back, p.cos, world_up, -p.sin),
    };
}

tp_vec3 tp_rotate(const tp_rotation *r, tp_vec3 v)
{
    return (tp_vec3){ tp_dot_dir(v, r->x), tp_dot_dir(v, r->y), tp_dot_dir(v, r->z) };
}

tp_vec3 tp_rotate_back(const tp_rotation *r, tp_vec3 v)
{
    return (tp_vec3){
        tp_dot_dir(v, (tp_dir3){ r->x.x, r->y.x, r->z.x }),
        tp_dot_dir(v, (tp_dir3){ r->x.y, r->y.y, r->z.y }),
        tp_dot_dir(v, (tp_dir3){ r->x.z, r->y.z, r->z.z }),
    };
}

/* A row of A B is the row of A times B: the transpose of B applied to the row of A. */
static tp_dir3 row_times(tp_dir3 row, const tp_rotation *b)
{
    const tp_vec3 v = tp_rotate_back(b, (tp_vec3){ row.x, row.y, row.z });
    return (tp_dir3){ v.x, v.y, v.z };
}

tp_rotation tp_rotation_mul(const tp_rotation *a, const tp_rotation *b)
{
    return (tp_rotation){ row_times(a->x, b), row_times(a->y, b), row_times(a->z, b) };
}
