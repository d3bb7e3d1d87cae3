/* SPDX-License-Identifier: MIT */
/* The five-height normal by central differences, [A6] of the models.  Four triangles meet
 * at a point.  The sum of their normals, before normalisation, contains exactly the central
 * differences: N = (h(x-d) - h(x+d), 2d, h(z-d) - h(z+d)). */
#include "base/assert.h"
#include "wave/wave.h"

tp_relief tp_neighbour_relief(tp_fx middle, const tp_fx around[4], tp_fx spacing)
{
    TP_ASSERT(spacing > 0 && spacing < 8192 * TP_FX_ONE);
    return (tp_relief){
        middle,
        tp_fx_div(around[1] - around[0], 2 * spacing),
        tp_fx_div(around[3] - around[2], 2 * spacing),
    };
}

tp_dir3 tp_neighbour_normal(const tp_fx around[4], tp_fx spacing)
{
    TP_ASSERT(spacing > 0 && spacing < 8192 * TP_FX_ONE);
    return tp_normalise(around[0] - around[1], 2 * spacing, around[2] - around[3]);
}
