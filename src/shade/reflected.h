/* SPDX-License-Identifier: MIT */
/* The mirrored view vector [F3]: R = 2 (N.V) N - V.  Its height Ry is known already.  With
 * k = Ry + Vy = 2 (N.V) Ny and N = Ny (-sx, 1, -sz) the other components are -k sx - Vx
 * and -k sz - Vz. */
#ifndef TP_SHADE_REFLECTED_H
#define TP_SHADE_REFLECTED_H
#include "shade/shade.h"

/* Fills rx and rz of sample i, Q1.14, and returns the mirrored vector.  A vector that
 * points down is made level. */
TP_ALWAYS_INLINE tp_ray tp_reflected_compute(tp_run *run, int32_t i)
{
    int32_t up = run->up[i], k = up + run->vy[i];
    int32_t rx = -(k * run->sx[i] >> 12) - run->vx[i];
    int32_t rz = -(k * run->sz[i] >> 12) - run->vz[i];

    rx = tp_clamp(rx, -16384, 16384);
    rz = tp_clamp(rz, -16384, 16384);
    run->rx[i] = (int16_t)rx;
    run->rz[i] = (int16_t)rz;
    return (tp_ray){ rx, up > 0 ? up : 0, rz, 0 };
}
#endif
