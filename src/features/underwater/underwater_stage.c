/* SPDX-License-Identifier: MIT */
/* The view from under water: the surface from below, bare water, and the absorption in
 * front of all other surfaces. */
#include "features/underwater/underwater.h"
#include "scene/world.h"
#include "shade/beam.h"
#include "shade/slope.h"

/* Returns the view ray of sample i; run->vx, vy, vz are set. */
TP_ALWAYS_INLINE tp_ray view_direction(const tp_run *run, int32_t i)
{
    return (tp_ray){ -run->vx[i], -run->vy[i], -run->vz[i], 0 };
}

/* Returns the length of the ray, m, to a depth along the camera's axis: the depth over
 * the cosine between both.  The cosine is at least 1/16, the edge of the widest view. */
static tp_fx ray_length_at_depth(const tp_shade *shade, tp_ray way, tp_fx depth)
{
    const tp_dir3 back = shade->world.back;
    int64_t cosine = -((int64_t)back.x * way.x + (int64_t)back.y * way.y
                       + (int64_t)back.z * way.z) >> 30;
    uint32_t n = (uint32_t)tp_clamp((int32_t)cosine, 1024, 16384) << 17;
    int      shift = tp_clz(n);
    return tp_fx_saturate((int64_t)((uint64_t)(uint32_t)depth * tp_recip_norm(n << shift)
                                >> (32 - shift)));
}

TP_ALWAYS_INLINE void shade_underside(const tp_shade *shade, tp_run *run, int rippled)
{
    const tp_underwater *in = shade->underwater;

    for (int32_t i = 0; i < run->count; i++) {
        tp_ray  n = tp_slope_run_normal(run, i, rippled);
        tp_refracted_ray ray;
        tp_underwater_set_start_points(shade, run, i, i + 1, &ray);
        ray.way = view_direction(run, i);
        tp_floor_plane  plane = tp_underwater_find_floor_plane(shade, &ray);
        uint32_t c = tp_underwater_trace_surface(shade, &plane, &ray, n, in->deep);
        run->colour[i] = tp_absorb_apply(&in->absorb, c, in->deep,
                                         ray_length_at_depth(shade, ray.way, ray.far));
    }
}

void tp_stage_underside(const tp_shade *shade, tp_run *run)
{
    shade_underside(shade, run, 0);
}

void tp_stage_underside_rippled(const tp_shade *shade, tp_run *run)
{
    shade_underside(shade, run, 1);
}

/* Shades bare water.  The stage computes its own view vectors. */
void tp_stage_deep(const tp_shade *shade, tp_run *run)
{
    tp_view_run(shade, &shade->world, run);
    for (int32_t i = 0; i < run->count; i++) {
        tp_refracted_ray ray = { shade->eye, view_direction(run, i), 0 };
        tp_floor_plane  plane = tp_underwater_find_floor_plane(shade, &ray);
        run->colour[i] = tp_underwater_trace(shade, &plane, &ray, shade->underwater->deep);
    }
}

void tp_stage_absorb(const tp_shade *shade, tp_run *run)
{
    const tp_underwater *in = shade->underwater;

    tp_view_run(shade, &shade->world, run);
    for (int32_t i = 0; i < run->count; i++) {
        tp_refracted_ray ray;
        tp_underwater_set_start_points(shade, run, i, i + 1, &ray);
        run->colour[i] =
            tp_absorb_apply(&in->absorb, run->colour[i], in->deep,
                            ray_length_at_depth(shade, view_direction(run, i), ray.far));
    }
}

const tp_stage tp_underwater_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_underwater(X)
#undef X
};
