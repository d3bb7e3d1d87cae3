/* SPDX-License-Identifier: MIT */
/* Pictures of a loaded scene at several ticks and in two sizes, with the water in each
 * pixel, and the rms of their colours where both show water. */
#ifndef TP_TESTS_LIB_DRAWINGS_H
#define TP_TESTS_LIB_DRAWINGS_H
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "app/scene/loaded_scene.h"
#include "raster/raster.h"
#include "world/pools.h"

enum { LAST = 300, MOST = 320 * 240 };

/* Size of the compared pictures; at most MOST pixels. */
static uint32_t width = 160, height = 120;

static inline bool is_looked_at(uint32_t tick)
{
    return tick == 0 || tick == 30 || tick == 60 || tick == 100 || tick == 200
        || tick == LAST;
}

typedef struct {
    uint32_t pixel[MOST];
    uint8_t  water[MOST];       /* 1: water */
    uint32_t vertices;
} drawing;

/* Draws a scene.  With one tile over the whole picture, the G-buffer's keys are the first
 * plane of the tile's scratch memory. */
static inline void draw(drawing *to, const loaded_scene *s, const tp_scene *scene,
                        const tp_world *world)
{
    const tp_config config = { .width = width, .height = height, .tile_height = height,
                               .program = &tp_program_all, .assets = &s->assets.names };
    void *block = malloc(tp_frame_bytes(&config, scene));
    uint32_t *scratch = malloc(tp_frame_scratch_bytes(&config, scene));
    tp_frame *frame;
    tp_tile   tile;

    if (!block || !scratch
        || tp_frame_init(&frame, &config, scene, block, tp_frame_bytes(&config, scene),
                         NULL))
        abort();
    tp_frame_begin(frame, world);
    tp_frame_draw_tile(frame, 0, scratch, &tile);
    for (uint32_t i = 0; i < width * height; i++) {
        to->pixel[i] = ((const uint32_t *)tile.pixels)[i];
        to->water[i] = TP_MARK(scratch[i]) == TP_MARK_WATER;
    }
    to->vertices = tp_frame_stats(frame).vertices;
    free(scratch);
    free(block);
}

static inline tp_scene exact_scene(const loaded_scene *s)
{
    static const tp_rung_set exact = { .of = { 0 } };
    tp_scene scene = s->file.scene;

    tp_rung_set_apply(&scene, &exact);
    scene.quality.error_px = scene.quality.error_colour = 0;
    return scene;
}

/* Returns the rms of the worst channel over pixels that are water in both, of 255. */
static inline double colour_rms(const drawing *a, const drawing *b)
{
    double   sum[3] = { 0, 0, 0 };
    uint32_t count = 1;

    for (size_t i = 0; i < width * height; i++) {
        if (!a->water[i] || !b->water[i])
            continue;
        count++;
        for (int c = 0; c < 3; c++) {
            const int off = (int)(a->pixel[i] >> 8 * c & 255)
                          - (int)(b->pixel[i] >> 8 * c & 255);
            sum[c] += off * off;
        }
    }
    return sqrt(fmax(sum[0], fmax(sum[1], sum[2])) / count);
}
#endif
