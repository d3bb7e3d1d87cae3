/* SPDX-License-Identifier: MIT */
/* The direction from each sample to the eye, exact at every 16th column (a unit vector
 * there), linear between: at 640 pixels and 60 degrees that is 0.0002 short of a unit in
 * the middle, and cutting to Q1.14 shortens it by as much again at most. */
#include "shade/shade.h"

static int32_t q14_of(int64_t x)
{
    return (int32_t)(x >> 20);
}

/* right (u - u0) + up (v0 - v) - back focal, towards the scene, turned round.  Each
 * product has 30 + 18 bits. */
tp_ray tp_view_ray(const tp_shade *shade, const tp_view_axes *a, int32_t x, int32_t y)
{
    int64_t u = 16 * x + 8 - shade->u0, v = shade->v0 - 16 * y - 8, f = shade->focal;
    tp_dir3 d = tp_normalise(q14_of(f * a->back.x - u * a->right.x - v * a->up.x),
                             q14_of(f * a->back.y - u * a->right.y - v * a->up.y),
                             q14_of(f * a->back.z - u * a->right.z - v * a->up.z));
    tp_ray r = { d.x >> 16, d.y >> 16, d.z >> 16, 0 };

    r.l = (r.x * a->lx + r.y * a->ly + r.z * a->lz) >> 14;
    return r;
}

void tp_view_run(const tp_shade *shade, const tp_view_axes *axes, tp_run *run)
{
    int32_t x = run->x, end = run->x + run->count;
    tp_ray a = tp_view_ray(shade, axes, x & ~15, run->y);

    for (int32_t i = 0; x < end; ) {
        int32_t from = x & ~15, next = from + 16;
        tp_ray b = tp_view_ray(shade, axes, next, run->y);
        tp_ray step = { b.x - a.x, b.y - a.y, b.z - a.z, b.l - a.l };
        int32_t stop = next < end ? next : end;
        for (; x < stop; x++, i++) {
            int32_t k = x - from;
            run->vx[i] = (int16_t)(a.x + (step.x * k >> 4));
            run->vy[i] = (int16_t)(a.y + (step.y * k >> 4));
            run->vz[i] = (int16_t)(a.z + (step.z * k >> 4));
            run->lv[i] = (int16_t)(a.l + (step.l * k >> 4));
        }
        a = b;
    }
}

void tp_stage_view(const tp_shade *shade, tp_run *run)
{
    tp_view_run(shade, &shade->world, run);
}
