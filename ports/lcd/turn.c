/* SPDX-License-Identifier: MIT */
/* Turns tiles of i1 by quarters, for panels that cannot: e-paper stores bytes of eight
 * pixels along a fixed side of the glass. */
#include "lcd.h"

static unsigned bit(const tp_tile *t, uint32_t x, uint32_t y)
{
    const uint8_t *row = (const uint8_t *)t->pixels + (y - t->y0) * t->stride;
    return (unsigned)row[(x - t->x0) / 8] >> (7 - (x - t->x0) % 8) & 1;
}

/* Returns the picture's pixel at (x, y) of the turned picture. */
static unsigned sample_turned_bit(const tp_tile *t, const tp_config *picture, unsigned turn,
                                  uint32_t x, uint32_t y)
{
    const uint32_t right = picture->width - 1, below = picture->height - 1;
    switch (turn) {
    case 0:  return bit(t, x, y);
    case 1:  return bit(t, y, below - x);
    case 2:  return bit(t, right - x, below - y);
    default: return bit(t, right - y, x);
    }
}

static tp_tile place(const tp_tile *t, const tp_config *p, unsigned turn)
{
    const uint32_t w = p->width, h = p->height;
    switch (turn) {
    case 0:  return *t;
    case 1:  return (tp_tile){ .x0 = h - t->y1, .x1 = h - t->y0, .y0 = t->x0, .y1 = t->x1 };
    case 2:  return (tp_tile){ .x0 = w - t->x1, .x1 = w - t->x0,
                               .y0 = h - t->y1, .y1 = h - t->y0 };
    default: return (tp_tile){ .x0 = t->y0, .x1 = t->y1, .y0 = w - t->x1, .y1 = w - t->x0 };
    }
}

tp_tile lcd_turned(const tp_tile *tile, const tp_config *picture, unsigned turn,
                   uint8_t *to)
{
    tp_tile turned = place(tile, picture, turn & 3);
    turned.pixels = to;
    turned.stride = (turned.x1 - turned.x0 + 7) / 8;
    for (uint32_t y = turned.y0; y < turned.y1; y++, to += turned.stride) {
        for (size_t i = 0; i < turned.stride; i++)
            to[i] = 0;
        for (uint32_t x = turned.x0; x < turned.x1; x++)
            to[(x - turned.x0) / 8] |=
                (uint8_t)(sample_turned_bit(tile, picture, turn & 3, x, y)
                          << (7 - (x - turned.x0) % 8));
    }
    return turned;
}
