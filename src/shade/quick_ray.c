/* SPDX-License-Identifier: MIT */
/* View rays of the fast stages; see quick_ray.h. */
#include "shade/quick_ray.h"

tp_quick_row tp_quick_row_make(const tp_shade *shade, int32_t y)
{
    const tp_view_axes *a = &shade->world;
    int32_t v = tp_quick_over_focal(shade, shade->v0 - 16 * y - 8);

    return (tp_quick_row){
        (a->back.x >> 16) - (v * (a->up.x >> 16) >> 14),
        (a->back.y >> 16) - (v * (a->up.y >> 16) >> 14),
        (a->back.z >> 16) - (v * (a->up.z >> 16) >> 14),
        (uint32_t)v * (uint32_t)v >> 4,
    };
}

tp_ray tp_quick_ray(const tp_shade *shade, const tp_quick_row *row, int32_t sixteenths)
{
    return tp_quick_ray_inline(shade, row, sixteenths);
}
