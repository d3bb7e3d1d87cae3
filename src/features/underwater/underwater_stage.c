/* SPDX-License-Identifier: MIT */
/*
 * Span stages of the inside of the water.  From under water: the surface from below, bare
 * water, and the absorption in front of all other surfaces.  From above: the view through
 * the surface of clear water.
 */
#include "features/underwater/underwater.h"
#include "shade/refracted_ray.h"
#include "shade/shade.h"
#include "shade/slope.h"
#include "view/projection.h"
#include "world/world.h"

/* -- from under water ---------------------------------------------------------------- */

/* Returns the view ray of sample i; run->vx, vy, vz are set. */
TP_ALWAYS_INLINE tp_ray view_direction(const tp_run *run, int32_t i)
{
    return (tp_ray){ -run->vx[i], -run->vy[i], -run->vz[i], 0 };
}

/* Returns the length of the ray, m, to a depth along the camera's axis: the depth over
 * the cosine between both.  The cosine is at least 1/16, the edge of the widest view. */
static tp_fx ray_length_at_view_depth(const tp_shade *shade, tp_ray direction,
                                      tp_fx view_depth)
{
    const tp_dir3 back = shade->world.back;
    int64_t cosine = -((int64_t)back.x * direction.x + (int64_t)back.y * direction.y
                       + (int64_t)back.z * direction.z) >> 30;
    uint32_t n = (uint32_t)tp_clamp((int32_t)cosine, 1024, 16384) << 17;
    int      shift = tp_clz(n);
    return tp_fx_saturate(
        (int64_t)((uint64_t)(uint32_t)view_depth * tp_recip_norm(n << shift)
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
        uint32_t c = tp_underwater_shade_underside(shade, &plane, &ray, n, in->deep);
        run->colour[i] = tp_absorb_apply(&in->absorb, c, in->deep,
                                         ray_length_at_view_depth(shade, ray.way, ray.far));
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
    tp_run_fill_vectors_to_eye(shade, &shade->world, run);
    for (int32_t i = 0; i < run->count; i++) {
        tp_refracted_ray ray = { shade->eye, view_direction(run, i), 0 };
        tp_floor_plane  plane = tp_underwater_find_floor_plane(shade, &ray);
        run->colour[i] = tp_underwater_trace(shade, &plane, &ray, shade->underwater->deep);
    }
}

enum { ABSORBED = 4 };          /* rays at a time: more take stack for little */

void tp_stage_absorb(const tp_shade *shade, tp_run *run)
{
    const tp_underwater *in = shade->underwater;
    tp_refracted_ray ray[ABSORBED];

    tp_run_fill_vectors_to_eye(shade, &shade->world, run);
    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = i + ABSORBED < run->count ? i + ABSORBED : run->count;
        tp_underwater_set_start_points(shade, run, i, stop, ray);
        for (int32_t k = i; k < stop; k++)
            run->colour[k] = tp_absorb_apply(
                &in->absorb, run->colour[k], in->deep,
                ray_length_at_view_depth(shade, view_direction(run, k), ray[k - i].far));
    }
}

const tp_stage tp_underwater_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_underwater(X)
#undef X
};

/* -- from above ---------------------------------------------------------------------- */

/* The view through the surface from above: floor, walls and objects in the water,
 * refracted at the bumped normal [F4] and attenuated along the ray.
 *
 * The water's own light is three parts of the deep colour and one part of the lit colour
 * left by the earlier stages.  Layers and light therefore still move over deep water,
 * while the shallowest water at a shore shows the land alone.
 *
 * With dispersion each channel has its own refractive index and its own ray; or, with
 * quality.dispersion=fast, red and blue shift green's place on the floor by the derivative
 * of the refracted ray (see fast_refraction_stage.c) by eta:
 *
 *     d way = in + m n,   m = ci + eta si^2 / ct,   si^2 = 1 - ci^2
 *
 * and, where the ray meets a level floor, d place = path (d way + way d way.y / ct).  A
 * block takes ci, ct and m of level water at its first sample. */

/* The surface at a sample, Q1.14: its normal, and the cosine of the angle to the view
 * ray. */
typedef struct {
    int16_t x, y, z, cosine;
} facet;

TP_ALWAYS_INLINE tp_ray clear_view_direction(const tp_run *run, int32_t i)
{
    return (tp_ray){ -run->vx[i], -run->vy[i], -run->vz[i], 0 };
}

TP_ALWAYS_INLINE void compute_facets(const tp_run *run, int32_t i, int32_t stop,
                                     int rippled, facet *to)
{
    for (; i < stop; i++, to++) {
        tp_ray n = tp_slope_run_normal(run, i, rippled);
        *to = (facet){ (int16_t)n.x, (int16_t)n.y, (int16_t)n.z,
                       (int16_t)tp_incidence_cosine(clear_view_direction(run, i), n) };
    }
}

/* Refracts the view rays of samples [i, stop) at the surface into the water, for one
 * colour channel. */
TP_ALWAYS_INLINE void refract_rays(const tp_shade *shade, const tp_run *run, int32_t i,
                                   int32_t stop, const facet *surface, int channel,
                                   tp_refracted_ray *ray)
{
    for (; i < stop; i++, surface++, ray++) {
        tp_ray n = { surface->x, surface->y, surface->z, 0 };
        tp_ray way = tp_underwater_refract_at_cosine(
            shade->underwater, channel, clear_view_direction(run, i), n, surface->cosine);
        if (way.y > -1638)      /* a steep ripple would bend the ray out of the water */
            way.y = -1638;
        ray->way = way;
    }
}

/* Mixes the refraction map over a colour.  The place in the map is displaced as for an
 * object half a metre under the surface, by a quarter of the slope [F4]. */
uint32_t tp_refraction_map_mix(const tp_shade *shade, const tp_planar_map *map,
                               const tp_run *run, int32_t i, tp_fx depth, int32_t nx,
                               int32_t nz, uint32_t colour)
{
    const tp_view_axes *axes = &shade->world;
    int32_t across = (int32_t)(((int64_t)axes->right.x * nx + (int64_t)axes->right.z * nz)
                               >> 30);
    int32_t along = (int32_t)(((int64_t)axes->up.x * nx + (int64_t)axes->up.z * nz)
                              >> 30);
    uint32_t far = (uint32_t)depth | 1;
    int      shift = tp_clz(far);
    int64_t  each = tp_recip_rough(far << shift);       /* 2^46 / m / 2^shift */
    int64_t  focal = shade->focal;
    int32_t  u = (int32_t)tp_clamp_abs((across * focal >> 4) * each >> (64 - shift), 64);
    int32_t  v = (int32_t)tp_clamp_abs((along * focal >> 4) * each >> (64 - shift), 64);
    int32_t  x = (run->x + i) / 2 - u, y = run->y / 2 + v;

    uint32_t over = tp_planar_map_pixel(map, x, y);
    uint32_t share = (over >> 24) + (over >> 31);
    return tp_colour_mix(colour, over, share);
}

/* Shades samples [i, stop) with dispersion.  On entry the beams hold the rays of green,
 * and the floor between the ends is looked up for green.  Red and blue rays end some
 * millimetres aside per metre of depth, where the floor is the same plane. */
static void shade_dispersed(const tp_shade *shade, tp_run *run, int32_t i, int32_t stop,
                            const facet *surface, const tp_floor_plane ends[2],
                            tp_refracted_ray *ray)
{
    uint32_t *seen = run->colour + i;
    const uint32_t *body = run->mirror + i;
    const int32_t count = stop - i;
    tp_ground under[TP_UNDERWATER_ROW];

    tp_underwater_interpolate_floor(shade, ends, ray, count, under);
    for (int32_t k = 0; k < count; k++)
        seen[k] = 0;
    tp_underwater_shade_row_channel(shade, under, ray, count, body, 8, seen);
    for (int channel = 0; channel < 3; channel += 2) {
        refract_rays(shade, run, i, stop, surface, channel, ray);
        tp_underwater_shade_row_channel(shade, under, ray, count, body, 16 - 8 * channel,
                                        seen);
    }
}

/* Sets the shifts of red for samples [i, stop); blue's are the opposite.  The derivatives
 * are below 2^16, half of the difference between red's and blue's eta below 2^13. */
static void set_shifts(const tp_underwater *in, const tp_run *run, int32_t i, int32_t stop,
                       const facet *surface, const tp_refracted_ray *ray, tp_place_shift *to)
{
    const int32_t eta = in->eta[1], ci = run->vy[i] > 0 ? run->vy[i] : 0;
    const uint32_t s2 = (1u << 28) - (uint32_t)(ci * ci);
    const int32_t ct =
        tp_sqrt_one_minus((uint32_t)((uint64_t)s2 * (uint32_t)in->eta2[1] >> 14));
    const int32_t more = eta * (int32_t)(s2 >> 14) / ct, m = ci + more;
    const int32_t fall = more * 16384 / ct, spread = (in->eta[0] - in->eta[2]) / 2;

    for (; i < stop; i++, surface++, ray++, to++) {
        const int32_t x = -run->vx[i] + ((surface->x * m + ray->way.x * fall) >> 14);
        const int32_t z = -run->vz[i] + ((surface->z * m + ray->way.z * fall) >> 14);
        *to = (tp_place_shift){ (int16_t)tp_ssat(x * spread, 14, 15),
                                (int16_t)tp_ssat(z * spread, 14, 15) };
    }
}

static void shade_shifted(const tp_shade *shade, tp_run *run, int32_t i, int32_t stop,
                          const facet *surface, const tp_floor_plane ends[2],
                          const tp_refracted_ray *ray)
{
    tp_place_shift shift[TP_UNDERWATER_ROW];

    set_shifts(shade->underwater, run, i, stop, surface, ray, shift);
    tp_underwater_shade_row_shifted(shade, ends, ray, shift, stop - i, run->mirror + i,
                                    run->colour + i);
}

TP_ALWAYS_INLINE void shade_clear_water(const tp_shade *shade, tp_run *run, int rippled,
                                        int dispersed)
{
    const tp_clear_water *clear = run->mine;
    tp_refracted_ray  ray[TP_UNDERWATER_ROW];
    facet    surface[TP_UNDERWATER_ROW];
    tp_floor_plane   ends[2];

    for (int32_t i = 0; i < run->count; ) {
        int32_t   stop = tp_block_end(run, i), count = stop - i;
        uint32_t *seen = run->colour + i, *body = run->mirror + i; /* not reflected yet */
        for (int32_t k = 0; k < count; k++)
            body[k] = tp_colour_mix(shade->underwater->deep, seen[k], 64);
        tp_underwater_set_start_points(shade, run, i, stop, ray);
        compute_facets(run, i, stop, rippled, surface);
        refract_rays(shade, run, i, stop, surface, 1, ray);
        ends[0] = tp_underwater_find_floor_plane(shade, ray);
        ends[1] = tp_underwater_find_floor_plane(shade, &ray[count - 1]);
        if (dispersed == 2)
            shade_shifted(shade, run, i, stop, surface, ends, ray);
        else if (dispersed)
            shade_dispersed(shade, run, i, stop, surface, ends, ray);
        else
            tp_underwater_shade_row(shade, ends, ray, count, body, seen);
        for (int32_t k = 0; clear->refraction_map && k < count; k++)
            seen[k] = clear->mix(shade, clear->refraction_map, run, i + k, ray[k].far,
                                 surface[k].x, surface[k].z, seen[k]);
        i = stop;
    }
}

#define REFRACT_STAGE(name, rippled, dispersed) \
    void tp_stage_##name(const tp_shade *shade, tp_run *run) \
    { shade_clear_water(shade, run, rippled, dispersed); }
TP_CLEAR_WATER_STAGES(REFRACT_STAGE)

const tp_stage tp_clear_water_stages[] = {
#define X(name, rippled, dispersed) [TP_NTH_##name] = tp_stage_##name,
    TP_CLEAR_WATER_STAGES(X)
#undef X
    [TP_NTH_quick_refract] = tp_stage_quick_refract,
    [TP_NTH_quick_refract_shifted] = tp_stage_quick_refract_shifted,
};
