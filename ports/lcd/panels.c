/* SPDX-License-Identifier: MIT */
/* Panel tables with the commands required by the controllers' data sheets.
 *
 * Colour panels: ILI9341 (ILITEK, V1.11) and ST7789V (Sitronix) use commands of MIPI DCS:
 *     01h SWRESET   reset; 5 ms until the next command, 120 ms until 11h
 *     11h SLPOUT    end of sleep: starts the charge pumps; 5 ms, 120 ms until they are up
 *     3Ah COLMOD    55h: 16 bits a pixel, high byte first
 *     36h MADCTL    order of pixels in the memory: MY MX MV, BGR of the glass
 *     2Ah CASET, 2Bh PASET      window: first and last, two bytes each, high byte first
 *     2Ch RAMWR     pixels from the window's corner on, until the next command
 *     29h DISPON    the glass shows the memory
 * E-paper: SSD1680 (Solomon Systech); its columns are bytes of 8 pixels, 1 is white. */
#include "lcd.h"

const char *lcd_status_text(lcd_status status)
{
    static const char *const sentence[] = {
#define X(name, text) text,
        LCD_STATUS_LIST(X)
#undef X
    };
    return (unsigned)status < LCD_STATUS_COUNT ? sentence[status] : "";
}

enum { EVERY_WALK = LCD_MX | LCD_MY | LCD_MV | LCD_BGR };

static const uint8_t display_on[] = { 0x29, 0 };

#define DCS_565 \
    .format = TP_FORMAT_RGB565BE, .unit = 1, .unit_bytes = 2, .cols = 240, .rows = 320, \
    .x_bytes = 2, .y_bytes = 2, .set_x = 0x2a, .set_y = 0x2b, .write = 0x2c, \
    .set_turn = 0x36, .able = EVERY_WALK, .on = LCD_SCRIPT(display_on)

/* -- ILI9341, 240x320 ---------------------------------------------------------------- */

/* Voltages and frame rate for modules of 2.2 to 3.2 inches; other registers keep their
 * reset values.  The glass shows the memory's columns from the right, blue first. */
static const uint8_t ili9341_start[] = {
    0x01, LCD_PAUSE | 0, 120,           /* SWRESET */
    0xc0, 1, 0x23,                      /* PWCTRL1: GVDD 4.6 V */
    0xc1, 1, 0x10,                      /* PWCTRL2: step-up factor */
    0xc5, 2, 0x3e, 0x28,                /* VMCTRL1: VCOMH 4.25 V, VCOML -1.5 V */
    0xc7, 1, 0x86,                      /* VMCTRL2: both 58 steps lower */
    0xb1, 2, 0x00, 0x18,                /* FRMCTR1: 79 frames a second */
    0x3a, 1, 0x55,                      /* COLMOD */
    0x11, LCD_PAUSE | 0, 120,           /* SLPOUT */
};

const lcd_panel lcd_ili9341 = {
    DCS_565, .width = 240, .height = 320, .upright = LCD_MX | LCD_BGR,
    .start = LCD_SCRIPT(ili9341_start),
};

/* -- ST7789, 240x320 and smaller glass in the same memory ---------------------------- */

/* Glass of this controller shows inverted colours unless INVON is set. */
static const uint8_t st7789_start[] = {
    0x01, LCD_PAUSE | 0, 120,           /* SWRESET */
    0x3a, 1, 0x55,                      /* COLMOD */
    0x21, 0,                            /* INVON */
    0x11, LCD_PAUSE | 0, 120,           /* SLPOUT */
};

const lcd_panel lcd_st7789 = {
    DCS_565, .width = 240, .height = 320, .start = LCD_SCRIPT(st7789_start),
};

const lcd_panel lcd_st7789_240x240 = {
    DCS_565, .width = 240, .height = 240, .start = LCD_SCRIPT(st7789_start),
};

const lcd_panel lcd_st7789_135x240 = {
    DCS_565, .x = 52, .y = 40, .width = 135, .height = 240,
    .start = LCD_SCRIPT(st7789_start),
};

/* -- SSD1680, 122x250 of 176x296 ----------------------------------------------------- */

/* The controller has two memories: 24h holds the next image, 26h the shown image.  A whole
 * update (display mode 1) blinks through black and white.  A partial update (mode 2)
 * drives only the pixels that differ; the ping-pong of 37h exchanges the memories after
 * it. */
static const uint8_t ssd1680_start[] = {
    0x12, LCD_PAUSE | LCD_BUSY | 0, 10, /* SWRESET */
    0x01, 3, 0xf9, 0x00, 0x00,          /* gates: 250 */
    0x11, 1, 0x03,                      /* data entry: x and y increase, x first */
    0x18, 1, 0x80,                      /* internal temperature sensor */
    0x21, 2, 0x00, 0x80,                /* memories unchanged; sources 8 to 167 */
    0x37, 10, 0, 0, 0, 0, 0, 0x40, 0, 0, 0, 0,  /* ping-pong */
};
static const uint8_t ssd1680_update[] = {
    0x3c, 1, 0x05,                      /* border: white, with the picture */
    0x22, 1, 0xf7,                      /* clock and voltages on, waveform, mode 1, off */
    0x20, LCD_BUSY | 0,
};
static const uint8_t ssd1680_partly[] = {
    0x3c, 1, 0x80,                      /* border: unchanged */
    0x22, 1, 0xff,                      /* the same in mode 2 */
    0x20, LCD_BUSY | 0,
};

const lcd_panel lcd_ssd1680 = {
    .cols = 176, .rows = 296, .width = 122, .height = 250,
    .format = TP_FORMAT_I1, .unit = 8, .unit_bytes = 1, .x_bytes = 1, .y_bytes = 2,
    .set_x = 0x44, .set_y = 0x45, .at_x = 0x4e, .at_y = 0x4f,
    .write = 0x24, .write_old = 0x26, .flags = LCD_LOW_FIRST,
    .start = LCD_SCRIPT(ssd1680_start),
    .update = LCD_SCRIPT(ssd1680_update), .partly = LCD_SCRIPT(ssd1680_partly),
};
