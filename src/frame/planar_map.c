/* SPDX-License-Identifier: MIT */
/* Planar maps; see planar_map.h. */
#include "frame/planar_map.h"

void tp_planar_layout(tp_planar_memory *store, tp_arena *arena, const tp_want *want,
                      uint32_t halvings)
{
    TP_ASSERT(want->width >= 16 && want->height >= 16);
    store->halvings = halvings;
    store->cols = (want->width + (1u << halvings) - 1) >> halvings;
    store->rows = (want->height + (1u << halvings) - 1) >> halvings;
    store->colour = tp_arena_alloc(arena, (size_t)store->cols * store->rows,
                                  sizeof *store->colour);
    store->samples = tp_arena_alloc(arena, (size_t)store->cols * TP_PLANAR_BAND,
                                    4 * sizeof *store->samples);
}

bool tp_planar_set_bounds(const tp_planar_memory *store, const tp_grid_box *box,
                          tp_planar_map *map)
{
    TP_ASSERT(store->colour != NULL);
    int32_t cols = (int32_t)store->cols, rows = (int32_t)store->rows;

    *map = (tp_planar_map){
        store->colour, tp_clamp(box->x0, 0, cols), tp_clamp(box->y0, 0, rows),
        tp_clamp(box->x1 + 1, 0, cols), tp_clamp(box->y1 + 1, 0, rows),
        (int32_t)store->halvings - 1,
    };
    if (map->x0 < map->x1 && map->y0 < map->y1)
        return true;
    map->colour = NULL;
    return false;
}

tp_gbuffer tp_planar_gbuffer(const tp_planar_memory *store, const tp_planar_map *map,
                             int32_t y0)
{
    size_t plane = (size_t)store->cols * TP_PLANAR_BAND;
    int32_t y1 = y0 + TP_PLANAR_BAND < map->y1 ? y0 + TP_PLANAR_BAND : map->y1;

    return (tp_gbuffer){ map->x0, y0, map->x1, y1, store->cols, store->samples,
                         store->samples + plane, store->samples + 2 * plane,
                         store->samples + 3 * plane, false };
}
