/* SPDX-License-Identifier: MIT */
/*
 * The water surface of all wave models together, at single points.  Swells of deep water,
 * or coastal water over its floor, displace a point of still water; rings and pools add
 * heights at the displaced position. A model without a part in the scene is NULL or 0 and
 * is not asked.
 */
#ifndef TP_VIEW_SURFACE_H
#define TP_VIEW_SURFACE_H
#include "pool/pool.h"
#include "tidepool/modules.h"
#include "view/projection.h"
#include "waves/coastal_water.h"
#include "waves/deep_water.h"

typedef struct {
    const tp_wave_models *by;   /* wave models of the program; models it lacks are not
                                 * used here */
    const tp_deep_water *deep;
    const tp_turn  *phases;
    const tp_coastal_water *coastal; /* replaces the sum of `deep`; NULL: deep water */
    const tp_ring_now *ring;
    uint32_t        rings;
    const tp_ring  *raised;     /* rings of the world, the source of `ring` at its tick */
    uint32_t        n_raised;   /* number of `raised` rings */
    const tp_pool  *pool, *field;
    const tp_pool_kind *pool_kind, *field_kind; /* not NULL if there is a pool
                                                     * that may be sampled */
    tp_fx           lag;        /* interpolation of the pools, 0..1 tick */
} tp_surface;

/* Returns the summed height and slopes of rings, pool and field at world (x, z), without
 * the swells. */
tp_height_slope tp_rings_pools_sample(const tp_surface *surface, tp_fx x, tp_fx z);

/* Same, times `weight`, 0..1.  A mesh fades its waves in the distance, where its cells are
 * too wide for them. */
tp_height_slope tp_rings_pools_sample_faded(const tp_surface *surface, tp_fx x, tp_fx z,
                                            tp_fx weight);

/* True if the deep water has swells and the program has their wave model. */
static inline bool tp_surface_has_swells(const tp_surface *surface)
{
    return surface->deep->count > 0 && surface->by->swells;
}

/* True if the surface has rings or pools. */
static inline bool tp_surface_has_rings_or_pools(const tp_surface *surface)
{
    return surface->rings || surface->pool || surface->field;
}

/* Bounds of the displacement from a rest position, m: horizontal and vertical. */
tp_fx tp_surface_displacement_bound(const tp_surface *surface);
tp_fx tp_surface_height_bound(const tp_surface *surface);

/* Returns the surface point above or below a position; ignores overhangs.  `rest` (x0,
 * z0) may be NULL; otherwise it is the start of the search and receives the rest position
 * found. */
tp_surface_point tp_surface_sample(const tp_surface *surface, tp_fx x, tp_fx z,
                                   tp_fx rest[2]);

/* Same for coastal water, without rings and pools; `rest` is not NULL. */
tp_surface_point tp_surface_coastal_sample(const tp_surface *surface, tp_fx x, tp_fx z,
                                           tp_fx rest[2]);

/* Return the displaced point of a rest position, without rings and pools: of swells alone,
 * with slopes; of any water. */
tp_surface_point tp_surface_displaced(const tp_surface *surface, tp_fx x, tp_fx z);
tp_vec3 tp_surface_displace(const tp_surface *surface, tp_fx x, tp_fx z);

/* Returns the surface point of coastal water near (x, z).  Rest positions crowd at a
 * breaking crest and would leave dark gaps behind it, so the point's rest position lies
 * `off` away from (x, z), as the displacement of the point before tells. */
tp_surface_point tp_surface_coastal_near(const tp_surface *s, tp_fx x, tp_fx z, tp_fx off[2]);

/* Returns the water level at a place, by one step of the search of [E1].  The error shows
 * only in steep waves; spray uses the level, and there has specks enough to hide it. */
tp_fx tp_surface_rough_height(const tp_surface *surface, tp_fx x, tp_fx z);

/* Computes dy/dx and dy/dz of a surface that goes along_x from column to column and
 * along_z from row to row (16.16 m, lengths below 2 km).  Slopes are within +-8;
 * overhangs get the limit. */
void tp_slopes_from_tangents(tp_vec3 along_x, tp_vec3 along_z, tp_fx *slope_x,
                             tp_fx *slope_z);

#endif
