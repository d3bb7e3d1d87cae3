/* SPDX-License-Identifier: MIT */
/* Reference picture of a scene, and the error of other pictures. Triangles, rows and exact
 * stages all approximate one surface and its light, so the reference is drawn by the exact
 * rungs on a mesh four times finer along each axis. The reference of shading also has twice
 * the picture's size, and each pixel is the mean of four: glints smaller than a pixel then
 * count for exact and fast stages alike. The reference of renderers has the picture's own
 * samples: such glints would hide the differences of the renderers. Measured at several
 * ticks and in two sizes.
 *
 * Outline error: pixels that are water in one picture only, over the number of changes
 * between water and other surfaces down the columns of the reference. Colour error: rms of
 * 255 of the worst channel, over pixels that are water in both. A rung's error is the part
 * beyond the exact rung: max(0, e - e_exact). Since the squares of independent errors add
 * up, several rungs together add at most the sum of their errors. */
#ifndef TP_TESTS_LIB_QUALITY_ERROR_H
#define TP_TESTS_LIB_QUALITY_ERROR_H
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "app/scene/loaded_scene.h"
#include "raster/raster.h"
#include "world/pools.h"

enum { FINER = 4, LAST = 300, MOST = 320 * 240 };

/* Size of the compared pictures; at most MOST pixels. */
static uint32_t width = 160, height = 120;

static inline bool is_looked_at(uint32_t tick)
{
    return tick == 0 || tick == 30 || tick == 60 || tick == 100 || tick == 200
        || tick == LAST;
}

typedef struct {
    uint32_t pixel[MOST];
    uint8_t  water[MOST];      /* number of its samples that are water, 0..4 */
    uint32_t vertices;
} truth_drawing;

typedef struct {
    double px, colour;
} error;

/* Draws with `parts` samples along each axis. With one tile over the whole picture, the
 * G-buffer's keys are the first plane of the tile's scratch memory. The shader list does
 * not check the scene: the reference's cells may be finer than a scene allows, down to a
 * quarter of 1 cm. */
static inline void draw_at(truth_drawing *to, const loaded_scene *s, const tp_scene *scene,
                           const tp_world *world, uint32_t parts)
{
    tp_program program = tp_program_all;
    const tp_config config = { .width = width * parts,
                               .height = height * parts,
                               .tile_height = height * parts,
                               .program = &program,
                               .assets = &s->assets.names };
    program.check = NULL;
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
        uint32_t sum[3] = { 0, 0, 0 }, water = 0;
        for (uint32_t k = 0; k < parts * parts; k++) {
            const uint32_t x = i % width * parts + k % parts;
            const uint32_t at = (i / width * parts + k / parts) * config.width + x;
            water += TP_MARK(scratch[at]) == TP_MARK_WATER;
            for (int c = 0; c < 3; c++)
                sum[c] += ((const uint32_t *)tile.pixels)[at] >> 8 * c & 255;
        }
        const uint32_t n = parts * parts;
        to->pixel[i] = 0;
        for (int c = 0; c < 3; c++)
            to->pixel[i] |= (sum[c] + n / 2) / n << 8 * c;
        to->water[i] = (uint8_t)(water * 4 / n);
    }
    to->vertices = tp_frame_stats(frame).vertices;
    free(scratch);
    free(block);
}

static inline void draw(truth_drawing *to, const loaded_scene *s, const tp_scene *scene,
                        const tp_world *world)
{
    draw_at(to, s, scene, world, 1);
}

static inline tp_scene exact_scene(const loaded_scene *s)
{
    tp_scene scene = s->file.scene;

    scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
    scene.quality.shading = TP_SHADING_EXACT;
    scene.quality.rate = TP_RATE_FULL;
    scene.quality.error_px = scene.quality.error_colour = 0;
    return scene;
}

/* Of a mesh to the horizon: up to the most that a scene allows. */
static inline int32_t finer_vertices(int32_t vertices)
{
    const int32_t most = 65536;
    return vertices < most / (FINER * FINER) ? vertices * FINER * FINER : most;
}

static inline void draw_truth(truth_drawing *to, const loaded_scene *s,
                              const tp_world *world, uint32_t parts)
{
    tp_scene scene = exact_scene(s);

    scene.grid.vertices = finer_vertices((int32_t)tp_fan_budget(&scene));
    draw_at(to, s, &scene, world, parts);
}

static inline error error_of(const truth_drawing *truth, const truth_drawing *b)
{
    double   sum[3] = { 0, 0, 0 };
    uint32_t count = 1, elsewhere = 0, borders = 1;

    for (size_t i = 0; i < width * height; i++) {
        const bool water = truth->water[i] >= 2;
        elsewhere += water != (b->water[i] >= 2);
        borders += i >= width && water != (truth->water[i - width] >= 2);
        if (truth->water[i] < 4 || b->water[i] < 4)
            continue;
        count++;
        for (int c = 0; c < 3; c++) {
            const int off = (int)(truth->pixel[i] >> 8 * c & 255)
                          - (int)(b->pixel[i] >> 8 * c & 255);
            sum[c] += off * off;
        }
    }
    return (error){ (double)elsewhere / borders,
                    sqrt(fmax(sum[0], fmax(sum[1], sum[2])) / count) };
}

static inline error beyond(error e, error base)
{
    return (error){ fmax(0, e.px - base.px), fmax(0, e.colour - base.colour) };
}

static inline error worse(error a, error b)
{
    return (error){ fmax(a.px, b.px), fmax(a.colour, b.colour) };
}
#endif
