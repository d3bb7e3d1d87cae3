/* SPDX-License-Identifier: MIT */
/* What kind of thing each pixel of a drawn picture shows. */
#ifndef TP_TESTS_MARKS_H
#define TP_TESTS_MARKS_H
#include "kinds.h"
#include "scenes.h"

/* The whole picture as one tile; `key` has a word for each pixel and may be NULL: depths,
 * and kinds in place of marks. */
static inline void marks_draw(const tp_scene *scene, const tp_assets *assets,
                              const tp_world *world, tp_frame_config config,
                              uint32_t *key, uint32_t *pixels)
{
    test_frame f = frame_of(scene, assets, &config);
    uint8_t kind[TP_MARKS];
    tp_tile tile;

    tp_frame_begin(f.frame, world);
    marks_list_kinds(f.frame, kind);
    for (uint32_t i = 0; tp_frame_tile(f.frame, i, f.scratch, &tile); i++) {
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
#endif
