/* SPDX-License-Identifier: MIT */
/* Colour panels: models of ILI9341 and ST7789 show the golden frame, for strips and
 * bands of several sizes, every rotation, and late transfers. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/tools.h"
#include "tests/lib/lcd.h"
#include "tests/lib/random.h"

typedef struct {
    const char      *name;
    const lcd_panel *panel;
    panel_model_kind       kind;
} glass;

static const glass glasses[] = {
    { "ili9341 240x320", &lcd_ili9341, PANEL_ILI9341 },
    { "st7789 240x320", &lcd_st7789, PANEL_ST7789 },
    { "st7789 240x240", &lcd_st7789_240x240, PANEL_ST7789 },
    { "st7789 135x240", &lcd_st7789_135x240, PANEL_ST7789 },
};
enum { GLASSES = sizeof glasses / sizeof *glasses, WALKS = 8 };

static const tp_format format = TP_FORMAT_RGB565BE;

static lcd_config config_of(const lcd_panel *table, const lcd_drawing *d)
{
    return (lcd_config){ .panel = table, .frame = d->config };
}

static lcd_screen *opened(const glass *g, lcd_config config)
{
    lcd_screen *s = screen_power(g->kind);
    assert_int_equal(screen_open(s, config), LCD_OK);
    return s;
}

/* -- pictures ----------------------------------------------------------------------- */

/* Sends the same tiles to every panel in every orientation.  Returns the number of wrong
 * pixels. */
static uint32_t wrong_on_all(const lcd_drawing *d, const uint32_t *right)
{
    lcd_screen *all[GLASSES * WALKS];
    tp_tile tile;
    uint32_t wrong = 0;
    for (unsigned i = 0; i < GLASSES * WALKS; i++) {
        lcd_config c = config_of(glasses[i / WALKS].panel, d);
        c.turn = i & 3;
        c.mirror = i & 4;
        all[i] = opened(&glasses[i / WALKS], c);
        lcd_begin(&all[i]->driver);
    }
    for (uint32_t t = 0; tp_frame_draw_tile(d->frame, t, d->scratch, &tile); t++)
        for (unsigned i = 0; i < GLASSES * WALKS; i++)
            assert_int_equal(lcd_tile(&all[i]->driver, &tile), LCD_OK);
    for (unsigned i = 0; i < GLASSES * WALKS; i++) {
        assert_int_equal(lcd_end(&all[i]->driver), LCD_OK);
        const uint32_t here = screen_wrong(all[i], right) + all[i]->model.faults;
        if (here)
            printf("%s walk %u, tiles %ux%u: %u wrong, %s\n", glasses[i / WALKS].name,
                   i % WALKS, d->config.tile_width, d->config.tile_height, here,
                   all[i]->model.fault ? all[i]->model.fault : "no fault");
        wrong += here;
        assert_int_equal(all[i]->model.bytes, all[i]->driver.sent);
        assert_int_equal(all[i]->model.overwritten, 0);
        screen_close(all[i]);
    }
    return wrong;
}

static void every_tiling_and_turn_shows_the_golden_frame(void **state)
{
    (void)state;
    static const uint32_t strips[] = { 0, 16, 48, 64 }, bands[] = { 7, 1, 16, 0 };
    uint32_t *right = golden_picture(format), wrong = 0;
    for (unsigned i = 0; i < 16; i += (unsigned)random_rounds(1, 3)) {
        lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, strips[i / 4],
                                     bands[i % 4], format);
        wrong += wrong_on_all(&d, right);
        drawing_close(&d);
    }
    free(right);
    assert_int_equal(wrong, 0);
}

static void another_pixel_is_found(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 0, 16, format);
    uint32_t *right = golden_picture(format);
    lcd_screen *s = opened(&glasses[0], config_of(&lcd_ili9341, &d));
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    assert_int_equal(screen_wrong(s, right), 0);
    s->model.memory[50 * PANEL_COLS + 200] ^= 1;
    assert_int_equal(screen_wrong(s, right), 1);
    screen_close(s);
    free(right);
    drawing_close(&d);
}

/* A driver with another panel's table shows a wrong picture. */
static void the_wrong_table_is_found(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 0, 16, format);
    uint32_t *right = golden_picture(format);
    lcd_panel not_this = lcd_ili9341;
    not_this.upright = 0;
    lcd_screen *s = opened(&glasses[0], config_of(&not_this, &d));
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    assert_true(screen_wrong(s, right) > GOLDEN_WIDTH * GOLDEN_HEIGHT / 2);
    screen_close(s);
    free(right);
    drawing_close(&d);
}

static void the_other_order_of_colours_is_for_the_other_glass(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 0, 16, format);
    uint32_t *right = golden_picture(format);
    lcd_config c = config_of(&lcd_st7789, &d);
    c.bgr = true;
    lcd_screen *s = opened(&glasses[1], c);
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    for (uint32_t i = 0; i < GOLDEN_WIDTH * GOLDEN_HEIGHT; i++)
        right[i] = right[i] >> 16 | (right[i] & 0xff00) | (right[i] & 0xff) << 16;
    assert_int_equal(screen_wrong(s, right), 0);
    screen_close(s);
    free(right);
    drawing_close(&d);
}

/* -- positions ---------------------------------------------------------------------- */

static void a_picture_may_lie_anywhere(void **state)
{
    (void)state;
    static const int16_t place[][2] = { { 16, 85 }, { -37, 0 }, { 0, -91 }, { 131, 300 },
                                        { -200, -149 }, { 112, -8 }, { -1, 319 } };
    lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 48, 7, format);
    uint32_t *right = golden_picture(format);
    for (size_t i = 0; i < sizeof place / sizeof *place; i++) {
        lcd_config c = config_of(&lcd_st7789, &d);
        c.x = place[i][0];
        c.y = place[i][1];
        lcd_screen *s = opened(&glasses[1], c);
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        assert_int_equal(screen_wrong(s, right), 0);
        assert_int_equal(s->model.faults, 0);
        assert_int_equal(s->model.wraps <= s->driver.windows, true);
        screen_close(s);
    }
    free(right);
    drawing_close(&d);
}

static void a_picture_larger_than_the_glass_is_cut(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(640, 480, 64, 50, format);
    uint32_t *right = drawn_whole(640, 480, format);
    for (unsigned i = 0; i < GLASSES; i++) {
        lcd_config c = config_of(glasses[i].panel, &d);
        c.x = -201;
        c.y = -153;
        c.turn = i & 3;
        lcd_screen *s = opened(&glasses[i], c);
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        assert_int_equal(screen_wrong(s, right), 0);
        assert_int_equal(s->model.faults, 0);
        assert_int_equal(s->model.pixels, s->driver.width * s->driver.height);
        screen_close(s);
    }
    free(right);
    drawing_close(&d);
}

/* A cleared panel is black beside the picture; clearing takes a window per sixteen
 * columns. */
static void a_cleared_glass_is_black_beside_the_picture(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(112, 96, 48, 7, format);
    uint32_t *right = drawn_whole(112, 96, format);
    for (unsigned i = 0; i < GLASSES * WALKS; i++) {
        lcd_config c = config_of(glasses[i / WALKS].panel, &d);
        c.turn = i & 3;
        c.mirror = i & 4;
        c.x = 11;
        c.y = 20;
        uint32_t wrong = 0;
        lcd_screen *s = opened(&glasses[i / WALKS], c);
        assert_int_equal(lcd_clear(&s->driver, 0), LCD_OK);
        assert_int_equal(s->driver.windows, (s->driver.width + 15) / 16);
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        assert_int_equal(s->model.pixels, s->driver.width * s->driver.height + 112 * 96);
        assert_int_equal(s->model.faults + s->model.overwritten, 0);
        for (int32_t y = 0; y < s->driver.height; y++)
            for (int32_t x = 0; x < s->driver.width; x++) {
                const int32_t u = x - c.x, v = y - c.y;
                const bool in = u >= 0 && v >= 0 && u < 112 && v < 96;
                wrong += screen_seen(s, x, y) != (in ? right[v * 112 + u] : 0);
            }
        assert_int_equal(wrong, 0);
        screen_close(s);
    }
    free(right);
    drawing_close(&d);
}

/* -- bytes -------------------------------------------------------------------------- */

/* A window takes 11 bytes for columns, rows and the write command; a pixel two bytes. */
static void bands_take_one_window_and_strips_one_each(void **state)
{
    (void)state;
    static const uint32_t tiling[][2] = { { 0, 0 }, { 0, 16 }, { 0, 1 }, { 160, 16 },
                                          { 64, 16 }, { 64, 6 }, { 16, 240 } };
    uint32_t *right = drawn_whole(320, 240, format);
    for (size_t i = 0; i < sizeof tiling / sizeof *tiling; i++) {
        lcd_drawing d = drawing_open(320, 240, tiling[i][0], tiling[i][1], format);
        lcd_config c = config_of(&lcd_ili9341, &d);
        c.turn = 1;
        lcd_screen *s = opened(&glasses[0], c);
        const uint32_t tiles = tp_frame_tiles(d.frame);
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        const uint64_t before = s->driver.sent;
        const uint32_t windows = s->driver.windows;
        assert_int_equal(windows, tiling[i][0] && tiling[i][0] < 320 ? tiles : 1);
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        const uint64_t bytes = s->driver.sent - before;
        assert_int_equal(bytes, 320 * 240 * 2 + 11 * windows);
        assert_int_equal(screen_wrong(s, right), 0);
        printf("320x240 in tiles of %ux%u: %u bytes a frame, %u windows; buffers %zu\n",
               s->driver.config.frame.tile_width, s->driver.config.frame.tile_height,
               (unsigned)bytes, windows, lcd_bytes(&s->driver.config, NULL));
        screen_close(s);
        drawing_close(&d);
    }
    free(right);
}

static void tiles_may_come_in_any_order(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 0, 16, format);
    uint32_t *right = golden_picture(format);
    lcd_screen *s = opened(&glasses[0], config_of(&lcd_ili9341, &d));
    tp_tile tile;
    lcd_begin(&s->driver);
    for (uint32_t i = tp_frame_tiles(d.frame); i-- > 0;) {
        assert_true(tp_frame_draw_tile(d.frame, i, d.scratch, &tile));
        assert_int_equal(lcd_tile(&s->driver, &tile), LCD_OK);
    }
    assert_int_equal(lcd_end(&s->driver), LCD_OK);
    assert_int_equal(screen_wrong(s, right), 0);
    assert_int_equal(s->model.faults, 0);
    screen_close(s);
    free(right);
    drawing_close(&d);
}

/* Hand-made tiles: the second one is below the first, but narrower. */
static void a_narrower_tile_has_a_window_of_its_own(void **state)
{
    (void)state;
    static uint8_t pixels[32 * 8 * 2];
    const tp_config f = { .width = 32, .height = 16, .tile_height = 8, .format = format };
    lcd_screen *s = opened(&glasses[1], (lcd_config){ .panel = &lcd_st7789, .frame = f });
    const tp_tile tiles[] = {
        { .x1 = 32, .y1 = 8, .pixels = pixels, .stride = 64 },
        { .y0 = 8, .x1 = 16, .y1 = 16, .pixels = pixels, .stride = 64 },
    };
    memset(pixels, 0x5a, sizeof pixels);
    lcd_begin(&s->driver);
    for (int i = 0; i < 2; i++)
        assert_int_equal(lcd_tile(&s->driver, &tiles[i]), LCD_OK);
    assert_int_equal(lcd_end(&s->driver), LCD_OK);
    for (uint32_t y = 0; y < 17; y++)
        for (uint32_t x = 0; x < 33; x++)
            assert_int_equal(s->model.memory[y * PANEL_COLS + x] == 0x5a5a,
                             x < (y < 8 ? 32u : y < 16 ? 16u : 0u));
    assert_int_equal(s->model.faults, 0);
    screen_close(s);
}

/* The panel stays dark until the first frame is complete. */
static void it_is_lit_when_there_is_a_picture(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 0, 16, format);
    for (unsigned i = 0; i < GLASSES; i++) {
        lcd_screen *s = opened(&glasses[i], config_of(glasses[i].panel, &d));
        assert_true(s->model.awake);
        assert_false(s->model.lit);
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        assert_true(s->model.lit);
        const uint64_t sent = s->driver.sent;
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        assert_true(s->driver.sent - sent > 0);
        assert_int_equal(s->model.faults, 0);
        screen_close(s);
    }
    drawing_close(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_and_turn_shows_the_golden_frame),
        cmocka_unit_test(another_pixel_is_found),
        cmocka_unit_test(the_wrong_table_is_found),
        cmocka_unit_test(the_other_order_of_colours_is_for_the_other_glass),
        cmocka_unit_test(a_picture_may_lie_anywhere),
        cmocka_unit_test(a_picture_larger_than_the_glass_is_cut),
        cmocka_unit_test(a_cleared_glass_is_black_beside_the_picture),
        cmocka_unit_test(bands_take_one_window_and_strips_one_each),
        cmocka_unit_test(tiles_may_come_in_any_order),
        cmocka_unit_test(a_narrower_tile_has_a_window_of_its_own),
        cmocka_unit_test(it_is_lit_when_there_is_a_picture),
    };
    return cmocka_run_group_tests_name("colour panels", tests, open_shown, close_shown);
}
