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

/* Visits a row, number `number` of the lattice, of a scene of several slices; returns the
 * sum of its cover. */
uint32_t tp_foam_visit_row_sparsely(tp_foam_visit *v, const tp_foam *foam, uint8_t *cover,
                                    int32_t number);

#endif
