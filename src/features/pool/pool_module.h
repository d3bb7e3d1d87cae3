/* SPDX-License-Identifier: MIT */
/*
 * Pools of a scene, their paddle and their parameters.  The wave equation is in the
 * folder of the pools' cells.
 */
#ifndef TP_FEATURES_POOL_POOL_MODULE_H
#define TP_FEATURES_POOL_POOL_MODULE_H
#include "pool/pool.h"
#include "tidepool/modules.h"
#include "world/pools.h"

/* Pushes the water by the paddle for one tick.  `scene` must be the parameters of
 * `pool`. */
void tp_paddle_push(tp_pool *pool, const tp_scene_pool *scene, uint64_t tick);

#define TP_ROW_POOL(name, part) \
    TP_ROW_COUNT(name ".cols", part.cols, "cells", 0, 512, 0, \
        "cells along x, 16 or more; 0: no pool"), \
    TP_ROW_COUNT(name ".rows", part.rows, "cells", 16, 512, 64, "cells along z"), \
    TP_ROW_CHOICE(name ".cell_bits", part.cell_bits, "8|16|32", TP_CELLS_32, TP_CELLS_16, \
        "bits of a cell: 8 saves memory, 32 keeps volume and detail"), \
    TP_ROW_CHOICE(name ".boundary", part.boundary, "wall|sponge|tile", TP_EDGES_TILE, \
        TP_EDGES_WALL, \
        "reflect waves, absorb them, or continue at the opposite edge"), \
    TP_ROW_NUMBER(name ".courant", part.courant, "", 0.05, 0.8, 0.484, \
        "Courant number: cells a wave travels in a tick, up to about 0.49"), \
    TP_ROW_CHOICE(name ".interval", part.interval, "1|2|4", 2, 0, \
        "ticks to a step of the cells; their Courant number: interval * courant"), \
    TP_ROW_COUNT(name ".damping", part.damping, "", 4, 10, 6, \
        "m: each tick removes 2^-m of the motion; lower m damps more"), \
    TP_ROW_COUNT(name ".sponge", part.sponge, "cells", 4, 64, 16, \
        "width of a sponge edge"), \
    TP_ROW_NUMBER(name ".max_height", part.max_height, "m", 0.01, 64, 1, \
        "greatest water height in 8- and 16-bit cells"), \
    TP_ROW_NUMBER(name ".cell", part.cell, "m", 0.01, 50, 0.25, "side of a cell"), \
    TP_ROW_NUMBER(name ".x", part.x, "m", -8000, 8000, 0, \
        "centre of the pool, to the right of the origin"), \
    TP_ROW_NUMBER(name ".z", part.z, "m", -8000, 8000, 0, \
        "centre of the pool, from the origin towards the viewer"), \
    TP_ROW_NUMBER(name ".drive_min", part.drive_min, "m", 0, 16, 0, \
        "rms height below which a splash is added; 0: never"), \
    TP_ROW_NUMBER(name ".drive_max", part.drive_max, "m", 0, 16, 0, \
        "rms height above which added splashes get smaller"), \
    TP_ROW_NUMBER(name ".drive_amplitude", part.drive_amplitude, "m", 0, 16, 0.1, \
        "height of an added splash"), \
    TP_ROW_NUMBER(name ".splash_interval", part.splash_interval, "s", 0, 600, 0, \
        "time between splashes at random places; 0: none"), \
    TP_ROW_NUMBER(name ".splash_height", part.splash_height, "m", -16, 16, 0.2, \
        "height of a splash at a random place"), \
    TP_ROW_NUMBER(name ".splash_width", part.splash_width, "m", 0.01, 50, 0.5, \
        "width of a splash at a random place, sigma"), \
    TP_ROW_NUMBER(name ".paddle", part.paddle, "m", 0, 16, 0, \
        "height of waves that a paddle makes at the north edge; 0: none"), \
    TP_ROW_NUMBER(name ".paddle_period", part.paddle_period, "s", 0.1, 60, 2, \
        "period of the paddle's waves"), \
    TP_ROW_NAME(name ".mask", part.mask, GREY, \
        "PNG over the pool, dark cells are walls; empty: none")

#define TP_POOL_ROWS \
    TP_ROW_POOL("pool", pool), \
    TP_ROW_POOL("field", field)

#endif
