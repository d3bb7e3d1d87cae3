/* SPDX-License-Identifier: MIT */
/* SSD0323: OLEDs of 128 x 64 pixels with 16 greys, two pixels to a byte, the left one in
 * the high bits.
 *
 * The memory has 64 columns of bytes and 80 rows.  Pixels need no command before them, and
 * arguments are sent as commands.  Values suit a Pictiva of 2.7 inches; the remap (a0)
 * orders pixels from left to right, rows from above, with odd and even lines split. */
#include "lcd.h"

/* Packs the upper four bits of each grey.  The core dithers l8 to 256 levels, not to the
 * panel's levels: steps are visible where 16 greys are too few. */
static void pack_greys(uint8_t *to, const uint8_t *from, uint32_t pixels)
{
    for (; pixels >= 2; pixels -= 2, from += 2)
        *to++ = (uint8_t)((from[0] & 0xf0) | from[1] >> 4);
}

static const uint8_t start[] = {
    0xae, 0,                                    /* off */
    0x81, 1, 0x3f,   0x86, 0,                   /* contrast, full current */
    0xa0, 1, 0x52,   0xa1, 1, 0,   0xa2, 1, 0,  /* remap, first line, offset */
    0xa4, 0,         0xa8, 1, 0x3f,             /* not inverted; 64 lines */
    0xb1, 1, 0x22,   0xb2, 1, 0x46,             /* phases, row period */
    0xb3, 1, 0xf1,   0xbf, 1, 0x0d,             /* clock, VSL */
    0xbe, 1, 0x02,   0xbc, 1, 0x10,             /* VCOMH, precharge */
    0xad, 1, 0x03,                              /* internal DC-DC converter on */
};

static const uint8_t on[] = { 0xaf, 0 };

const lcd_panel lcd_ssd0323 = {
    .cols = 128, .rows = 80, .width = 128, .height = 64,
    .format = TP_FORMAT_L8,
    .unit = 2, .unit_bytes = 1,
    .set_x = 0x15, .set_y = 0x75, .x_bytes = 1, .y_bytes = 1,
    .flags = LCD_ALL_COMMANDS,
    .start = LCD_SCRIPT(start), .on = LCD_SCRIPT(on),
    .pack = pack_greys,
};
