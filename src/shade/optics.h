/* SPDX-License-Identifier: MIT */
/* Light at the water's surface: how much is reflected, and where rays go, [F1]-[F4] of the
 * models.
 *
 * From air into water, never back: there is no total reflection.  Units
 * are those of tp_dir3: unit vectors and shares in Q2.30. */
#ifndef TP_SHADE_OPTICS_H
#define TP_SHADE_OPTICS_H
#include "fx/fx.h"

/* Water's refractive index and its inverse, for TP_FX() and TP_Q30(). */
#define TP_WATER_INDEX 1.333
#define TP_WATER_ETA   0.750187547

/* The share that is reflected, mean of both polarisations, of light that meets the
 * surface at an angle of this cosine to its normal; held to 0..1.  [F1] within 2^-28. */
tp_q30 tp_fresnel(tp_q30 cos_i);

/* Schlick's rule for the same [F2]: up to 0.059 more, and no cheaper than a table. */
tp_q30 tp_fresnel_schlick(tp_q30 cos_i);

/* `incident` goes towards the surface, `normal` out of the water; both are unit vectors,
 * and so is the result, within 2^-26.  Grazing light is no special case, nor is light
 * from below the plane: each formula goes on there. */
tp_dir3 tp_reflect(tp_dir3 incident, tp_dir3 normal);   /* [F3]; may point downwards */
tp_dir3 tp_refract(tp_dir3 incident, tp_dir3 normal);   /* [F4]; never out of the water */

/* Where a ray that goes down as `refracted` from the origin meets a floor that lies
 * `depth` m lower [F4]: (x, z) in metres, 16.16, saturated.  A ray that does not go down
 * never meets it: the ends of the range, by its direction's signs. */
typedef struct { tp_fx x, z; } tp_floor_offset;
tp_floor_offset tp_refract_offset(tp_dir3 refracted, tp_fx depth);
#endif
