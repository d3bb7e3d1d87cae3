/* SPDX-License-Identifier: MIT */
/* Caustics: sunlight that the curved surface of the water focuses on the floor and on the
 * walls under water.
 *
 * A fine grid over the surface sends one refracted sun ray [F4] down from each vertex. The
 * light at a point under water is the sum, over all triangles of rays that contain the
 * point at its own depth, of the triangle's area across the sun's rays over its area at
 * that depth; both areas are level. Still water gives exactly 1, everywhere. No light is
 * filtered: a fold of the rays has a sharp edge.
 *
 * A map place of a point is the point of the still surface whose ray meets it. The map
 * places of the scene's rectangle have caustics: the pool's sides, or a square of
 * water.caustic_size ahead of the eye, where caustics fade to even light within the outer
 * eighth of the side. At a tank's walls light is mirrored: map places repeat mirrored
 * beyond the rectangle's edges. Elsewhere the grid extends beyond the rectangle.
 *
 * Left out: ripples of the normal map, which also the engine's caustics leave out; the
 * share of the light that the surface reflects; shadows of crests in front of the sun,
 * which matter if slopes exceed the tangent of the sun's elevation. */
#ifndef TP_TOOLS_REFERENCE_CAUSTICS_H
#define TP_TOOLS_REFERENCE_CAUSTICS_H
#include "scene.h"

/* Ray of one vertex: the map place at depth d is from + d * away. `sun`: the vertex moved
 * along the sun's ray to the still level. m, and m per m of depth. */
typedef struct {
    double from[2], away[2], sun[2];
} ref_light_ray;

/* Bounds of `from` and `away` in a square block of the grid. */
typedef struct {
    double low[2], high[2], low_away[2], high_away[2];
} ref_light_bounds;

enum { REF_LIGHT_LEVELS = 16 };

struct ref_caustics {
    double low[2], high[2];     /* the rectangle: x and z, m */
    double still[2];            /* horizontal way of light per depth under still water */
    double strength;            /* contrast; 1: all of it */
    double fade;                /* m inside of the edge; 0: a tank, mirrored at its walls */
    double cell;                /* side of a cell of the grid, m */
    int    cells[2];            /* cells along x and z */
    ref_light_ray *ray;         /* (cells[0] + 1) x (cells[1] + 1), rows along x */
    int    levels;              /* bounds of blocks; the last level has one block */
    ref_light_bounds *bounds[REF_LIGHT_LEVELS];
};

/* Traces the light of a scene whose surface, light, camera and tank are set. Returns NULL
 * if the scene has no caustics. */
ref_caustics *ref_caustics_make(const ref_scene *s);
void          ref_caustics_free(ref_caustics *caustics);

/* Light at a point under water, as a share of the light under still water; 1 at and above
 * the still level. Strength and fade do not count. */
double ref_caustics_light(const ref_caustics *caustics, ref_vec at);

/* Factor of the sunlight at a point under water: the light with the scene's strength and
 * the fade at the edges, at least 0. NULL: 1. */
double ref_caustics_factor(const ref_caustics *caustics, ref_vec at);
#endif
