/* SPDX-License-Identifier: MIT */
/* Triangles to samples: for every pixel of a tile what is nearest there.
 *
 * Fill rule, by pixel centres at (16 x + 8, 16 y + 8) in 28.4.  An edge belongs to the
 * triangle on its right, a horizontal one to the triangle below: a row y is covered
 * where v_top <= 16 y + 8 < v_bottom, in it a pixel where x_left <= 16 x + 8 < x_right.
 * Where an edge crosses a row is computed from the edge's two ends alone, upper end
 * first, so the two triangles of an edge agree on it and each pixel of a closed mesh
 * is drawn exactly once per layer.
 *
 * Everything is linear in absolute x and y, and the perspective blocks begin at
 * multiples of 16 (step.h): where a tile cuts a triangle never shows.
 *
 * Depth and stencil share a word, as they do on GPUs: the high 24 bits are near / depth
 * (larger is nearer), the low 8 say what is there.  Of two things equally near the one
 * drawn first stays. */
#ifndef TP_RASTER_H
#define TP_RASTER_H
#include "geom/geom.h"

/* Marks from SOLID on are dealt when a frame is laid out: frame/marks.h. */
enum { TP_MARK_SKY = 0, TP_MARK_WATER = 1, TP_MARK_SOLID = 2 };
#define TP_MARK_BITS  8
#define TP_MARK(key)  ((key) & 0xffu)
#define TP_ZI(key)    ((key) >> 1 & 0x7fffff80u)                    /* Q1.31 again */

/* The line of samples, for a whole tile.  Four planes, row-major from (x0, y0). */
typedef struct {
    int32_t   x0, y0, x1, y1;   /* the tile, x1 and y1 not included */
    uint32_t  stride;           /* samples from row to row */
    uint32_t *key;              /* depth << 8 | mark */
    uint32_t *s;                /* water: rest place x, 16.16 m; solids: s:t, 0.16 each */
    uint32_t *t;                /* water: rest place z; solids: face number */
    uint32_t *n;                /* water: slopes x:z, Q3.12 each; solids: packed normal */
    bool      front_only;       /* leave out areas >= 0, see tp_tri_area */
} tp_samples;

void tp_samples_clear(const tp_samples *tile);

/* Corners as tp_lens_project and tp_clip_triangle leave them. */
void tp_tri_water(const tp_samples *tile, const tp_corner *a, const tp_corner *b,
                  const tp_corner *c);

/* `face` goes into the samples; `opacity` 0..16 sixteenths of the pixels are drawn, in
 * an ordered pattern. */
void tp_tri_solid(const tp_samples *tile, const tp_corner *a, const tp_corner *b,
                  const tp_corner *c, uint32_t mark, uint32_t face, int opacity);

/* A lid, drawn after the solids: where one of them lies behind it, its sample takes the
 * lid's depth and stays what it is.  So water behind the lid is not drawn over it, and
 * water before the lid is. */
void tp_tri_lid(const tp_samples *tile, const tp_corner *a, const tp_corner *b,
                const tp_corner *c);

/* Twice the signed area, 1/256 square pixels; negative for a front face. */
static inline int64_t tp_tri_area(const tp_corner *a, const tp_corner *b,
                                  const tp_corner *c)
{
    return (int64_t)(b->u - a->u) * (c->v - a->v)
         - (int64_t)(c->u - a->u) * (b->v - a->v);
}
#endif
