/* SPDX-License-Identifier: MIT */
/*
 * Rasterizes triangles and lines of water into the G-buffer of a tile, with a depth test.
 *
 * Fill rule: pixel centres are (16 x + 8, 16 y + 8) in 28.4 px.  An edge belongs to the
 * triangle on its right, a horizontal edge to the triangle below: row y is covered if
 * v_top <= 16 y + 8 < v_bottom, and a pixel in the row if x_left <= 16 x + 8 < x_right.
 * The crossing of an edge with a row is computed from the two ends of the edge only,
 * upper end first.  Both triangles of an edge therefore agree, and each pixel of a closed
 * mesh is drawn exactly once per layer.
 *
 * All values are linear in absolute x and y, and perspective blocks begin at multiples of
 * 16 (TP_SPAN_STEP), so tile borders are not visible.
 *
 * Depth and stencil share a word, as on GPUs: the high 24 bits are near / depth (larger
 * is nearer), the low 8 bits are the stencil.  At equal depth the first drawn sample
 * stays.
 */
#ifndef TP_RASTER_RASTER_H
#define TP_RASTER_RASTER_H
#include "base/base.h"
#include "view/projection.h"

/* -- intersections of an edge with the rows of pixels -------------------------------- */

/* Returns the first row with its centre at or below v: ceil(v - 1/2).  The same holds for
 * columns. */
TP_ALWAYS_INLINE int32_t tp_first_centre(int32_t v_28_4)
{
    return (v_28_4 + 7) >> 4;
}

/* State of an edge on a row: the first pixel centre at or right of the crossing.  The
 * crossing is a multiple of 1 / (16 dv) px and is stored exactly, as in Bresenham's
 * algorithm.  Two edges through a common point therefore never pass each other, a
 * condition for "each pixel exactly once" between slivers. */
typedef struct {
    int32_t row, pixel;
    int32_t over;               /* distance from crossing to centre, 0..one-1 */
    int32_t whole, part;        /* step per row: pixels, and the remainder 0..one-1 */
    int32_t one;                /* a pixel in these units: 16 dv, at most 2^22 */
} tp_edge;

/* Returns the edge from the upper end (u0, v0) to the lower end (u1, v1), v0 < v1, on its
 * first row.  `along` is in 1/16 px; `left` is the remainder in units of the edge.
 * `left` is below 30 dv, so the loop adds at most two pixels. */
TP_ALWAYS_INLINE tp_edge tp_edge_begin(int32_t u0, int32_t v0, int32_t u1, int32_t v1)
{
    TP_ASSERT(v0 < v1);
    int32_t dv = v1 - v0, whole = (u1 - u0) / dv, part = (u1 - u0) % dv;
    int32_t row = tp_first_centre(v0), down = 16 * row + 8 - v0;

    if (part < 0) {
        part += dv;
        whole--;
    }
    int32_t along = u0 - 8 + whole * down;
    int32_t left = (along & 15) * dv + part * down;
    tp_edge e = { row, along >> 4, 0, whole, 16 * part, 16 * dv };

    for (; left > 0; left -= e.one)
        e.pixel++;
    e.over = -left;
    return e;
}

TP_ALWAYS_INLINE void tp_edge_step(tp_edge *e)
{
    e->pixel += e->whole;
    e->over -= e->part;
    if (e->over < 0) {
        e->over += e->one;
        e->pixel++;
    }
}

/* Advances to row y >= e->row, 256 rows at a time, so that products stay within 31 bits. */
TP_ALWAYS_INLINE void tp_edge_advance(tp_edge *e, int32_t y)
{
    TP_ASSERT(y >= e->row);
    for (int32_t n = y - e->row; n > 0; n -= 256) {
        int32_t rows = n < 256 ? n : 256;
        int32_t over = rows * e->part - e->over;
        int32_t pixels = over > 0 ? (over + e->one - 1) / e->one : 0;

        e->pixel += rows * e->whole + pixels;
        e->over = pixels * e->one - over;
    }
    e->row = y;
}

/* -- the G-buffer, and triangles in it ----------------------------------------------- */

/* Stencil values.  Values from SOLID on are assigned at the layout of a frame:
 * frame/drawing.h. */
enum { TP_MARK_SKY = 0, TP_MARK_WATER = 1, TP_MARK_SOLID = 2 };
#define TP_MARK_BITS  8
#define TP_MARK(key)  ((key) & 0xffu)
#define TP_ZI(key)    ((key) >> 1 & 0x7fffff80u)                    /* back to Q1.31 */

/* Draws a solid triangle.  `mark`: stencil value; `face`: face number in the samples;
 * `opacity`: number of pixels drawn out of 16, in an ordered pattern. */
struct tp_gbuffer;
typedef void tp_solid_drawer(const struct tp_gbuffer *tile, const tp_screen_vertex *a,
                             const tp_screen_vertex *b, const tp_screen_vertex *c,
                             uint32_t mark, uint32_t face, int opacity);

/* The G-buffer of a tile: four planes, row-major from (x0, y0). */
typedef struct tp_gbuffer {
    int32_t   x0, y0, x1, y1;   /* bounds of the tile, px; x1 and y1 not included */
    uint32_t  stride;           /* samples per row */
    uint32_t *key;              /* depth << 8 | stencil */
    uint32_t *s;                /* water: rest x, 16.16 m; solids: s:t, 0.16 each */
    uint32_t *t;                /* water: rest z, 16.16 m; solids: face number */
    uint32_t *n;                /* water: slopes x:z, Q3.12 each; solids: packed normal */
    bool      front_only;       /* skip triangles with area >= 0, see tp_tri_twice_area */
    uint8_t   outline_shift;    /* see tp_outline_draw_edge; 0: no memory for the layer */
    uint32_t *outline;          /* a second layer of four planes, at the same distances:
                                 * samples of outlines, key 0 elsewhere; NULL: none */
    int32_t   outline_x0, outline_x1;   /* columns that may have outlines, if there is one */
    tp_solid_drawer *draw_wide; /* solids whose s and t need perspective; NULL: they are
                                 * affine, and counted */
    uint32_t *dropped;          /* number of triangles that the program cannot draw; NULL:
                                 * not counted */
} tp_gbuffer;

void tp_gbuffer_clear(const tp_gbuffer *tile);

/* Draws a water triangle. Vertices come from tp_projection_project and tp_clip_triangle. */
typedef void tp_triangle_drawer(const tp_gbuffer *tile, const tp_screen_vertex *a,
                                const tp_screen_vertex *b, const tp_screen_vertex *c);
tp_triangle_drawer tp_tri_water;

/* The halves of a cell of water, a bit each: the triangles left[0] left[1] right[1] and
 * left[0] right[1] right[0].  `left` and `right` are the cell's sides, each from above to
 * below if the cell shows its front. */
enum { TP_CELL_LOWER = 1, TP_CELL_UPPER = 2, TP_CELL_WHOLE = 3 };

/* Draws a cell at a lower price: the pixels are those of its triangles, but in cells of up
 * to 64 pixels each way both are shaded as one plane, and s and t are affine.  Returns the
 * halves that need exact triangles, which it does not draw. */
typedef uint32_t tp_cell_drawer(const tp_gbuffer *tile, const tp_screen_vertex left[2],
                                const tp_screen_vertex right[2]);
tp_cell_drawer tp_cell_water_fast;

/* Draws halves of a cell by triangles. */
static inline void tp_cell_draw_halves(tp_triangle_drawer *draw, const tp_gbuffer *tile,
                                       const tp_screen_vertex left[2],
                                       const tp_screen_vertex right[2], uint32_t halves)
{
    if (halves & TP_CELL_LOWER)
        draw(tile, &left[0], &left[1], &right[1]);
    if (halves & TP_CELL_UPPER)
        draw(tile, &left[0], &right[1], &right[0]);
}

tp_solid_drawer tp_tri_solid;
tp_solid_drawer tp_tri_solid_wide;      /* for tp_gbuffer.draw_wide */

/* Draws a solid triangle's front side at a lower price, for the fast rung.  n[0] and n[1]
 * of the vertices are light within +-504; t of the samples is not set.  Returns false, and
 * draws nothing, if the triangle is too large: larger than 64 px, or s and t need
 * perspective. */
bool tp_tri_solid_fast(const tp_gbuffer *tile, const tp_screen_vertex *a,
                       const tp_screen_vertex *b, const tp_screen_vertex *c, uint32_t mark);

/* Draws a lid, after the solids.  A lid writes depth only: a solid sample behind the lid
 * gets the lid's depth and keeps its stencil.  Water behind the lid is then hidden, and
 * water in front of the lid is drawn. */
void tp_tri_depth_only(const tp_gbuffer *tile, const tp_screen_vertex *a,
                       const tp_screen_vertex *b, const tp_screen_vertex *c);

/* -- outlines ------------------------------------------------------------------------ */

/* Samples of a mesh's outline, in the layer tp_gbuffer.outline.  A pixel crossed by an edge
 * between a front face and a back face, or by a border, shows the mesh with a share: the
 * part of the pixel on the inner side.  The tile keeps the sample behind the mesh there,
 * and the outline's sample is blended over its colour.
 *
 * The edges of a view are drawn before its faces.  A face's sample in a pixel with an
 * outline of its own material and depth is left out of the tile.
 *
 * t of such a sample is the face number, below 2^15, and two signed sums of shares: of
 * edges closer to upright, then of edges closer to level.  Each edge adds the part of the
 * pixel to its right (or below), negative where the mesh lies to its left (or above).  A
 * sum below 0 lacks the pixel's left part, which is inside.  A rope thinner than a pixel
 * thus has the share of its width. */

#define TP_OUTLINE_FACES (1u << 15)
#define TP_OUTLINE_OUT   (1u << 15)     /* in t: the centre is well outside an edge */
#define TP_OUTLINE_HIT   (1u << 31)     /* in n: a face's sample was left out */
#define TP_OUTLINE_MORE  (1u << 30)     /* in n: several edges cross the pixel */

/* Returns tp_gbuffer.outline_shift: depths within 8 px of each other belong together. */
static inline uint8_t tp_outline_shift(int32_t focal_28_4)
{
    const int log2 = 27 - tp_clz((uint32_t)focal_28_4 | 16);
    return (uint8_t)(log2 > 4 ? log2 - 3 : 1);
}

/* Begins the tile's outlines: none yet.  The layer lies right behind the four planes.  All
 * edges will be between the columns x0 and x1, x1 included. */
void tp_outline_begin(tp_gbuffer *tile, int32_t x0, int32_t x1);

/* Draws the edge from a to b of a front face; both in the order of the face.  Samples of
 * the same material within depth / 2^(outline_shift) belong to the same outline. */
typedef void tp_outline_edge_drawer(const tp_gbuffer *tile, const tp_screen_vertex *a,
                                    const tp_screen_vertex *b, uint32_t mark,
                                    uint32_t face);
tp_outline_edge_drawer tp_outline_draw_edge;

/* The same with one place and light for all pixels of the edge, for the fast rung. */
tp_outline_edge_drawer tp_outline_draw_edge_fast;

/* Returns the share of the pixel, 0..256, of an outline's sample. */
uint32_t tp_outline_share(uint32_t t, uint32_t n);

/* Returns twice the signed area, 1/256 square px; negative for a front face. */
static inline int64_t tp_tri_twice_area(const tp_screen_vertex *a,
                                        const tp_screen_vertex *b,
                                        const tp_screen_vertex *c)
{
    return (int64_t)(b->u - a->u) * (c->v - a->v)
         - (int64_t)(c->u - a->u) * (b->v - a->v);
}

/* -- water by lines ------------------------------------------------------------------ */

/* Rasterizes water as a height field, without triangles.  Lines of points are drawn from
 * near to far.  Each line is a polyline on the screen, and every column of pixels stores
 * its covered height.  Where a line rises above the covered height, the pixels between
 * are interpolated between the previous line and this line; elsewhere a nearer crest
 * hides the line.  Each pixel is written at most once, and only the depth of solids is
 * read.
 *
 * All values are linear in absolute x and y between the points of two lines, so tile
 * borders are not visible.
 *
 * The method is valid if the points of a line go from left to right and the lines are
 * ordered along every ray; frame/visibility.c has the conditions. */

/* A projected point of a line. */
typedef struct {
    int32_t  u, v;              /* 28.4 px, anywhere in the guard band */
    uint32_t zi;                /* near / depth, Q1.31 */
    int32_t  s, t;              /* rest position, 16.16 m */
    uint32_t n;                 /* slopes x:z, Q3.12 each */
} tp_row_point;

/* A line at a column of pixels. */
typedef struct {
    int32_t  v;                 /* row, 16.16 px, or TP_ROW_NONE */
    uint32_t zi;
    int32_t  s, t;
    uint32_t n;
} tp_row_sample;

/* State of a column: covered height and last line. */
typedef struct {
    int32_t  limit;             /* row, 16.16 px; lines at or above this row are visible */
    tp_row_sample line;
} tp_row_column;

#define TP_ROW_NONE (-(1 << 30))  /* below all lines, by less than 2^31 */

typedef struct {
    const tp_gbuffer *tile;
    tp_row_column    *column;   /* a state for each column of the tile */
    int32_t x0, x1;             /* columns to walk, x1 not included */
    int32_t open;               /* columns of the tile not yet covered to its upper edge */
    bool    solid;              /* true if the tile already has other samples */
} tp_rows;

size_t tp_rows_bytes(uint32_t columns);         /* size of the columns' states */

/* Begins a tile.  `memory`: tp_rows_bytes(x1 - x0) bytes, aligned to 4.  `solid`: the
 * tile may already have samples.  Of the lines below the tile only the last is needed,
 * and only in columns where the next line is not below: limit x0 and x1 accordingly. */
void tp_rows_begin(tp_rows *rows, const tp_gbuffer *tile, void *memory, bool solid);

/* Draws the next line, farther than the previous line, with water between both; the first
 * line starts the water. u must increase from point to point; points that break the order
 * are skipped. */
void tp_rows_draw_line(tp_rows *rows, const tp_row_point *point, uint32_t count);

/* Same, for a line behind a gap: nothing is drawn between the previous line and this
 * line, and the gap hides everything behind.  `behind_triangles`: triangles lie in
 * front of the line.  Triangles assign pixels at an edge by another rule, so the pixel
 * at the line is drawn again. */
void tp_rows_restart_line(tp_rows *rows, const tp_row_point *point, uint32_t count,
                          bool behind_triangles);

/* Used before a line that reaches farther to a side than the previous line: the edge of
 * the side, from left to right, replaces the previous line there. */
void tp_rows_restart_side(tp_rows *rows, const tp_row_point *left,
                          const tp_row_point *right);

/* Marks columns without a line between two u positions; the next line starts anew there. */
void tp_rows_mark_gap(tp_rows *rows, int32_t left_28_4, int32_t right_28_4);

#endif
