/* SPDX-License-Identifier: MIT */
/* Frames in memory of their own, G-buffer tiles for the rasteriser, and the kind of object
 * behind a stencil value. */
#ifndef TP_TESTS_LIB_FRAMES_H
#define TP_TESTS_LIB_FRAMES_H
#include <stdlib.h>
#include <string.h>
#include "frame/frame.h"
#include "raster/raster.h"
#include "tests/lib/scenes.h"
#include "tidepool/modules.h"

#define FRAME_GUARD 64

typedef struct {
    tp_frame *frame;
    uint8_t  *block, *scratch;
    size_t    bytes, scratch_bytes;
} test_frame;

/* A block of exact size, filled with 0xA5, with FRAME_GUARD more bytes behind its end. */
static inline uint8_t *frame_block(size_t bytes)
{
    uint8_t *block = malloc(bytes + FRAME_GUARD);
    memset(block, 0xa5, bytes + FRAME_GUARD);
    return block;
}

static inline bool frame_guard_holds(const uint8_t *block, size_t bytes)
{
    for (size_t i = 0; i < FRAME_GUARD; i++) {
        if (block[bytes + i] != 0xa5)
            return false;
    }
    return true;
}

/* The config with another program and with the assets. */
static inline tp_config config_with(const tp_config *config, const tp_program *by,
                                    const tp_assets *assets)
{
    tp_config c = *config;

    c.program = by;
    c.assets = assets;
    return c;
}

static inline test_frame frame_by(const tp_program *by, const tp_scene *scene,
                                  const tp_assets *assets, const tp_config *config)
{
    const tp_config c = config_with(config, by, assets);
    test_frame f = { .bytes = tp_frame_bytes(&c, scene),
                     .scratch_bytes = tp_frame_scratch_bytes(&c, scene) };

    f.block = frame_block(f.bytes);
    f.scratch = frame_block(f.scratch_bytes);
    if (tp_frame_init(&f.frame, &c, scene, f.block, f.bytes, NULL) != TP_OK)
        abort();
    return f;
}

static inline test_frame frame_of(const tp_scene *scene, const tp_assets *assets,
                                  const tp_config *config)
{
    return frame_by(&tp_program_all, scene, assets, config);
}

static inline void frame_free(test_frame *f)
{
    free(f->block);
    free(f->scratch);
}

/* Begins the frame and draws all tiles into a picture of 4 bytes a pixel. Ends the program
 * if a tile was written beyond the frame's memory. */
static inline void frame_draw_picture(const test_frame *f, const tp_world *world,
                                      uint32_t *pixels)
{
    const size_t width = f->frame->config.width;
    tp_tile tile;

    tp_frame_begin(f->frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(f->frame, i, f->scratch, &tile); i++)
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            memcpy(pixels + y * width + tile.x0,
                   (const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride,
                   (tile.x1 - tile.x0) * sizeof *pixels);
    if (!frame_guard_holds(f->block, f->bytes)
        || !frame_guard_holds(f->scratch, f->scratch_bytes))
        abort();
}

/* -- kinds of objects ---------------------------------------------------------------- */

typedef enum {
    MARKS_SKY, MARKS_WATER, MARKS_BOAT, MARKS_LAND, MARKS_DROP, MARKS_TANK, MARKS_SIDE
} marks_kind;

/* Returns the kind from the owner of the stencil value's shader list. */
static inline marks_kind marks_kind_of(const tp_frame *frame, uint32_t mark)
{
    if (mark < TP_MARK_SOLID)
        return mark == TP_MARK_SKY ? MARKS_SKY : MARKS_WATER;
    const tp_drawing *owner = mark < frame->buffers.marks.count
                            ? tp_frame_list(frame, mark)->owner : NULL;
    return owner == &tp_tank_drawing ? MARKS_TANK
         : owner == &tp_glass_drawing ? MARKS_SIDE
         : owner == &tp_land_drawing ? MARKS_LAND
         : owner == &tp_drops_drawing ? MARKS_DROP : MARKS_BOAT;
}

/* Stores the kind of each stencil value of the frame. */
static inline void marks_list_kinds(const tp_frame *frame, uint8_t kind[TP_MARKS])
{
    for (uint32_t mark = 0; mark < TP_MARKS; mark++)
        kind[mark] = (uint8_t)marks_kind_of(frame, mark);
}

/* -- a G-buffer tile ----------------------------------------------------------------- */

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
                                 tile.block + 3 * tile.words, false, 0, NULL, 0, 0,
                                 tp_tri_solid_wide, NULL };
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
