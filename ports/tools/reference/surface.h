/* SPDX-License-Identifier: MIT */
/* Complete water surface in double precision: waves of deep water [A7]-[A11] or of coastal
 * water displace a rest point; rings and pools are heights over the displaced place. The
 * sums of steepness are at most 0.95, so the surface is a height field: above each place
 * there is exactly one point, found by Newton's method.
 *
 * The water is a square of 16 km around the eye, or the rectangle of a tank. */
#ifndef TP_TOOLS_REFERENCE_SURFACE_H
#define TP_TOOLS_REFERENCE_SURFACE_H
#include "coastal_water.h"
#include "deep_water.h"
#include "relief.h"
#include "vector.h"

typedef struct {
    double x, z;                /* centre, m */
    double half_x, half_z;      /* half sides, m */
} ref_extent;

#define REF_CLOSE 1e-10         /* m; tests/charts/reference.c shows the reason */

typedef struct {
    ref_deep_water sea;
    ref_coastal *coastal;       /* coastal water, or NULL */
    double     phase[TP_WAVES];
    ref_relief relief;
    ref_extent extent;
    double     high, reach;     /* largest displacement, up and sideways, m */
    double     steep, fine;     /* bound of slopes; shortest feature, m */
    double     close;           /* accuracy of a ray's root, m; initially REF_CLOSE */
    struct ref_memory *memory;  /* ray.h; initially NULL */
} ref_surface;

/* A point of the surface. */
typedef struct {
    ref_vec at;
    double  x0, z0;             /* its rest point */
    double  slope_x, slope_z;
    double  bump_x[2], bump_z[2];   /* slopes of pools that only bend the normals */
    bool    wet;                /* false: land, or outside the rectangle */
} ref_water;

ref_surface ref_surface_make(const tp_scene *scene, const tp_world *world, ref_vec eye);
void        ref_surface_free(ref_surface *surface);

/* Height of the surface at (x, z), accurate to `off` m along. `rest`: start of the search,
 * then the rest point found. */
double ref_surface_height(const ref_surface *s, double x, double z, double rest[2],
                          double off);

/* Surface point above or below (x, z), to 1e-12 m along; `rest` as in
 * ref_surface_height. */
ref_water ref_surface_sample(const ref_surface *s, double x, double z, double rest[2]);

#endif
