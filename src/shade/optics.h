/* SPDX-License-Identifier: MIT */
/*
 * Light at the water's surface and in the water: the reflected share and the directions of
 * reflected and refracted rays, [F1]-[F4] of the models, absorption by Beer's law, and the
 * data of the water volume.
 *
 * Light goes from air into water, never back: total reflection does not occur.  Unit
 * vectors and shares are Q2.30, as in tp_dir3.
 */
#ifndef TP_SHADE_OPTICS_H
#define TP_SHADE_OPTICS_H
#include <stdbool.h>
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "tidepool/fixed.h"
#include "waves/coastal_water.h"

/* Refractive index of water and its inverse, for TP_FX() and TP_Q30(). */
#define TP_WATER_INDEX 1.333
#define TP_WATER_ETA   0.750187547

/* Returns the reflected share of unpolarised light (mean of both polarisations) that meets
 * the surface with this cosine to the normal; in 0..1.  [F1] within 2^-28. */
tp_q30 tp_fresnel(tp_q30 cos_i);

/* Schlick's approximation of tp_fresnel [F2]: up to 0.059 more, no cheaper than a table. */
tp_q30 tp_fresnel_schlick(tp_q30 cos_i);

/* `incident` points towards the surface, `normal` out of the water; both are unit vectors.
 * The result is a unit vector within 2^-26.  The formulas also hold for grazing light and
 * for light from below the plane. */
tp_dir3 tp_reflect(tp_dir3 incident, tp_dir3 normal);   /* [F3]; may point downwards */
tp_dir3 tp_refract(tp_dir3 incident, tp_dir3 normal);   /* [F4]; never points out of
                                                         * the water */

/* Offset between the origin and the point where a ray of direction `refracted` meets a
 * floor `depth` m lower [F4]: (x, z) in metres, 16.16, saturated.  A ray that does not go
 * down never meets the floor: the result is the ends of the range, by the direction's
 * signs. */
typedef struct { tp_fx x, z; } tp_floor_offset;
tp_floor_offset tp_refract_offset(tp_dir3 refracted, tp_fx depth);

/* -- absorption ---------------------------------------------------------------------- */

/*
 * Beer's law: attenuation of a colour on its path through water.  Each channel keeps the
 * share tint^(distance / clear); the colour of deep water replaces the lost light.
 *
 * The share is 2^-x with x halvings on the path.  Shifts and one table, 64 entries for one
 * halving, serve every tint and any distance.
 */

typedef struct {
    uint32_t halvings[3];       /* halvings per metre of red, green and blue; Q16.16 */
} tp_absorb;

/* `tint` is the colour of white after `clear` metres.  A channel c of the tint counts as
 * (c + 1/2) / 256, which excludes the rates 0 and infinity. */
void tp_absorb_init(tp_absorb *absorb, uint32_t tint, tp_fx clear);

/* Entry i is 2^-(i / 64), Q0.16. */
extern const uint16_t tp_absorb_fall[65];

/* Returns the share of a channel's light that is left after a path, Q0.16. */
TP_ALWAYS_INLINE int32_t tp_absorb_share_left(uint32_t halvings, tp_fx metres)
{
    uint64_t x = (uint64_t)halvings * (uint32_t)metres >> 16;

    if (x >= 16u << 16)
        return 0;
    const uint16_t *at = tp_absorb_fall + ((uint32_t)x >> 10 & 63);
    return (at[0] - ((at[0] - at[1]) * (int32_t)(x & 1023) >> 10)) >> (x >> 16);
}

TP_ALWAYS_INLINE uint32_t tp_absorbed_channel(uint32_t halvings, tp_fx metres,
                                              uint32_t colour, uint32_t deep)
{
    const int32_t left = tp_absorb_share_left(halvings, metres);
    int32_t c = (int32_t)(colour & 0xff), d = (int32_t)(deep & 0xff);

    return (uint32_t)(d + (((c - d) * left + 0x8000) >> 16));
}

/* Attenuates `colour` over `metres` of water of colour `deep`; both colours are
 * 0x00RRGGBB.  Negative distances count as 0. */
TP_ALWAYS_INLINE uint32_t tp_absorb_apply(const tp_absorb *absorb, uint32_t colour,
                                          uint32_t deep, tp_fx metres)
{
    const uint32_t *halvings = absorb->halvings;
    tp_fx way = metres > 0 ? metres : 0;

    return tp_absorbed_channel(halvings[0], way, colour >> 16, deep >> 16) << 16
         | tp_absorbed_channel(halvings[1], way, colour >> 8, deep >> 8) << 8
         | tp_absorbed_channel(halvings[2], way, colour, deep);
}

/* -- the water volume ---------------------------------------------------------------- */

/* The surfaces that a ray meets on its way through the water.
 *
 * The water is a box.  Its floor is level, or the floor of coastal water, or absent.  Its
 * four walls are a tank's walls or absent.  Its surface, seen from below, is taken as
 * level at each point.  Floor and walls have a texture, are lit by the sun as still water
 * refracts its rays, and their light is absorbed on the way to the eye [Beer].
 *
 * Under level water sunlight is steeper and its beam narrower.  The share cos i / cos t of
 * the refracted N.L counts: a level floor is as bright as it would be when dry, and shores
 * show no seam.
 *
 * shade/refracted_ray.h declares the functions on this data. */

/* Material of static geometry: a texture laid out in world metres, or a plain colour. */
typedef struct {
    const tp_texture *texture;  /* NULL: plain colour */
    uint32_t colour;            /* multiplies the texture */
    uint32_t per_metre;         /* texture repeats per metre, Q0.32 per Q16.16 metre */
    int32_t  lod;               /* mipmap level at 1 m, Q8 */
} tp_wall_material;

/* Caustics map: the light that falls through the surface on to the floor. */
typedef struct tp_caustic {
    int32_t (*sample)(const struct tp_caustic *c, tp_vec3 at);  /* 256 is even light */
    const uint16_t *light;      /* cells x cells entries, 256 is even light */
    tp_fx    x, z;              /* north-west corner, m */
    uint32_t cells;
    uint32_t per_metre_x, per_metre_z;  /* cells per metre, 16.16 */
    uint32_t per_depth;         /* 256 / (the depth that the map was made for, m), 16.16 */
    int32_t  lean_x, lean_z;    /* slope of rays back to the sun, m per m, Q1.14 */
    int32_t  strength;          /* contrast, 256 is full */
    bool     fades;             /* true: fades to even light at the map's edges */
} tp_caustic;

/* The floor around a point as a plane: a point (x, z) on it, and the depth there in m. */
typedef struct {
    tp_fx   x, z, depth;
    tp_fx   rise_x, rise_z;     /* slope, m per m */
    int32_t nl;                 /* N.L of the sun, Q1.14 */
} tp_floor_plane;

typedef struct {
    bool    floored, walled;    /* `walled` implies `floored` */
    bool    island;             /* floor and walls count only for rays from between the
                                 * walls; the other two are false then */
    tp_fx   x0, x1, z0, z1;     /* walls, m */
    const tp_coastal_water *coastal; /* coastal water whose floor counts; NULL:
                                      * `floor_plane` counts */
    const struct tp_draw_coast_floor *coast_floor;      /* not NULL for coastal water */
    tp_floor_at (*sample_floor)(const tp_coastal_water *coastal, tp_fx x, tp_fx z);
    const struct tp_draw_upward_rays *upward_rays;  /* NULL: the program lacks them */
    tp_floor_plane floor_plane;
    tp_wall_material wall, floor;
    uint32_t deep;              /* colour of bottomless water, 0x00RRGGBB */
    tp_absorb absorb;           /* loss of light from surfaces and objects, per m of
                                 * its path in the water */
    int32_t sun_x, sun_y, sun_z;/* direction to the sun in water, scaled by cos i / cos t;
                                 * Q1.14 */
    int32_t eta[3], eta2[3];    /* 1 / index of red, green, blue; squared; Q1.14 */
    tp_fx   zi_near;            /* of the projection, m: depth = zi_near / zi */
    int64_t right[3], up[3];    /* view axes, steps of 1/16 px at 1 m depth, Q42 */
} tp_underwater;

#endif
