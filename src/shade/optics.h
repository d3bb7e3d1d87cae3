/* SPDX-License-Identifier: MIT */
/* Light at the water's surface: the reflected share and the directions of reflected and
 * refracted rays, [F1]-[F4] of the models.
 *
 * Light goes from air into water, never back: total reflection does not occur.  Unit
 * vectors and shares are Q2.30, as in tp_dir3. */
#ifndef TP_SHADE_OPTICS_H
#define TP_SHADE_OPTICS_H
#include "fx/fx.h"

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
#endif
