/* SPDX-License-Identifier: MIT */
/*
 * The water's grid: rows of vertices, displaced by the waves and projected; four
 * neighbours are the corners of a cell.  fan.h has the law of the rows.
 *
 * Texture coordinates are rest positions.
 */
#ifndef TP_VIEW_GRID_H
#define TP_VIEW_GRID_H
#include "base/base.h"
#include "view/kept_lines.h"
#include "view/surface.h"

#define TP_GRID_NEEDS_CLIP INT32_MIN
#define TP_GRID_BLOCK 16        /* cells of a row with a common bounding box */

/* A grid vertex: displaced, projected, packed. */
typedef struct {
    int32_t  u, v;              /* 28.4 px; u = TP_GRID_NEEDS_CLIP: needs clipping */
    uint32_t zi;                /* near / depth, Q1.31 */
    int16_t  slope_x, slope_z;  /* slopes, Q3.12 */
} tp_grid_vertex;

/* Bounding box in whole pixels, x1 and y1 included. */
typedef struct {
    int16_t x0, y0, x1, y1;
} tp_grid_box;

typedef struct {
    uint16_t first, end;        /* visible cells of a row */
} tp_grid_span;

/* Displaced vertices of a row of coastal water, those of the columns `done`. */
typedef struct {
    tp_vec3      *at;           /* array, one for each column */
    uint32_t      row;
    tp_grid_span  done;
} tp_grid_sheet;

/* A row of a streamed grid that a scratch keeps. */
typedef struct {
    tp_grid_span   done;        /* its evaluated vertices */
    tp_grid_vertex vertex[];
} tp_grid_kept_row;

/* Two neighbouring rows of vertices: row j is line[j & 1]. */
typedef struct {
    const tp_grid_vertex *line[2];
    tp_grid_vertex *memory;     /* for a streamed grid: two rows */
    uint32_t        row[2];     /* rows in memory; their evaluated vertices are in `done` */
    tp_grid_span    done[2];
    tp_kept_lines  *kept;       /* rows that lie here instead; NULL: none */
    const struct tp_draw_kept_lines *keep;      /* their code */
    tp_grid_sheet   sheet[3];   /* of coastal water: row j is sheet[j % 3] */
    uint32_t       *dry;        /* the grid's own window marks the land here; NULL: others */
} tp_grid_window;

typedef struct {
    uint32_t cols, rows;        /* vertices of a row, rows; cells are one fewer */
    uint32_t most_cols;         /* columns in memory */
    uint32_t blocks;            /* blocks in a row of cells */
    tp_grid_vertex *vertex;     /* rows x cols; NULL if the grid is streamed */
    bool            streams;
    bool            plain_normals;      /* quality.normals is fast */
    uint8_t         half_px;    /* limit of `large`, 1/2 px */
    tp_grid_window  window;     /* for tp_grid_evaluate_row, valid until the next call */
    const tp_grid_span *span;   /* visible cells of each row */
    tp_grid_span   *placed_span;        /* their memory; NULL: they are baked */
    tp_grid_box    *box;        /* bounding boxes, (rows - 1) x blocks */
    uint32_t vertices;          /* vertices evaluated in the last frame */
    const tp_projection *projection;
    const tp_surface    *surface;
    uint32_t *dry;              /* a bit per vertex of coastal water: on land */
    struct tp_fan *fan;         /* the rows, view/fan.h */
    const struct tp_draw_fast_waves *waves; /* evaluates the vertices; NULL: exact_waves */
    const struct tp_draw_exact_waves *exact_waves;  /* NULL: all vertices lie in one point, */
    const struct tp_draw_exact_corners *exact_corners; /* and nothing is drawn */
    const struct tp_draw_large_waves *large;    /* weighs the swells; NULL: the filter alone */
} tp_grid;

/* The vertices of a fan in 32 bits, for quality.waves = fast: tp_fan_evaluate_row and
 * tp_fan_make_view_vertices.  fan_fast_vertices.c. */
struct tp_draw_fast_waves {
    void (*evaluate_row)(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                         tp_grid_vertex *vertex);
    void (*make_view_vertices)(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                               tp_view_vertex *to);
};

/* The exact vertices of any water, in two parts, and of water without swells;
 * fan_vertices.c. */
struct tp_draw_exact_waves {
    void (*evaluate_row)(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                         tp_grid_vertex *vertex);
};
struct tp_draw_exact_corners {
    void (*make_view_vertices)(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                               tp_view_vertex *to);
};
struct tp_draw_level_waves {
    struct tp_draw_fast_waves by;
};

/* The same by packed sines, for quality.normals and quality.sine = fast;
 * packed_vertices.h. */
struct tp_draw_packed_waves {
    struct tp_draw_fast_waves by;
};
struct tp_draw_table_waves {
    struct tp_draw_fast_waves by;
};

struct tp_fan_row;

/* The weights of quality.geometry = large and largest: `least` returns the displacement, m,
 * up to which a row keeps nothing of a swell; `share` the share of a swell that the row
 * keeps, 0..1.  fan_large.c. */
struct tp_draw_large_waves {
    tp_fx (*least)(const tp_grid *grid, const struct tp_fan_row *row);
    tp_fx (*share)(tp_fx least, const tp_swell *swell);
};

/* Allocates a grid of `vertices` at the most, whose slope variance is kept between frames
 * for so many swells.  A window of a streamed grid evaluates its
 * vertices again each time, with the same bits. */
void tp_grid_layout(tp_grid *grid, tp_arena *arena, uint32_t vertices, uint32_t swells,
                    bool streams);

/* The same without memory for rows, which are baked; and the memory for rows that are not. */
void tp_grid_layout_vertices(tp_grid *grid, tp_arena *arena, uint32_t vertices,
                             bool streams);
void tp_grid_layout_rows(tp_grid *grid, tp_arena *arena, uint32_t vertices,
                         uint32_t swells);

/* Returns the cells of block b of a row, without cells out of view. */
static inline tp_grid_span tp_grid_block_span(tp_grid_span span, uint32_t b)
{
    uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;

    first = first > span.first ? first : span.first;
    end = end < span.end ? end : span.end;
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* Allocates the additional tables of coastal water for a number of vertices. */
void tp_grid_layout_coastal(tp_grid *grid, tp_arena *arena, uint32_t vertices);

/* A horizontal rectangle in world coordinates, m. */
typedef struct {
    tp_fx x0, x1, z0, z1;
} tp_rectangle;

/* Rings and pools of a scene; rows of a fan are dense up to their farthest place.  The
 * numbers depend on the scene alone, so that rows do not jump when a ring begins. */
typedef struct {
    tp_fx length;               /* of the shortest waves to hold, m; 0: neither */
    tp_rectangle sides;         /* around all of them */
    const struct tp_fan_walls *walls;   /* the water ends at these sides; NULL: it does
                                         * not */
} tp_water_detail;

extern const struct tp_fan_walls tp_fan_tank;

/* Adds waves of a length in a rectangle. */
void tp_grid_detail_widen(tp_water_detail *to, int64_t length, tp_rectangle by);

/* The inputs of a grid for a frame. */
typedef struct {
    const tp_projection *projection;
    const tp_surface *surface;
    uint32_t width, height;     /* size of the picture, px */
    uint32_t vertices;          /* budget */
    tp_water_detail detail;
} tp_grid_view;

/* Places rows that are not baked; fan.c. */
struct tp_draw_grid_rows {
    void (*place)(tp_grid *grid, const tp_grid_view *view);
};

static inline bool tp_grid_vertex_is_dry(const tp_grid *grid, uint32_t i, uint32_t j)
{
    size_t at = (size_t)j * grid->cols + i;
    return grid->dry[at / 32] >> at % 32 & 1;
}

/* True if all four vertices of a visible cell are on land, so the cell has no water. */
static inline bool tp_grid_cell_is_dry(const tp_grid *grid, uint32_t i, uint32_t j)
{
    return grid->dry && grid->surface->coastal && tp_grid_vertex_is_dry(grid, i, j)
           && tp_grid_vertex_is_dry(grid, i + 1, j)
           && tp_grid_vertex_is_dry(grid, i, j + 1)
           && tp_grid_vertex_is_dry(grid, i + 1, j + 1);
}

/* tp_grid_place_rows places the rows and finds the visible cells of each row.
 * tp_grid_evaluate_row then evaluates the vertices of row j, in order from 0, and completes
 * the bounding boxes of row j - 1.  tp_grid_evaluate_vertices does both for all rows. */
void tp_grid_evaluate_vertices(tp_grid *grid, const tp_grid_view *view);
void tp_grid_begin(tp_grid *grid, const tp_grid_view *view);  /* without rows */
void tp_grid_place_rows(tp_grid *grid, const tp_grid_view *view);
void tp_grid_evaluate_row(tp_grid *grid, uint32_t j);

/* Returns a window of the caller, so that several threads can read a placed grid.
 * `memory` has tp_grid_window_bytes(most_cols, coastal) bytes; unused if vertices are
 * stored. */
tp_grid_window tp_grid_window_init(const tp_grid *grid, void *memory);
static inline size_t tp_grid_window_bytes(uint32_t cols, bool coastal)
{
    return cols * (2 * sizeof(tp_grid_vertex) + (coastal ? 3 * sizeof(tp_vec3) : 0));
}

/* Returns the bytes of a kept row of so many columns. */
static inline uint32_t tp_grid_kept_row_bytes(uint32_t cols)
{
    return (uint32_t)(sizeof(tp_grid_kept_row) + cols * sizeof(tp_grid_vertex));
}

/* Makes vertices first to end - 1 of row j available in the window.  They replace row
 * j - 2 or j + 2, and extend vertices of row j already in the window. */
void tp_grid_window_load(const tp_grid *grid, tp_grid_window *window, uint32_t j,
                         uint32_t first, uint32_t end);

/* Evaluates vertices first to end - 1 of row j again, before projection, for visible cells
 * that need clipping: to[0] is vertex `first`.  Projection and surface are those of the last
 * tp_grid_evaluate_vertices; slopes come from the row's vertices, row[0] at column 0. */
void tp_grid_make_view_vertices(const tp_grid *grid, const tp_grid_vertex *row, uint32_t j,
                                uint32_t first, uint32_t end, tp_view_vertex *to);

/* -- coastal water ------------------------------------------------------------------- */

/*
 * Each vertex of coastal water is displaced by the wave model.  Waves may break and
 * overhang, so slopes are differences between the four neighbours of a vertex.  A window
 * keeps three displaced rows, its sheets; each is evaluated once.
 */

static inline bool tp_grid_is_coastal(const tp_grid *grid)
{
    return grid->surface->coastal && grid->dry;
}

/* Returns the vertices of row j, first to end - 1, that the cells on both sides need. */
tp_grid_span tp_grid_needed_vertices(const tp_grid *grid, uint32_t j);

#endif
