/* SPDX-License-Identifier: MIT */
/* What is not water: the boat's mesh, drops, the land and floor of an ocean, a tank's
 * walls and floor; where a ray meets them, and their colour by Phong [F5].
 *
 * Opacity of materials is taken as whole, but for lids, which are not seen themselves.
 * Walls of glass that the eye does not look through are blocks like those of stone, with
 * outer faces.  The floor over a map is bilinear between the world's nodes.  Under water
 * the sun is steeper and its beam narrower: of N.L there a share of cos i / cos t counts,
 * so that a level floor is as bright as it would be dry, and the same share of the lobe
 * about the bent light. */
#ifndef TP_REFERENCE_SOLIDS_H
#define TP_REFERENCE_SOLIDS_H
#include "scene.h"

/* Bed: a tank's floor; side: the water behind its glass. */
typedef enum { REF_SKY, REF_WATER, REF_BOAT, REF_DROP, REF_LAND, REF_WALL, REF_BED,
               REF_SIDE } ref_kind;

typedef struct {
    ref_kind kind;
    double   t;
    ref_vec  at, normal;        /* world; unit */
    double   far;               /* m of depth; in the water that of the surface where the
                                   ray came in, and the way from there */
    ref_face_hit face;          /* of the boat */
} ref_solid;

/* Boat and drops; an ocean's floor; blocks of stone; a tank's inside. */
enum { REF_THINGS = 1, REF_FLOOR = 2, REF_BLOCKS = 4, REF_TANK = 8 };

/* The nearest between t0 and t1 of those kinds. */
bool ref_solid_meets(const ref_scene *s, const ref_ray *ray, int which, double t0,
                     double t1, ref_solid *solid);

/* Where the boat, which is seen at `t1`, is covered by a lid: no water is seen from there
 * on; t1: it is not. */
double ref_lid_at(const ref_scene *s, const ref_ray *ray, double t0, double t1);

/* Seen along `way`, in air or under water. */
ref_colour ref_solid_colour(const ref_scene *s, const ref_solid *solid, ref_vec way,
                            bool wet);
#endif
