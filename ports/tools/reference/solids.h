/* SPDX-License-Identifier: MIT */
/* Solids: the boat's mesh, drops, land and floor of coastal water, walls and floor of a
 * tank; intersections with rays, and colours by Phong [F5].
 *
 * Materials count as opaque, except lids, which are never seen themselves. Glass walls that
 * the eye does not look through are blocks with outer faces, like stone walls. A mapped
 * floor is bilinear between the world's nodes. Under water the sun is steeper and the beam
 * narrower: the share cos i / cos t of N.L counts, so a level floor is as bright as a dry
 * floor, and the same share of the lobe about the refracted light.
 *
 * On a beach a sheet of water, the swash, runs up and down by the phase of the wave with
 * the highest run-up (Hunt: slope sqrt(H L), at most 2 H; slope 0.1 on a map). Sand below the
 * run-up is dark, below the swash glossy, and the front of the swash is white. Left out:
 * swash seen by an eye under water, and on land without a texture beside opaque water; the
 * engine draws neither. */
#ifndef TP_TOOLS_REFERENCE_SOLIDS_H
#define TP_TOOLS_REFERENCE_SOLIDS_H
#include "scene.h"

/* Kinds of surface. REF_BED: floor of a tank; REF_SIDE: water behind a tank's
 * glass. */
typedef enum { REF_SKY, REF_WATER, REF_BOAT, REF_DROP, REF_LAND, REF_WALL, REF_BED,
               REF_SIDE } ref_kind;

typedef struct {
    ref_kind kind;
    double   t;
    ref_vec  at, normal;        /* world, m; unit vector */
    double   far;               /* depth, m; in the water: depth of the surface where the
                                 * ray came in plus the distance from there */
    ref_face_hit face;          /* face of the boat */
} ref_solid;

/* Bits of solids: boat and drops; floor of coastal water; blocks of stone; inside of a
 * tank. */
enum { REF_THINGS = 1, REF_FLOOR = 2, REF_BLOCKS = 4, REF_TANK = 8 };

/* Finds the nearest solid between t0 and t1 among the kinds of the bits in `which`. */
bool ref_solid_meets(const ref_scene *s, const ref_ray *ray, int which, double t0,
                     double t1, ref_solid *solid);

/* Distance at which a lid covers the boat seen at `t1`: no water is seen beyond. Returns t1
 * if no lid covers the boat. */
double ref_find_lid(const ref_scene *s, const ref_ray *ray, double t0, double t1);

/* Finds the swash of a world into s->runup and s->swash. */
void ref_swash_open(ref_scene *s, const tp_world *world);

/* Height of the swash at a point, m. */
double ref_swash_height(const ref_scene *s, double x, double z);

/* Colour of a solid seen along `way`, in air or under water. */
ref_colour ref_solid_colour(const ref_scene *s, const ref_solid *solid, ref_vec way,
                            bool wet);
#endif
