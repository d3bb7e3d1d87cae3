/* SPDX-License-Identifier: MIT */
/* A device with a serial port, a panel and a sketch.
 *     tft WIDTH HEIGHT N      runs setup and N times loop, writes what the panel shows
 * Exit code 2: the sketch used the panel wrongly; 3: it drew nothing. */
#include <cstdio>
#include <cstdlib>
#include "Arduino.h"
#include "shown.h"
#include "tft_panel.h"

static int32_t width, height, pushed;
static bool is_ready, is_writing, is_open, swaps;
static uint8_t sent[512 * 512 * 2];

HardwareSerial Serial;

static void want(bool holds, const char *what)
{
    if (holds)
        return;
    std::fprintf(stderr, "tft: %s\n", what);
    std::exit(2);
}

void HardwareSerial::begin(unsigned long baud)
{
    is_open = baud == 115200;
}

size_t HardwareSerial::print(const char *text)
{
    want(is_open, "the serial port was not begun");
    return (size_t)std::fprintf(stderr, "%s", text);
}

size_t HardwareSerial::println(const char *text)
{
    return print(text) + print("\n");
}

bool tft_panel::begin()
{
    return is_ready = true;
}

int32_t tft_panel::side(bool is_height) const
{
    want(is_ready, "a size before init");
    return is_height ? height : width;
}

void tft_panel::startWrite()
{
    want(is_ready && !is_writing, "startWrite out of turn");
    is_writing = true;
}

void tft_panel::endWrite()
{
    want(is_writing, "endWrite out of turn");
    is_writing = false;
}

void tft_panel::setSwapBytes(bool swap)
{
    swaps = swap;
}

void tft_panel::setRotation(uint8_t rotation)
{
    want(rotation == 1, "the panel lies on its side");
}

/* Without a swap the bytes go out as they lie in memory, both libraries do so. */
void tft_panel::push(int32_t x, int32_t y, int32_t w, int32_t h, const uint16_t *data)
{
    const uint8_t *from = (const uint8_t *)data;

    want(is_writing, "pixels outside of startWrite and endWrite");
    want(x >= 0 && y >= 0 && w > 0 && h > 0 && x + w <= width && y + h <= height,
         "an image outside of the panel");
    for (int32_t i = 0; i < 2 * w * h; i++)
        sent[2 * ((y + i / (2 * w)) * width + x) + i % (2 * w)] = from[swaps ? i ^ 1 : i];
    pushed += w * h;
}

int main(int argc, char **argv)
{
    want(argc == 4, "three arguments");
    width = std::atoi(argv[1]);
    height = std::atoi(argv[2]);
    want(width > 0 && width <= 512 && height > 0 && height <= 512, "no such panel");
    setup();
    for (int n = std::atoi(argv[3]); n > 0; n--) {
        pushed = 0;
        loop();
        want(!is_writing, "the bus was not given back");
        if (pushed == 0)
            return 3;
        want(pushed == width * height, "not a whole picture");
    }
    for (int32_t i = 0; i < width * height; i++)
        shown_write((uint16_t)(sent[2 * i] << 8 | sent[2 * i + 1]));
    return 0;
}
