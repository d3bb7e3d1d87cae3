/* SPDX-License-Identifier: MIT */
/* A G-buffer tile for tests in memory of its own, with known contents before drawing. */
#ifndef TP_TESTS_TILE_H
#define TP_TESTS_TILE_H
#include <stdlib.h>
#include <string.h>
#include "raster/raster.h"

#define TILE_UNSET 0xa5a5a5a5u

typedef struct {
    tp_gbuffer samples;
    uint32_t  *block;
    size_t     words;           /* words of one plane */
} test_tile;

/* A tile; rows are `spare` samples longer than the tile's width. */
static inline test_tile tile_of(int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                                uint32_t spare)
{
    const uint32_t stride = (uint32_t)(x1 - x0) + spare;
    test_tile tile = { .words = (size_t)stride * (uint32_t)(y1 - y0) };

    tile.block = malloc(4 * tile.words * sizeof *tile.block);
    memset(tile.block, 0xa5, 4 * tile.words * sizeof *tile.block);
    tile.samples = (tp_gbuffer){ x0, y0, x1, y1, stride, tile.block,
                                 tile.block + tile.words, tile.block + 2 * tile.words,
                                 tile.block + 3 * tile.words, false };
    tp_gbuffer_clear(&tile.samples);
    return tile;
}

static inline void tile_free(test_tile *tile)
{
    free(tile->block);
    tile->block = NULL;
}

/* Index of pixel (x, y) in each plane. */
static inline size_t tile_at(const test_tile *tile, int32_t x, int32_t y)
{
    const tp_gbuffer *s = &tile->samples;
    return (size_t)(uint32_t)(y - s->y0) * s->stride + (uint32_t)(x - s->x0);
}
#endif
