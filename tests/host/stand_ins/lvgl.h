/* SPDX-License-Identifier: MIT */
/* A stand-in for LVGL 9: the calls used by ports/examples/lvgl, with LVGL's
 * declarations, for one canvas and one timer.  A refresh shows a canvas only if the
 * canvas was invalidated. */
#ifndef STAND_IN_LVGL_H
#define STAND_IN_LVGL_H
#include <stdint.h>

typedef struct _lv_obj_t lv_obj_t;
typedef struct _lv_timer_t lv_timer_t;
typedef void (*lv_timer_cb_t)(lv_timer_t *);
typedef enum {
    LV_COLOR_FORMAT_UNKNOWN = 0,
    LV_COLOR_FORMAT_RGB565 = 0x12
} lv_color_format_t;

lv_obj_t *lv_screen_active(void);
lv_obj_t *lv_canvas_create(lv_obj_t *parent);
void lv_canvas_set_buffer(lv_obj_t *obj, void *buf, int32_t w, int32_t h,
                          lv_color_format_t cf);
void lv_obj_invalidate(const lv_obj_t *obj);
lv_timer_t *lv_timer_create(lv_timer_cb_t timer_xcb, uint32_t period, void *user_data);
uint32_t lv_timer_handler(void);
void lv_tick_inc(uint32_t tick_period);
#endif
