/* SPDX-License-Identifier: MIT */
/* An OLED of 16 greys (SSD0323), by a model of its bytes: for any tiling it shows the
 * upper four bits of the picture's greys.  The model uses nothing of the driver, and
 * rejects bytes not in the data sheet. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/lcd.h"

enum { WIDE = 128, HIGH = 64, COLS = 64, ROWS = 80, UNTOUCHED = 0x100 };

typedef struct {
    uint16_t memory[ROWS * COLS];           /* bytes, or UNTOUCHED */
    uint8_t  command, argument[8];
    uint32_t taken, wanted;                 /* arguments of the current command */
    uint8_t  col0, col1, row0, row1, col, row;
    bool     lit, remapped;
    uint32_t pixels, bytes, faults;
} grey;

/* Returns the number of arguments of a command; -1: unknown command. */
static int arguments_of(uint8_t command)
{
    switch (command) {
    case 0x15: case 0x75:
        return 2;
    case 0x81: case 0xa0: case 0xa1: case 0xa2: case 0xa8: case 0xad: case 0xb0:
    case 0xb1: case 0xb2: case 0xb3: case 0xb4: case 0xbc: case 0xbe: case 0xbf:
        return 1;
    case 0xb8:
        return 8;
    case 0x84: case 0x85: case 0x86: case 0xa4: case 0xa5: case 0xa6: case 0xa7:
    case 0xae: case 0xaf: case 0xe3:
        return 0;
    default:
        return -1;
    }
}

static void window(uint8_t *first, uint8_t *last, uint8_t *at, const uint8_t *argument,
                   uint8_t end, grey *g)
{
    g->faults += argument[0] > argument[1] || argument[1] >= end;
    *first = *at = argument[0];
    *last = argument[1];
}

static void obey(grey *g)
{
    switch (g->command) {
    case 0x15: window(&g->col0, &g->col1, &g->col, g->argument, COLS, g); break;
    case 0x75: window(&g->row0, &g->row1, &g->row, g->argument, ROWS, g); break;
    case 0xa0: g->remapped = g->argument[0] == 0x52; break;
    case 0xae: g->lit = false; break;
    case 0xaf: g->lit = true; break;
    default:   break;
    }
}

static void grey_command(void *user, uint8_t byte)
{
    grey *g = user;
    g->bytes++;
    if (g->taken == g->wanted) {
        const int count = arguments_of(byte);
        g->faults += count < 0;
        g->command = byte;
        g->taken = 0;
        g->wanted = count > 0 ? (uint32_t)count : 0;
    } else {
        g->argument[g->taken++] = byte;
    }
    if (g->taken == g->wanted)
        obey(g);
}

/* Stores bytes row by row into the window, wrapping to its start. */
static void grey_data(void *user, const uint8_t *bytes, size_t count)
{
    grey *g = user;
    g->faults += g->taken < g->wanted;
    g->bytes += (uint32_t)count;
    for (; count > 0; count--, bytes++) {
        g->memory[g->row * COLS + g->col] = *bytes;
        g->pixels += 2;
        if (g->col++ < g->col1)
            continue;
        g->col = g->col0;
        g->row = g->row < g->row1 ? g->row + 1 : g->row0;
    }
}

static void grey_pause(void *user, uint32_t ms)
{
    (void)user;
    (void)ms;
}

/* Returns the grey of a pixel; the left pixel is in the high half of a byte.  UNTOUCHED:
 * never written. */
static uint32_t grey_seen(const grey *g, uint32_t x, uint32_t y)
{
    const uint32_t byte = g->memory[y * COLS + x / 2];
    return byte == UNTOUCHED ? UNTOUCHED : x % 2 ? byte & 15 : byte >> 4;
}

/* -- frames ------------------------------------------------------------------------- */

typedef struct { grey model; lcd driver; void *memory; } oled;

static oled *oled_open(lcd_config config)
{
    oled *o = calloc(1, sizeof *o);
    for (int i = 0; i < ROWS * COLS; i++)
        o->model.memory[i] = UNTOUCHED;
    config.panel = &lcd_ssd0323;
    config.wires = (lcd_wires){ &o->model, grey_command, grey_data, NULL, grey_pause };
    o->memory = malloc(lcd_bytes(&config, NULL));
    assert_int_equal(lcd_open(&o->driver, &config, o->memory), LCD_OK);
    return o;
}

static void oled_close(oled *o)
{
    free(o->memory);
    free(o);
}

static void show(oled *o, uint32_t width, uint32_t height, uint32_t strip, uint32_t band)
{
    lcd_drawing d = drawing_open(width, height, strip, band, TP_FORMAT_L8);
    assert_int_equal(lcd_show(&o->driver, d.frame, d.scratch), LCD_OK);
    drawing_close(&d);
}

/* Returns the number of panel pixels unlike the picture placed at (x, y). */
static uint32_t wrong(const oled *o, const uint32_t *right, int32_t x, int32_t y,
                      int32_t width, int32_t height)
{
    uint32_t n = 0;
    for (int32_t v = 0; v < HIGH; v++)
        for (int32_t u = 0; u < WIDE; u++) {
            const int32_t px = u - x, py = v - y;
            const bool in = px >= 0 && py >= 0 && px < width && py < height;
            const uint32_t want = in ? (right[py * width + px] & 0xff) >> 4 : UNTOUCHED;
            n += grey_seen(&o->model, (uint32_t)u, (uint32_t)v) != want;
        }
    return n;
}

static void every_tiling_shows_the_same(void **state)
{
    static const uint32_t strips[] = { 0, 16, 32, 48, 112 }, bands[] = { 0, 1, 3, 8, 40 };
    (void)state;
    uint32_t *right = drawn_whole(WIDE, HIGH, TP_FORMAT_L8);
    for (size_t i = 0; i < 5; i++)
        for (size_t j = 0; j < 5; j++) {
            oled *o = oled_open((lcd_config){ .frame = { .width = WIDE,
                                                         .height = HIGH,
                                                         .tile_width = strips[i],
                                                         .tile_height = bands[j],
                                                         .format = TP_FORMAT_L8 } });
            assert_true(!o->model.lit && o->model.remapped);
            show(o, WIDE, HIGH, strips[i], bands[j]);
            assert_int_equal(wrong(o, right, 0, 0, WIDE, HIGH), 0);
            assert_int_equal(o->model.pixels, WIDE * HIGH);
            assert_int_equal(o->model.faults, 0);
            assert_int_equal(o->driver.sent, o->model.bytes);
            assert_true(o->model.lit);
            right[0] ^= 0x10;                   /* a changed picture is found */
            assert_int_equal(wrong(o, right, 0, 0, WIDE, HIGH), 1);
            right[0] ^= 0x10;
            oled_close(o);
        }
    free(right);
}

static void a_picture_may_lie_anywhere_on_whole_bytes(void **state)
{
    static const int16_t places[][2] = { { 0, 0 }, { 2, 7 }, { -6, -5 }, { 100, 50 } };
    (void)state;
    uint32_t *right = drawn_whole(48, 33, TP_FORMAT_L8);
    for (size_t i = 0; i < 4; i++) {
        oled *o = oled_open((lcd_config){ .frame = { .width = 48,
                                                     .height = 33,
                                                     .tile_width = 16,
                                                     .tile_height = 5,
                                                     .format = TP_FORMAT_L8 },
                                          .x = places[i][0],
                                          .y = places[i][1] });
        show(o, 48, 33, 16, 5);
        assert_int_equal(wrong(o, right, places[i][0], places[i][1], 48, 33), 0);
        assert_int_equal(o->model.faults, 0);
        oled_close(o);
    }
    free(right);
}

static void what_it_cannot_show_is_refused(void **state)
{
    (void)state;
    grey model = { 0 };
    lcd_config good = { .panel = &lcd_ssd0323,
                        .frame = { .width = WIDE,
                                   .height = HIGH,
                                   .tile_height = 8,
                                   .format = TP_FORMAT_L8 },
                        .wires = { &model, grey_command, grey_data, NULL, grey_pause } };
    lcd_config odd = good, turned = good, colour = good, beside = good;
    lcd_status why;
    odd.x = 1;
    turned.turn = 1;
    colour.frame.format = TP_FORMAT_RGB565BE;
    beside.y = HIGH;
    assert_int_equal(lcd_bytes(&good, &why), 2 * WIDE / 2 * 8);
    assert_true(!lcd_bytes(&odd, &why) && why == LCD_E_PLACE);
    assert_true(!lcd_bytes(&turned, &why) && why == LCD_E_TURN);
    assert_true(!lcd_bytes(&colour, &why) && why == LCD_E_FORMAT);
    assert_true(!lcd_bytes(&beside, &why) && why == LCD_E_SIZE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_shows_the_same),
        cmocka_unit_test(a_picture_may_lie_anywhere_on_whole_bytes),
        cmocka_unit_test(what_it_cannot_show_is_refused),
    };
    return cmocka_run_group_tests(tests, open_shown, close_shown);
}
