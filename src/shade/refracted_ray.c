/* SPDX-License-Identifier: MIT */
/* View rays in the water: intersection with floor or walls, and the light from the hit
 * point; see optics.h and refracted_ray.h. */
#include "shade/env.h"
#include "shade/material.h"
#include "shade/refracted_ray.h"

const uint16_t tp_sqrt_one_minus_table[65] = {
#include "shade/root_table.inc"
};

/* -- distances along a ray ----------------------------------------------------------- */

/* Returns the point `metres` along the ray, 0..TP_UNDERWATER_FAR: each product fits 32 bits
 * after the shift. */
static inline tp_vec3 point_along_ray(tp_vec3 from, tp_ray way, tp_fx metres)
{
    return (tp_vec3){ tp_fx_add_sat(from.x, (tp_fx)((int64_t)way.x * metres >> 14)),
                      tp_fx_add_sat(from.y, (tp_fx)((int64_t)way.y * metres >> 14)),
                      tp_fx_add_sat(from.z, (tp_fx)((int64_t)way.z * metres >> 14)) };
}

/* -- the floor ----------------------------------------------------------------------- */

static inline tp_ground sample_ground(const tp_floor_plane *bed, tp_vec3 at)
{
    return (tp_ground){ tp_floor_plane_depth(bed, at), bed->rise_x, bed->rise_z, bed->nl };
}

/* Interpolates two floor planes: share / 16 of b, the rest of a.  The two depths differ by
 * less than 2^31. */
static inline tp_ground interpolate_ground(const tp_floor_plane *a,
                                           const tp_floor_plane *b, int32_t sixteenths,
                                           tp_vec3 at)
{
    int32_t one = tp_floor_plane_depth(a, at), other = tp_floor_plane_depth(b, at);

    return (tp_ground){
        one + (int32_t)((int64_t)(other - one) * sixteenths >> 4),
        a->rise_x + ((b->rise_x - a->rise_x) * sixteenths >> 4),
        a->rise_z + ((b->rise_z - a->rise_z) * sixteenths >> 4),
        a->nl + ((b->nl - a->nl) * sixteenths >> 4),
    };
}

/* Returns the distance along a ray to the floor plane.  Rays that approach the floor by
 * less than 1 m in 1024 m count as parallel: they never meet the floor. */
static inline tp_fx distance_to_floor(const tp_ground *under, tp_fx from_y, tp_ray way)
{
    tp_fx   gap = tp_fx_add_sat(from_y, under->depth);
    int32_t down = (int32_t)(((int64_t)under->rise_x * way.x
                              + (int64_t)under->rise_z * way.z) >> 16) - way.y;

    if (gap <= 0)
        return 0;
    return down < 16 ? TP_UNDERWATER_FAR : tp_underwater_closing_distance(gap, down);
}

int32_t tp_underwater_floor_light_cosine(const tp_underwater *in, tp_fx rise_x, tp_fx rise_z)
{
    tp_dir3 n = tp_normalise(-rise_x, TP_FX_ONE, -rise_z);
    int32_t nl = (n.x >> 16) * in->sun_x + (n.y >> 16) * in->sun_y
               + (n.z >> 16) * in->sun_z;
    return nl > 0 ? nl >> 14 : 0;
}

tp_floor_plane tp_underwater_sample_floor(const tp_underwater *in, tp_vec3 at)
{
    tp_floor_at floor = in->sample_floor(in->coastal, at.x, at.z);
    return (tp_floor_plane){ at.x, at.z, floor.depth, floor.rise_x, floor.rise_z, 0 };
}

/* Finds the floor's tangent plane near the hit point by two iterations; after them the
 * curvature of a beach leaves an error below a hundredth of its depth.  A ray that goes
 * up meets the floor after its reflection at the surface. */
static tp_floor_plane find_coast_floor(const tp_underwater *in, const tp_refracted_ray *ray)
{
    tp_ray down = { ray->way.x, -tp_abs(ray->way.y), ray->way.z, 0 };
    tp_floor_plane here = tp_underwater_sample_floor(in, ray->at), bed = here;
    for (int n = 0; n < 2; n++) {
        tp_ground under = sample_ground(&bed, ray->at);
        tp_fx  way = distance_to_floor(&under, ray->at.y, down);
        way = way < 200 * TP_FX_ONE ? way : 200 * TP_FX_ONE;
        bed = tp_underwater_sample_floor(in, point_along_ray(ray->at, down, way));
    }
    if (tp_floor_plane_depth(&bed, ray->at) + (int64_t)ray->at.y <= 0)
        bed = here;             /* a far bank's slope does not pass under this point */
    bed.nl = tp_underwater_floor_light_cosine(in, bed.rise_x, bed.rise_z);
    return bed;
}

const struct tp_draw_coast_floor tp_draw_coast_floor = { find_coast_floor };

tp_floor_plane tp_underwater_find_floor_plane(const tp_shade *shade,
                                              const tp_refracted_ray *ray)
{
    const tp_underwater *in = shade->underwater;

    return in->coastal ? in->coast_floor->find(in, ray) : in->floor_plane;
}

/* -- light --------------------------------------------------------------------------- */

/* Returns the factor of a colour in the light at a point, Q8. */
static inline uint32_t light_factor(const tp_shade *shade, int32_t nl, tp_vec3 at)
{
    int32_t sun = (256 - shade->ambient) * (nl < 16384 ? nl : 16384) >> 14;
    int32_t light = shade->caustic ? shade->caustic->sample(shade->caustic, at) : 256;
    return (uint32_t)(shade->ambient + (sun * light >> 8));
}

/* -- hits ---------------------------------------------------------------------------- */

typedef enum { NOTHING, FLOOR, WALL_X, WALL_Z } face;

typedef struct {
    face  what;
    tp_fx way;
} hit;

static inline hit nearer(hit a, face what, tp_fx way)
{
    return way < a.way ? (hit){ what, way } : a;
}

static inline tp_fx distance_to_wall(tp_fx from, int32_t speed, tp_fx low, tp_fx high)
{
    tp_fx gap = speed > 0 ? tp_fx_sub_sat(high, from) : tp_fx_sub_sat(from, low);

    if (speed == 0)
        return TP_UNDERWATER_FAR;
    return gap > 0 ? tp_underwater_closing_distance(gap, speed > 0 ? speed : -speed) : 0;
}

static inline bool is_between_walls(const tp_underwater *in, tp_vec3 at)
{
    return at.x >= in->x0 && at.x <= in->x1 && at.z >= in->z0 && at.z <= in->z1;
}

static inline hit nearest_wall(const tp_underwater *in, hit h, tp_vec3 from, tp_ray way)
{
    h = nearer(h, WALL_X, distance_to_wall(from.x, way.x, in->x0, in->x1));
    return nearer(h, WALL_Z, distance_to_wall(from.z, way.z, in->z0, in->z1));
}

static inline hit first_hit(const tp_underwater *in, const tp_ground *under, tp_vec3 from,
                            tp_ray way)
{
    hit h = { NOTHING, TP_UNDERWATER_FAR };

    if (!in->floored && !(in->island && is_between_walls(in, from)))
        return h;
    h = nearer(h, FLOOR, distance_to_floor(under, from.y, way));
    return in->walled || in->island ? nearest_wall(in, h, from, way) : h;
}

/* The material at a hit point, the position in its plane, the distance from the eye, and
 * the light there. */
typedef struct {
    const tp_wall_material *coat;
    tp_fx    x, z, far;
    bool     ground;
    uint32_t light;
} spot;

/* Describes the hit point.  Walls are lit from inside: their normal points against the
 * ray. */
TP_ALWAYS_INLINE spot describe_hit_point(const tp_shade *shade, int32_t floor_nl, hit h,
                                         tp_vec3 from, tp_ray way, tp_fx eye_distance)
{
    const tp_underwater *in = shade->underwater;
    tp_vec3 at = point_along_ray(from, way, h.way);
    tp_fx   from_eye = tp_fx_add_sat(eye_distance, h.way);

    if (h.what == FLOOR)
        return (spot){ &in->floor, at.x, at.z, from_eye, true,
                       light_factor(shade, floor_nl, at) };
    int32_t across = h.what == WALL_X ? way.x : way.z;
    int32_t sun = h.what == WALL_X ? in->sun_x : in->sun_z;
    int32_t nl = across > 0 ? -sun : sun;
    return (spot){ &in->wall, h.what == WALL_X ? at.z : at.x, -at.y, from_eye, false,
                   light_factor(shade, nl > 0 ? nl : 0, at) };
}

/* Returns the colour along a ray that starts at `from`, without the surface: the colour of
 * the hit point, attenuated by the water on the path. */
static inline uint32_t shade_hit(const tp_shade *shade, int32_t floor_nl, hit h,
                                 tp_vec3 from, tp_ray way, tp_fx eye_distance,
                                 uint32_t body)
{
    if (h.what == NOTHING)
        return body;
    spot s = describe_hit_point(shade, floor_nl, h, from, way, eye_distance);
    uint32_t colour = tp_wall_material_sample(s.coat, s.x, s.z, s.far, s.ground);
    return tp_absorb_apply(&shade->underwater->absorb, tp_colour_brighten(colour, s.light),
                           body, h.way);
}

/* One channel of shade_hit, shifted to its place in a colour. */
static inline uint32_t shade_hit_channel(const tp_shade *shade, int32_t floor_nl, hit h,
                                         const tp_refracted_ray *ray, uint32_t body,
                                         int shift)
{
    if (h.what == NOTHING)
        return body & (uint32_t)0xff << shift;
    spot s = describe_hit_point(shade, floor_nl, h, ray->at, ray->way, ray->far);
    uint32_t c = tp_wall_material_channel(s.coat, s.x, s.z, s.far, s.ground, shift);
    return tp_absorbed_channel(shade->underwater->absorb.halvings[2 - shift / 8], h.way,
                               tp_channel_brighten(c, s.light), body >> shift) << shift;
}

/* Entry n is 16 / n, Q8. */
static const uint16_t over[TP_UNDERWATER_ROW] = { 0, 4096, 2048, 1365, 1024, 819, 683, 585,
                                              512, 455, 410, 372, 341, 315, 293, 273 };

TP_ALWAYS_INLINE tp_ground ground_between_ends(const tp_underwater *in,
                                               const tp_floor_plane ends[2],
                                               int32_t sixteenths, tp_vec3 at)
{
    return in->coastal ? interpolate_ground(&ends[0], &ends[1], sixteenths, at)
                       : sample_ground(&ends[0], at);
}

void tp_underwater_interpolate_floor(const tp_shade *shade, const tp_floor_plane ends[2],
                                     const tp_refracted_ray ray[], int32_t count,
                                     tp_ground under[])
{
    TP_ASSERT(count > 0 && count <= TP_UNDERWATER_ROW);
    const int32_t each = over[count - 1];

    for (int32_t k = 0; k < count; k++)
        under[k] = ground_between_ends(shade->underwater, ends, k * each >> 8, ray[k].at);
}

/* Finds what a ray of a row hits, and the ground under it; sixteenths: of the row, before
 * the ray. */
TP_ALWAYS_INLINE hit row_hit(const tp_underwater *in, const tp_floor_plane ends[2],
                             int32_t sixteenths, const tp_refracted_ray *ray,
                             tp_ground *ground)
{
    *ground = ground_between_ends(in, ends, sixteenths, ray->at);
    return first_hit(in, ground, ray->at, ray->way);
}

void tp_underwater_shade_row(const tp_shade *shade, const tp_floor_plane ends[2],
                             const tp_refracted_ray ray[], int32_t count,
                             const uint32_t body[], uint32_t seen[])
{
    TP_ASSERT(count > 0 && count <= TP_UNDERWATER_ROW);
    const tp_underwater *in = shade->underwater;
    const int32_t each = over[count - 1];

    for (int32_t k = 0; k < count; k++, ray++) {
        tp_ground g;
        const hit h = row_hit(in, ends, k * each >> 8, ray, &g);
        seen[k] = shade_hit(shade, g.nl, h, ray->at, ray->way, ray->far, body[k]);
    }
}

void tp_underwater_shade_row_channel(const tp_shade *shade, const tp_ground under[],
                                     const tp_refracted_ray ray[], int32_t count,
                                     const uint32_t body[], int shift, uint32_t seen[])
{
    for (int32_t k = 0; k < count; k++, ray++, under++) {
        hit h = first_hit(shade->underwater, under, ray->at, ray->way);
        seen[k] |= shade_hit_channel(shade, under->nl, h, ray, body[k], shift);
    }
}

/* Returns the texel at (s, t), with red at a place shifted by (ds, dt), and blue at one
 * shifted the other way.  Shifts below a 16th of a texel are left out. */
static uint32_t sample_shifted(const tp_mip_level *level, uint32_t s, uint32_t t, uint32_t ds,
                               uint32_t dt)
{
    const uint32_t texel = tp_mip_level_sample_linear(level, s, t);
    const uint32_t least_s = level->half_s / 8, least_t = level->half_t / 8;

    if (ds + least_s < 2 * least_s && dt + least_t < 2 * least_t)
        return texel;
    return (texel & 0xff00) | tp_mip_level_channel_linear(level, s + ds, t + dt, 16) << 16
         | tp_mip_level_channel_linear(level, s - ds, t - dt, 0);
}

/* The same as shade_hit for a hit of the floor, with shifted red and blue. */
static inline uint32_t shade_floor_shifted(const tp_shade *shade, int32_t floor_nl, hit h,
                                           const tp_refracted_ray *ray,
                                           const tp_place_shift *shift, uint32_t body)
{
    const tp_wall_material *coat = &shade->underwater->floor;
    const spot s = describe_hit_point(shade, floor_nl, h, ray->at, ray->way, ray->far);
    const tp_mip_level level = tp_wall_material_level(coat, s.far, true);
    const uint32_t dx = (uint32_t)((int64_t)shift->x * h.way >> 14) * coat->per_metre;
    const uint32_t dz = (uint32_t)((int64_t)shift->z * h.way >> 14) * coat->per_metre;
    const uint32_t texel = sample_shifted(&level, (uint32_t)s.x * coat->per_metre,
                                          (uint32_t)s.z * coat->per_metre, dx, dz);

    return tp_absorb_apply(&shade->underwater->absorb,
                           tp_colour_brighten(tp_colour_times(texel, coat->colour), s.light),
                           body, h.way);
}

void tp_underwater_shade_row_shifted(const tp_shade *shade, const tp_floor_plane ends[2],
                                     const tp_refracted_ray ray[],
                                     const tp_place_shift shift[], int32_t count,
                                     const uint32_t body[], uint32_t seen[])
{
    TP_ASSERT(count > 0 && count <= TP_UNDERWATER_ROW);
    const int32_t each = over[count - 1];

    for (int32_t k = 0; k < count; k++, ray++) {
        tp_ground g;
        const hit h = row_hit(shade->underwater, ends, k * each >> 8, ray, &g);
        seen[k] = h.what == FLOOR && shade->underwater->floor.texture
            ? shade_floor_shifted(shade, g.nl, h, ray, &shift[k], body[k])
            : shade_hit(shade, g.nl, h, ray->at, ray->way, ray->far, body[k]);
    }
}

/* -- the surface from below ---------------------------------------------------------- */

#define INDEX  21840            /* refractive index of water, 1.333, Q1.14 */
#define INDEX2 29113            /* INDEX squared, Q1.14 */

/* Cosine in air of a ray that goes up with cosine ci in water, Q1.14.  Returns 0 or less
 * beyond 48.6 degrees, where reflection is total. */
static inline int32_t cos_in_air(int32_t ci)
{
    int64_t left = ((int64_t)1 << 28)
                 - ((((int64_t)1 << 28) - (int64_t)ci * ci) * INDEX2 >> 14);
    if (left <= 0)
        return 0;
    int      even = tp_clz((uint32_t)left) & ~1;        /* n in [2^30, 2^32) */
    uint32_t n = (uint32_t)left << even;
    return (int32_t)((uint64_t)n * tp_rsqrt_norm(n) >> (47 + even / 2));
}

/* Fresnel share, interpolated between the table's entries: near the rim of Snell's window
 * neighbouring entries differ by 6 levels. */
static inline uint32_t fresnel_share(const tp_shade *shade, int32_t cosine)
{
    const tp_entry8 *at = shade->fresnel + (cosine >> 6);
    if (cosine >= 16384)
        return at[0];
    int32_t a = (int32_t)at[0], b = (int32_t)at[1];
    return (uint32_t)(a + ((b - a) * (cosine & 63) >> 6));
}

uint32_t tp_underwater_shade_underside(const tp_shade *shade, const tp_floor_plane *plane,
                                       const tp_refracted_ray *ray, tp_ray normal,
                                       uint32_t deep_colour)
{
    tp_ray  way = ray->way;
    int32_t ci = (way.x * normal.x + way.y * normal.y + way.z * normal.z) >> 14;

    ci = tp_clamp(ci, 0, 16384);
    int32_t  ct = cos_in_air(ci), lean = ct - (INDEX * ci >> 14);
    uint32_t share = ct > 0 ? fresnel_share(shade, ct) : 256, sky = 0;
    if (share < 256)
        sky = tp_env_sample(shade, (INDEX * way.x + lean * normal.x) >> 14,
                        (INDEX * way.y + lean * normal.y) >> 14,
                        (INDEX * way.z + lean * normal.z) >> 14) & 0xffffff;
    if (share < 4)
        return sky;
    tp_ray back = { way.x - (2 * ci * normal.x >> 14), way.y - (2 * ci * normal.y >> 14),
                    way.z - (2 * ci * normal.z >> 14), 0 };
    if (back.y > -64)           /* reflected upwards by a steep slope: taken as nearly
                                 * level */
        back.y = -64;
    tp_ground under = sample_ground(plane, ray->at);
    hit h = first_hit(shade->underwater, &under, ray->at, back);
    uint32_t mirrored =
        shade_hit(shade, plane->nl, h, ray->at, back, ray->far, deep_colour);
    return tp_colour_mix(sky, mirrored, share);
}

const struct tp_draw_upward_rays tp_draw_upward_rays = { tp_underwater_shade_underside };

uint32_t tp_underwater_trace(const tp_shade *shade, const tp_floor_plane *bed,
                             const tp_refracted_ray *ray, uint32_t body)
{
    tp_ground under = sample_ground(bed, ray->at);
    hit    h = first_hit(shade->underwater, &under, ray->at, ray->way);
    tp_fx  deep = ray->at.y < 0 ? -(ray->at.y + (ray->at.y == TP_FX_MIN)) : 0;

    if (ray->way.y <= 0 || tp_underwater_closing_distance(deep, ray->way.y) >= h.way)
        return shade_hit(shade, bed->nl, h, ray->at, ray->way, ray->far, body);
    tp_fx   way = tp_underwater_closing_distance(deep, ray->way.y);
    tp_refracted_ray on = { point_along_ray(ray->at, ray->way, way), ray->way,
                            tp_fx_saturate((int64_t)ray->far + way) };
    const struct tp_draw_upward_rays *up = shade->underwater->upward_rays;
    const uint32_t colour =
        up ? up->shade_underside(shade, bed, &on, (tp_ray){ 0, 16384, 0, 0 }, body) : body;
    return tp_absorb_apply(&shade->underwater->absorb, colour, body, way);
}
