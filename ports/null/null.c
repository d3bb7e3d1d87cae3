/* SPDX-License-Identifier: MIT */
/* The smallest port: draws a scene made in code, in bands, in every pixel format, and
 * prints the CRCs of the frames.  A port to a board replaces the CRC by its display. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "pixel/pixel.h"
#include "tidepool/tidepool.h"
#include "world/text.h"
#include "world/world.h"

enum { WIDTH = 160, HEIGHT = 120, BAND = 16, FRAMES = 4 };
enum { DONE = 0, FAILED = 3 };          /* exit codes, as of the host program */

static void set(tp_scene *scene, const char *name, const char *text)
{
    const tp_param *param = tp_param_find(name, strlen(name));
    if (!param || tp_param_set(scene, param, text, strlen(text), NULL))
        printf("%s cannot be %s\n", name, text);
}

/* Draws one frame and prints its CRC.  Bands are as wide as the picture and come in order:
 * their rows are the picture's rows. */
static void draw(const tp_frame *frame, tp_format format, void *scratch, unsigned number)
{
    tp_tile tile;
    uint32_t crc = 0;
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++)
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            crc = tp_crc32_pixels(crc, format, (const uint8_t *)tile.pixels
                                  + (y - tile.y0) * tile.stride, WIDTH);
    printf("%s frame %04u crc32 %08x\n", tp_format_name(format), number, (unsigned)crc);
}

static int run(const tp_scene *scene, tp_format format)
{
    const tp_config config = {
        .width = WIDTH, .height = HEIGHT, .tile_height = BAND, .format = format
    };
    const size_t bytes = tp_frame_bytes(&config, scene); /* 1: memory */
    void *block = malloc(bytes);
    void *scratch = malloc(tp_frame_scratch_bytes(&config, scene));
    tp_frame *frame;
    tp_world world;                                                 /* 2: the world */
    if (!block || !scratch || tp_frame_init(&frame, &config, scene, block, bytes, NULL))
        return FAILED;
    tp_world_init(NULL, &world, sizeof world, scene, NULL, NULL);
    for (unsigned n = 0; n < FRAMES; n++, tp_world_step(NULL, &world, scene, NULL)) {
        tp_frame_begin(frame, &world);                              /* 3: frames */
        draw(frame, format, scratch, n);
    }
    free(block);
    free(scratch);
    return DONE;
}

int main(void)
{
    tp_scene scene;
    tp_scene_level(&scene);
    set(&scene, "wave0.amplitude", "0.5");
    set(&scene, "wave0.length", "12");
    for (int format = 0; format < TP_FORMAT_COUNT; format++)
        if (run(&scene, (tp_format)format))
            return FAILED;
    return DONE;
}
