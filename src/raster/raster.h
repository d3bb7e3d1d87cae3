/* SPDX-License-Identifier: MIT */
/* Rasterizes triangles into the G-buffer of a tile, with a depth test.
 *
 * Fill rule: pixel centres are (16 x + 8, 16 y + 8) in 28.4 px.  An edge belongs to the
 * triangle on its right, a horizontal edge to the triangle below: row y is covered if
 * v_top <= 16 y + 8 < v_bottom, and a pixel in the row if x_left <= 16 x + 8 < x_right.
 * The crossing of an edge with a row is computed from the two ends of the edge only,
 * upper end first.  Both triangles of an edge therefore agree, and each pixel of a closed
 * mesh is drawn exactly once per layer.
 *
 * All values are linear in absolute x and y, and perspective blocks begin at multiples of
 * 16 (step.h), so tile borders are not visible.
 *
 * Depth and stencil share a word, as on GPUs: the high 24 bits are near / depth (larger
 * is nearer), the low 8 bits are the stencil.  At equal depth the first drawn sample
 * stays. */
#ifndef TP_RASTER_H
#define TP_RASTER_H
#include "geom/geom.h"

/* Stencil values.  Values from SOLID on are assigned at the layout of a frame:
 * frame/marks.h. */
enum { TP_MARK_SKY = 0, TP_MARK_WATER = 1, TP_MARK_SOLID = 2 };
#define TP_MARK_BITS  8
#define TP_MARK(key)  ((key) & 0xffu)
#define TP_ZI(key)    ((key) >> 1 & 0x7fffff80u)                    /* back to Q1.31 */

/* The G-buffer of a tile: four planes, row-major from (x0, y0). */
typedef struct {
    int32_t   x0, y0, x1, y1;   /* bounds of the tile, px; x1 and y1 not included */
    uint32_t  stride;           /* samples per row */
    uint32_t *key;              /* depth << 8 | stencil */
    uint32_t *s;                /* water: rest x, 16.16 m; solids: s:t, 0.16 each */
    uint32_t *t;                /* water: rest z, 16.16 m; solids: face number */
    uint32_t *n;                /* water: slopes x:z, Q3.12 each; solids: packed normal */
    bool      front_only;       /* skip triangles with area >= 0, see tp_tri_twice_area */
} tp_gbuffer;

void tp_gbuffer_clear(const tp_gbuffer *tile);

/* Draws a water triangle. Vertices come from tp_projection_project and tp_clip_triangle. */
void tp_tri_water(const tp_gbuffer *tile, const tp_screen_vertex *a,
                  const tp_screen_vertex *b, const tp_screen_vertex *c);

/* Draws a solid triangle.  `mark`: stencil value; `face`: face number in the samples;
 * `opacity`: number of pixels drawn out of 16, in an ordered pattern. */
void tp_tri_solid(const tp_gbuffer *tile, const tp_screen_vertex *a,
                  const tp_screen_vertex *b, const tp_screen_vertex *c, uint32_t mark,
                  uint32_t face, int opacity);

/* Draws a lid, after the solids.  A lid writes depth only: a solid sample behind the lid
 * gets the lid's depth and keeps its stencil.  Water behind the lid is then hidden, and
 * water in front of the lid is drawn. */
void tp_tri_depth_only(const tp_gbuffer *tile, const tp_screen_vertex *a,
                       const tp_screen_vertex *b, const tp_screen_vertex *c);

/* Returns twice the signed area, 1/256 square px; negative for a front face. */
static inline int64_t tp_tri_twice_area(const tp_screen_vertex *a,
                                        const tp_screen_vertex *b,
                                        const tp_screen_vertex *c)
{
    return (int64_t)(b->u - a->u) * (c->v - a->v)
         - (int64_t)(c->u - a->u) * (b->v - a->v);
}
#endif
