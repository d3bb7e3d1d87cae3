/* SPDX-License-Identifier: MIT */
/* Wires of panels: late transfers, waits that time out, refused configurations; and the
 * model itself, which must find a driver's faults. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/lcd.h"

enum { BAND = 16 };

static const tp_format format = TP_FORMAT_RGB565BE;

/* -- two buffers -------------------------------------------------------------------- */

static panel_model *watched;

/* Counts pixels drawn while a transfer is running. */
static void store_watched(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                          int count)
{
    if (watched->waiting)
        watched->overlapped += (uint32_t)count;
    tp_store_rgb565be(row, x_in_row, x, y, colours, count);
}

static tp_program watched_program(void)
{
    tp_program program = tp_program_all;
    program.store[format] = store_watched;
    return program;
}

typedef struct {
    uint32_t wrong, faults, overwritten, overlapped;
} outcome;

/* Sends two frames over wires with up to `late` transfers pending. */
static outcome outcome_of(uint32_t strip, uint32_t late, bool liar, bool one_buffer)
{
    const tp_program program = watched_program();
    lcd_screen *s = screen_power(PANEL_ST7789);
    watched = &s->model;
    lcd_drawing d =
        drawing_open_with(&program, GOLDEN_WIDTH, GOLDEN_HEIGHT, strip, BAND, format);
    uint32_t *right = golden_picture(format);
    const lcd_config c = { .panel = &lcd_st7789, .frame = d.config };
    assert_int_equal(screen_open(s, c), LCD_OK);
    s->model.late = late;
    s->wires.liar = liar;
    if (one_buffer)
        s->driver.buffer[1] = s->driver.buffer[0];
    for (int i = 0; i < 2; i++)
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    panel_settle(&s->model);
    const outcome o = { screen_wrong(s, right), s->model.faults, s->model.overwritten,
                        s->model.overlapped };
    free(right);
    drawing_close(&d);
    screen_close(s);
    return o;
}

/* The whole frame but its first tile is drawn while the tile before is being sent. */
static void a_tile_is_drawn_while_the_last_one_is_sent(void **state)
{
    (void)state;
    const outcome late = outcome_of(0, 1, false, false),
                  now = outcome_of(0, 0, false, false);
    assert_int_equal(late.wrong + late.faults + late.overwritten, 0);
    assert_int_equal(now.wrong + now.faults + now.overwritten, 0);
    assert_int_equal(late.overlapped, 2 * GOLDEN_WIDTH * (GOLDEN_HEIGHT - BAND));
    assert_int_equal(now.overlapped, 0);
    const outcome strips = outcome_of(48, 1, false, false);
    assert_int_equal(strips.wrong + strips.faults + strips.overwritten, 0);
    assert_int_equal(strips.overlapped, 2 * (GOLDEN_WIDTH * GOLDEN_HEIGHT - 48 * BAND));
}

/* The same wires, but the wait function returns at once: the driver reuses a buffer too
 * early. */
static void a_driver_that_does_not_wait_is_found(void **state)
{
    (void)state;
    const outcome o = outcome_of(0, PANEL_PENDING - 1, true, false);
    assert_true(o.overwritten > 0);
    assert_true(o.wrong > 0);
    assert_true(o.faults > 0);
}

static void a_driver_with_one_buffer_is_found(void **state)
{
    (void)state;
    const outcome o = outcome_of(0, 1, false, true);
    assert_true(o.overwritten > 0);
    assert_true(o.wrong > 0);
}

static void wires_may_do_without_waiting(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 64, BAND, format);
    uint32_t *right = golden_picture(format);
    lcd_screen *s = screen_power(PANEL_ILI9341);
    lcd_config c = { .panel = &lcd_ili9341, .frame = d.config, .turn = 3 };
    s->model.late = 0;
    assert_int_equal(screen_open(s, c), LCD_OK);
    s->driver.config.wires.wait = NULL;
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    assert_int_equal(screen_wrong(s, right) + s->model.faults, 0);
    screen_close(s);
    free(right);
    drawing_close(&d);
}

/* -- a blocked panel ---------------------------------------------------------------- */

/* A timeout at any wait of a frame: an error, twice; world and frame are unchanged; the
 * next frame is complete. */
static void a_blocked_panel_is_an_error_and_no_more(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(GOLDEN_WIDTH, GOLDEN_HEIGHT, 112, 32, format);
    uint32_t *right = golden_picture(format);
    const size_t world_bytes =
        tp_world_bytes(&tp_program_all, &shown.file.scene, &shown.assets.names);
    const size_t frame_bytes = tp_frame_bytes(&d.config, &shown.file.scene);
    uint8_t *before = malloc(world_bytes + frame_bytes);
    memcpy(before, shown.world[LATE_INDEX], world_bytes);
    memcpy(before + world_bytes, d.block, frame_bytes);
    lcd_screen *s = screen_power(PANEL_ILI9341);
    const lcd_config c = { .panel = &lcd_ili9341, .frame = d.config };
    assert_int_equal(screen_open(s, c), LCD_OK);
    s->wires.waits = 0;
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
    const uint32_t waits = s->wires.waits;
    assert_true(waits > 20);
    for (uint32_t k = 1; k <= waits - 1; k++) {         /* lit already: one wait less */
        s->wires.waits = 0;
        s->wires.blocked_from = k;
        const uint32_t frames = s->driver.frames;
        for (int i = 0; i < 2; i++)
            assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_E_BLOCKED);
        assert_int_equal(s->driver.frames, frames);
        assert_memory_equal(before, shown.world[LATE_INDEX], world_bytes);
        assert_memory_equal(before + world_bytes, d.block, frame_bytes);
        s->wires.blocked_from = 0;
        for (size_t i = 0; i < sizeof s->model.memory / sizeof *s->model.memory; i++)
            s->model.memory[i] = PANEL_NOTHING;
        assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_OK);
        assert_int_equal(screen_wrong(s, right), 0);
        assert_int_equal(s->model.overwritten, 0);
    }
    free(before);
    free(right);
    drawing_close(&d);
    screen_close(s);
}

static void a_panel_that_is_not_there_is_found_at_the_start(void **state)
{
    (void)state;
    const lcd_config c = { .panel = &lcd_ili9341,
                           .frame = { .width = 240, .height = 320, .format = format } };
    for (uint32_t k = 1; k < 8; k++) {
        lcd_screen *s = screen_power(PANEL_ILI9341);
        s->wires.blocked_from = k;
        assert_int_equal(screen_open(s, c), LCD_E_BLOCKED);
        s->wires.blocked_from = 0;
        panel_power(&s->model, PANEL_ILI9341);          /* as by the reset line */
        assert_int_equal(screen_open(s, c), LCD_OK);
        assert_int_equal(s->model.faults, 0);
        screen_close(s);
    }
}

/* -- refused ------------------------------------------------------------------------ */

static lcd_status refusal(lcd_config c)
{
    lcd_screen *s = screen_power(c.panel == &lcd_ssd1680 ? PANEL_SSD1680 : PANEL_ILI9341);
    uint64_t memory[64];
    lcd_status why = LCD_OK;
    const lcd_status all = screen_open(s, c);
    if (all != LCD_OK) {
        c.wires = wires_to(&s->wires);
        assert_int_equal(lcd_bytes(&c, &why), 0);
        assert_int_equal(why, all);
        assert_int_equal(lcd_bytes(&c, NULL), 0);
        assert_int_equal(lcd_open(&s->driver, &c, memory), all);
        assert_int_equal(s->model.bytes, 0);            /* nothing sent */
    }
    screen_close(s);
    return all;
}

static void bad_configs_are_refused(void **state)
{
    (void)state;
    const lcd_config good = {
        .panel = &lcd_ili9341, .frame = { .width = 240, .height = 320, .format = format }
    };
    lcd_config c;
#define REFUSED(why, change) c = good, c.change, assert_int_equal(refusal(c), why)
    assert_int_equal(refusal(good), LCD_OK);
    REFUSED(LCD_E_TURN, turn = 4);
    REFUSED(LCD_E_TURN, turn = 255);
    REFUSED(LCD_E_FORMAT, frame.format = TP_FORMAT_RGB565);
    REFUSED(LCD_E_FORMAT, frame.format = (tp_format)77);
    REFUSED(LCD_E_SIZE, frame.width = 15);
    REFUSED(LCD_E_SIZE, frame.height = 0);
    REFUSED(LCD_E_SIZE, frame.width = 4097);
    REFUSED(LCD_E_SIZE, frame.height = UINT32_MAX);
    REFUSED(LCD_E_SIZE, frame.tile_width = 24);
    REFUSED(LCD_E_SIZE, x = 240);
    REFUSED(LCD_E_SIZE, x = -240);
    REFUSED(LCD_E_SIZE, y = 320);
    REFUSED(LCD_E_SIZE, y = -320);
    REFUSED(LCD_E_SIZE, x = INT16_MIN);
    REFUSED(LCD_OK, x = 239);
    REFUSED(LCD_OK, y = -319);
    REFUSED(LCD_OK, frame.tile_height = UINT32_MAX);    /* means the picture's height */
    c = good, c.panel = &lcd_ssd1680,
    c.frame = (tp_config){
        .width = 122, .height = 250, .tile_height = 8, .format = TP_FORMAT_I1
    };
    assert_int_equal(refusal(c), LCD_OK);
    c.turn = 1;
    assert_int_equal(refusal(c), LCD_E_TURN);
    c.turn = 0, c.mirror = true;
    assert_int_equal(refusal(c), LCD_E_TURN);
    c.mirror = false, c.x = 4;
    assert_int_equal(refusal(c), LCD_E_PLACE);
    c.x = -8;
    assert_int_equal(refusal(c), LCD_OK);
#undef REFUSED
}

static void missing_wires_are_refused(void **state)
{
    (void)state;
    bus b = { 0 };
    lcd_config c = { .panel = &lcd_ili9341,
                     .frame = { .width = 240, .height = 320, .format = format } };
    lcd_status why;
    for (int i = 0; i < 4; i++) {
        c.wires = wires_to(&b);
        if (i == 0) c.wires.command = NULL;
        if (i == 1) c.wires.data = NULL;
        if (i == 2) c.wires.pause = NULL;
        if (i == 3) c.wires.wait = NULL;                /* unused without BUSY */
        assert_int_equal(lcd_bytes(&c, &why) != 0, i == 3);
        assert_int_equal(why, i == 3 ? LCD_OK : LCD_E_WIRES);
    }
    c.panel = &lcd_ssd1680;
    c.frame.format = TP_FORMAT_I1;
    assert_int_equal(lcd_bytes(&c, &why), 0);
    assert_int_equal(why, LCD_E_WIRES);
    for (int i = 0; i < LCD_STATUS_COUNT; i++)
        assert_true(strlen(lcd_status_text((lcd_status)i)) > 1);
    assert_string_equal(lcd_status_text((lcd_status)99), "");
}

static void a_frame_of_larger_tiles_is_refused(void **state)
{
    (void)state;
    lcd_drawing d = drawing_open(240, 320, 0, 32, format);
    lcd_screen *s = screen_power(PANEL_ILI9341);
    const lcd_config c = { .panel = &lcd_ili9341,
                           .frame = { .width = 240, .height = 320, .format = format } };
    assert_int_equal(screen_open(s, c), LCD_OK);
    assert_int_equal(lcd_show(&s->driver, d.frame, d.scratch), LCD_E_SIZE);
    assert_int_equal(s->model.pixels, 0);
    screen_close(s);
    drawing_close(&d);
}

/* -- the model ---------------------------------------------------------------------- */

/* Sends bytes to an awake panel, commands as 1xx.  Returns the fault found, or NULL. */
static const char *fault_of(panel_model_kind kind, const uint16_t *bytes, size_t count)
{
    static panel_model p;
    panel_power(&p, kind);
    const uint16_t dcs[] = { 0x101, 0x13a, 0x55, 0x111 },
                   paper[] = { 0x112, 0x111, 3, 0x144, 0, 15,    0x145, 0,
                               0,     249,   0, 0x14e, 0, 0x14f, 0,     0 };
    const bool e = kind == PANEL_SSD1680;
    const uint16_t *start = e ? paper : dcs;
    for (size_t i = 0; i < (e ? sizeof paper : sizeof dcs) / sizeof *dcs; i++) {
        panel_byte(&p, !(start[i] >> 8), (uint8_t)start[i]);
        panel_pause(&p, 120);
        panel_idle(&p);
    }
    assert_int_equal(p.faults, 0);
    for (size_t i = 0; i < count; i++)
        panel_byte(&p, !(bytes[i] >> 8), (uint8_t)bytes[i]);
    return p.fault;
}

#define FAULT(kind, ...) \
    fault_of(kind, (const uint16_t[]){ __VA_ARGS__ }, \
             sizeof((const uint16_t[]){ __VA_ARGS__ }) / sizeof(uint16_t))

static void the_model_refuses_what_data_sheets_do(void **state)
{
    (void)state;
    const panel_model_kind ili = PANEL_ILI9341, st = PANEL_ST7789, e = PANEL_SSD1680;
    assert_null(FAULT(ili, 0x12a, 0, 0, 0, 239, 0x12b, 0, 0, 1, 63, 0x12c, 1, 2, 0x129));
    assert_null(FAULT(st, 0x12c, 1, 2, 0x129, 0x13c, 3, 4, 0x100));
    assert_non_null(FAULT(ili, 0x12a, 0, 0, 0, 240));           /* beyond the memory */
    assert_null(FAULT(ili, 0x136, 0x20, 0x12a, 0, 0, 0, 240));  /* allowed when turned */
    assert_non_null(FAULT(ili, 0x12a, 0, 9, 0, 8));             /* backwards */
    assert_non_null(FAULT(ili, 0x12a, 0, 0, 0, 0x12b));         /* too few arguments */
    assert_non_null(FAULT(ili, 0x12a, 0, 0, 0, 9, 9));          /* too many */
    assert_non_null(FAULT(ili, 0x12c, 1, 0x129));               /* half a pixel */
    assert_non_null(FAULT(ili, 7));                             /* data without a command */
    assert_non_null(FAULT(ili, 0x13c, 1, 2));                   /* no write to go on */
    assert_non_null(FAULT(ili, 0x13a, 0x66, 0x12c, 1, 2));      /* 18 bits per pixel */
    assert_non_null(FAULT(ili, 0x101, 0x13a, 0x55));            /* 5 ms are not over */
    assert_non_null(FAULT(st, 0x1c0, 0x23));                    /* of the other panel */
    assert_null(FAULT(e, 0x124, 1, 2, 3, 0x122, 0xf7, 0x120));
    assert_non_null(FAULT(e, 0x144, 0, 22));
    assert_non_null(FAULT(e, 0x145, 0, 0, 40, 1));
    assert_non_null(FAULT(e, 0x14e, 16, 0x124, 1));             /* outside of the window */
    assert_non_null(FAULT(e, 0x122, 0xf7, 0x120, 0x124));       /* while BUSY */
    assert_non_null(FAULT(e, 0x122, 0x30, 0x120));              /* voltages off */
    assert_non_null(FAULT(e, 0x111, 0));
}

/* A full window wraps to its start; a write continues after other commands. */
static void the_model_wraps_and_goes_on(void **state)
{
    (void)state;
    static panel_model p;
    panel_power(&p, PANEL_ST7789);
    static const uint16_t bytes[] = { 0x101, 0x111, 0x13a, 0x55, 0x121, 0x129,
                                      0x12a, 0,     3,     0,    4,     0x12b,
                                      0,     5,     0,     6,    0x12c, 0,
                                      1,     0,     2,     0,    3,     0x100,
                                      0x13c, 0,     4,     0,    5 };
    for (size_t i = 0; i < sizeof bytes / sizeof *bytes; i++) {
        panel_byte(&p, !(bytes[i] >> 8), (uint8_t)bytes[i]);
        panel_pause(&p, 120);
    }
    assert_int_equal(p.faults, 0);
    assert_int_equal(p.wraps, 1);
    assert_int_equal(p.memory[5 * PANEL_COLS + 3], 5);
    assert_int_equal(p.memory[5 * PANEL_COLS + 4], 2);
    assert_int_equal(p.memory[6 * PANEL_COLS + 3], 3);
    assert_int_equal(p.memory[6 * PANEL_COLS + 4], 4);
    assert_int_equal(panel_seen(&p, 3, 6), 3 << 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tile_is_drawn_while_the_last_one_is_sent),
        cmocka_unit_test(a_driver_that_does_not_wait_is_found),
        cmocka_unit_test(a_driver_with_one_buffer_is_found),
        cmocka_unit_test(wires_may_do_without_waiting),
        cmocka_unit_test(a_blocked_panel_is_an_error_and_no_more),
        cmocka_unit_test(a_panel_that_is_not_there_is_found_at_the_start),
        cmocka_unit_test(bad_configs_are_refused),
        cmocka_unit_test(missing_wires_are_refused),
        cmocka_unit_test(a_frame_of_larger_tiles_is_refused),
        cmocka_unit_test(the_model_refuses_what_data_sheets_do),
        cmocka_unit_test(the_model_wraps_and_goes_on),
    };
    return cmocka_run_group_tests_name("wires of panels", tests, open_shown, close_shown);
}
