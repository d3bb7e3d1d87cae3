/* SPDX-License-Identifier: MIT */
/* A device made of the stand-in of LVGL and the example's canvas.
 *     lvgl N      runs the timer N times, then writes the screen's content to stdout
 * Exit code 2: the example used LVGL wrongly. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lvgl.h"
#include "shown.h"

enum { WIDTH = 320, HEIGHT = 240, DRAW_BUF_ALIGN = 4 };

struct _lv_obj_t {
    const void *buffer;
    int32_t w, h;
};
struct _lv_timer_t {
    lv_timer_cb_t call;
    uint32_t period, last;
};

static lv_obj_t screen, canvas;
static lv_timer_t timer;
static uint32_t now, calls;
static int is_invalid;
static uint16_t shown[WIDTH * HEIGHT];

lv_obj_t *sea_create(lv_obj_t *parent);

static void want(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "lvgl: %s\n", what);
        exit(2);
    }
}

lv_obj_t *lv_screen_active(void)
{
    return &screen;
}

lv_obj_t *lv_canvas_create(lv_obj_t *parent)
{
    want(parent == &screen, "the canvas has no screen");
    return &canvas;
}

void lv_canvas_set_buffer(lv_obj_t *obj, void *buf, int32_t w, int32_t h,
                          lv_color_format_t cf)
{
    want(obj == &canvas && buf != NULL, "no canvas or no buffer");
    want((uintptr_t)buf % DRAW_BUF_ALIGN == 0, "the buffer is not aligned");
    want(cf == LV_COLOR_FORMAT_RGB565, "not the display's format");
    want(w == WIDTH && h == HEIGHT, "not the display's size");
    canvas = (lv_obj_t){ buf, w, h };
}

void lv_obj_invalidate(const lv_obj_t *obj)
{
    want(obj == &canvas, "another object");
    is_invalid = 1;
}

lv_timer_t *lv_timer_create(lv_timer_cb_t timer_xcb, uint32_t period, void *user_data)
{
    (void)user_data;
    want(timer.call == NULL && timer_xcb != NULL, "one timer is enough");
    timer = (lv_timer_t){ timer_xcb, period, now };
    return &timer;
}

void lv_tick_inc(uint32_t tick_period)
{
    now += tick_period;
}

uint32_t lv_timer_handler(void)
{
    if (timer.call != NULL && now - timer.last >= timer.period) {
        timer.last = now;
        timer.call(&timer);
        calls++;
    }
    if (is_invalid)
        memcpy(shown, canvas.buffer, sizeof shown);
    is_invalid = 0;
    return 1;
}

int main(int argc, char **argv)
{
    const uint32_t end = argc == 2 ? (uint32_t)atoi(argv[1]) : 0;

    want(sea_create(lv_screen_active()) == &canvas, "no canvas was made");
    while (calls < end) {
        want(now < end * 1000, "the timer is too slow");
        lv_tick_inc(1);
        lv_timer_handler();
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        shown_write(shown[i]);
    return 0;
}
