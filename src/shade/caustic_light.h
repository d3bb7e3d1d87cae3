/* SPDX-License-Identifier: MIT */
/* Light of a caustics map (tp_caustic in optics.h) at a point of a floor or a wall. */
#ifndef TP_SHADE_CAUSTIC_LIGHT_H
#define TP_SHADE_CAUSTIC_LIGHT_H
#include "shade/optics.h"

/* Coordinate on the caustics map in cells, 16.16, mirrored at the map's edges and clamped
 * to the range between the centres of the first and the last cell. */
static inline int32_t mirrored_map_coordinate(int64_t metres, uint32_t per_metre,
                                              uint32_t cells)
{
    int64_t at = metres * (int64_t)per_metre >> 16, side = (int64_t)cells * 65536;

    at = at < 0 ? -at : at > side ? 2 * side - at : at;
    at -= 0x8000;
    return (int32_t)(at < 0 ? 0 : at > side - 65536 ? side - 65536 : at);
}

/* Returns the fade at the map's edges: 0 at an edge, 256 from an eighth of the side on. */
static inline int32_t map_edge_fade(int32_t at, uint32_t cells)
{
    int32_t last = (int32_t)(cells - 1) * 65536, edge = at < last - at ? at : last - at;
    int32_t share = edge / (int32_t)(cells * 32);
    return share < 256 ? share : 256;
}

/* Returns the caustics' factor of the sunlight on a floor or a wall, 256 is 1. */
static inline int32_t caustic_sample(const tp_caustic *c, tp_vec3 at)
{
    if (at.y >= 0)
        return 256;
    int64_t x = (int64_t)at.x - c->x - ((int64_t)c->lean_x * at.y >> 14);
    int64_t z = (int64_t)at.z - c->z - ((int64_t)c->lean_z * at.y >> 14);
    int32_t u = mirrored_map_coordinate(x, c->per_metre_x, c->cells);
    int32_t v = mirrored_map_coordinate(z, c->per_metre_z, c->cells);
    uint32_t i = (uint32_t)u >> 16, j = (uint32_t)v >> 16, n = c->cells;
    uint32_t right = i + 1 < n ? 1 : 0, below = j + 1 < n ? n : 0;
    const uint16_t *cell = c->light + j * n + i;
    int32_t fu = u >> 8 & 0xff, fv = v >> 8 & 0xff;
    int32_t top = cell[0] * (256 - fu) + cell[right] * fu;
    int32_t low = cell[below] * (256 - fu) + cell[below + right] * fu;
    int32_t light = (top >> 8) + (((low >> 8) - (top >> 8)) * fv >> 8);
    int64_t deep = -(int64_t)at.y * c->per_depth >> 16;
    int32_t share = c->strength * (int32_t)(deep < 256 ? deep : 256) >> 8;

    if (c->fades) {
        int32_t eu = map_edge_fade(u, n), ev = map_edge_fade(v, n);
        share = share * (eu < ev ? eu : ev) >> 8;
    }
    light = 256 + ((light - 256) * share >> 8);
    return light > 0 ? light : 0;
}

#endif
