/* SPDX-License-Identifier: MIT */
/* Counts the bytes, commands included, that the driver of ports/lcd sends to a display for
 * one frame: a picture's tiles go through the driver into counting wires.
 *
 *     sent WIDTHxHEIGHT TILExTILE FORMAT
 *
 * Colours go to an ILI9341, one bit a pixel to an SSD1680, with glass of the picture's
 * size. The measured frame is the third: its e-paper update is partial. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lcd/lcd.h"
#include "pixel/pixel.h"

static uint64_t sent;

static void command(void *user, uint8_t byte)
{
    (void)user, (void)byte;
    sent++;
}

static void data(void *user, const uint8_t *bytes, size_t count)
{
    (void)user, (void)bytes;
    sent += count;
}

static bool wait_for(void *user, lcd_until until)
{
    (void)user, (void)until;
    return true;
}

static void pause_ms(void *user, uint32_t ms)
{
    (void)user, (void)ms;
}

static void fail(const char *why)
{
    fprintf(stderr, "sent: %s\n", why);
    exit(2);
}

/* Landscape pictures are shown turned. */
static lcd_config config_of(lcd_panel *panel, const tp_config *frame)
{
    const bool turned = frame->format != TP_FORMAT_I1 && frame->width > frame->height;

    *panel = frame->format == TP_FORMAT_I1 ? lcd_ssd1680 : lcd_ili9341;
    panel->width = (uint16_t)(turned ? frame->height : frame->width);
    panel->height = (uint16_t)(turned ? frame->width : frame->height);
    return (lcd_config){
        .panel = panel, .frame = *frame, .turn = turned, .whole_every = 1000,
        .wires = { .command = command, .data = data, .wait = wait_for,
                   .pause = pause_ms },
    };
}

static void show(lcd *l, const tp_config *f, const void *pixels)
{
    lcd_begin(l);
    for (uint32_t y = 0; y < f->height; y += f->tile_height)
        for (uint32_t x = 0; x < f->width; x += f->tile_width) {
            tp_tile tile = { .x0 = x, .y0 = y, .x1 = x + f->tile_width,
                             .y1 = y + f->tile_height, .pixels = pixels,
                             .stride = tp_format_row_bytes(f->format, (int)f->tile_width) };
            tile.x1 = tile.x1 < f->width ? tile.x1 : f->width;
            tile.y1 = tile.y1 < f->height ? tile.y1 : f->height;
            if (lcd_tile(l, &tile) != LCD_OK)
                fail("a tile was refused");
        }
    if (lcd_end(l) != LCD_OK)
        fail("the frame was refused");
}

int main(int argc, char **argv)
{
    tp_config f = { 0 };
    lcd_status why;
    lcd_panel panel;
    lcd l;

    if (argc != 4 || sscanf(argv[1], "%" SCNu32 "x%" SCNu32, &f.width, &f.height) != 2
        || sscanf(argv[2], "%" SCNu32 "x%" SCNu32, &f.tile_width, &f.tile_height) != 2
        || f.tile_width == 0 || f.tile_height == 0)
        fail("usage: sent WIDTHxHEIGHT TILExTILE FORMAT");
    const int format = tp_format_find(argv[3], (uint32_t)strlen(argv[3]));
    f.format = format < 0 ? TP_FORMAT_COUNT : (tp_format)format;
    const lcd_config config = config_of(&panel, &f);
    const size_t bytes = lcd_bytes(&config, &why);
    void *memory = calloc(1, bytes + 1), *pixels = calloc(4, f.tile_width * f.tile_height);
    if (!bytes || !memory || !pixels || lcd_open(&l, &config, memory) != LCD_OK)
        fail(lcd_status_text(why));
    for (int n = 0; n < 3; n++) {
        sent = 0;
        show(&l, &f, pixels);
    }
    printf("%" PRIu64 "\n", sent);
    free(memory);
    free(pixels);
    return 0;
}
