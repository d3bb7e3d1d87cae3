/* SPDX-License-Identifier: MIT */
/*
 * Foam: a field of cover, one byte per cell, over rest positions of the water.  Foam
 * therefore moves with the water displaced by waves.  The cells lie on an endless
 * lattice; the lattice drifts by the scene's speed.  The field is a window of
 * cells x cells on the lattice, around the pool or the eye, stored as a torus: cell (i,
 * j) of the lattice lies in column i mod cells, row j mod cells, at any position of the
 * window.
 *
 *     foam_module.c    the module: its state, window, fading and drift
 *     foam_sources.c   the foam made in a tick
 *     foam_coast.c     the foam of coastal water
 *     foam_hull.c      the foam of a hull
 *     foam_visit.h, foam_sparse.c      a visit of rows; sources of every n-th visit
 *     foam_access.c    cover by place, and means
 *     foam_drawing.c   the data of a frame
 *     foam_stage.c     the span stages
 *     foam_fast_stage.c    cheaper span stages
 *     foam_window.c    the window's squares without cover
 *     foam_lace.c      the pattern of bubbles
 *     foam_surf.c      cover beyond the window by the depth of the floor
 *     foam_cover.h     cover beyond the window over open water
 *     foam_wide.h      the stage's loops for vector units
 */
#ifndef TP_FEATURES_FOAM_FOAM_H
#define TP_FEATURES_FOAM_FOAM_H
#include <stdint.h>
#include "pool/pool.h"
#include "shade/shade.h"
#include "tidepool/assets.h"
#include "tidepool/modules.h"
#include "waves/coastal_water.h"
#include "world/module.h"

#define TP_FOAM_TICKS 8         /* each tick visits a slice: an eighth of the rows */

/* Plain data without pointers; the cells' bytes follow this head, row by row. */
typedef struct {
    uint32_t cells;             /* cells per side, 1..256 */
    tp_fx    cell;              /* side of a cell, m */
    int64_t  drift_x, drift_z;  /* lattice origin, Q32 m, 0 to a side */
    int32_t  first_x, first_z;  /* lowest lattice cell of the window */
    int32_t  seen[TP_FOAM_TICKS][2];    /* first_x, first_z at a slice's last visit */
    uint32_t visits;            /* ticks so far */
    uint32_t sum[TP_FOAM_TICKS];        /* cover of a slice's rows at its last visit */
    uint32_t scratch;           /* byte offset of a row of positions; 0: none.  Over a map
                                 * of the floor a tp_foam_open follows the row */
    uint32_t slices;            /* 1..16: visits to one of waves and walls, the scene's at
                                 * init */
    uint32_t unused;
} tp_foam;

/* Cover of the field's cells in open water over a map of the floor, and the shares 0..256 of
 * their open water's cover that their depths leave: the mean is kept while the window has
 * none. */
typedef struct {
    uint32_t sum, count;        /* count is below TP_FOAM_OPEN_COUNT, sum at most 4 counts */
} tp_foam_open;

#define TP_FOAM_OPEN_COUNT (1u << 21)
#define TP_FOAM_OPEN_SHARE 64   /* cells of smaller shares do not count */

/* Returns the cover 0..255 at a rest position, bilinear between cell centres; 0 outside. */
uint8_t tp_foam_sample(const tp_foam *foam, tp_fx x, tp_fx z);

/* Returns the foam of a world, or NULL. */
const tp_foam *tp_world_foam(const tp_world *world);

#define TP_FOAM_ID TP_MODULE_ID('f', 'o', 'a', 'm')

/* The module's state in a world, or NULL. */
static inline tp_foam *tp_foam_of_world(const tp_world *world)
{
    return tp_world_module_state(world, TP_FOAM_ID);
}

/* Adds a round patch of `radius` m around a rest position; `cover` 0..255 is its centre
 * value. */
void tp_foam_add_blob(tp_foam *foam, tp_fx x, tp_fx z, tp_fx radius, uint32_t cover);

static inline uint8_t *tp_foam_cover(tp_foam *foam)
{
    return (uint8_t *)(foam + 1);
}

/* Returns i mod n, not negative for either sign of i. */
static inline uint32_t tp_foam_mod(int32_t i, uint32_t n)
{
    int32_t m = i % (int32_t)n;
    return (uint32_t)(m < 0 ? m + (int32_t)n : m);
}

/* Returns the mean cover of the field, 0..255 in Q8, as of each slice's last visit; over a
 * map of the floor the mean of its open water. */
uint32_t tp_foam_mean(const tp_foam *foam);
uint32_t tp_foam_open_mean(const tp_foam *foam, const tp_world *world);

/* Returns the coast of a world with a map of the floor, where foam goes on beyond the
 * window by depth; else NULL. */
const tp_coastal_water *tp_foam_map(const tp_world *world);

/* Returns e^(-8 / 60 / fade), Q24, the share of cover kept by a visit; a fade of 0.1 s or
 * more. */
uint32_t tp_foam_kept_share(tp_fx fade_seconds);

static inline tp_foam_open *tp_foam_open_water(const tp_foam *foam)
{
    return (tp_foam_open *)((uintptr_t)foam + foam->scratch
                            + foam->cells * sizeof(tp_vec3));
}

/* -- foam_sources.c ------------------------------------------------------------------ */

/* A hull over rest positions: alpha from stern -1 to bow 1, beta to starboard. */
typedef struct {
    tp_fx x, z, foam_radius;    /* middle, and farthest foam of the hull, m */
    tp_fx along[2], across[2];  /* gradients of alpha and beta, 1/m */
    tp_fx length, beam;         /* half lengths, m */
    tp_fx pace;                 /* speed ahead over PACE, -1..1 */
} tp_foam_hull;

/* The foam sources in this tick, and the row being asked for. */
typedef struct {
    const tp_wave_models *by;
    const tp_world *world;
    const tp_scene *scene;
    const tp_coastal_water *coastal;
    const tp_pool *pool;        /* a pool with walls that make foam */
    tp_foam *foam;
    tp_fx    z;                 /* z of the row, m; set by the caller */
    tp_vec3  left;              /* coastal: position of the last cell */
    tp_fx    per_cell, per_shore, deep, per_deep;
    int64_t  per_lsb;           /* speed of one LSB of the pool, m/s, Q32 */
    bool     has_hull;
    tp_foam_hull hull;
} tp_foam_maker;

#define TP_FOAM_DRY UINT32_MAX

void tp_foam_maker_begin(tp_foam_maker *m, tp_foam *foam, const tp_wave_models *by,
                         const tp_world *world, const tp_scene *scene);

/* Returns the cover gained by the cell at x in TP_FOAM_TICKS ticks, in 1/256 of a byte's
 * units, below 2^16; or TP_FOAM_DRY for a dry cell.  Ask for the cells of a row in order
 * of columns.  `after_neighbour`: the last cell was the neighbour at x - cell. */
uint32_t tp_foam_maker_gain(tp_foam_maker *m, uint32_t col, tp_fx x, bool after_neighbour);

#define TP_FOAM_GAIN_MOST 0xff00u

/* Returns share x units of cover in 1/256 units, clamped to 0..TP_FOAM_GAIN_MOST.  `share` is
 * 16.16. */
static inline uint32_t tp_foam_scale_gain(tp_fx share, int32_t units)
{
    int64_t gain = (int64_t)share * units >> 8;
    return gain < 0 ? 0 : gain > TP_FOAM_GAIN_MOST ? TP_FOAM_GAIN_MOST : (uint32_t)gain;
}

/* The gains apart: waves here, others in foam_visit.h.  A coastal wave's gain in open water is
 * that of its swells without wind. */
bool     tp_foam_maker_has_waves(const tp_foam_maker *m);       /* false: no wave foams */
uint32_t tp_foam_maker_wave_gain(const tp_foam_maker *m, tp_fx x);
uint32_t tp_foam_deep_gain(const tp_foam_maker *m, tp_fx x);    /* of swells */
uint32_t tp_foam_crest_gain(const tp_foam_maker *m, tp_fx jacobian);

/* True if none of the bytes has cover. */
bool tp_foam_is_empty(const uint8_t *cover, size_t bytes);

/* Coastal water only.  Returns the mean cover 0..255 of water at a depth, m, by breaking
 * and by the shore.  `visits`: age of the foam in visits of a cell; the mean grows with it
 * from 0 on.  tp_foam_maker_open_share returns the share 0..256 of the cover of open water
 * that is left there. */
uint32_t tp_foam_maker_mean_cover(const tp_foam_maker *m, tp_fx depth, uint32_t visits);
uint32_t tp_foam_maker_open_share(const tp_foam_maker *m, tp_fx depth);

/* -- data of the stages, in tp_run.mine ---------------------------------------------- */

enum { TP_FOAM_BEACH = 1, TP_FOAM_DEPTH };

struct tp_shade_foam;

/* Returns the cover 0..255 beyond the window over a floor, at sample i of a run; v as in
 * foam_cover.h. */
typedef uint32_t tp_foam_floor_cover(const struct tp_shade_foam *f, const tp_run *run,
                                     int32_t i, uint32_t v);

typedef struct tp_shade_foam {
    const uint8_t *cover;       /* torus of cells x cells bytes */
    uint32_t cells, col, row;   /* cells per side; cell before the low corner's cell */
    tp_fx    low_s, low_t;      /* rest position of the low corner, m */
    uint32_t side;              /* side of the window, m, 16.16 */
    uint64_t per_metre;         /* cells per metre, Q16 over 16.16, Q32 */
    uint32_t edge;              /* 2^40 over 7/16 of the squared radius, cells Q8;
                                 * UINT32_MAX: no fading, walls at the window's edge */
    uint32_t colour;
    uint32_t far_fresh;         /* cover of crests beyond the window, Q8, below 90000; 0: no
                                 * foam there */
    uint32_t far_old;           /* cover of other water there, 0..255 */
    uint32_t per_square;        /* 1 over the mean square of the slope, Q32 over Q24 */
    int32_t  way_x, way_z;      /* unit vector of the waves' mean way, Q14 */
    int32_t  shore_x, shore_z;  /* straight beach: its direction, Q14 */
    int32_t  stretch;           /* length of beach that repeats, m, 16.16 */
    const tp_texture *texture;  /* NULL: no texture */
    uint32_t repeats, drift_s, drift_t;     /* as in tp_layer */
    uint32_t wide_repeats, wide_drift_s, wide_drift_t;  /* four times as large */
    int32_t  lod;
    int16_t  mean;              /* rank of the texture's mean */
    uint16_t floor;             /* foam beyond the window over a floor, if far_fresh is 0:
                                 * 0 none, TP_FOAM_BEACH, or TP_FOAM_DEPTH by the
                                 * tp_foam_surf that follows */
    tp_foam_floor_cover *floor_cover;       /* if `floor` is not 0 */
    bool     none;              /* no foam in this picture */
    bool     has_surf;          /* true: a tp_foam_surf follows */
    uint32_t square;            /* log2 of the cells along a square; 0: none is known */
    uint32_t empty[32];         /* bit i of word j: the stored cells of the square (i, j)
                                 * have no cover */
    tp_entry8 rank[256];         /* share of darker texels, by green, 0..255 */
} tp_shade_foam;

/* Foam beyond the window by the depth of the floor, a map or a plane.  Means at the depths
 * of the tables of coastal water, and cover of its open water as in tp_shade_foam. */
typedef struct {
    tp_fx    depth;             /* a plane: its depth at the origin, m, ... */
    int32_t  rise_x, rise_z;    /* ... and its rise, Q30 */
    const tp_coastal_floor_node *node;      /* the map's, row by row; NULL: a plane */
    uint32_t cols;
    tp_fx    map_x, map_z;      /* its north-west node, m, ... */
    uint32_t last_x, last_z;    /* ... and the way to the last node, m, 16.16, less one unit */
    uint32_t per_step;          /* nodes per metre, Q16 over 16.16, Q24 */
    tp_fx    deepest;           /* depth from which on there is no foam, m */
    uint32_t open_fresh, open_old;
    uint32_t per_slope;         /* 2^23 over the root of the waves' mean square, Q12 */
    int32_t  swing;             /* share of the mean that waves add and take, 0..256 */
    uint8_t  mean[TP_COASTAL_DEPTHS], open[TP_COASTAL_DEPTHS];  /* open: share, 0..255 */
} tp_foam_surf;

typedef struct {
    tp_shade_foam foam;
    tp_foam_surf  surf;
} tp_shade_foam_surf;

/* Sets the data of surf; way and per_square of `foam` are set. */
void tp_foam_surf_begin(tp_shade_foam_surf *foam, const tp_foam *field,
                        const tp_wave_models *by, const tp_world *world,
                        const tp_scene *scene);

/* name; slopes bent by a ripple, 2: packed by fast stages; glint below the foam */
#define TP_FOAM_STAGES(X) \
    X(foam,                 0, 0) \
    X(foam_rippled,         1, 0) \
    X(foam_shiny,           0, 1) \
    X(foam_shiny_rippled,   1, 1) \
    X(foam_packed,          2, 0)

/* Cheaper stages: name, lace, glint below the foam */
#define TP_FOAM_FAST_STAGES(X) \
    X(foam_fast,            1, 0) \
    X(foam_fast_shiny,      1, 1) \
    X(foam_plain,           0, 0) \
    X(foam_plain_shiny,     0, 1)

/* Words of the row quality.foam after `exact` */
enum { TP_FOAM_FAST = TP_RUNG_FAST, TP_FOAM_PLAIN };

/* Fills `rank`.  With ranks every texture turns white by the share of the cover. */
void tp_shade_foam_make_ranks(tp_shade_foam *foam, const tp_texture *texture);

/* -- parameters ---------------------------------------------------------------------- */

#define TP_FOAM_ROWS \
    TP_ROW_COUNT("foam.cells", foam.cells, "cells", 0, 256, 0, \
        "cells along a side of the foam field; 0: no foam"), \
    TP_ROW_COUNT("foam.slices", foam.slices, "", 1, 16, 1, \
        "waves and walls foam at every n-th visit of a cell, for less cost"), \
    TP_ROW_NUMBER("foam.cell", foam.cell, "m", 0.01, 50, 0.5, "side of a cell"), \
    TP_ROW_NUMBER("foam.crest", foam.crest, "", 0, 2, 0.6, \
        "crests whose Jacobian is below this value foam; 0: none"), \
    TP_ROW_NUMBER("foam.breaking", foam.breaking, "", 0, 2, 1, \
        "strength of foam on breaking crests"), \
    TP_ROW_NUMBER("foam.shore", foam.shore, "m", 0, 20, 0.3, \
        "moving water shallower than this foams"), \
    TP_ROW_NUMBER("foam.wall", foam.wall, "", 0, 2, 0.5, \
        "strength of foam from water that moves along walls"), \
    TP_ROW_NUMBER("foam.hull", foam.hull, "", 0, 2, 0.5, \
        "strength of foam around and behind the boat"), \
    TP_ROW_NUMBER("foam.fade", foam.fade, "s", 0.1, 600, 4, \
        "time in which foam fades to about a third"), \
    TP_ROW_MAP("foam", foam.map, 4, "PNG of the bubbles; empty: plain foam"), \
    TP_ROW_COLOUR("foam.colour", foam.colour, 0xf4f8fa, "colour of foam in full light")

#endif
