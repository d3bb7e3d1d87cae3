/* SPDX-License-Identifier: MIT */
/* Render views: cameras that solids are drawn for.  The picture is one view.  Mirrors,
 * refraction maps and the faces of a cube map are other views, drawn before the picture;
 * all views share the memory of projected vertices.
 *
 *     tp_sight_begin(frame, &sight)       sets up shading for the view
 *     tp_sight_place(frame, &sight)       projects all solids
 *     tp_sight_draw(frame, &sight, tile)  draws one tile, any number of times */
#ifndef TP_FRAME_SIGHT_H
#define TP_FRAME_SIGHT_H
#include "geom/grid.h"
#include "raster/raster.h"
#include "shade/depth.h"
#include "tidepool/frame.h"

typedef struct {
    const tp_lens *lens;
    bool          picture;      /* true: the picture itself */
    bool          cut;          /* true: clipped to the inner side of `level` */
    bool          walls;        /* true: tanks and blocks are drawn too */
    tp_view_plane level;
} tp_sight;

/* The target of the mirrors' views. */
typedef struct {
    tp_vec3 middle;             /* middle of the objects, world, m */
    tp_fx   level;              /* still water level there, m */
} tp_sight_anchor;

/* Returns the clip plane of the view, or NULL. */
static inline const tp_view_plane *tp_sight_cut(const tp_sight *sight)
{
    return sight->cut ? &sight->level : NULL;
}

static inline bool tp_sight_touches(const tp_grid_box *box, const tp_samples *tile)
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
tp_fx tp_sight_level(const tp_frame *frame);

/* Sets the shade's view numbers from a projection; the light stays the world's. */
void tp_sight_look(tp_frame *frame, const tp_lens *lens);

/* True if the camera is above water and above still water of height `level`: the water
 * then mirrors. */
bool tp_sight_is_above_level(const tp_frame *frame, tp_fx level);

void tp_sight_begin(tp_frame *frame, const tp_sight *sight);

/* Projects the solids of all modules for a view; returns the box of all covered pixels. */
tp_grid_box tp_sight_place(tp_frame *frame, tp_sight *sight);
void tp_sight_draw(const tp_frame *frame, const tp_sight *sight, tp_samples *tile);

/* clipped.c: a view vertex without texture coordinates; the clipped screen vertices of a
 * triangle, fewer than 3 if nothing is left; drawing the clipped polygon, with t as its
 * stage expects. */
tp_view_corner tp_clipped_corner(const tp_lens *lens, tp_vec3 at, const int16_t n[3]);
int tp_clipped_corners(const tp_lens *lens, const tp_view_plane *level,
                       const tp_view_corner in[3], tp_corner to[TP_CLIP_CORNERS]);
void tp_clipped_draw(const tp_lens *lens, const tp_view_plane *level,
                     const tp_samples *tile, const tp_view_corner in[3], uint32_t mark,
                     uint32_t t);

#endif
