/* SPDX-License-Identifier: MIT */
/* Rings of droplets [A4] [A5] and pools of cells, in double precision: heights over a
 * place of the world.  Cells and rings are read from the world, which alone evolves
 * them; a ring is evaluated by its formula, a pool bilinear between its cells' centres
 * as pool/pool.h says, with a cell's slope that of its two neighbours.  Where
 * water.pool_bump is above 0 their slopes, times that, are told apart. */
#ifndef TP_REFERENCE_RELIEF_H
#define TP_REFERENCE_RELIEF_H
#include <stdbool.h>
#include "tidepool/world.h"

typedef struct {
    double x, z;                /* centre, m */
    double length, crest;       /* L and rc, m */
    double gain, spread;        /* A0 smoothstep exp, m; rho0, m */
} ref_ring;

typedef struct {
    int     cols, rows;
    bool    tiled;
    double  cell, x, z;         /* m: side, and the north-west corner */
    double *height;             /* m; of a wall the mean of the open cells beside it, or
                                   NAN deep inside */
    bool   *wall;
} ref_cells;

typedef struct {
    ref_ring *ring;
    int       rings;
    ref_cells cells[2];         /* pool and field; cols 0: none */
    double    high, steep;      /* bounds of height and slope */
    double    fine;             /* m: nothing is narrower */
    double    bump;             /* > 0: cells bend slopes, so much, and lift nothing */
} ref_relief;

typedef struct {
    double height, slope_x, slope_z;
    double bump_x[2], bump_z[2];    /* slopes of cells that lift nothing */
} ref_heights;

/* The world's, world->back of a tick before its last one. */
ref_relief  ref_relief_of(const tp_world *world, double bump);
void        ref_relief_free(ref_relief *relief);
ref_heights ref_relief_at(const ref_relief *relief, double x, double z);
#endif
