/* SPDX-License-Identifier: MIT */
/* The direction from each sample to the eye, exact at every 16th column (a unit vector
 * there) and a parabola between, bowed by the mean of the second differences at its two
 * ends.  A straight line would be 0.0015 short of a unit in a picture of 160 pixels: a
 * sharp lobe would lose an eighth between the knots, and stripes would show.  What is
 * left are cuts to Q1.14. */
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

/* a + step k / 16 + bow k (16 - k) / 1024 of the way from a to b. */
typedef struct {
    tp_ray step, bow;
} bend;

static bend bend_of(tp_ray before, tp_ray a, tp_ray b, tp_ray after)
{
    return (bend){
        { b.x - a.x, b.y - a.y, b.z - a.z, b.l - a.l },
        { a.x + b.x - before.x - after.x, a.y + b.y - before.y - after.y,
          a.z + b.z - before.z - after.z, a.l + b.l - before.l - after.l },
    };
}

TP_ALWAYS_INLINE int16_t along(int32_t a, int32_t step, int32_t bow, int32_t k)
{
    return (int16_t)(a + ((step * 64 + bow * (16 - k)) * k >> 10));
}

void tp_view_run(const tp_shade *shade, const tp_view_axes *axes, tp_run *run)
{
    int32_t x = run->x, end = run->x + run->count, y = run->y, from = x & ~15;
    tp_ray before = tp_view_ray(shade, axes, from - 16, y);
    tp_ray a = tp_view_ray(shade, axes, from, y);
    tp_ray b = tp_view_ray(shade, axes, from + 16, y);

    for (int32_t i = 0; x < end; from += 16) {
        tp_ray after = tp_view_ray(shade, axes, from + 32, y);
        bend   to = bend_of(before, a, b, after);
        int32_t stop = from + 16 < end ? from + 16 : end;
        for (; x < stop; x++, i++) {
            int32_t k = x - from;
            run->vx[i] = along(a.x, to.step.x, to.bow.x, k);
            run->vy[i] = along(a.y, to.step.y, to.bow.y, k);
            run->vz[i] = along(a.z, to.step.z, to.bow.z, k);
            run->lv[i] = along(a.l, to.step.l, to.bow.l, k);
        }
        before = a;
        a = b;
        b = after;
    }
}

void tp_stage_view(const tp_shade *shade, tp_run *run)
{
    tp_view_run(shade, &shade->world, run);
}
