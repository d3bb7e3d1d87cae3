/* SPDX-License-Identifier: MIT */
/* The picture: drawn by a frame renderer as large as the window allows, compared, filmed,
 * and shown under overlays.  Overlays are drawn into the window only: screenshots and films
 * hold exactly the core's pixels. */
#include <stdio.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "app/files/timing.h"
#include "app/scene/stopwatch.h"
#include "overlay.h"
#include "view.h"

#define SAID_US 4000000u        /* how long a message stays */
#define FADE_US 500000u         /* how long a message then fades */

/* -- drawing ------------------------------------------------------------------------- */

int view_size(view *v)
{
    options *o = v->options;
    if (v->film) {
        view_say(v, "the film has ended: the picture's size changed");
        view_film(v, false);
    }
    window_fits(&v->window, v->scale, &o->width, &o->height);
    const int code = loaded_scene_open_renderer(v->loaded, o);
    if (!code)
        view_refit(v, true);
    return code;
}

int view_draw(view *v)
{
    loaded_scene *s = v->loaded;
    const bool timed = v->measures || v->sheet;
    stopwatch_use(&s->renderer, timed);
    if (timed != v->timed)
        performance_set_stopwatch(v->performance, timed);
    v->timed = timed;
    const uint64_t begin = now_us();
    frame_renderer_draw(&s->renderer, s->world);
    const uint64_t took = now_us() - begin;
    frame_governor_add_time(&v->governor, v->drawn++, took);
    performance_add_time(v->performance, PERFORMANCE_GEOMETRY, s->renderer.begin_us);
    performance_add_time(v->performance, PERFORMANCE_PIXELS, took - s->renderer.begin_us);
    v->stale = false;

    if (v->film && !recorder_add(v->film, &s->renderer.picture))
        view_film(v, false);
    const picture *other = compare_draw(v->compare, s);
    const uint64_t drawn = now_us();
    if (!window_upload(&v->window, other ? other : &s->renderer.picture))
        return log_fail(EXIT_LOST, "tidepool view: the display is lost: %s",
                        SDL_GetError());
    performance_add_time(v->performance, PERFORMANCE_COMPARE, drawn - begin - took);
    performance_add_time(v->performance, PERFORMANCE_UPLOAD, now_us() - drawn);
    return EXIT_DONE;
}

/* -- overlays ------------------------------------------------------------------------ */

/* Copies the last message printed to the terminal, to show it over the picture too. */
static void take_said(view *v, uint64_t now)
{
    unsigned count;
    const char *last = log_last(&count);
    if (count != v->said_count) {
        v->said_count = count;
        snprintf(v->said, sizeof v->said, "%s", last);
        v->said_at = 0;
    }
    if (v->said[0] && v->said_at == 0)
        v->said_at = now;
}

static void draw_said(view *v, const layout *at, int scale, uint64_t now)
{
    const uint64_t age = now - v->said_at;
    if (!v->said[0] || age > SAID_US + FADE_US)
        return;
    const uint64_t left = SAID_US + FADE_US - age;
    v->lively = v->lively > 1 ? v->lively : 1;
    overlay_message(v->font, &at->room, scale, v->said,
                    left < FADE_US ? (uint8_t)(255 * left / FADE_US) : 255);
}

/* Shows at the upper right the other renderer of the comparison, and the PSNR. */
static void draw_compared(view *v, const layout *at, int scale)
{
    const panel_compare *c = &v->compared;
    char text[VIEW_SAID];
    if (c->psnr >= 100)
        snprintf(text, sizeof text, "%s: %s, the same bits  %s", c->off, c->against,
                 c->note);
    else if (c->psnr >= 0)
        snprintf(text, sizeof text, "%s: %s, %.1f dB  %s", c->off, c->against, c->psnr,
                 c->note);
    else
        snprintf(text, sizeof text, "%s: %s  %s", c->off, c->against, c->note);
    const int wide = (font_cell_count(text) + 2) * FONT_WIDE * scale;
    const int high = (FONT_HIGH + 4) * scale;
    const int x = at->room.x + at->room.w - wide, y = at->room.y;
    font_draw_background(v->font, x, y, wide, high, 160);
    font_draw(v->font, x + FONT_WIDE * scale, y + 3 * scale, scale, 0xffffff, text);
}

static void draw_overlays(view *v, const layout *at, uint64_t now)
{
    const int scale = v->ui >= 200 ? 1 + v->ui / 200 : v->ui > 125 ? 2 : 1;
    const bool large = at->room.w >= 960 && at->room.h >= 540;
    const int size = scale + (large && scale == 1);
    if (v->sheet)
        overlay_performance(v->font, &at->room, size, &v->shown, &v->compared);
    if (compare_get_how(v->compare) != COMPARE_OFF)
        draw_compared(v, at, size);
    if (v->help)
        overlay_help(v->font, &at->room, scale, &v->keys);
    else
        draw_said(v, at, size, now);
}

void view_show(view *v, uint64_t now)
{
    const layout at = window_layout(&v->window, v->scale);
    take_said(v, now);
    window_clear(&v->window, v->scale);
    const uint64_t begin = now_us();
    if (v->font)
        draw_overlays(v, &at, now);
    if (v->panel && at.panel.w > 0)
        panel_draw(v->panel, &at.panel);
    const uint64_t painted = now_us();
    window_present(&v->window);
    performance_add_time(v->performance, PERFORMANCE_PANEL, painted - begin);
    performance_add_time(v->performance, PERFORMANCE_PRESENT, now_us() - painted);
    performance_note_shown(v->performance, now_us());
    v->control.exposed = false;
}

/* -- pictures and films as files ----------------------------------------------------- */

void view_save_shot(view *v)
{
    char name[TP_NAME_BYTES + 32];
    path_numbered(name, sizeof name, v->loaded->file.name, ".png");
    if (picture_write_png(&v->loaded->renderer.picture, name) == EXIT_DONE)
        log_line("%s", name);
}

void view_film(view *v, bool on)
{
    const picture *p = &v->loaded->renderer.picture;
    if (on && !v->film) {
        v->film = recorder_begin(v->loaded->file.name, p->width, p->height);
        if (v->film)
            view_say(v, "filming %s: F9 ends it", recorder_name(v->film));
    } else if (!on && v->film) {
        recorder *ended = v->film;
        v->film = NULL;
        recorder_end(ended);
    }
}
