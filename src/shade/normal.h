/* SPDX-License-Identifier: MIT */
/* Normals of solids, unpacked from samples for span stages. */
#ifndef TP_SHADE_NORMAL_H
#define TP_SHADE_NORMAL_H
#include "asset/mesh.h"
#include "fx/fx.h"

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
#endif
