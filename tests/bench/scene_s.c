/* SPDX-License-Identifier: MIT */
/* Scene S, on which other software renderers were measured: 20 m x 20 m of water on a
 * grid of 128 x 128, three waves, one texture of 256 x 256 texels repeated eight times,
 * nearest texels, lit, and nothing else: no haze, glitter, reflection or ripples.  The
 * eye is 3 m up, 60 degrees of view, looking 15.6 degrees down; the water then covers
 * 59 % of the picture.
 *
 *   scene_s WIDTH HEIGHT [FILE.ppm]     prints the water's pixels and the frame's CRC
 *
 * Drawn through the public functions, in one tile. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "tidepool/tidepool.h"

enum { SIDE = 256, POINTS = 128 };

/* Mottled blues in a grid of darker lines: repeats and skewed texels would be seen. */
static uint32_t texel(uint32_t x, uint32_t y)
{
    uint32_t noise = (x * 2654435761u ^ y * 2246822519u) * 3266489917u >> 28;
    uint32_t line = x % 32 == 0 || y % 32 == 0 ? 48 : 0;
    return 0xff000000u | (70 - line + noise) << 16 | (140 - line + noise) << 8
         | (190 - line + noise);
}

static tp_scene scene_s(void)
{
    static tp_scene s;
    tp_scene_default(&s);
    s.camera.y = TP_FX(3);
    s.camera.z = TP_FX(8.65);
    s.camera.pitch = TP_FX(-15.6);
    s.camera.fov = TP_FX(60);
    s.light.colour = 0xffffff;
    s.sky.haze = 0;
    s.water.colour = 0xffffff;
    s.layer[0].map.size = TP_FX(2.5);
    s.water.filter = TP_FILTER_NEAREST;
    s.water.specular = 0;
    s.water.reflection = 0;
    s.grid.cols = s.grid.rows = POINTS;
    s.grid.cell = TP_FX(20.0 / (POINTS - 1));
    s.grid.reach = 0;
    s.grid.follow = 0;
    s.wave[0] = (tp_wave){ TP_FX(0.20), TP_FX(6), TP_FX(0.15), TP_FX(30), 0, TP_FX(1), 1 };
    s.wave[1] = (tp_wave){ TP_FX(0.12), TP_FX(3.5), TP_FX(0.15), TP_FX(75), 0, TP_FX(1), 1 };
    s.wave[2] = (tp_wave){ TP_FX(0.06), TP_FX(2), TP_FX(0.15), TP_FX(-20), 0, TP_FX(1), 1 };
    return s;
}

static void *claim(size_t bytes)
{
    void *memory = bytes ? malloc(bytes) : NULL;
    if (!memory)
        exit(1);
    return memory;
}

static void write_ppm(const char *name, const tp_tile *tile)
{
    FILE *f = fopen(name, "wb");
    if (!f)
        return;
    fprintf(f, "P6\n%" PRIu32 " %" PRIu32 "\n255\n", tile->x1, tile->y1);
    for (uint32_t y = 0; y < tile->y1; y++)
        for (uint32_t x = 0; x < tile->x1; x++) {
            const uint8_t *row = (const uint8_t *)tile->pixels + y * tile->stride;
            uint32_t p = tp_pixel_read(TP_FORMAT_XRGB8888, row, (int)x);
            const uint8_t rgb[3] = { (uint8_t)(p >> 16), (uint8_t)(p >> 8), (uint8_t)p };
            fwrite(rgb, 1, 3, f);
        }
    fclose(f);
}

int main(int argc, char **argv)
{
    static uint32_t pixels[SIDE * SIDE];
    static tp_texture texture;
    static tp_world world;
    tp_error  err;
    tp_frame *frame;
    tp_tile   tile;

    if (argc < 3) {
        fprintf(stderr, "usage: scene_s WIDTH HEIGHT [FILE.ppm]\n");
        return 2;
    }
    const tp_frame_config config = { (uint32_t)atoi(argv[1]), (uint32_t)atoi(argv[2]),
                                     0, 0, TP_FORMAT_XRGB8888 };
    const tp_scene scene = scene_s();
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        pixels[i] = texel(i % SIDE, i / SIDE);
    if (tp_texture_init(&texture, pixels, SIDE, SIDE, claim(tp_texture_bytes(SIDE, SIDE)),
                        &err))
        return 1;
    const tp_assets assets = { .layer[0] = &texture };
    void *block = claim(tp_frame_bytes(&scene, &assets, &config));
    void *scratch = claim(tp_frame_scratch_bytes(&config));
    if (tp_frame_init(&frame, &scene, &assets, &config, block, &err))
        return 1;

    tp_world_init(&world, sizeof world, &scene, NULL, NULL);
    for (int i = 0; i < 60; i++)
        tp_world_step(&world, &scene, NULL);
    tp_frame_begin(frame, &world);
    if (!tp_frame_tile(frame, 0, scratch, &tile))
        return 1;
    uint32_t crc = 0;
    for (uint32_t y = 0; y < tile.y1; y++)
        crc = tp_crc32_pixels(crc, config.format, (const uint8_t *)tile.pixels
                              + y * tile.stride, (int)tile.x1);
    printf("water_pixels %" PRIu32 " crc32 %08" PRIx32 "\n",
           tp_frame_water_pixels(frame, scratch, &tile), crc);
    if (argc > 3)
        write_ppm(argv[3], &tile);
    free(scratch);
    free(block);
    free((void *)(uintptr_t)texture.level[0]);
    return 0;
}
