/* SPDX-License-Identifier: MIT */
/* Pictures with the kind of object that each pixel shows. */
#ifndef TP_TESTS_MARKS_H
#define TP_TESTS_MARKS_H
#include "kinds.h"
#include "scenes.h"

/* Draws the whole picture as one tile.  `key` has one word per pixel and may be NULL; it
 * receives depths, with object kinds in place of stencil values. */
static inline void marks_draw(const tp_scene *scene, const tp_assets *assets,
                              const tp_world *world, tp_config config, uint32_t *key,
                              uint32_t *pixels)
{
    test_frame f = frame_of(scene, assets, &config);
    uint8_t kind[TP_MARKS];
    tp_tile tile;

    tp_frame_begin(f.frame, world);
    marks_list_kinds(f.frame, kind);
    for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++) {
        const uint32_t *from = (const uint32_t *)(const void *)f.scratch;
        for (uint32_t y = tile.y0; y < tile.y1; y++) {
            const size_t row = (y - tile.y0) * (size_t)f.frame->config.tile_width;
            const size_t at = y * (size_t)config.width + tile.x0;
            const size_t bytes = (tile.x1 - tile.x0) * sizeof *from;
            for (uint32_t x = 0; key && x < tile.x1 - tile.x0; x++)
                key[at + x] = (from[row + x] & ~0xffu) | kind[TP_MARK(from[row + x])];
            if (pixels)
                memcpy(pixels + at, (const uint8_t *)tile.pixels
                                    + (y - tile.y0) * tile.stride, bytes);
        }
    }
    if (!frame_guard_holds(f.block, f.bytes)
        || !frame_guard_holds(f.scratch, f.scratch_bytes))
        abort();
    frame_free(&f);
}

static inline uint32_t marks_count(const uint32_t *key, size_t pixels, marks_kind kind)
{
    uint32_t count = 0;

    for (size_t i = 0; i < pixels; i++)
        count += TP_MARK(key[i]) == kind;
    return count;
}

/* Asserts that the picture has the same pixels in tiles of each of these sizes as in one
 * tile. */
static inline void marks_assert_tiled(const tp_scene *scene, const tp_assets *assets,
                                      const tp_world *world, tp_config config,
                                      const uint32_t size[][2], size_t count,
                                      uint32_t *key)
{
    const size_t bytes = (size_t)config.width * config.height * sizeof(uint32_t);
    uint32_t *const whole = malloc(bytes), *const tiled = malloc(bytes);

    assert_true(whole && tiled && config.tile_height == config.height);
    marks_draw(scene, assets, world, config, key, whole);
    for (size_t i = 0; i < count; i++) {
        config.tile_width = size[i][0];
        config.tile_height = size[i][1];
        marks_draw(scene, assets, world, config, NULL, tiled);
        assert_memory_equal(tiled, whole, bytes);
    }
    free(whole);
    free(tiled);
}

/* Still water below a camera at this height in m that looks to -z. */
static inline tp_scene marks_still(int32_t metres)
{
    tp_scene s;

    tp_scene_level(&s);
    s.grid.cols = s.grid.rows = 12;
    s.camera.y = metres * TP_FX_ONE;
    s.camera.pitch = 0;
    return s;
}
#endif
