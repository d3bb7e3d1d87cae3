/* SPDX-License-Identifier: MIT */
/* The projection of a camera. */
#include "geom/geom.h"

const uint32_t tp_recip_seed[128] = {
#include "geom/recip_table.inc"
};

/* Scales a row. focal <= 2^m and row entries are <= 1, so the result fits Q2.30. */
static tp_dir3 dir_scaled(tp_dir3 d, tp_fx focal, int m)
{
    int32_t by = (int32_t)((int64_t)focal * (1 << 14) >> m);    /* factor, Q2.30 */
    return (tp_dir3){ tp_q30_mul(d.x, by), tp_q30_mul(d.y, by), tp_q30_mul(d.z, by) };
}

void tp_lens_init(tp_lens *lens, tp_vec3 eye, tp_turn heading, tp_turn pitch, tp_fx fov,
                  tp_fx near, uint32_t width, uint32_t height)
{
    tp_lens_turned(lens, eye, tp_rotation_from_angles(heading, pitch, 0), fov, near,
                   width, height);
}

void tp_lens_turned(tp_lens *lens, tp_vec3 eye, tp_rotation turn, tp_fx fov, tp_fx near,
                    uint32_t width, uint32_t height)
{
    tp_dir3 half =
        tp_rotation_from_angles(tp_turn_of_degrees(fov) / 2, 0, 0).x; /* cos, 0, sin */

    TP_ASSERT(width > 0 && height > 0 && near > 0 && half.z > 0);
    lens->eye = eye;
    lens->turn = turn;
    lens->near = near;
    lens->zi_near = near - (near >> 8);
    lens->focal = (tp_fx)((int64_t)height * (1 << 15) * half.x / half.z);
    lens->m = 0;
    while (lens->m < TP_GUARD_LOG2 && lens->focal > TP_FX_ONE << lens->m)
        lens->m++;
    lens->right = dir_scaled(turn.x, lens->focal, lens->m);
    lens->up = dir_scaled(turn.y, lens->focal, lens->m);
    lens->lean = lens->right.y;
    lens->ahead = (tp_dir3){ -turn.z.x, -turn.z.y, -turn.z.z };
    lens->u0 = (int32_t)(width * 8);
    lens->v0 = (int32_t)(height * 8);
}

/* focal is above 2^(m-1) and m is above 0, because a picture has at least 16 rows and a
 * view at most 100 degrees. */
tp_lens tp_lens_halved(const tp_lens *lens)
{
    TP_ASSERT(lens->m > 0);
    tp_lens half = *lens;

    half.focal = lens->focal >> 1;
    half.m = lens->m - 1;
    half.u0 = lens->u0 / 2;
    half.v0 = lens->v0 / 2;
    return half;
}

/* Scales the view's rows by 2^m / focal, 1..2 (0.7 if m is at its limit).  A scaled view
 * coordinate times this factor is in metres. */
tp_view_plane tp_lens_level(const tp_lens *lens, tp_fx level, int side)
{
    TP_ASSERT(lens->focal > 0 && (side == 1 || side == -1));
    int64_t one = ((int64_t)1 << (44 + lens->m)) / lens->focal;     /* 2^m / focal, Q.28 */
    tp_fx   up = lens->eye.y - level;

    return (tp_view_plane){
        (int32_t)(side * (lens->turn.x.y * one >> 30)),
        (int32_t)(side * (lens->turn.y.y * one >> 30)),
        side * (lens->ahead.y >> 2), side > 0 ? up : -up,
    };
}

void tp_corner_project(const tp_lens *lens, const tp_view_corner *from, tp_corner *to)
{
    TP_ASSERT(tp_lens_holds(lens, from));
    tp_lens_project(lens, from, &to->u, &to->v, &to->zi);
    to->s = from->s;
    to->t = from->t;
    for (int i = 0; i < 3; i++)
        to->n[i] = from->n[i];
}

/* Returns the plane through the eye and the screen column or row `half` px from the
 * centre: normal = side x focal + ahead x half; the inside faces the centre. */
static tp_plane side_plane(const tp_lens *lens, tp_dir3 side, int sign, uint32_t half)
{
    int32_t f = lens->focal >> 4, h = (int32_t)half << 12;      /* Q20.12 */
    tp_dir3 a = lens->ahead;
    tp_dir3 n = tp_normalise(
        (int32_t)(((int64_t)sign * side.x * f + (int64_t)a.x * h) >> 28),
        (int32_t)(((int64_t)sign * side.y * f + (int64_t)a.y * h) >> 28),
        (int32_t)(((int64_t)sign * side.z * f + (int64_t)a.z * h) >> 28));
    return (tp_plane){ n, -tp_dot_dir(lens->eye, n) };
}

void tp_lens_planes(const tp_lens *lens, uint32_t width, uint32_t height,
                    tp_plane planes[TP_LENS_PLANES])
{
    uint32_t half_w = width / 2 + 1, half_h = height / 2 + 1;

    planes[0] = (tp_plane){ lens->ahead,
                            -tp_dot_dir(lens->eye, lens->ahead) - lens->near };
    planes[1] = side_plane(lens, lens->turn.x, 1, half_w);
    planes[2] = side_plane(lens, lens->turn.x, -1, half_w);
    planes[3] = side_plane(lens, lens->turn.y, 1, half_h);
    planes[4] = side_plane(lens, lens->turn.y, -1, half_h);
}
