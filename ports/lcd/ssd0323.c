/* SPDX-License-Identifier: MIT */
/* SSD0323: OLEDs of 128 x 64 pixels of 16 greys, two to a byte, the left one high.
 *
 * Its memory has 64 columns of bytes and 80 rows.  It takes no command before pixels, and
 * its commands' arguments as commands.  Values are those of a Pictiva of 2.7 inches; the
 * remap (a0) has pixels from left to right, rows from above, and lines odd and even. */
#include "lcd.h"

/* Of a grey the upper four bits; where they are too few the core has dithered to eight,
 * whose steps are seen. */
static void pack_greys(uint8_t *to, const uint8_t *from, uint32_t pixels)
{
    for (; pixels >= 2; pixels -= 2, from += 2)
        *to++ = (uint8_t)((from[0] & 0xf0) | from[1] >> 4);
}

static const uint8_t start[] = {
    0xae, 0,                                    /* off */
    0x81, 1, 0x3f,   0x86, 0,                   /* contrast, whole current */
    0xa0, 1, 0x52,   0xa1, 1, 0,   0xa2, 1, 0,  /* remap, first line, offset */
    0xa4, 0,         0xa8, 1, 0x3f,             /* not inverted; 64 lines */
    0xb1, 1, 0x22,   0xb2, 1, 0x46,             /* phases, row period */
    0xb3, 1, 0xf1,   0xbf, 1, 0x0d,             /* clock, VSL */
    0xbe, 1, 0x02,   0xbc, 1, 0x10,             /* VCOMH, precharge */
    0xad, 1, 0x03,                              /* its own DC-DC converter is on */
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
