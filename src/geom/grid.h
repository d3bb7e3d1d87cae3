/* SPDX-License-Identifier: MIT */
/* The water's grid: lines across and along, their crossings displaced and projected.
 *
 * The middle of the grid has square cells of one size.  If the scene asks for water
 * that reaches farther, the outer eighth of the lines at each side (TP_GRID_FLANK at the
 * most) stretches out to it in steps that grow by one ratio, flat: the waves fade out
 * before, over the last eighth of the middle.  A grid that follows the camera moves by
 * whole cells, so that its crossings stay where they were in the world: nothing swims.
 *
 * Texture coordinates are the places at rest, so a column has one s and a row one t.
 * What happens to a crossing is told in geom/vertex.h. */
#ifndef TP_GEOM_GRID_H
#define TP_GEOM_GRID_H
#include "base/arena.h"
#include "geom/vertex.h"

#define TP_GRID_FLANK 12
#define TP_GRID_BLOCK 16        /* cells of a row that share a bounding box */

/* Whole pixels, x1 and y1 included. */
typedef struct {
    int16_t x0, y0, x1, y1;
} tp_grid_box;

typedef struct {
    uint16_t first, end;        /* cells of this row that may be seen */
} tp_grid_span;

/* Two neighbouring rows of crossings at hand: row j is line[j & 1]. */
typedef struct {
    const tp_grid_vertex *line[2];
    tp_grid_vertex *memory;     /* of a streamed grid: two rows */
    uint32_t        row[2];     /* that lie there, and which of their crossings */
    tp_grid_span    done[2];
} tp_grid_window;

typedef struct {
    uint32_t cols, rows;        /* lines; cells are one less */
    uint32_t most_cols, most_rows;      /* of which some may be left out, see lod.h */
    uint32_t blocks;            /* of a row of cells */
    tp_grid_line   *column, *row;
    tp_grid_vertex *vertex;     /* rows x cols, of a grid that does not stream */
    bool            streams;
    tp_grid_window  window;     /* for tp_grid_place_row and until the next */
    tp_grid_span   *span;       /* of each row of cells */
    tp_grid_box    *box;        /* (rows - 1) x blocks */
    uint32_t vertices;          /* evaluated by the last tp_grid_place */
    tp_vertex_frame   frame;
    struct tp_thinning *lod;    /* of columns and rows; NULL: there is no memory */
    tp_vertex_columns columns;
    tp_grid_span      waves;    /* columns that have any */
    tp_vec3  *sheet[3];         /* an ocean's displaced crossings: of three rows */
    uint32_t  sheets;           /* rows of them done: the last is (sheets - 1) % 3 */
    uint32_t *dry;              /* a bit for each crossing of an ocean: on land */
} tp_grid;

void tp_grid_carve(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows);

/* Without a store: crossings are evaluated again whenever a window sees them, the same bit
 * by bit.  Not for an ocean, and for `waves` swells; more are left out. */
void tp_grid_carve_streamed(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows,
                            uint32_t waves);

/* What an ocean takes besides. */
void tp_grid_carve_ocean(tp_grid *grid, tp_arena *arena);

/* What the grid shows, taken together. */
typedef struct {
    const tp_lens *lens;
    const tp_surface *surface;
    uint32_t width, height;     /* of the picture */
    tp_fx cell, reach;
    bool  follow;
    bool  lod;                  /* water is the sea's plain swells alone */
} tp_grid_view;

static inline bool tp_grid_is_dry(const tp_grid *grid, uint32_t i, uint32_t j)
{
    size_t at = (size_t)j * grid->cols + i;
    return grid->dry[at / 32] >> at % 32 & 1;
}

/* Whether a cell that may be seen has all its corners on land: there is no water. */
static inline bool tp_grid_cell_is_dry(const tp_grid *grid, uint32_t i, uint32_t j)
{
    return grid->dry && grid->frame.surface->ocean
        && tp_grid_is_dry(grid, i, j) && tp_grid_is_dry(grid, i + 1, j)
        && tp_grid_is_dry(grid, i, j + 1) && tp_grid_is_dry(grid, i + 1, j + 1);
}

/* lines.c: the columns, or along z the rows; lines beyond the middle at each side. */
void tp_lines_lay(tp_grid_line *line, uint32_t count, const tp_grid_view *view,
                  bool along_z);
uint32_t tp_lines_flank(uint32_t count, const tp_grid_view *view);

/* Of the lines one way: the outer two, and those between which there are waves, which
 * fade over `fading` metres; 0: they do not. */
typedef struct {
    tp_fx first, last, calm[2], fading;
} tp_grid_extent;

tp_grid_extent tp_lines_extent(uint32_t count, const tp_grid_view *view, bool along_z);

/* Of waves at any place, as tp_grid_line's. */
tp_fx tp_lines_fade(const tp_grid_extent *extent, tp_fx place);

/* Lays the lines, evaluates the crossings that may be seen: all, or row by row, where row
 * j completes the boxes of the cells before it. */
void tp_grid_place(tp_grid *grid, const tp_grid_view *view);
void tp_grid_begin(tp_grid *grid, const tp_grid_view *view);
void tp_grid_place_row(tp_grid *grid, uint32_t j);

/* A window of one's own: several threads may look at a grid that is placed.  `memory` is
 * of TP_GRID_WINDOW(most_cols) bytes, and not used where crossings are stored. */
#define TP_GRID_WINDOW(cols) (2 * (size_t)(cols) * sizeof(tp_grid_vertex))
tp_grid_window tp_grid_window_over(void *memory);

/* Crossings first to end - 1 of row j, in place of those of row j - 2 and j + 2.  They
 * join those of row j that are there. */
void tp_grid_see(const tp_grid *grid, tp_grid_window *window, uint32_t j, uint32_t first,
                 uint32_t end);

/* A corner of a seen cell again, before projection, for those that must be clipped.  Lens
 * and surface are those of the last tp_grid_place, slopes those of `vertex`. */
tp_view_corner tp_grid_corner(const tp_grid *grid, const tp_grid_vertex *vertex,
                              uint32_t i, uint32_t j);
#endif
