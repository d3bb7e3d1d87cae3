/* SPDX-License-Identifier: MIT */
/* A sea on a canvas of LVGL 9: 60 pictures a second while lv_timer_handler runs.
 *
 * Add this file and libtidepool.a to a project that has LVGL with LV_USE_CANVAS, and call
 * sea_create(lv_screen_active()).  With LVGL 8 the format is LV_IMG_CF_TRUE_COLOR and
 * LV_COLOR_DEPTH 16. */
#include <string.h>
#include "lvgl.h"
#include "tidepool/tidepool.h"

enum { WIDTH = 320, HEIGHT = 240 };

static const tp_config config = { .width = WIDTH,
                                  .height = HEIGHT,
                                  .format = TP_FORMAT_RGB565 };
static uint32_t pixels[WIDTH * HEIGHT / 2]; /* RGB565, two to a word */
static uint64_t memory[24 << 10];
static tp_scene scene;
static tp_engine *sea;
static lv_obj_t *canvas;

static void draw(lv_timer_t *timer)
{
    tp_tile tile;

    (void)timer;
    tp_engine_begin(sea);
    while (tp_engine_next_tile(sea, &tile))
        memcpy(pixels + tile.y0 * WIDTH / 2, tile.pixels,
               (tile.y1 - tile.y0) * tile.stride);
    lv_obj_invalidate(canvas);
    tp_engine_step(sea, NULL);
}

/* Creates the canvas; returns NULL if the memory is too small. */
lv_obj_t *sea_create(lv_obj_t *parent)
{
    tp_scene_init(&scene);
    if (tp_engine_init(&sea, &config, &scene, memory, sizeof memory, NULL))
        return NULL;
    canvas = lv_canvas_create(parent);
    lv_canvas_set_buffer(canvas, pixels, WIDTH, HEIGHT, LV_COLOR_FORMAT_RGB565);
    lv_timer_create(draw, 1000 / 60, NULL);
    return canvas;
}
