/* SPDX-License-Identifier: MIT */
/* The water's surface, all models together: swells of the open sea, or an ocean over its
 * floor, displace a point of still water; rings and pools are heights over the displaced
 * place.  A part that a scene does not have is NULL or 0 and is not asked. */
#ifndef TP_GEOM_SURFACE_H
#define TP_GEOM_SURFACE_H
#include "pool/pool.h"
#include "tidepool/modules.h"
#include "wave/ocean.h"
#include "wave/ring.h"

typedef struct {
    const tp_waters *by; /* the program's; what it lacks is not here */
    const tp_sea   *sea;
    const tp_turn  *phases;
    const tp_ocean *ocean;      /* instead of the sea's own sum; NULL: open sea */
    const tp_ring_now *ring;
    uint32_t        rings;
    const tp_ring  *raised;     /* a world's: what `ring` is made of at its tick, */
    uint32_t        n_raised;   /* and so many */
    const tp_pool  *pool, *field;
    tp_fx           back;       /* of the pools, 0..1 tick */
} tp_surface;

/* Rings and pools at the world's (x, z). */
tp_relief tp_surface_relief(const tp_surface *surface, tp_fx x, tp_fx z);

/* The same where a mesh lets its waves fade, 0..1: its far cells are too wide for them. */
tp_relief tp_surface_relief_faded(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx fade);

/* True if the sea has swells, and the program their model. */
static inline bool tp_surface_has_swells(const tp_surface *surface)
{
    return surface->sea->count > 0 && surface->by->swells;
}

/* True if rings or pools lie on it. */
static inline bool tp_surface_has_relief(const tp_surface *surface)
{
    return surface->rings || surface->pool || surface->field;
}

/* No point lies farther from its rest: sideways and up. */
tp_fx tp_surface_reach(const tp_surface *surface);
tp_fx tp_surface_height(const tp_surface *surface);

/* The surface above or below a place, without what overhangs.  `rest` (x0, z0), if not
 * NULL, is where the search begins and then what it found. */
tp_sea_point tp_surface_above(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx rest[2]);

/* The same of an ocean, without what lies on it; `rest` is not NULL. */
tp_sea_point tp_surface_ocean_above(const tp_surface *surface, tp_fx x, tp_fx z,
                                    tp_fx rest[2]);

/* dy/dx and dy/dz of a sheet that goes along_x from column to column and along_z from
 * row to row (16.16 m each, below 2 km), within +-8; what overhangs is held there. */
void tp_slopes_across(tp_vec3 along_x, tp_vec3 along_z, tp_fx *slope_x, tp_fx *slope_z);
#endif
