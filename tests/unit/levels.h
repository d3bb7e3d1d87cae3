/* SPDX-License-Identifier: MIT */
/* Two frames of one moment, drawn by two water renderers and compared sample by sample. */
#ifndef TP_TESTS_LEVELS_H
#define TP_TESTS_LEVELS_H
#include "frame/frame.h"
#include "scenes.h"

#ifndef LEVEL_WIDTH
#define LEVEL_WIDTH  150
#define LEVEL_HEIGHT 90
#endif
#define LEVEL_PIXELS (LEVEL_WIDTH * LEVEL_HEIGHT)

/* G-buffer of a frame that is drawn as one tile; the caller frees the frame. */
typedef struct {
    test_frame frame;
    tp_world   world;
    const uint32_t *key, *s, *t, *n;
    const uint32_t *pixels;
} level_shot;

static inline void level_draw(level_shot *shot, tp_scene *scene, const tp_assets *assets,
                              tp_visibility how, uint64_t tick)
{
    const tp_config config = { .width = LEVEL_WIDTH,
                               .height = LEVEL_HEIGHT,
                               .tile_height = LEVEL_HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    tp_tile tile;

    scene->quality.visibility = (int32_t)how;
    shot->frame = frame_of(scene, assets, &config);
    if (tp_world_init(&tp_program_all, &shot->world, sizeof shot->world, scene, NULL,
                      NULL)
        != TP_OK)
        abort();
    shot->world.tick = tick;
    tp_world_apply(&tp_program_all, &shot->world, scene, NULL);
    tp_frame_begin(shot->frame.frame, &shot->world);
    if (!tp_frame_draw_tile(shot->frame.frame, 0, shot->frame.scratch, &tile))
        abort();
    shot->key = (const uint32_t *)(const void *)shot->frame.scratch;
    shot->s = shot->key + LEVEL_PIXELS;
    shot->t = shot->s + LEVEL_PIXELS;
    shot->n = shot->t + LEVEL_PIXELS;
    shot->pixels = (const uint32_t *)tile.pixels;
}

static inline bool level_is_water(const level_shot *shot, int i)
{
    return TP_MARK(shot->key[i]) == TP_MARK_WATER;
}

/* Returns the number of pixels that are water in one frame only. */
static inline int level_apart(const level_shot *a, const level_shot *b)
{
    int count = 0;

    for (int i = 0; i < LEVEL_PIXELS; i++)
        count += level_is_water(a, i) != level_is_water(b, i);
    return count;
}

/* Mean absolute difference of the colour channels of both pictures. */
static inline double level_colour_apart(const level_shot *a, const level_shot *b)
{
    double sum = 0;

    for (int i = 0; i < LEVEL_PIXELS; i++)
        for (int k = 0; k < 24; k += 8)
            sum += abs((int)(a->pixels[i] >> k & 255) - (int)(b->pixels[i] >> k & 255));
    return sum / 3 / LEVEL_PIXELS;
}

/* Asserts that every tile of a begun frame equals its part of the picture. */
static inline void level_compare_tiles(const test_frame *f, const uint32_t *picture)
{
    tp_tile tile;

    for (uint32_t i = 0; tp_frame_draw_tile(f->frame, i, f->scratch, &tile); i++) {
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            assert_memory_equal((const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride,
                                picture + y * LEVEL_WIDTH + tile.x0,
                                (tile.x1 - tile.x0) * sizeof *picture);
    }
    assert_true(frame_guard_holds(f->block, f->bytes));
    assert_true(frame_guard_holds(f->scratch, f->scratch_bytes));
}

/* Asserts that every tiling gives the same pixels as the frame drawn whole. */
static inline void level_compare_tilings(const level_shot *whole, const tp_scene *scene,
                                         const tp_assets *assets)
{
    static const uint32_t sizes[][2] = { { 0, 1 }, { 0, 7 }, { 16, 0 }, { 48, 13 },
                                         { 64, 16 } };

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const tp_config config = { .width = LEVEL_WIDTH,
                                   .height = LEVEL_HEIGHT,
                                   .tile_width = sizes[i][0],
                                   .tile_height = sizes[i][1],
                                   .format = TP_FORMAT_XRGB8888 };
        test_frame f = frame_of(scene, assets, &config);
        tp_frame_begin(f.frame, &whole->world);
        level_compare_tiles(&f, whole->pixels);
        frame_free(&f);
    }
}

/* Puts the camera aboard a rolling boat. */
static inline void level_board(tp_scene *scene, tp_fx height)
{
    scene->camera.follow = TP_FOLLOW_BOAT;
    scene->camera.y = height;
    scene->boat.mode = TP_BOAT_KINEMATIC;
}
#endif
