/* SPDX-License-Identifier: MIT */
/* A glass of one colour, for pictures that leave some of it free: what a panel's memory
 * holds when it is switched on is noise.  Columns of narrow tiles, top to bottom, so that
 * each column is one window; all rows of a tile are one row. */
#include "lcd.h"

enum { NARROW = 16 };           /* pixels: no tile is narrower, so they fit the buffers */

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
