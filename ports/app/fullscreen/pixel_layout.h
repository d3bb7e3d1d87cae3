/* SPDX-License-Identifier: MIT */
/* Pixel layouts of screens: the position of each channel in a pixel of 8 to 32 bits.  No
 * device is accessed here. */
#ifndef TP_APP_FULLSCREEN_PIXEL_LAYOUT_H
#define TP_APP_FULLSCREEN_PIXEL_LAYOUT_H
#include <stdbool.h>
#include "app/files/picture.h"

typedef struct { uint8_t offset, length; } pixel_channel;     /* bits; 0 is the lowest */

typedef struct {
    uint32_t bits;              /* per pixel: 8, 16, 24 or 32 */
    bool     indexed;           /* 8-bit index into a colour table */
    bool     grey;              /* 8-bit brightness */
    bool     big;               /* high byte first; usually the machine's order */
    pixel_channel red, green, blue;   /* unused if indexed or grey */
    pixel_channel spare;        /* alpha or padding, filled with ones */
} pixel_layout;

bool machine_is_big(void);      /* true on a big-endian machine */

/* True if pixel_layout_row can write the layout: channels lie inside the pixel and do not
 * overlap. */
bool pixel_layout_is_supported(const pixel_layout *l);

/* Returns the picture format with the least loss for the layout. */
tp_format pixel_layout_format(const pixel_layout *l);

/* Converts row y of a picture to bits / 8 bytes per pixel.  A channel below 8 bits
 * keeps the high bits, a wider channel repeats them.  Indices and greys are copied:
 * pixel_layout_accepts is true for an indexed layout and p8, l8, i1, for a grey layout
 * and l8, i1, for other layouts always. */
bool pixel_layout_accepts(const pixel_layout *l, tp_format format);
void pixel_layout_row(const pixel_layout *l, void *to, const picture *p, uint32_t y);

/* Returns entry `i` of the colour table for a picture's format, 0x00RRGGBB. */
uint32_t pixel_layout_colour(tp_format format, uint32_t i);

/* Writes all 256 entries, 0..65535 per channel. */
void pixel_layout_table(tp_format format, uint16_t *red, uint16_t *green, uint16_t *blue);
#endif
