/* SPDX-License-Identifier: MIT */
/* The whole water's surface in double precision: swells of the open sea [A7]-[A11] or an
 * ocean over its floor displace a point of still water; rings and pools are heights over
 * the displaced place.  Steepness sums are held to 0.95, so it is a height field: above
 * each place there is one point, found by Newton's method.
 *
 * The water is a rectangle, that of the scene's grid.  With `fading` waves end where the
 * engine's mesh lets them end, without what the fading itself adds to slopes; without it
 * they go on to the rectangle's edge. */
#ifndef TP_REFERENCE_SURFACE_H
#define TP_REFERENCE_SURFACE_H
#include "ocean.h"
#include "relief.h"
#include "sea.h"
#include "vector.h"

typedef struct {
    double x, z;                /* centre, m */
    double half_x, half_z;      /* of the even cells */
    double out_x, out_z;        /* where the water ends */
    double fade;                /* m inside of the even cells' edge; 0: no fading */
} ref_extent;

#define REF_CLOSE 1e-10         /* m; tests/charts/reference.c shows what for */

typedef struct {
    ref_sea    sea;
    ref_ocean *ocean;           /* or NULL */
    double     phase[TP_WAVES];
    ref_relief relief;
    ref_extent extent;
    double     high, reach;     /* no point is farther from its rest, up and sideways */
    double     steep, fine;     /* bounds of slopes; m, the shortest thing */
    double     close;           /* m: a ray's root is so close; REF_CLOSE to begin with */
} ref_surface;

/* A point of it. */
typedef struct {
    ref_vec at;
    double  x0, z0;             /* its place at rest */
    double  slope_x, slope_z;
    double  bump_x[2], bump_z[2];   /* slopes of pools that only bend the light */
    bool    wet;                /* false: land, or beyond the rectangle */
} ref_water;

ref_surface ref_surface_of(const tp_scene *scene, const tp_world *world, ref_vec eye,
                           ref_vec ahead, bool fading);
void        ref_surface_free(ref_surface *surface);

/* The height above or below (x, z), within `off` metres along; `rest` is where the search
 * begins and then the place at rest that it found. */
double ref_surface_height(const ref_surface *s, double x, double z, double rest[2],
                          double off);

/* All of the point above or below (x, z), to 1e-12 m along; `rest` as above. */
ref_water ref_surface_above(const ref_surface *s, double x, double z, double rest[2]);

/* Whether waves may reach (x, z) at all: elsewhere the surface is level. */
bool ref_surface_moves(const ref_surface *s, double x, double z);
#endif
