/* SPDX-License-Identifier: MIT */
/* The direction from each sample to the eye, exact at every 16th column (a unit vector
 * there) and a parabola between.  The straight line would be short of a unit by dip =
 * |b - a|^2 / 8 in the middle, 0.0015 in a picture of 160 pixels: a sharp lobe would lose
 * an eighth there, and stripes would show.  The parabola's own error is that dip's
 * square. */
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

/* From one ray to the next, 16 columns on: a + step k / 16 + bow k (16 - k) / 1024, so
 * that bow is 16 dip of the two rays' mean. */
typedef struct {
    tp_ray step, bow;
} bend;

static bend bend_of(tp_ray a, tp_ray b)
{
    tp_ray  s = { b.x - a.x, b.y - a.y, b.z - a.z, b.l - a.l };
    int64_t way = s.x * s.x + s.y * s.y + s.z * s.z;    /* |b - a|^2 in Q28, below 2^31 */

    return (bend){ s, { (int32_t)((a.x + b.x) * way >> 28),
                        (int32_t)((a.y + b.y) * way >> 28),
                        (int32_t)((a.z + b.z) * way >> 28),
                        (int32_t)((a.l + b.l) * way >> 28) } };
}

TP_ALWAYS_INLINE int16_t along(int32_t a, int32_t step, int32_t bow, int32_t k)
{
    return (int16_t)(a + ((step * 64 + bow * (16 - k)) * k >> 10));
}

void tp_view_run(const tp_shade *shade, const tp_view_axes *axes, tp_run *run)
{
    int32_t x = run->x, end = run->x + run->count;
    tp_ray a = tp_view_ray(shade, axes, x & ~15, run->y);

    for (int32_t i = 0; x < end; ) {
        int32_t from = x & ~15, next = from + 16;
        tp_ray b = tp_view_ray(shade, axes, next, run->y);
        bend   to = bend_of(a, b);
        int32_t stop = next < end ? next : end;
        for (; x < stop; x++, i++) {
            int32_t k = x - from;
            run->vx[i] = along(a.x, to.step.x, to.bow.x, k);
            run->vy[i] = along(a.y, to.step.y, to.bow.y, k);
            run->vz[i] = along(a.z, to.step.z, to.bow.z, k);
            run->lv[i] = along(a.l, to.step.l, to.bow.l, k);
        }
        a = b;
    }
}

void tp_stage_view(const tp_shade *shade, tp_run *run)
{
    tp_view_run(shade, &shade->world, run);
}
