/* SPDX-License-Identifier: MIT */
#include <cstdio>
#include <tidepool/tidepool.h>
#include <vector>

int main()
{
    static tp_scene scene;
    tp_config config = tp_config();
    tp_engine *sea;
    tp_tile tile;
    uint32_t crc = 0;

    tp_scene_init(&scene);
    config.width = 320, config.height = 240;
    std::vector<uint64_t> memory(tp_engine_bytes(&config, &scene) / 8 + 1);
    if (tp_engine_init(&sea, &config, &scene, memory.data(), memory.size() * 8, NULL))
        return 1;
    for (tp_engine_begin(sea); tp_engine_next_tile(sea, &tile);)
        crc = tp_crc32_pixels(crc, config.format, tile.pixels,
                              320 * int(tile.y1 - tile.y0));
    std::printf("%s %08x\n", tp_version(), unsigned(crc));
}
