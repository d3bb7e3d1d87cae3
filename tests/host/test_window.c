/* SPDX-License-Identifier: MIT */
/* The preview's window with SDL's driver without a display: layout, visible pixels, and
 * dragging of the bar. */
#define _POSIX_C_SOURCE 200809L
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/preview/window.h"

#define BAR 6

static window w;
static uint32_t pixels[64 * 48];
static uint32_t shown[400 * 200];       /* the window's content after look() */

static int end(void **state)
{
    (void)state;
    window_close(&w);
    return 0;
}

static picture some_picture(uint32_t width, uint32_t height)
{
    for (uint32_t i = 0; i < width * height; i++)
        pixels[i] = i * 2654435761u >> 8;
    return (picture){ .format = TP_FORMAT_XRGB8888, .width = width, .height = height,
                      .row_bytes = width * 4, .rows = (uint8_t *)pixels };
}

static void opened(int width, int height, int scale, int panel)
{
    const picture p = some_picture((uint32_t)width, (uint32_t)height);
    if (!window_open(&w, "test", width, height, scale, panel))
        fail_msg("%s", SDL_GetError());
    assert_true(window_upload(&w, &p));
}

static void resized(int wide, int high)
{
    SDL_SetWindowSize(w.window, wide, high);
    SDL_Event event;
    while (SDL_PollEvent(&event))
        window_event(&w, &event);
}

/* Draws and reads back; writes the size to *wide and *high. */
static void look(int scale, int *wide, int *high)
{
    SDL_GetWindowSize(w.window, wide, high);
    assert_in_range(*wide * *high, 1, 400 * 200);
    SDL_SetRenderDrawColor(w.renderer, 255, 0, 255, 255);
    SDL_RenderClear(w.renderer);
    window_clear(&w, scale);
    assert_int_equal(SDL_RenderReadPixels(w.renderer, NULL, SDL_PIXELFORMAT_ARGB8888, shown,
                                          *wide * 4), 0);
    window_present(&w);
}

/* Expects every pixel of the picture at its place, and nothing left from before. */
static void shows_the_picture(int scale)
{
    int wide, high, px, py, seen = 0;
    look(scale, &wide, &high);
    for (int y = 0; y < high; y++)
        for (int x = 0; x < wide; x++) {
            const uint32_t pixel = shown[y * wide + x] & 0xffffff;
            if (pixel == 0xff00ff)
                fail_msg("nothing is drawn at %d, %d", x, y);
            if (!window_pixel(&w, scale, x, y, &px, &py))
                continue;
            assert_in_range(px, 0, w.width - 1);
            assert_in_range(py, 0, w.height - 1);
            if (pixel != (pixels[py * w.width + px] & 0xffffff))
                fail_msg("%d, %d is not pixel %d, %d", x, y, px, py);
            seen++;
        }
    const layout at = window_layout(&w, scale);
    assert_int_equal(seen, SDL_min(at.room.w, at.picture.w)
                         * SDL_min(at.room.h, at.picture.h));
}

static bool mouse(uint32_t type, int x, int y, int clicks)
{
    SDL_Event event = { .type = type };
    if (type == SDL_MOUSEMOTION) {
        event.motion.x = x;
        event.motion.y = y;
        event.motion.state = clicks ? SDL_BUTTON_LMASK : 0;
    } else {
        event.button.button = SDL_BUTTON_LEFT;
        event.button.x = x;
        event.button.y = y;
        event.button.clicks = (uint8_t)clicks;
    }
    return window_event(&w, &event);
}

/* -- layout -------------------------------------------------------------------------- */

static void a_window_without_a_panel_is_the_picture(void **state)
{
    (void)state;
    opened(64, 48, 3, 0);
    const layout at = window_layout(&w, 3);
    assert_int_equal(at.room.w, 192);
    assert_int_equal(at.room.h, 144);
    assert_int_equal(at.bar.w, 0);
    assert_int_equal(at.panel.w, 0);
    assert_memory_equal(&at.picture, &at.room, sizeof at.room);
}

static void room_bar_and_panel_share_the_window(void **state)
{
    (void)state;
    opened(64, 48, 3, 130);
    const layout at = window_layout(&w, 3);
    assert_int_equal(at.room.w, 192);
    assert_int_equal(at.bar.x, 192);
    assert_int_equal(at.bar.w, BAR);
    assert_int_equal(at.panel.x, 192 + BAR);
    assert_int_equal(at.panel.w, 130);
    assert_int_equal(at.panel.h, 144);
}

static void a_narrow_window_keeps_room_for_the_picture(void **state)
{
    (void)state;
    opened(64, 48, 3, 130);
    resized(160, 150);
    const layout at = window_layout(&w, 3);
    assert_int_equal(at.room.w, 64);
    assert_int_equal(at.room.w + at.bar.w + at.panel.w, 160);
    assert_int_equal(w.panel, 130);
}

static void the_largest_picture_fits_whole(void **state)
{
    uint32_t width, height;
    (void)state;
    opened(64, 48, 3, 130);
    window_fits(&w, 3, &width, &height);
    assert_int_equal(width, 64);
    assert_int_equal(height, 48);
    window_fits(&w, 5, &width, &height);
    assert_int_equal(width, 38);
    assert_int_equal(height, 28);
    window_fits(&w, 100, &width, &height);
    assert_int_equal(width, 16);
    assert_int_equal(height, 16);
}

/* -- pixels ---------------------------------------------------------------------------- */

static void every_pixel_shows_scale_times_as_large(void **state)
{
    (void)state;
    opened(64, 48, 3, 130);
    for (int scale = 1; scale <= 3; scale++)
        shows_the_picture(scale);
    resized(390, 199);
    for (int scale = 1; scale <= 4; scale++)
        shows_the_picture(scale);
}

static void one_bit_shows_as_black_and_white(void **state)
{
    int wide, high;
    uint8_t bits[2] = { 0xa5, 0x0f };
    const picture p = { .format = TP_FORMAT_I1, .width = 16, .height = 1, .row_bytes = 2,
                        .rows = bits };
    uint32_t row[16];
    (void)state;
    opened(32, 24, 1, 0);
    assert_true(window_upload(&w, &p));
    look(1, &wide, &high);
    picture_expand_row(&p, 0, row);
    const layout at = window_layout(&w, 1);
    for (int x = 0; x < 16; x++)
        assert_int_equal(shown[at.picture.y * wide + at.picture.x + x] & 0xffffff, row[x]);
    assert_int_not_equal(row[0], row[1]);
}

static void a_lost_texture_is_told_and_made_again(void **state)
{
    const SDL_Event reset = { .type = SDL_RENDER_DEVICE_RESET };
    (void)state;
    opened(64, 48, 3, 0);
    assert_false(w.lost);
    assert_false(window_event(&w, &reset));
    assert_true(w.lost);
    window_clear(&w, 3);                /* nothing to show, and no harm */
    const picture p = some_picture(64, 48);
    assert_true(window_upload(&w, &p));
    assert_false(w.lost);
    shows_the_picture(3);
}

static void beside_the_picture_is_no_pixel(void **state)
{
    int px, py;
    (void)state;
    opened(64, 48, 3, 130);
    assert_true(window_pixel(&w, 3, 191, 143, &px, &py));
    assert_int_equal(px, 63);
    assert_int_equal(py, 47);
    assert_false(window_pixel(&w, 3, 192, 100, &px, &py));
    assert_false(window_pixel(&w, 3, -1, 100, &px, &py));
    assert_false(window_pixel(&w, 1, 0, 0, &px, &py));
    assert_false(window_pixel(&w, 5, 200, 70, &px, &py));   /* covered by the panel */
}

static void the_panel_may_be_at_the_left(void **state)
{
    (void)state;
    opened(64, 48, 3, 130);
    w.left = true;
    const layout at = window_layout(&w, 3);
    assert_int_equal(at.panel.x, 0);
    assert_int_equal(at.bar.x, 130);
    assert_int_equal(at.room.x, 130 + BAR);
    assert_int_equal(at.picture.x, at.room.x);
    shows_the_picture(3);
    assert_true(mouse(SDL_MOUSEBUTTONDOWN, 132, 50, 1));
    assert_true(mouse(SDL_MOUSEMOTION, 163, 50, 1));
    assert_in_range(window_layout(&w, 3).panel.w, 158, 162);
    assert_true(mouse(SDL_MOUSEBUTTONUP, 163, 50, 1));
    resized(420, 160);
    shows_the_picture(3);
}

/* -- the bar --------------------------------------------------------------------------- */

static void the_bar_is_dragged(void **state)
{
    (void)state;
    opened(64, 48, 3, 130);
    assert_false(mouse(SDL_MOUSEBUTTONDOWN, 100, 50, 1));
    assert_false(mouse(SDL_MOUSEBUTTONUP, 100, 50, 1));
    assert_false(mouse(SDL_MOUSEMOTION, 194, 50, 0));
    assert_true(mouse(SDL_MOUSEBUTTONDOWN, 194, 50, 1));
    assert_true(w.dragged);
    assert_true(mouse(SDL_MOUSEMOTION, 104, 50, 1));
    assert_in_range(window_layout(&w, 3).bar.x, 98, 104);
    assert_true(mouse(SDL_MOUSEMOTION, -50, 50, 1));
    assert_int_equal(window_layout(&w, 3).room.w, 64);
    assert_true(mouse(SDL_MOUSEMOTION, 1000, 50, 1));
    assert_int_equal(window_layout(&w, 3).panel.w, 120);
    assert_true(mouse(SDL_MOUSEBUTTONUP, 1000, 50, 1));
    assert_false(mouse(SDL_MOUSEMOTION, 150, 50, 1));
    assert_int_equal(w.panel, 120);
}

static void a_double_click_restores_the_usual_width(void **state)
{
    (void)state;
    opened(64, 48, 3, 130);
    w.panel = 200;
    const int x = window_layout(&w, 3).bar.x + 2;
    assert_true(mouse(SDL_MOUSEBUTTONDOWN, x, 50, 2));
    assert_int_equal(w.panel, 130);
    assert_false(w.dragged);
}

static void a_button_let_go_outside_ends_the_drag(void **state)
{
    (void)state;
    opened(64, 48, 3, 130);
    assert_true(mouse(SDL_MOUSEBUTTONDOWN, 194, 50, 1));
    assert_false(mouse(SDL_MOUSEMOTION, 100, 50, 0));
    assert_int_equal(w.panel, 130);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_teardown(name, end)
    const struct CMUnitTest tests[] = {
        TEST(a_window_without_a_panel_is_the_picture),
        TEST(room_bar_and_panel_share_the_window),
        TEST(a_narrow_window_keeps_room_for_the_picture),
        TEST(the_largest_picture_fits_whole),
        TEST(every_pixel_shows_scale_times_as_large),
        TEST(one_bit_shows_as_black_and_white),
        TEST(a_lost_texture_is_told_and_made_again),
        TEST(beside_the_picture_is_no_pixel),
        TEST(the_panel_may_be_at_the_left),
        TEST(the_bar_is_dragged),
        TEST(a_double_click_restores_the_usual_width),
        TEST(a_button_let_go_outside_ends_the_drag),
    };
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    return cmocka_run_group_tests_name("window", tests, NULL, NULL);
}
