/* SPDX-License-Identifier: MIT */
/* The five-height normal by central differences, [A6] of the models.  Four triangles meet
 * at a point.  The sum of their normals, before normalisation, contains exactly the central
 * differences: N = (h(x-d) - h(x+d), 2d, h(z-d) - h(z+d)). */
#include "base/assert.h"
#include "wave/wave.h"

tp_height_slope tp_neighbour_height_slope(tp_fx middle, const tp_fx neighbours[4],
                                          tp_fx spacing)
{
    TP_ASSERT(spacing > 0 && spacing < 8192 * TP_FX_ONE);
    return (tp_height_slope){
        middle,
        tp_fx_div(neighbours[1] - neighbours[0], 2 * spacing),
        tp_fx_div(neighbours[3] - neighbours[2], 2 * spacing),
    };
}

tp_dir3 tp_neighbour_normal(const tp_fx neighbours[4], tp_fx spacing)
{
    TP_ASSERT(spacing > 0 && spacing < 8192 * TP_FX_ONE);
    return tp_normalise(neighbours[0] - neighbours[1], 2 * spacing,
                        neighbours[2] - neighbours[3]);
}
