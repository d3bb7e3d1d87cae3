/* SPDX-License-Identifier: MIT */
/*
 * View rays of samples: the unit vector to the eye, for exact and for fast stages, and the
 * world position of a sample in the water, from its depth.
 *
 * For exact stages the vector is exact at every 16th column (a knot) and quadratic
 * between.  The curvature is the mean of the second differences at both knots.  Linear
 * interpolation would be 0.0015 too short in a picture 160 pixels wide: a sharp lobe would
 * lose an eighth of its peak between knots, visible as stripes.  The remaining error is the
 * truncation to Q1.14.
 */
#include "shade/refracted_ray.h"
#include "shade/shade.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

/* right (u - u0) + up (v0 - v) - back focal points to the scene; this is its negative,
 * Q30.  Each product has 30 + 18 bits. */
typedef struct {
    int64_t x, y, z;
} way;

static way pixel_view_vector(const tp_shade *shade, const tp_view_axes *a, int32_t x,
                             int32_t y)
{
    int64_t u = 16 * x + 8 - shade->u0, v = shade->v0 - 16 * y - 8, f = shade->focal;

    return (way){
        f * a->back.x - u * a->right.x - v * a->up.x,
        f * a->back.y - u * a->right.y - v * a->up.y,
        f * a->back.z - u * a->right.z - v * a->up.z,
    };
}

/* Returns the upper 16 bits of a component of tp_normalise, which is
 * (x inverse + 2^(32 - half)) / 2^(33 - half): inverse is 2^31..2^32, so x inverse is
 * x 2^32 + x (inverse - 2^32), two words that Cortex-M multiplies in one instruction. */
TP_ALWAYS_INLINE int32_t normalise_q14(int32_t x, uint32_t inverse, int half)
{
    const int64_t below = (int64_t)x * (int32_t)inverse + ((int64_t)1 << (32 - half));

    return ((int32_t)(below >> 32) + x) >> (17 - half);
}

/* Normalises a vector, reduced to Q10, with the bits of tp_normalise.  A vector shorter
 * than 2^16 occurs only in pictures of few pixels. */
TP_ALWAYS_INLINE tp_ray normalise_ray(const tp_view_axes *a, way w)
{
    const int32_t x = (int32_t)(w.x >> 20), y = (int32_t)(w.y >> 20),
                  z = (int32_t)(w.z >> 20);
    const uint64_t sum = (uint64_t)((int64_t)x * x) + (uint64_t)((int64_t)y * y)
                       + (uint64_t)((int64_t)z * z);
    const uint32_t high = (uint32_t)(sum >> 32);
    tp_ray r;

    if (high == 0) {
        const tp_dir3 d = tp_normalise(x, y, z);
        r = (tp_ray){ d.x >> 16, d.y >> 16, d.z >> 16, 0 };
    } else {
        const int half = tp_clz(high) >> 1;
        const uint32_t inverse = tp_rsqrt_norm((uint32_t)(sum << 2 * half >> 32));
        r = (tp_ray){ normalise_q14(x, inverse, half), normalise_q14(y, inverse, half),
                      normalise_q14(z, inverse, half), 0 };
    }
    r.l = (r.x * a->lx + r.y * a->ly + r.z * a->lz) >> 14;
    return r;
}

tp_ray tp_vector_to_eye(const tp_shade *shade, const tp_view_axes *a, int32_t x, int32_t y)
{
    return normalise_ray(a, pixel_view_vector(shade, a, x, y));
}

/* Returns the ray 16 columns further right: unnormalised rays are exactly linear in the
 * column. */
TP_NEVER_INLINE tp_ray advance_ray_to_next_knot(const tp_view_axes *a, way *w)
{
    w->x -= 256 * (int64_t)a->right.x;
    w->y -= 256 * (int64_t)a->right.y;
    w->z -= 256 * (int64_t)a->right.z;
    return normalise_ray(a, *w);
}

/* One component between the knots a and b; `before` and `after` are the outer neighbour
 * knots.  Value at column k of 16: begin + step k + bow k (16 - k), Q10. */
typedef struct {
    int32_t begin, step, bow;
} arc;

static inline arc make_parabola_between_knots(int32_t before, int32_t a, int32_t b,
                                              int32_t after)
{
    return (arc){ a * 1024, (b - a) * 64, a + b - before - after };
}

/* Evaluates a component at `count` columns from k on. */
static void evaluate_arc(arc a, int32_t k, int32_t count, int16_t *restrict to)
{
    if (TP_WIDE) {
        for (int32_t i = 0; i < count; i++) {
            int32_t here = k + i;
            to[i] = (int16_t)((a.begin + a.step * here + a.bow * ((16 - here) * here))
                              >> 10);
        }
        return;
    }
    int32_t at = a.begin + (a.step + a.bow * (16 - k)) * k;
    int32_t step = a.step + a.bow * (15 - 2 * k);
    for (int32_t i = 0; i < count; i++, at += step, step -= 2 * a.bow)
        to[i] = (int16_t)(at >> 10);
}

/* Evaluates two components at `count` columns from k on: each column directly for vector
 * units, else by forward differences. */
static void evaluate_arcs(arc a, arc b, int32_t k, int32_t count, int16_t *restrict to_a,
                          int16_t *restrict to_b)
{
    if (TP_WIDE) {
        for (int32_t i = 0; i < count; i++) {
            int32_t here = k + i, square = (16 - here) * here;
            to_a[i] = (int16_t)((a.begin + a.step * here + a.bow * square) >> 10);
            to_b[i] = (int16_t)((b.begin + b.step * here + b.bow * square) >> 10);
        }
        return;
    }
    int32_t at_a = a.begin + (a.step + a.bow * (16 - k)) * k;
    int32_t at_b = b.begin + (b.step + b.bow * (16 - k)) * k;
    int32_t step_a = a.step + a.bow * (15 - 2 * k);
    int32_t step_b = b.step + b.bow * (15 - 2 * k);
    for (int32_t i = 0; i < count; i++) {
        to_a[i] = (int16_t)(at_a >> 10);
        to_b[i] = (int16_t)(at_b >> 10);
        at_a += step_a;
        at_b += step_b;
        step_a -= 2 * a.bow;
        step_b -= 2 * b.bow;
    }
}

/* Fills `count` samples from sample `first` on; `light` is a literal: 1 fills lv too. */
TP_ALWAYS_INLINE void interpolate_knot_rays(const tp_ray *a, const tp_ray *b,
                                            const tp_ray *c, const tp_ray *d,
                                            int32_t column_in_block, int32_t count,
                                            tp_run *run, int32_t first, int light)
{
    evaluate_arcs(make_parabola_between_knots(a->x, b->x, c->x, d->x),
                  make_parabola_between_knots(a->y, b->y, c->y, d->y), column_in_block,
                  count, run->vx + first, run->vy + first);
    if (light)
        evaluate_arcs(make_parabola_between_knots(a->z, b->z, c->z, d->z),
                      make_parabola_between_knots(a->l, b->l, c->l, d->l),
                      column_in_block, count, run->vz + first, run->lv + first);
    else
        evaluate_arc(make_parabola_between_knots(a->z, b->z, c->z, d->z),
                     column_in_block, count, run->vz + first);
}

/* Four knots serve a block; the knots of the next block overwrite them in turn. */
TP_ALWAYS_INLINE void fill_vectors(const tp_shade *shade, const tp_view_axes *axes,
                                   tp_run *run, int light)
{
    TP_ASSERT(run->count > 0 && run->count <= TP_RUN);
    int32_t from = run->x & ~15;
    uint32_t n = 3;             /* knots made */
    way     w = pixel_view_vector(shade, axes, from - 16, run->y);
    tp_ray  knot[4] = { normalise_ray(axes, w) };

    knot[1] = advance_ray_to_next_knot(axes, &w);
    knot[2] = advance_ray_to_next_knot(axes, &w);
    for (int32_t i = 0; i < run->count; n++) {
        int32_t stop = tp_block_end(run, i), k = (run->x + i) & 15;
        knot[n & 3] = advance_ray_to_next_knot(axes, &w);
        interpolate_knot_rays(&knot[(n + 1) & 3], &knot[(n + 2) & 3], &knot[(n + 3) & 3],
                              &knot[n & 3], k, stop - i, run, i, light);
        i = stop;
    }
}

void tp_run_fill_vectors_to_eye(const tp_shade *shade, const tp_view_axes *axes,
                                tp_run *run)
{
    fill_vectors(shade, axes, run, 1);
}

void tp_run_fill_sky_vectors(const tp_shade *shade, tp_run *run)
{
    fill_vectors(shade, &shade->world, run, 0);
}

void tp_stage_view(const tp_shade *shade, tp_run *run)
{
    tp_run_fill_vectors_to_eye(shade, &shade->world, run);
}

/* -- view rays of the fast stages, see slope.h --------------------------------------- */

tp_quick_ray_row tp_quick_ray_row_make(const tp_shade *shade, int32_t y)
{
    const tp_view_axes *a = &shade->world;
    int32_t v = tp_quick_over_focal(shade, shade->v0 - 16 * y - 8);

    return (tp_quick_ray_row){
        (a->back.x >> 16) - (v * (a->up.x >> 16) >> 14),
        (a->back.y >> 16) - (v * (a->up.y >> 16) >> 14),
        (a->back.z >> 16) - (v * (a->up.z >> 16) >> 14),
        (uint32_t)v * (uint32_t)v >> 4,
    };
}

tp_ray tp_quick_ray(const tp_shade *shade, const tp_quick_ray_row *row, int32_t sixteenths)
{
    return tp_quick_ray_inline(shade, row, sixteenths);
}

/* -- world positions of samples in the water, see refracted_ray.h -------------------- */

void tp_underwater_set_view(tp_underwater *in, const tp_shade *shade, tp_fx zi_near)
{
    const tp_dir3 right = shade->world.right, up = shade->world.up;
    const tp_q30 across[3] = { right.x, right.y, right.z };
    const tp_q30 along[3] = { up.x, up.y, up.z };

    for (int k = 0; k < 3; k++) {
        in->right[k] = (int64_t)across[k] * 4096 / shade->focal;
        in->up[k] = (int64_t)along[k] * 4096 / shade->focal;
    }
    in->zi_near = zi_near;
}

/* The view vector is -back + right (u - u0) / focal + up (v0 - v) / focal at 1 m of depth.
 * Q42 steps times 2^16 sixteenths of a pixel stay below 2^58; reduced to Q20, products
 * with 2^31 of depth do too. */
void tp_underwater_set_start_points(const tp_shade *shade, const tp_run *run, int32_t i,
                                    int32_t stop, tp_refracted_ray *ray)
{
    const tp_underwater *in = shade->underwater;
    const tp_dir3 back = shade->world.back;
    const int32_t eye[3] = { shade->eye.x, shade->eye.y, shade->eye.z };
    const int32_t behind[3] = { back.x, back.y, back.z };
    int64_t u = 16 * (run->x + i) + 8 - shade->u0, v = shade->v0 - 16 * run->y - 8;
    int64_t view[3];

    for (int k = 0; k < 3; k++)
        view[k] = in->right[k] * u + in->up[k] * v - behind[k] * (int64_t)4096;
    for (; i < stop; i++, ray++) {
        uint32_t zi = (run->key[i] >> 1 & ~(uint32_t)0x7f) | 0x40;
        int64_t  depth = tp_depth_from_zi(in->zi_near, zi);
        int32_t  at[3];
        for (int k = 0; k < 3; k++) {
            at[k] = tp_fx_saturate(eye[k] + (depth * (view[k] >> 22) >> 20));
            view[k] += in->right[k] * 16;
        }
        ray->at = (tp_vec3){ at[0], at[1], at[2] };
        ray->far = tp_fx_saturate(depth);
    }
}
