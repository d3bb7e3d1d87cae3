/* SPDX-License-Identifier: MIT */
/* A stand-in for LovyanGFX 1.2: the calls of ports/examples/tft by its declarations; of
 * the pixels that its template takes, those of 16 bits alone. */
#ifndef STAND_IN_LOVYANGFX_HPP
#define STAND_IN_LOVYANGFX_HPP
#include "tft_panel.h"
#ifndef LGFX_AUTODETECT
#error "LGFX is declared by LGFX_AUTODETECT alone"
#endif

class LGFX : public tft_panel
{
  public:
    bool init() { return begin(); }
    int32_t width() const { return side(false); }
    int32_t height() const { return side(true); }
    template <typename T>
    void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, const T *data)
    {
        const uint16_t *pixels = data;
        push(x, y, w, h, pixels);
    }
};
#endif
