/* SPDX-License-Identifier: MIT */
/* Bilinear look-up in a planar map of half the picture's size. */
#ifndef TP_SHADE_HALF_H
#define TP_SHADE_HALF_H
#include "shade/shade.h"

/* Returns a pixel of the map; 0 outside of the map's box. */
static inline uint32_t tp_planar_map_pixel(const tp_planar_map *map, int32_t i, int32_t j)
{
    if (i < map->x0 || i >= map->x1 || j < map->y0 || j >= map->y1)
        return 0;
    return map->colour[(size_t)(uint32_t)(j - map->y0)
                        * (uint32_t)(map->x1 - map->x0) + (uint32_t)(i - map->x0)];
}

/* Samples the map at (u, v) of the whole picture, 28.4.  The result is premultiplied by
 * its alpha, because uncovered pixels are 0. */
static inline uint32_t tp_planar_map_sample(const tp_planar_map *map, int32_t u, int32_t v)
{
    int32_t i = (u - 16) >> 5, j = (v - 16) >> 5;
    uint32_t fu = (uint32_t)(u - 16) & 31, fv = (uint32_t)(v - 16) & 31;

    if (i < map->x0 - 1 || i >= map->x1 || j < map->y0 - 1 || j >= map->y1)
        return 0;
    return tp_argb_mix_32(tp_argb_mix_32(tp_planar_map_pixel(map, i, j),
                                         tp_planar_map_pixel(map, i + 1, j), fu),
                          tp_argb_mix_32(tp_planar_map_pixel(map, i, j + 1),
                                         tp_planar_map_pixel(map, i + 1, j + 1), fu),
                          fv);
}
#endif
