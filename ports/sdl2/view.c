/* SPDX-License-Identifier: MIT */
/* tidepool view: the preview.  Ticks of 1/60 s follow the clock whatever the display
 * does; a picture is drawn when a tick has changed it and shown at the display's pace. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "../host/commands.h"
#include "../host/deck.h"
#include "../host/governing.h"
#include "../host/path.h"
#include "../host/say.h"
#include "../host/stage.h"
#include "../host/timing.h"
#include "../live/wish.h"
#include "control.h"
#include "window.h"

#define TICKS_AT_ONCE 8             /* behind by more, the water slows down */
#define SETTLE_US     150000u       /* a window that is being dragged larger */
#define TITLE_US      500000u
#define WAIT_MS       2             /* for events, when there is nothing to draw */

typedef struct {
    options *options;
    stage    stage;
    window   window;
    control  control;
    deck     tape;
    tp_input wish;                  /* for the next tick */
    timings  times;                 /* of drawing, since the title was set */
    governing governing;
    uint32_t drawn;                 /* frames */
    uint64_t title_at, clock;       /* us */
    uint64_t owed;                  /* ticks not yet made, in 1/1000000 */
    bool     stale;                 /* the picture is older than the world */
} view;

static void print_help(void)
{
    puts("usage: tidepool view SCENE [OPTION]...\n"
         "Opens a window to look around in: drag with the left button or use the\n"
         "arrows, move with W A S D Q E (Shift: faster), turn the light with [ ] and\n"
         "Page Up and Down; Space pauses, P saves a screenshot, F1 prints all keys,\n"
         "Esc quits.  --tape records what you do.\n");
    args_print(FOR_VIEW);
}

/* -- time ------------------------------------------------------------------------ */

/* Where the mouse points at the level of still water: a poke there. */
static void aim(view *v, tp_input *input)
{
    const double pi = 3.14159265358979, one = 1 << 30;
    const tp_camera camera = tp_world_camera(v->stage.world);
    const tp_scene *scene = &v->stage.file.scene;
    const tp_rotation *turn = &camera.turn;
    const double half = v->options->height / 2.0;
    const double focal = half / tan(scene->camera.fov / 65536.0 * pi / 360);
    const double u = v->control.poke_x - v->options->width / 2.0;
    const double w = half - v->control.poke_y;
    const double x = (u * turn->x.x + w * turn->y.x - focal * turn->z.x) / one;
    const double y = (u * turn->x.y + w * turn->y.y - focal * turn->z.y) / one;
    const double z = (u * turn->x.z + w * turn->y.z - focal * turn->z.z) / one;
    const double far = y < 0 ? -camera.eye.y / y : 0;

    v->control.poke = false;
    if (far <= 0 || far * (focal + fabs(u)) > 8000 * 65536.0)
        return;
    input->poke = scene->pool.poke;
    input->poke_x = (tp_fx)tp_limit(camera.eye.x + (int64_t)(far * x), INT32_MAX);
    input->poke_z = (tp_fx)tp_limit(camera.eye.z + (int64_t)(far * z), INT32_MAX);
}

/* The next picture's ticks; the first of them takes the input.  In slow motion there
 * are pictures without a tick: what was done then waits. */
static void step(view *v)
{
    static const tp_input nothing;
    tp_world *world = v->stage.world;
    for (uint32_t ticks = tp_world_frame(world); ticks > 0; ticks--) {
        deck_add(&v->tape, world->tick, &v->wish);
        tp_world_step(world, &v->stage.file.scene, &v->wish);
        v->wish = nothing;
    }
}

static void tick(view *v)
{
    const tp_input input = control_input(&v->control);
    wish_add(&v->wish, &input);
    if (v->control.poke)
        aim(v, &v->wish);
    if (!v->control.pause) {
        step(v);
        v->stale = true;
    } else if (wish_moves(&input)) {
        tp_world_look(v->stage.world, &input);
        v->wish = (tp_input){ 0 };
        v->stale = true;
    }
}

static void advance(view *v, uint64_t now)
{
    v->owed += (now - v->clock) * TP_TICKS_PER_SECOND;
    v->clock = now;
    for (int i = 0; i < TICKS_AT_ONCE && v->owed >= 1000000u; i++, v->owed -= 1000000u)
        tick(v);
    v->owed %= 1000000u;
}

/* What the window is called. */
static const char *name_of(const view *v)
{
    const char *title = v->stage.file.scene.title;
    return title[0] ? title : v->stage.file.name;
}

/* -- pictures -------------------------------------------------------------------- */

static int resize(view *v, uint64_t now)
{
    control *c = &v->control;
    if (!c->resized || now - c->resized_at < SETTLE_US)
        return EXIT_DONE;
    c->resized = false;
    v->options->width = (uint32_t)tp_clamp(c->width, 16, 4096);
    v->options->height = (uint32_t)tp_clamp(c->height, 16, 4096);
    v->stale = true;
    const int code = stage_canvas(&v->stage, v->options);
    if (!code)
        governing_begin(&v->governing, &v->stage);
    return code;
}

static int draw(view *v)
{
    const uint64_t begin = now_us();
    canvas_draw(&v->stage.canvas, v->stage.world);
    const uint64_t took = now_us() - begin;
    timings_add(&v->times, took);
    governing_add(&v->governing, v->drawn++, took);
    v->stale = false;
    if (!window_upload(&v->window, &v->stage.canvas.picture))
        return fail(EXIT_INPUT, "tidepool view: %s", SDL_GetError());
    return EXIT_DONE;
}

static void set_title(view *v, uint64_t now)
{
    char title[256];
    if (now - v->title_at < TITLE_US || !v->times.count)
        return;
    const unsigned us = timings_median(&v->times);
    snprintf(title, sizeof title, "tidepool: %s, %ux%u: %u.%u ms a frame%s - F1: keys",
             name_of(v), (unsigned)v->options->width, (unsigned)v->options->height,
             us / 1000, us / 100 % 10, v->control.pause ? ", paused" : "");
    SDL_SetWindowTitle(v->window.window, title);
    v->times.count = 0;
    v->title_at = now;
}

/* Under the first number that is free. */
static void save_shot(view *v)
{
    char name[TP_NAME_BYTES + 32];
    int number = 0;
    do
        snprintf(name, sizeof name, "%.100s-%04d.png", v->stage.file.name, ++number);
    while (access(name, F_OK) == 0 && number < 9999);
    v->control.shot = false;
    if (picture_write_png(&v->stage.canvas.picture, name) == EXIT_DONE)
        say("%s", name);
}

/* -- the loop -------------------------------------------------------------------- */

static int frame(view *v)
{
    SDL_Event event;
    while (SDL_PollEvent(&event))
        control_event(&v->control, &event, now_us());
    const uint64_t now = now_us();
    int code = resize(v, now);
    advance(v, now);
    const bool fresh = v->stale;
    if (!code && fresh)
        code = draw(v);
    if (code)
        return code;
    if (v->control.shot)
        save_shot(v);
    if (fresh || v->control.exposed) {
        window_clear(&v->window, 1);
        window_present(&v->window);
    } else {
        SDL_WaitEventTimeout(NULL, WAIT_MS);
    }
    v->control.exposed = false;
    set_title(v, now);
    return EXIT_DONE;
}

static int run(view *v)
{
    char title[TP_NAME_BYTES + 32];
    snprintf(title, sizeof title, "tidepool: %s", name_of(v));
    const int width = (int)v->options->width, height = (int)v->options->height;
    if (!window_open(&v->window, title, width, height, 1, 0)) {
        say("tidepool view: no window can be opened: %s", SDL_GetError());
        return fail(EXIT_INPUT, "Without a display, this draws a picture:"
                    " tidepool render %s --out %s.png", v->options->scene,
                    v->stage.file.name);
    }
    v->stale = true;
    v->clock = v->title_at = now_us();
    governing_begin(&v->governing, &v->stage);
    int code = EXIT_DONE;
    while (!v->control.quit && !code)
        code = frame(v);
    return code;
}

int view_command(int argc, char **argv)
{
    options o;
    view v;
    memset(&v, 0, sizeof v);
    v.options = &o;
    int code = args_read(&o, FOR_VIEW, argc, argv);
    if (!o.threads)
        o.threads = crew_usual();
    if (!code && o.help) {
        print_help();
        code = finish_stdout();
    } else if (!code) {
        code = stage_open(&v.stage, &o);
        if (!code && o.tape)
            code = deck_record(&v.tape, o.tape, v.stage.file.name);
        if (!code)
            code = run(&v);
        const int end = deck_close(&v.tape);
        code = code ? code : end;
        window_close(&v.window);
    }
    timings_free(&v.times);
    stage_close(&v.stage);
    free(o.settings);
    return code;
}
