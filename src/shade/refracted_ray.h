/* SPDX-License-Identifier: MIT */
/* View rays in the water: their start points and the surfaces that they hit (see
 * optics.h). */
#ifndef TP_SHADE_REFRACTED_RAY_H
#define TP_SHADE_REFRACTED_RAY_H
#include "fixed/arithmetic.h"
#include "shade/shade.h"

#define TP_UNDERWATER_FAR (16000 * TP_FX_ONE)

/* -- start points and directions ----------------------------------------------------- */

/* Sets the members of `in` that depend on the current view of `shade`. */
void tp_underwater_set_view(tp_underwater *in, const tp_shade *shade, tp_fx zi_near);

#define TP_UNDERWATER_ROW 16        /* largest number of rays in one batch */

/* Start point of a ray in world coordinates, m, and its direction, a unit vector in
 * Q1.14. */
typedef struct {
    tp_vec3 at;
    tp_ray  way;
    tp_fx   far;                /* distance from the eye to the start point, m,
                                 * approximate */
} tp_refracted_ray;

/* Entry i is sqrt(1 - i / 64), Q1.14. */
extern const uint16_t tp_sqrt_one_minus_table[65];

/* Returns sqrt(1 - x), Q1.14, for x in 0..1, Q28.  Error: within 2 units for x <= 0.8. */
TP_ALWAYS_INLINE int32_t tp_sqrt_one_minus(uint32_t x)
{
    const uint16_t *at = tp_sqrt_one_minus_table + (x >> 22 & 63);
    return at[0] - ((at[0] - at[1]) * (int32_t)(x >> 8 & 0x3fff) >> 14);
}

/* Returns -in . n, clamped to -1..1. */
TP_ALWAYS_INLINE int32_t tp_incidence_cosine(tp_ray in, tp_ray n)
{
    return tp_clamp(-((in.x * n.x + in.y * n.y + in.z * n.z) >> 14), -16384, 16384);
}

/* Refracts a ray from air into water [F4].  `in` points towards the surface, `n` is the
 * surface normal out of the water, `ci` the cosine between them, all Q1.14. */
TP_ALWAYS_INLINE tp_ray tp_underwater_refract_at_cosine(const tp_underwater *underwater,
                                                        int channel, tp_ray in, tp_ray n,
                                                        int32_t ci)
{
    int32_t  eta = underwater->eta[channel];
    uint32_t s2 = (1u << 28) - (uint32_t)(ci * ci);
    int32_t ct = tp_sqrt_one_minus(
        (uint32_t)((uint64_t)s2 * (uint32_t)underwater->eta2[channel] >> 14));
    int32_t lean = (eta * ci >> 14) - ct;
    return (tp_ray){ (eta * in.x + lean * n.x) >> 14, (eta * in.y + lean * n.y) >> 14,
                     (eta * in.z + lean * n.z) >> 14, 0 };
}

TP_ALWAYS_INLINE tp_ray tp_underwater_refract(const tp_underwater *underwater,
                                              int channel, tp_ray in, tp_ray n)
{
    return tp_underwater_refract_at_cosine(underwater, channel, in, n,
                                           tp_incidence_cosine(in, n));
}

/* Sets the start points of the rays of samples [i, stop) of a run: ray[].at to the sample's
 * world position, ray[].far to the sample's depth, m.  Directions are left unchanged. */
void tp_underwater_set_start_points(const tp_shade *shade, const tp_run *run, int32_t i,
                                    int32_t stop, tp_refracted_ray *ray);

/* -- distances to the floor ---------------------------------------------------------- */

/* Returns the distance along a ray, m, until a `gap` >= 0 m is closed; the gap shrinks by
 * `speed` > 0 per metre, Q1.14. */
static inline tp_fx tp_underwater_closing_distance(tp_fx gap, int32_t speed)
{
    int     shift = tp_clz((uint32_t)speed);
    int64_t way = (int64_t)gap * tp_recip_rough((uint32_t)speed << shift) >> (48 - shift);
    return way < TP_UNDERWATER_FAR ? (tp_fx)way : TP_UNDERWATER_FAR;
}

/* Returns the rise of the plane from the world's origin to a point, Q32; sums may wrap. */
static inline uint64_t tp_floor_plane_rise(const tp_floor_plane *plane, tp_fx x, tp_fx z)
{
    return (uint64_t)((int64_t)plane->rise_x * x) + (uint64_t)((int64_t)plane->rise_z * z);
}

/* Returns the depth of the plane below a point, m, clamped to 16 km. */
static inline tp_fx tp_floor_plane_depth(const tp_floor_plane *plane, tp_vec3 at)
{
    if (plane->rise_x == 0 && plane->rise_z == 0)
        return (tp_fx)tp_clamp_abs(plane->depth, TP_UNDERWATER_FAR);
    int64_t rise = (int64_t)(tp_floor_plane_rise(plane, at.x, at.z)
                             - tp_floor_plane_rise(plane, plane->x, plane->z));
    return (tp_fx)tp_clamp_abs(plane->depth - (rise >> 16), TP_UNDERWATER_FAR);
}

/* Returns N.L of the sun on a floor of these slopes, Q1.14, at least 0. */
int32_t tp_underwater_floor_light_cosine(const tp_underwater *in, tp_fx rise_x,
                                         tp_fx rise_z);

/* Returns the tangent plane of coastal water's floor at a point, without N.L. */
tp_floor_plane tp_underwater_sample_floor(const tp_underwater *in, tp_vec3 at);

/* -- parts of a program -------------------------------------------------------------- */

/* Returns the floor plane of coastal water near the point where a ray would hit it. */
struct tp_draw_coast_floor {
    tp_floor_plane (*find)(const tp_underwater *in, const tp_refracted_ray *ray);
};

/* tp_underwater_shade_underside, for rays that meet the surface from below. */
struct tp_draw_upward_rays {
    uint32_t (*shade_underside)(const tp_shade *shade, const tp_floor_plane *plane,
                                const tp_refracted_ray *ray, tp_ray normal,
                                uint32_t deep_colour);
};

/* -- colour along a ray -------------------------------------------------------------- */

/* Returns the floor, as a plane, near the point where the ray would hit the floor. */
tp_floor_plane tp_underwater_find_floor_plane(const tp_shade *shade,
                                              const tp_refracted_ray *ray);

/* Returns the colour seen along a ray; `body` is the colour of the water itself. */
uint32_t tp_underwater_trace(const tp_shade *shade, const tp_floor_plane *plane,
                             const tp_refracted_ray *ray, uint32_t body);

/* The floor plane below one point: its depth there in m, its slopes along x and z, and
 * N.L. */
typedef struct {
    tp_fx   depth, rise_x, rise_z;
    int32_t nl;
} tp_ground;

/* Returns the floor below up to 16 neighbouring rays, interpolated between the planes of
 * the first ray and the last ray. */
void tp_underwater_interpolate_floor(const tp_shade *shade, const tp_floor_plane ends[2],
                                     const tp_refracted_ray ray[], int32_t count,
                                     tp_ground under[]);

/* Colours seen along up to 16 neighbouring rays that go down.  seen[k] is the colour of the
 * point that ray[k] hits, absorbed towards body[k], the colour of the water itself, or
 * body[k] if nothing is hit.  The second function computes only the channel at bit `shift`
 * and adds the channel to the others in `seen`. */
void tp_underwater_shade_row(const tp_shade *shade, const tp_floor_plane ends[2],
                             const tp_refracted_ray ray[], int32_t count,
                             const uint32_t body[], uint32_t seen[]);
void tp_underwater_shade_row_channel(const tp_shade *shade, const tp_ground under[],
                                     const tp_refracted_ray ray[], int32_t count,
                                     const uint32_t body[], int shift, uint32_t seen[]);

/* A shift of the place where red meets the floor, m per m of path in the water, Q14; that
 * of blue is its opposite. */
typedef struct {
    int16_t x, z;
} tp_place_shift;

/* The same for colours of a floor that red and blue see at shifted places; walls, light and
 * absorption are those of green. */
void tp_underwater_shade_row_shifted(const tp_shade *shade, const tp_floor_plane ends[2],
                                     const tp_refracted_ray ray[],
                                     const tp_place_shift shift[], int32_t count,
                                     const uint32_t body[], uint32_t seen[]);

/* Colour of a ray that goes up and has reached the surface: the sky through Snell's window
 * mixed with the water mirrored by the Fresnel share.  Beyond 48.6 degrees all light is
 * mirrored [F1].  `normal`: of the surface, out of the water, Q1.14.  `deep_colour`: the
 * colour of the water itself. */
uint32_t tp_underwater_shade_underside(const tp_shade *shade, const tp_floor_plane *plane,
                                       const tp_refracted_ray *ray, tp_ray normal,
                                       uint32_t deep_colour);

#endif
