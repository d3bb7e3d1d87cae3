/* SPDX-License-Identifier: MIT */
/* Planar maps: pictures of half or a quarter of the picture's size, sampled by the water's
 * stages.  Maps are drawn before any tile, a few rows at a time to keep the G-buffer
 * small. */
#ifndef TP_FRAME_PLANAR_MAP_H
#define TP_FRAME_PLANAR_MAP_H
#include "base/arena.h"
#include "frame/render_view.h"
#include "scene/module.h"
#include "shade/shade.h"

#define TP_PLANAR_BAND 4        /* rows drawn at a time */

typedef struct {
    uint32_t *colour;
    uint32_t *samples;          /* four planes of one band */
    uint32_t  cols, rows;
    uint32_t  halvings;         /* halvings of the picture's sides: 1 or 2 */
} tp_planar_memory;

/* Allocates the map's memory; pointers are NULL if the arena only counts. */
void tp_planar_layout(tp_planar_memory *store, tp_arena *arena, const tp_want *want,
                      uint32_t halvings);

/* Sets *half to the part of the map covered by `box`.  Returns false if the part is
 * empty. */
bool tp_planar_set_bounds(const tp_planar_memory *store, const tp_grid_box *box,
                          tp_planar_map *map);

/* Returns the G-buffer of the band at row y0. */
tp_gbuffer tp_planar_gbuffer(const tp_planar_memory *store, const tp_planar_map *map,
                             int32_t y0);
#endif
