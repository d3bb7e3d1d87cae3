/* SPDX-License-Identifier: MIT */
/*
 * Render views: cameras that solids are drawn for.  The picture is one view.  Mirrors,
 * refraction maps and the faces of a cube map are other views, drawn before the picture;
 * all views share the memory of projected vertices.
 *
 *     tp_view_begin(frame, &view)       sets up shading for the view
 *     tp_view_project_solids(frame, &view)       projects all solids
 *     tp_view_draw_solids(frame, &view, tile)  draws one tile, any number of times
 */
#ifndef TP_FRAME_RENDER_VIEW_H
#define TP_FRAME_RENDER_VIEW_H
#include "base/arena.h"
#include "raster/raster.h"
#include "shade/shade.h"
#include "tidepool/frame.h"
#include "view/grid.h"
#include "world/module.h"

typedef struct {
    const tp_projection *projection;
    bool          picture;      /* true: the picture itself */
    bool          clipped;          /* true: clipped to the inner side of `level` */
    bool          walls;        /* true: tanks and blocks are drawn too */
    tp_view_plane level;
} tp_view;

/* The target of the mirrors' views. */
typedef struct {
    tp_vec3 middle;             /* middle of the objects, world, m */
    tp_fx   level;              /* still water level there, m */
} tp_view_anchor;

/* Returns the clip plane of the view, or NULL. */
static inline const tp_view_plane *tp_view_clip_plane(const tp_view *view)
{
    return view->clipped ? &view->level : NULL;
}

static inline bool tp_box_overlaps_tile(const tp_grid_box *box, const tp_gbuffer *tile)
{
    return box->x0 < tile->x1 && box->x1 >= tile->x0 && box->y0 < tile->y1
        && box->y1 >= tile->y0 && box->x0 <= box->x1;
}

#define TP_BOX_NONE (tp_grid_box){ INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN }

static inline void tp_box_widen(tp_grid_box *box, int32_t u, int32_t v)
{
    TP_ASSERT(u >> 4 == (int16_t)(u >> 4) && v >> 4 == (int16_t)(v >> 4));
    int16_t x = (int16_t)(u >> 4), y = (int16_t)(v >> 4);

    box->x0 = x < box->x0 ? x : box->x0;
    box->x1 = x > box->x1 ? x : box->x1;
    box->y0 = y < box->y0 ? y : box->y0;
    box->y1 = y > box->y1 ? y : box->y1;
}

static inline void tp_box_join(tp_grid_box *to, const tp_grid_box *box)
{
    to->x0 = box->x0 < to->x0 ? box->x0 : to->x0;
    to->x1 = box->x1 > to->x1 ? box->x1 : to->x1;
    to->y0 = box->y0 < to->y0 ? box->y0 : to->y0;
    to->y1 = box->y1 > to->y1 ? box->y1 : to->y1;
}

/* Returns the height of still water at the anchor, m. */
tp_fx tp_view_anchor_level(const tp_frame *frame);

/* Sets the shade's view numbers from a projection; the light stays the world's. */
void tp_view_set_shade(tp_frame *frame, const tp_projection *projection);

/* True if the camera is above water and above still water of height `level`: the water
 * then mirrors. */
bool tp_view_is_above_level(const tp_frame *frame, tp_fx level);

void tp_view_begin(tp_frame *frame, const tp_view *view);

/* Projects the solids of all modules for a view; returns the box of all covered pixels. */
tp_grid_box tp_view_project_solids(tp_frame *frame, tp_view *view);
void tp_view_draw_solids(const tp_frame *frame, const tp_view *view, tp_gbuffer *tile);

/* A view vertex without texture coordinates; the clipped screen vertices of a
 * triangle, fewer than 3 if nothing is left; drawing the clipped polygon, with t as its
 * stage expects. */
tp_view_vertex tp_solid_vertex_make(const tp_projection *projection, tp_vec3 at,
                                    const int16_t n[3]);
int tp_clipped_corners(const tp_projection *projection, const tp_view_plane *level,
                       const tp_view_vertex in[3], tp_screen_vertex to[TP_CLIP_VERTICES]);
void tp_clipped_draw(const tp_projection *projection, const tp_view_plane *level,
                     const tp_gbuffer *tile, const tp_view_vertex in[3], uint32_t mark,
                     uint32_t t);

/* -- planar maps --------------------------------------------------------------------- */

/*
 * Pictures of half or a quarter of the picture's size, sampled by the water's stages.  Maps
 * are drawn before any tile, a few rows at a time to keep the G-buffer small.
 */

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
