/* SPDX-License-Identifier: MIT */
/* A tick's visit of a slice of the field: what its rows share. */
#ifndef TP_FEATURES_FOAM_FOAM_VISIT_H
#define TP_FEATURES_FOAM_FOAM_VISIT_H
#include "base/base.h"
#include "features/foam/foam.h"

/* One axis of the window: lattice cells from `first` on; cell `first` lies in column or
 * row `seam`. */
typedef struct {
    int32_t  first;
    uint32_t seam, cells;
} tp_lattice_axis;

/* Returns the lattice cell number of a column or row. */
static inline int32_t tp_lattice_cell_number(const tp_lattice_axis *a, uint32_t col_or_row)
{
    return a->first
           + (int32_t)(col_or_row >= a->seam ? col_or_row - a->seam
                                             : col_or_row + a->cells - a->seam);
}

/* Returns the centre of a lattice cell, m. */
static inline tp_fx tp_foam_cell_centre(const tp_foam *foam, int32_t number, int64_t drift)
{
    return (tp_fx)((int64_t)number * foam->cell + foam->cell / 2 + (drift >> 16));
}

/* Gains of waves of a pair of rows, at every second cell of the window. */
typedef struct {
    bool     sources, waves;    /* true: something may foam beside hulls; waves may */
    bool     ready;             /* the gains of `pair` are set */
    int32_t  pair;
    uint16_t gain[129];
} tp_foam_sparse;

typedef struct {
    tp_foam_maker make;
    const tp_coastal_water *map;        /* NULL: no map of the floor */
    uint32_t kept_q24, threshold_q24;
    tp_lattice_axis x, z, seen_x, seen_z;
    uint32_t slices;            /* 1..16 */
    tp_fx    low_x;             /* centre of the window's first column, m */
    tp_foam_sparse sparse;
} tp_foam_visit;

#define TP_FOAM_GOLDEN 10368889u        /* 2^24 / 1.618..., odd, so the period is 2^24 */

/* Returns the new cover of a cell.  New foam covers only the free share.
 * cover x kept < 255 x 2^24; with the threshold the sum stays below 2^32. */
static inline uint8_t tp_foam_next_cover(uint32_t cover, const tp_foam_visit *v,
                                         uint32_t col, uint32_t gain_q8)
{
    uint64_t sum = (uint64_t)cover * v->kept_q24
                 + ((uint64_t)(gain_q8 * (255 - cover)) << 8);
    uint32_t held = sum < (uint32_t)255 << 24 ? (uint32_t)sum : (uint32_t)255 << 24;
    uint32_t threshold = (v->threshold_q24 + col * TP_FOAM_GOLDEN) & 0xffffff;

    return (uint8_t)((held + threshold) >> 24);
}

/* -- parts of a program -------------------------------------------------------------- */

/* Foam of coastal water, foam_coast.c; and its cover beyond the window. */
struct tp_water_foam_coast {
    /* tp_foam_maker_gain and tp_foam_maker_wave_gain, without other sources. */
    uint32_t (*gain)(tp_foam_maker *m, uint32_t col, tp_fx x, bool after_neighbour);
    uint32_t (*wave_gain)(const tp_foam_maker *m, tp_fx x);
    /* Prepares the displaced positions of the row at m->z - cell.  Call once for each cell
     * of a row before asking for the row, unless the last row was the neighbour at
     * z - cell. */
    void (*sample_previous_row)(tp_foam_maker *m, uint32_t col, tp_fx x);
    /* Over a map of the floor: gives the cells of a row that enter the window the mean, so
     * the window shows no edge when it moves.  `seen`: the window of the last visit; `all`:
     * the row enters. */
    void (*fill_entering_cells)(const tp_foam_visit *v, const tp_foam *foam, uint8_t *cover,
                                const tp_lattice_axis *seen, bool all);
    /* Over a map: adds every sixteenth cell of a row that lies in open water. */
    void (*count_open_water)(const tp_foam_visit *v, tp_foam *foam, const uint8_t *cover);
    void (*begin_surf)(tp_shade_foam_surf *foam, const tp_foam *field,
                       const tp_wave_models *by, const tp_world *world,
                       const tp_scene *scene);
    /* Sets the direction of a straight beach, and its cover, near the window. */
    void (*set_shore)(tp_shade_foam *f, const tp_scene *scene);
};

/* Foam along the walls of a pool, foam_sources.c. */
struct tp_water_foam_walls {
    void (*begin)(tp_foam_maker *m);
    /* TP_FOAM_DRY inside a wall, 0 outside of the pool. */
    uint32_t (*gain)(const tp_foam_maker *m, tp_fx x);
};

/* Foam of a hull, foam_hull.c. */
struct tp_water_foam_hull {
    void (*find)(tp_foam_maker *m);         /* in rest positions */
    uint32_t (*gain)(const tp_foam_maker *m, tp_fx x);
};

/* Sets the cells from..to, counted from the cell at x, that the hull may reach in the row;
 * false: none. */
bool tp_foam_maker_hull_range(const tp_foam_maker *m, tp_fx x, uint32_t *from, uint32_t *to);

/* Foam where drops fall, foam_access.c. */
struct tp_water_foam_splashes {
    void (*add)(tp_foam *foam, tp_fx x, tp_fx z, tp_fx radius, uint32_t cover);
};

/* Visits a row, number `number` of the lattice, of a scene of several slices; returns the
 * sum of its cover. */
struct tp_water_foam_slices {
    uint32_t (*visit_row)(tp_foam_visit *v, const tp_foam *foam, uint8_t *cover,
                          int32_t number);
};

#endif
