/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <tidepool/tidepool.h>

static tp_scene scene;
static uint64_t memory[40 << 10];

int main(void)
{
    const tp_config config = { .width = 320, .height = 240 };
    tp_engine *sea;
    tp_tile tile;
    uint32_t crc = 0;

    tp_scene_init(&scene);
    if (tp_engine_init(&sea, &config, &scene, memory, sizeof memory, NULL))
        return 1;
    for (tp_engine_begin(sea); tp_engine_next_tile(sea, &tile);)
        crc = tp_crc32_pixels(crc, config.format, tile.pixels,
                              320 * (int)(tile.y1 - tile.y0));
    printf("%s %08x\n", tp_version(), (unsigned)crc);
    return 0;
}
