/* SPDX-License-Identifier: MIT */
/* A sea on a TFT: an Arduino sketch for TFT_eSPI, or for LovyanGFX with -DUSE_LOVYANGFX.
 * Both send a tile by pushImage, with its bytes in the panel's order.
 *
 * Copy this file as tft.ino into a sketch's folder, and Tidepool's include and src into a
 * library's folder; C++11 is enough.  A panel of 320x240 takes 88 KB.  On failure the
 * serial port, 115200 baud, prints the reason. */
#include <Arduino.h>
#ifdef USE_LOVYANGFX
#define LGFX_AUTODETECT
#include <LovyanGFX.hpp>
static LGFX tft;
#else
#include <TFT_eSPI.h>
static TFT_eSPI tft;
#endif
#include "tidepool/tidepool.h"

static tp_scene scene;
static tp_engine *sea;
static uint64_t memory[11 << 10]; /* 88 KB */

void setup()
{
    tp_config config = tp_config();
    tp_error err;
    char why[120];

    Serial.begin(115200);
    tft.init();
    tft.setRotation(1);
    tft.setSwapBytes(false); /* pixels have their high byte first already */
    config.width = (uint32_t)tft.width();
    config.height = (uint32_t)tft.height();
    config.tile_height = 8;
    config.format = TP_FORMAT_RGB565BE;
    tp_scene_init(&scene);
    scene.grid.vertices = 400;
    if (tp_engine_init(&sea, &config, &scene, memory, sizeof memory, &err) != TP_OK) {
        tp_error_text(&err, why, sizeof why);
        Serial.print("sea: ");
        Serial.println(why);
        sea = nullptr;
    }
}

void loop()
{
    tp_tile tile;

    if (sea == nullptr)
        return;
    tft.startWrite();
    tp_engine_begin(sea);
    while (tp_engine_next_tile(sea, &tile))
        tft.pushImage((int32_t)tile.x0, (int32_t)tile.y0, (int32_t)(tile.x1 - tile.x0),
                      (int32_t)(tile.y1 - tile.y0), (const uint16_t *)tile.pixels);
    tft.endWrite();
    tp_engine_step(sea, nullptr);
}
