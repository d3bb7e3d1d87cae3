/* SPDX-License-Identifier: MIT */
/* Rings of droplets [A4] [A5] and cells of pools in double precision, as heights over a
 * place of the world. Rings and cells are read from the world, which evolves them. A ring
 * is evaluated by its formula; a pool is bilinear between cell centres as defined in
 * pool/pool.h, and a cell's slope is the difference of its two neighbours. If
 * water.pool_normal_strength is above 0, the slopes of pools times that strength are kept
 * separate. */
#ifndef TP_TOOLS_REFERENCE_RELIEF_H
#define TP_TOOLS_REFERENCE_RELIEF_H
#include <stdbool.h>
#include "tidepool/world.h"

typedef struct {
    double x, z;                /* centre, m */
    double length, crest;       /* wavelength L and crest radius rc, m */
    double gain, spread;        /* amplitude A0 smoothstep exp, m; rho0, m */
} ref_ring;

typedef struct {
    int     cols, rows;
    bool    tiled;
    double  cell, x, z;         /* side of a cell; north-west corner; m */
    double *height;             /* m; a wall has the mean of the open cells beside it, or
                                 * NAN deep inside a wall */
    bool   *wall;
} ref_cells;

typedef struct {
    ref_ring *ring;
    int       rings;
    ref_cells cells[2];         /* pool and field; cols 0: none */
    double    high, steep;      /* bounds of height and slope */
    double    fine;             /* width of the narrowest feature, m */
    double    bump;             /* > 0: cells bend normals by this factor, lift nothing */
} ref_relief;

typedef struct {
    double height, slope_x, slope_z;
    double bump_x[2], bump_z[2];    /* slopes of cells that lift nothing */
} ref_heights;

/* Reads rings and cells of the world; world->back: fraction of a tick before the last
 * tick. */
ref_relief  ref_relief_make(const tp_world *world, double bump);
void        ref_relief_free(ref_relief *relief);
ref_heights ref_relief_sample(const ref_relief *relief, double x, double z);
#endif
