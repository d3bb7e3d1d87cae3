/* SPDX-License-Identifier: MIT */
/* Parameter rows of a pool, and of a second pool, the field. */
#ifndef TP_POOL_ROWS_H
#define TP_POOL_ROWS_H
#include "tidepool/modules.h"

#define TP_ROW_POOL(name, part) \
    TP_ROW_COUNT(name ".cols", part.cols, "cells", 0, 512, 0, \
        "along x, 16 or more; 0: no such pool"), \
    TP_ROW_COUNT(name ".rows", part.rows, "cells", 16, 512, 64, "along z"), \
    TP_ROW_CHOICE(name ".cells", part.cells, "8|16|32", TP_CELLS_32, TP_CELLS_16, \
        "bits of a cell: 8 save memory, 32 keep volume and detail"), \
    TP_ROW_CHOICE(name ".edges", part.edges, "wall|sponge|tile", TP_EDGES_TILE, \
        TP_EDGES_WALL, \
        "reflect waves, swallow them, or go on at the other side for ever"), \
    TP_ROW_NUMBER(name ".courant", part.courant, "", 0.05, 0.8, 0.484, \
        "cells that a wave goes in a tick, 0.49 at the most"), \
    TP_ROW_COUNT(name ".damping", part.damping, "", 4, 10, 6, \
        "m: a tick takes 2^-m of the motion; less comes to rest sooner"), \
    TP_ROW_COUNT(name ".sponge", part.sponge, "cells", 4, 64, 16, \
        "width of a sponge edge"), \
    TP_ROW_NUMBER(name ".range", part.range, "m", 0.01, 64, 1, \
        "highest water of 8- and 16-bit cells"), \
    TP_ROW_NUMBER(name ".cell", part.cell, "m", 0.01, 50, 0.25, "side of a cell"), \
    TP_ROW_NUMBER(name ".x", part.x, "m", -8000, 8000, 0, \
        "of its centre, to the right"), \
    TP_ROW_NUMBER(name ".z", part.z, "m", -8000, 8000, 0, \
        "of its centre, towards the viewer"), \
    TP_ROW_NUMBER(name ".feed_low", part.feed_low, "m", 0, 16, 0, \
        "rms height under which it is fed with hats; 0: never"), \
    TP_ROW_NUMBER(name ".feed_high", part.feed_high, "m", 0, 16, 0, \
        "rms height above which it is not"), \
    TP_ROW_NUMBER(name ".feed", part.feed, "m", 0, 16, 0.1, "height of such a hat"), \
    TP_ROW_NUMBER(name ".poke_every", part.poke_every, "s", 0, 600, 0, \
        "between hats at random places; 0: none"), \
    TP_ROW_NUMBER(name ".poke", part.poke, "m", -16, 16, 0.2, "height of such a hat"), \
    TP_ROW_NUMBER(name ".poke_size", part.poke_size, "m", 0.01, 50, 0.5, \
        "its width, sigma"), \
    TP_ROW_NUMBER(name ".paddle", part.paddle, "m", 0, 16, 0, \
        "height of waves that a paddle makes at its north edge; 0: none"), \
    TP_ROW_NUMBER(name ".paddle_period", part.paddle_period, "s", 0.1, 60, 2, \
        "of such waves"), \
    TP_ROW_NAME(name ".mask", part.mask, GREY, \
        "PNG laid over it, dark is wall; empty: none")

#define TP_POOL_ROWS \
    TP_ROW_POOL("pool", pool), \
    TP_ROW_POOL("field", field)
#endif
