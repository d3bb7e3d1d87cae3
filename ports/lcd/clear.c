/* SPDX-License-Identifier: MIT */
/* Fills a glass with one colour, for pictures smaller than the glass: after power-on a
 * panel's memory contains noise.  Drawn as columns of narrow tiles from top to bottom:
 * each column is one window, and all rows of a tile share one row of bytes. */
#include "lcd.h"

enum { NARROW = 16 };           /* px: the smallest tile width, fits each buffer */

static lcd_status clear_column(lcd *l, tp_tile tile)
{
    const uint32_t step = l->config.frame.tile_height, end = l->height;
    for (tile.y0 = 0; tile.y0 < end; tile.y0 = tile.y1) {
        tile.y1 = end - tile.y0 < step ? end : tile.y0 + step;
        const lcd_status status = lcd_tile(l, &tile);
        if (status != LCD_OK)
            return status;
    }
    return LCD_OK;
}

lcd_status lcd_clear(lcd *l, uint8_t byte)
{
    const lcd_config config = l->config;
    lcd_status status = LCD_OK;
    uint8_t row[NARROW * 4];

    for (size_t i = 0; i < sizeof row; i++)
        row[i] = byte;
    l->config.x = l->config.y = 0;
    l->config.frame.width = l->width;
    l->config.frame.height = l->height;
    lcd_begin(l);
    for (uint32_t x = 0; status == LCD_OK && x < l->width; x += NARROW)
        status = clear_column(l, (tp_tile){ .x0 = x, .x1 = x + NARROW, .pixels = row });
    l->config = config;
    return status;
}
