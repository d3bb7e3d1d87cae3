/* SPDX-License-Identifier: MIT */
/* A panel storing the bytes sent by either of two libraries. */
#ifndef STAND_IN_TFT_PANEL_H
#define STAND_IN_TFT_PANEL_H
#include <cstdint>

class tft_panel
{
  public:
    void startWrite();
    void endWrite();
    void setSwapBytes(bool swap);
    void setRotation(uint8_t rotation);

  protected:
    bool begin();
    int32_t side(bool is_height) const;
    void push(int32_t x, int32_t y, int32_t w, int32_t h, const uint16_t *data);
};
#endif
