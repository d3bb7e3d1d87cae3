/* SPDX-License-Identifier: MIT */
/* Pools for tidepool check. */
#ifndef TP_TOOLS_CHECK_CHECK_POOL_H
#define TP_TOOLS_CHECK_CHECK_POOL_H
#include "check.h"
#include "pool/pool.h"

typedef struct {
    tp_cells cells;
    uint32_t cols, rows, damping;
    tp_fx    courant;
    const tp_grey *mask;
} check_pool_shape;

/* Returns a pool at rest between walls: cells of 1/4 m, heights within 1 m.  Returns NULL
 * if the core refuses the shape.  The caller frees the pool. */
tp_pool *check_pool_make(const check_pool_shape *shape);

/* Prints that the pool of a row is refused; returns EXIT_INPUT. */
int check_pool_refuse(const check_run *run, unsigned row, const check_pool_shape *shape);
#endif
