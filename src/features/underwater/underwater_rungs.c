/* SPDX-License-Identifier: MIT */
/* Cost estimate of caustics: each cell of the map, over a tank's floor or the sea floor. */
#include "features/underwater/underwater.h"
#include "quality/fixed_cost.h"
#include "world/pools.h"

static void count_work(tp_site *w)
{
    const uint32_t cells = (uint32_t)w->scene->water.caustic_cells;
    const int way = tp_has_tank(w->scene) ? TP_WORK_caustic_pool : TP_WORK_caustic_sea;

    w->fixed_cost.of[way] = cells * cells;
}

const tp_cost tp_caustics_cost = { .work = count_work };
