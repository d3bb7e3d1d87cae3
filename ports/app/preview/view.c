/* SPDX-License-Identifier: MIT */
/* tidepool view: the command of the preview and its main loop. view.h lists the other
 * files.
 *
 * A turn of the loop handles events, makes the ticks due, draws a frame if the world has
 * changed, and presents the frame at the display's rate. */
#define _POSIX_C_SOURCE 200809L
#include "view.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>
#include "app/cli/command_help.h"
#include "app/cli/commands.h"
#include "app/files/log.h"
#include "app/files/timing.h"

#define SETTLE_US 150000u       /* wait after the last resize event before resizing */
#define TITLE_US  500000u
#define SHOW_US   16000u        /* least interval between frames of an unchanged world */
#define WAIT_MS   2             /* wait for events if there is nothing to draw */
#define AWAY_MS   100           /* the same for a minimised window */
#define PAST      (64u << 20)   /* bytes of memory for rewinding */

/* -- the end ------------------------------------------------------------------------- */

/* SDL calls exit() if the display is lost.  The exit handler then keeps the session and
 * tells the person how to resume. */
static view *alive;

static void on_exit(void)
{
    view *v = alive;
    alive = NULL;
    if (!v)
        return;
    const loaded_scene *s = v->loaded;
    session_put(v->session, &s->file, &s->assets.names, s->world, s->world_bytes,
                v->picture);
    if (v->film)
        recorder_end(v->film);
    tape_file_close(&v->tape);
    log_line("tidepool view: the display is lost; `tidepool view --resume` continues");
    fflush(NULL);
    _exit(EXIT_LOST);
}

/* -- events -------------------------------------------------------------------------- */

static bool is_key(const SDL_Event *event)
{
    return event->type == SDL_KEYDOWN && !event->key.repeat;
}

static void take_event(view *v, const SDL_Event *event, uint64_t now)
{
    if (event->type == SDL_KEYDOWN || event->type == SDL_MOUSEBUTTONDOWN
        || event->type == SDL_MOUSEMOTION)
        performance_note_input(v->performance, now);
    v->lively = 2;
    if (window_event(&v->window, event)) {
        view_size(v);
        return;
    }
    if (v->panel && v->window.panel && panel_event(v->panel, event))
        return;
    if (is_key(event)) {
        const action what = keymap_action(&v->keys, &event->key.keysym);
        if (what < ACTIONS)
            view_act(v, what);
        return;
    }
    const action what = pad_event(&v->pad, event);
    if (what < ACTIONS)
        view_act(v, what);
    user_input_event(&v->control, event, now);
}

static void take_events(view *v)
{
    SDL_Event event;
    while (SDL_PollEvent(&event))
        take_event(v, &event, now_us());
    if (v->control.dropped[0])
        view_open(v, v->control.dropped);
    v->control.dropped[0] = '\0';
    v->quit = v->quit || v->control.quit;
}

/* -- the loop ------------------------------------------------------------------------ */

static const char *scene_title(const view *v)
{
    const char *title = v->loaded->file.scene.title;
    return title[0] ? title : v->loaded->file.name;
}

static void set_title(view *v, uint64_t now)
{
    char title[256];
    if (now - v->title_at < TITLE_US)
        return;
    snprintf(title, sizeof title, "tidepool: %s, %ux%u: %.1f ms a frame%s%s - F1: keys",
             scene_title(v), (unsigned)v->options->width, (unsigned)v->options->height,
             (double)v->shown.median_ms, v->paused ? ", paused" : "",
             v->film ? ", filming" : v->taping ? ", on tape" : "");
    SDL_SetWindowTitle(v->window.window, title);
    v->title_at = now;
}

static int resize(view *v, uint64_t now)
{
    user_input *c = &v->control;
    if (!c->resized || now - c->resized_at < SETTLE_US)
        return EXIT_DONE;
    c->resized = false;
    return view_size(v);
}

static int turn(view *v)
{
    take_events(v);
    const uint64_t now = now_us();
    int code = resize(v, now);
    view_advance(v, now);
    performance_add_time(v->performance, PERFORMANCE_WORLD, now_us() - now);
    if (v->window.lost && v->font)
        font_reload(v->font);
    v->stale = v->stale || v->window.lost;
    v->window.lost = false;
    const bool fresh = (v->stale || compare_moves(v->compare)) && !v->control.hidden;
    if (!code && fresh)
        code = view_draw(v);
    if (code)
        return code;
    const bool lively = v->lively > 0 && now - v->shown_at >= SHOW_US;
    if (fresh || v->control.exposed || lively) {
        v->lively -= v->lively > 0;
        v->shown_at = now;
        view_panel_fill(v, now);
        view_show(v, now);
        if (fresh)
            performance_end_picture(v->performance, now_us() - now);
    } else {
        SDL_WaitEventTimeout(NULL, v->control.hidden ? AWAY_MS : WAIT_MS);
    }
    set_title(v, now);
    view_keep(v, now);
    if (v->options->counted && v->drawn > v->options->last)
        v->quit = true;
    return EXIT_DONE;
}

/* -- the beginning ------------------------------------------------------------------- */

static void place_window(view *v, int width, int height)
{
    SDL_SetWindowSize(v->window.window, width, height);
    SDL_SetWindowPosition(v->window.window, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED);
}

/* Makes room for the picture at the wanted size and for the panel, if the display is
 * wide enough for both. */
static int open_window(view *v)
{
    char title[TP_NAME_BYTES + 32];
    SDL_Rect usable = { 0, 0, 0, 0 };
    const options *o = v->options;
    const int wide = (int)o->width * v->scale, beside = view_panel_width(v);
    snprintf(title, sizeof title, "tidepool: %s", scene_title(v));
    if (!window_open(&v->window, title, (int)o->width, (int)o->height, v->scale, 0)) {
        log_line("tidepool view: no window can be opened: %s", SDL_GetError());
        return log_fail(EXIT_DISPLAY, "Without a display this command draws a picture:"
                    " tidepool render %s", o->resume ? v->loaded->file.path : o->scene);
    }
    v->window.usual = beside;
    v->font = font_open(v->window.renderer);
    view_panel_open(v);
    SDL_GetDisplayUsableBounds(SDL_GetWindowDisplayIndex(v->window.window), &usable);
    v->window.panel = v->panel && !o->no_panel ? beside : 0;
    const int all = wide + window_layout(&v->window, v->scale).bar.w + v->window.panel;
    if (all <= usable.w)
        place_window(v, all, (int)o->height * v->scale);
    else
        v->window.panel = 0;
    if (o->counted)
        SDL_RenderSetVSync(v->window.renderer, 0);
    return view_size(v);
}

static int open_scene(view *v)
{
    const options *o = v->options;
    view_list(v);
    if (o->resume)
        return view_resume(v, o->scene);
    if (!view_open(v, o->scene))
        return EXIT_INPUT;
    if (o->play)
        return view_play(v, o->play);
    return o->tape ? view_tape(v, o->tape) : EXIT_DONE;
}

static int run(view *v)
{
    int code = keymap_read(&v->keys, v->options->keys);
    if (!code)
        code = open_scene(v);
    if (!code)
        code = open_window(v);
    if (code)
        return code;
    v->clock = v->title_at = v->kept_at = now_us();
    v->stale = true;
    if (!v->options->counted)
        v->session = session_begin();
    if (v->picture > 0)
        view_say(v, "continues at picture %u  -  F1: all keys", (unsigned)v->picture);
    else
        view_say(v, "%s  -  F1: all keys   drag: look round   W A S D: move   P: pause",
                 scene_title(v));
    alive = v;
    atexit(on_exit);
    while (!v->quit && !code)
        code = turn(v);
    alive = NULL;
    return code;
}

static void print_stats(view *v)
{
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    printf("{\"pictures\": %u, \"ms_median\": %.3f, \"per_second\": %.1f, "
           "\"latency_ms\": %.1f, \"peak_kb\": %ld, \"has_panel\": %s", (unsigned)v->drawn,
           (double)v->shown.median_ms, (double)v->shown.shown_per_s,
           (double)v->shown.latency_ms, used.ru_maxrss, v->panel ? "true" : "false");
    for (uint32_t i = 0; i < v->shown.part_count; i++)
        printf(", \"%s\": %.1f", v->shown.parts[i].name, (double)v->shown.parts[i].mean);
    puts("}");
}

static void end(view *v)
{
    const loaded_scene *s = v->loaded;
    if (s) {
        view_film(v, false);
        session_put(v->session, &s->file, &s->assets.names, s->world, s->world_bytes,
                    v->picture);
    }
    session_end(v->session);
    pad_close(&v->pad);
    view_panel_close(v);
    if (v->font)
        font_close(v->font);
    window_close(&v->window);
    compare_end(v->compare);
    performance_end(v->performance);
    rewind_end(v->history);
    view_unlist(v);
    undo_edits_clear(&v->edits);
    free(v->saved_as);
    if (v->loaded)
        loaded_scene_close(v->loaded);
    free(v->loaded);
    memset(v, 0, sizeof *v);            /* a leak checker then sees forgotten allocations */
}

int view_command(int argc, char **argv)
{
    options o;
    static view v;              /* static: large, and read by on_exit */
    v = (view){ .options = &o, .ui = 100, .scale = 1 };
    int code = args_read(&o, FOR_VIEW, argc, argv);
    if (!o.threads)
        o.threads = thread_pool_default_size();
    if (!code && o.help) {
        command_help_print(FOR_VIEW);
        code = streams_finish();
    } else if (!code) {
        v.scale = o.scale ? (int)o.scale : 1;
        v.ui = o.ui ? (int)o.ui : 100;
        keymap_default(&v.keys);
        v.history = rewind_begin(PAST);
        v.compare = compare_begin();
        v.performance = performance_begin();
        code = run(&v);
        const int taped = view_untape(&v);
        code = code ? code : taped;
        if (!code && o.stats) {
            print_stats(&v);
            code = streams_finish();
        }
        end(&v);
    }
    free(o.settings);
    return code;
}
