/* SPDX-License-Identifier: MIT */
/* A stand-in for TFT_eSPI 2.5: the calls used by ports/examples/tft, with TFT_eSPI's
 * declarations. */
#ifndef STAND_IN_TFT_ESPI_H
#define STAND_IN_TFT_ESPI_H
#include "tft_panel.h"

class TFT_eSPI : public tft_panel
{
  public:
    void init(uint8_t tab = 0) { (void)tab, begin(); }
    int16_t width() { return (int16_t)side(false); }
    int16_t height() { return (int16_t)side(true); }
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t *data)
    {
        push(x, y, w, h, data);
    }
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, const uint16_t *data)
    {
        push(x, y, w, h, data);
    }
};
#endif
