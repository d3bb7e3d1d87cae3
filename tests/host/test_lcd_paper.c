/* SPDX-License-Identifier: MIT */
/* E-paper: dithered pictures of 1 bit per pixel, full and partial updates, BUSY. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/lcd.h"

enum { WIDTH = 122, HEIGHT = 250, EVERY = 12 };

static const tp_format format = TP_FORMAT_I1;

static lcd_config config_of(const lcd_drawing *d, uint16_t whole_every)
{
    return (lcd_config){ .panel = &lcd_ssd1680, .frame = d->config,
                         .whole_every = whole_every };
}

static lcd_screen *opened(lcd_config config)
{
    lcd_screen *s = screen_power(PANEL_SSD1680);
    assert_int_equal(screen_open(s, config), LCD_OK);
    return s;
}

/* Returns the number of pixels unlike the picture, which covers the panel. */
static uint32_t wrong(const lcd_screen *s, const uint32_t *right, uint32_t width)
{
    uint32_t n = 0;
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++)
            n += panel_seen(&s->model, x, y) != right[y * width + x];
    return n;
}

static void every_tiling_shows_the_picture(void **state)
{
    (void)state;
    static const uint32_t strips[] = { 0, 16, 48, 64 }, bands[] = { 8, 1, 33, 0 };
    uint32_t *right = drawn_whole(WIDTH, HEIGHT, format);
    for (unsigned i = 0; i < 16; i++) {
        lcd_drawing d = drawing_open(WIDTH, HEIGHT, strips[i / 4], bands[i % 4], format);
        lcd_screen *s = opened(config_of(&d, 1));
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        assert_int_equal(wrong(s, right, WIDTH), 0);
        assert_int_equal(s->model.faults, 0);
        assert_int_equal(s->model.bytes, s->driver.sent);
        screen_close(s);
        drawing_close(&d);
    }
    free(right);
}

/* The golden frame is wider than the panel, and lower. */
static void the_golden_frame_is_cut_to_the_glass(void **state)
{
    (void)state;
    uint32_t *right = golden_picture(format);
    for (int16_t x = 0; x >= -80; x -= 40) {
        lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 48, 7, format);
        lcd_config c = config_of(&d, 1);
        c.x = x;
        c.y = 50;
        lcd_screen *s = opened(c);
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        uint32_t apart = 0;
        for (uint32_t y = 0; y < GOLDEN_HEIGHT; y++)
            for (uint32_t u = 0; u < WIDTH; u++)
                apart += panel_seen(&s->model, u, y + 50)
                         != right[y * GOLDEN_WIDTH + u + (uint32_t)-x];
        assert_int_equal(apart, 0);
        assert_int_equal(s->model.faults, 0);
        s->model.paper[100 * PANEL_COLS / 8 + 3] ^= 4;
        assert_true(panel_seen(&s->model, 29, 100)
                    != right[50 * GOLDEN_WIDTH + 29 + (uint32_t)-x]);
        screen_close(s);
        drawing_close(&d);
    }
    free(right);
}

/* Cleared, then a smaller picture is shown: white beside it, in both memories. */
static void a_cleared_paper_is_white_beside_the_picture(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(64, 100, 16, 9, format);
    uint32_t *right = drawn_whole(64, 100, format);
    lcd_config c = config_of(&d, 5);
    c.x = 24;
    c.y = 60;
    lcd_screen *s = opened(c);
    assert_int_equal(lcd_clear(&s->driver, 0xff), LCD_OK);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        for (uint32_t y = 0; y < HEIGHT; y++)
            for (uint32_t x = 0; x < WIDTH; x++) {
                const bool in = x >= 24 && x < 88 && y >= 60 && y < 160;
                assert_int_equal(panel_seen(&s->model, x, y),
                                 in ? right[(y - 60) * 64 + x - 24] : 0xffffff);
            }
    }
    assert_int_equal(s->model.partial, 2);
    assert_int_equal(s->model.faults, 0);
    screen_close(s);
    free(right);
    drawing_close(&d);
}

/* The paper turned by a quarter or a half: six rows or columns of the picture fall into
 * the memory's last six columns, outside of the glass. */
static uint32_t wrong_turned(unsigned turn, uint32_t strip, uint32_t band)
{
    const uint32_t width = turn & 1 ? 250 : 128, height = turn & 1 ? 128 : 250;
    lcd_drawing d = drawing_open(width, height, strip, band, format);
    uint32_t *right = drawn_whole(width, height, format), n = 0;
    lcd_config c = config_of(&d, 1);
    c.frame =
        (tp_config){ .width = 128, .height = 250, .tile_height = 250, .format = format };
    lcd_screen *s = opened(c);
    uint8_t *turned = malloc(128 / 8 * 250);
    tp_tile tile;
    lcd_begin(&s->driver);
    for (uint32_t i = 0; tp_frame_draw_tile(d.frame, i, d.scratch, &tile); i++) {
        const tp_tile t = lcd_turned(&tile, &d.config, turn, turned);
        assert_int_equal(lcd_tile(&s->driver, &t), LCD_OK);
    }
    assert_int_equal(lcd_end(&s->driver), LCD_OK);
    for (uint32_t y = 0; y < HEIGHT; y++)
        for (uint32_t x = 0; x < WIDTH; x++) {
            const uint32_t from[4][2] = { { x, y }, { y, 127 - x }, { 127 - x, 249 - y },
                                          { 249 - y, x } };
            n += panel_seen(&s->model, x, y)
                 != right[from[turn][1] * width + from[turn][0]];
        }
    n += s->model.faults;
    free(turned);
    free(right);
    screen_close(s);
    drawing_close(&d);
    return n;
}

static void paper_may_hang_any_way(void **state)
{
    (void)state;
    for (unsigned turn = 0; turn < 4; turn++) {
        assert_int_equal(wrong_turned(turn, 0, turn & 1 ? 8 : 25), 0);
        assert_int_equal(wrong_turned(turn, 0, turn & 1 ? 128 : 250), 0);
        assert_int_equal(wrong_turned(turn, 64, 16), 0);
    }
}

typedef struct {
    uint32_t wrong, updates, partial, faults;
    uint64_t bytes;
} paper_film;

/* A running world, shown every EVERY ticks and compared each time. */
static paper_film filmed(const lcd_panel *table, uint16_t whole_every, uint32_t frames,
                         uint32_t blocked_at)
{
    const size_t bytes =
        tp_world_bytes(&tp_program_all, &shown.file.scene, &shown.assets.names);
    tp_world *world = malloc(bytes);
    memcpy(world, shown.world[LATE_INDEX], bytes);
    lcd_drawing d = drawing_open(WIDTH, HEIGHT, 0, 25, format);
    lcd_config c = config_of(&d, whole_every);
    c.panel = table;
    lcd_screen *s = opened(c);
    uint32_t *right = malloc(sizeof *right * WIDTH * HEIGHT);
    paper_film f = { 0 };
    for (uint32_t n = 0; n < frames; n++) {
        tp_frame_begin(d.frame, world);
        tp_tile tile;
        for (uint32_t i = 0; tp_frame_draw_tile(d.frame, i, d.scratch, &tile); i++)
            for (uint32_t y = tile.y0; y < tile.y1; y++)
                for (uint32_t x = 0; x < WIDTH; x++)
                    right[y * WIDTH + x] = tp_pixel_read(
                        format,
                        (const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride,
                        (int)x);
        if (blocked_at && n == blocked_at) {
            s->wires.waits = 0;
            s->wires.blocked_from = 9;
            assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_E_BLOCKED);
            s->wires.blocked_from = 0;
        }
        const uint64_t sent = s->driver.sent;
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        f.bytes = s->driver.sent - sent;
        f.wrong += wrong(s, right, WIDTH);
        for (uint32_t i = 0; i < EVERY; i++)
            tp_world_step(&tp_program_all, world, &shown.file.scene, NULL);
    }
    f.updates = s->model.updates;
    f.partial = s->model.partial;
    f.faults = s->model.faults;
    free(right);
    free(world);
    screen_close(s);
    drawing_close(&d);
    return f;
}

static void partial_updates_show_each_frame(void **state)
{
    (void)state;
    const paper_film whole = filmed(&lcd_ssd1680, 0, 9, 0),
                     part = filmed(&lcd_ssd1680, 4, 9, 0);
    const paper_film last = filmed(&lcd_ssd1680, 4, 8, 0);
    assert_int_equal(whole.wrong + whole.faults + part.wrong + part.faults, 0);
    assert_int_equal(whole.updates, 9);
    assert_int_equal(whole.partial, 0);
    assert_int_equal(part.updates, 9);
    assert_int_equal(part.partial, 6);                  /* 0, 4 and 8 are full updates */
    printf("e-paper %dx%d: %u bytes a whole update, %u a partial one\n", WIDTH, HEIGHT,
           (unsigned)whole.bytes, (unsigned)last.bytes);
    assert_true(last.bytes < whole.bytes * 6 / 10);
}

/* A driver that does not write the old picture would leave pixels unchanged. */
static void a_forgotten_old_picture_is_found(void **state)
{
    (void)state;
    lcd_panel forgetful = lcd_ssd1680;
    forgetful.write_old = 0;
    assert_true(filmed(&forgetful, 4, 3, 0).wrong > 0);
    assert_int_equal(filmed(&forgetful, 1, 3, 0).wrong, 0);
}

/* An aborted frame leaves half a picture in the memory: the next update is a full one. */
static void after_a_blocked_frame_an_update_is_whole(void **state)
{
    (void)state;
    const paper_film f = filmed(&lcd_ssd1680, 100, 6, 3);
    assert_int_equal(f.wrong + f.faults, 0);
    assert_int_equal(f.updates, 6);
    assert_int_equal(f.partial, 4);
}

static bool no_busy(void *user, lcd_until until)
{
    return until == LCD_IDLE || bus_wait(user, until);
}

static void a_driver_that_ignores_busy_is_found(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(WIDTH, HEIGHT, 0, 25, format);
    lcd_screen *s = opened(config_of(&d, 1));
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    assert_int_equal(s->model.faults, 0);
    s->driver.config.wires.wait = no_busy;
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    assert_true(s->model.faults > 0);
    screen_close(s);
    drawing_close(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_shows_the_picture),
        cmocka_unit_test(the_golden_frame_is_cut_to_the_glass),
        cmocka_unit_test(a_cleared_paper_is_white_beside_the_picture),
        cmocka_unit_test(paper_may_hang_any_way),
        cmocka_unit_test(partial_updates_show_each_frame),
        cmocka_unit_test(a_forgotten_old_picture_is_found),
        cmocka_unit_test(after_a_blocked_frame_an_update_is_whole),
        cmocka_unit_test(a_driver_that_ignores_busy_is_found),
    };
    return cmocka_run_group_tests_name("e-paper", tests, open_shown, close_shown);
}
