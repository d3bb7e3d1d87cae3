/* SPDX-License-Identifier: MIT */
/* Grids in memory of exact size. */
#ifndef TP_TESTS_LIB_GRIDS_H
#define TP_TESTS_LIB_GRIDS_H
#include <stdlib.h>
#include <string.h>
#include "view/grid.h"

static inline void grid_carve(tp_grid *grid, tp_arena *arena, uint32_t vertices,
                              bool coastal)
{
    tp_grid_layout(grid, arena, vertices, TP_WAVES, false);
    grid->exact_waves = &tp_draw_exact_waves;
    grid->exact_corners = &tp_draw_exact_corners;
    if (coastal)
        tp_grid_layout_coastal(grid, arena, vertices);
}

/* Carves a grid, for coastal water or deep water, from a block of exact size, filled with
 * 0xa5 before; the caller frees the block. */
static inline void *grid_block(tp_grid *grid, uint32_t vertices, bool coastal)
{
    tp_arena count = tp_arena_init(NULL, 0);

    grid_carve(grid, &count, vertices, coastal);
    void *block = malloc(count.used);
    assert_non_null(block);
    memset(block, 0xa5, count.used);
    tp_arena arena = tp_arena_init(block, count.used);
    grid_carve(grid, &arena, vertices, coastal);
    assert_false(arena.failed);
    return block;
}

/* View corner of a grid vertex, for a placed grid that stores its vertices. */
static inline tp_view_vertex grid_corner(const tp_grid *grid, uint32_t i, uint32_t j)
{
    tp_view_vertex c;

    tp_grid_make_view_vertices(grid, &grid->vertex[(size_t)j * grid->cols], j, i, i + 1, &c);
    return c;
}
#endif
