/* SPDX-License-Identifier: MIT */
/* Shared by tests of panels: a golden scene, its frames in any tiling, wires to a model
 * of a panel, and the comparison of the panel's picture. */
#ifndef TP_TESTS_LIB_LCD_H
#define TP_TESTS_LIB_LCD_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lcd/lcd.h"
#include "pixel/pixel.h"
#include "tests/lib/golden.h"
#include "tests/lib/lcd_panel.h"
#include "tidepool/modules.h"

enum { LATE_INDEX = 1 };                /* index in golden_frames */

static golden_scene shown;

static int open_shown(void **state)
{
    (void)state;
    return !golden_open(&shown, "assets/scenes/three-swells.ini");
}

static int close_shown(void **state)
{
    (void)state;
    golden_close(&shown);
    return 0;
}

/* -- frames ------------------------------------------------------------------------- */

typedef struct {
    tp_config config;
    tp_frame *frame;
    void     *block, *scratch;
} lcd_drawing;

static lcd_drawing drawing_open_with(const tp_program *program, uint32_t width,
                                     uint32_t height, uint32_t strip, uint32_t band,
                                     tp_format format)
{
    lcd_drawing d = { .config = { .width = width,
                                  .height = height,
                                  .tile_width = strip,
                                  .tile_height = band,
                                  .format = format,
                                  .program = program,
                                  .assets = &shown.assets.names } };
    const size_t bytes = tp_frame_bytes(&d.config, &shown.file.scene);
    d.block = malloc(bytes);
    d.scratch = malloc(tp_frame_scratch_bytes(&d.config, &shown.file.scene));
    assert_int_equal(
        tp_frame_init(&d.frame, &d.config, &shown.file.scene, d.block, bytes, NULL),
        TP_OK);
    tp_frame_begin(d.frame, shown.world[LATE_INDEX]);
    return d;
}

static inline lcd_drawing drawing_open(uint32_t width, uint32_t height, uint32_t strip,
                                       uint32_t band, tp_format format)
{
    return drawing_open_with(&tp_program_all, width, height, strip, band, format);
}

static void drawing_close(lcd_drawing *d)
{
    free(d->block);
    free(d->scratch);
}

/* Returns a picture drawn by the core without a panel; to be freed. */
static inline uint32_t *drawn_whole(uint32_t width, uint32_t height, tp_format format)
{
    lcd_drawing d = drawing_open(width, height, 0, height, format);
    uint32_t *pixels = malloc(sizeof *pixels * width * height);
    tp_tile tile;
    assert_true(tp_frame_draw_tile(d.frame, 0, d.scratch, &tile));
    for (uint32_t y = 0; y < height; y++)
        for (uint32_t x = 0; x < width; x++)
            pixels[y * width + x] = tp_pixel_read(format, (const uint8_t *)tile.pixels
                                                  + y * tile.stride, (int)x);
    drawing_close(&d);
    return pixels;
}

/* Returns the golden frame from tests/golden; to be freed. */
static inline uint32_t *golden_picture(tp_format format)
{
    char path[128];
    uint32_t width, height;
    snprintf(path, sizeof path, "tests/golden/three-swells/%s-%04u.png",
             tp_format_name(format), (unsigned)golden_frames[LATE_INDEX]);
    uint32_t *pixels = picture_read_png(path, "test", &width, &height);
    assert_non_null(pixels);
    assert_int_equal(width * 10000 + height, GOLDEN_WIDTH * 10000 + GOLDEN_HEIGHT);
    for (uint32_t i = 0; i < width * height; i++)
        pixels[i] &= 0xffffff;
    return pixels;
}

/* -- wires -------------------------------------------------------------------------- */

typedef struct {
    panel_model *panel;
    uint32_t  waits, blocked_from;      /* number of the first wait to time out; 0: none */
    bool      liar;                     /* waits return at once */
} bus;

static void bus_command(void *user, uint8_t byte)
{
    panel_model *p = ((bus *)user)->panel;
    if (p->waiting)
        panel_settle(p), p->faults++, p->fault = "a command while data are on their way";
    panel_byte(p, false, byte);
}

static void bus_data(void *user, const uint8_t *bytes, size_t count)
{
    panel_send(((bus *)user)->panel, bytes, count);
}

static bool bus_wait(void *user, lcd_until until)
{
    bus *b = user;
    if (++b->waits >= b->blocked_from && b->blocked_from)
        return false;
    if (until == LCD_IDLE)
        panel_idle(b->panel);
    else if (!b->liar)
        panel_settle(b->panel);
    return true;
}

static void bus_pause(void *user, uint32_t ms)
{
    panel_pause(((bus *)user)->panel, ms);
}

static inline lcd_wires wires_to(bus *b)
{
    return (lcd_wires){ b, bus_command, bus_data, bus_wait, bus_pause };
}

/* -- a panel and its driver --------------------------------------------------------- */

typedef struct {
    panel_model model;
    bus    wires;
    lcd    driver;
    void  *memory;
} lcd_screen;

static inline lcd_screen *screen_power(panel_model_kind kind)
{
    lcd_screen *s = calloc(1, sizeof *s);
    panel_power(&s->model, kind);
    s->model.late = 1;
    s->wires.panel = &s->model;
    return s;
}

static inline lcd_status screen_open(lcd_screen *s, lcd_config config)
{
    lcd_status why;
    config.wires = wires_to(&s->wires);
    const size_t bytes = lcd_bytes(&config, &why);
    if (!bytes)
        return why;
    free(s->memory);
    s->memory = malloc(bytes);                  /* exact size, watched by a sanitizer */
    assert_non_null(s->memory);
    return lcd_open(&s->driver, &config, s->memory);
}

static inline void screen_close(lcd_screen *s)
{
    free(s->memory);
    free(s);
}

/* Returns the panel's pixel at (x, y) of the picture's orientation: mirrored if
 * configured, then turned by `turn` quarters clockwise. */
static uint32_t screen_seen(const lcd_screen *s, int32_t x, int32_t y)
{
    const lcd_config *c = &s->driver.config;
    const lcd_panel *p = c->panel;
    const int32_t w = p->width, h = p->height;          /* upright panel */
    const int32_t width = c->turn & 1 ? h : w;          /* in the picture's orientation */
    const int32_t u = c->mirror ? width - 1 - x : x;
    const int32_t at[4][2] = { { u, y }, { w - 1 - y, u }, { w - 1 - u, h - 1 - y },
                               { y, h - 1 - u } };
    const int32_t gx = at[c->turn][0], gy = at[c->turn][1];
    return panel_seen(&s->model, p->x + (uint32_t)gx, p->y + (uint32_t)gy);
}

/* Returns the number of wrong pixels on the panel: the picture at its place, untouched
 * elsewhere. */
static inline uint32_t screen_wrong(const lcd_screen *s, const uint32_t *right)
{
    const lcd_config *c = &s->driver.config;
    const int32_t w = (int32_t)c->frame.width, h = (int32_t)c->frame.height;
    uint32_t wrong = 0;
    for (int32_t y = 0; y < s->driver.height; y++)
        for (int32_t x = 0; x < s->driver.width; x++) {
            const int32_t px = x - c->x, py = y - c->y;
            const bool in = px >= 0 && py >= 0 && px < w && py < h;
            wrong += screen_seen(s, x, y) != (in ? right[py * w + px] : PANEL_NOTHING);
        }
    return wrong;
}
#endif
