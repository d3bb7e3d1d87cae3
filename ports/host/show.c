/* SPDX-License-Identifier: MIT */
/* tidepool show: a scene on a screen without a window system.  The loop, the console and
 * the screens are in ../screen; the program adds files, threads and tapes here. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "about.h"
#include "../screen/show.h"
#include "commands.h"
#include "governing.h"
#include "replay.h"
#include "say.h"
#include "stage.h"
#include "timing.h"

typedef struct {
    options  *options;
    stage     stage;
    replay    tape;
    uint32_t  played;           /* entries of the tape taken by the kept world */
    governing governing;
} shown;

/* -- callbacks of the loop ------------------------------------------------------- */

static int prepare(void *user, uint32_t width, uint32_t height, tp_format format)
{
    shown *s = user;
    options *o = s->options;
    o->width = width;
    o->height = height;
    o->format = o->formatted ? o->format : format;
    replay_skip(&s->tape, &s->stage, s->played);
    const int code = stage_canvas(&s->stage, o);
    if (!code)
        governing_begin(&s->governing, &s->stage);
    return code;
}

static const picture *draw(void *user, const tp_world *world, uint32_t frame)
{
    shown *s = user;
    const uint64_t begin = now_us();
    canvas_draw(&s->stage.canvas, world);
    governing_add(&s->governing, frame, now_us() - begin);
    return &s->stage.canvas.picture;
}

static int acts(void *user)
{
    shown *s = user;
    bool opened = false;
    const int code = replay_acts(&s->tape, &s->stage, s->options, &opened);
    if (!code && opened)
        governing_begin(&s->governing, &s->stage);
    return code;
}

static const tp_input *taped(void *user)
{
    shown *s = user;
    return replay_step(&s->tape);
}

static uint32_t played(void *user)
{
    const shown *s = user;
    return replay_played(&s->tape);
}

static bool remake(void *user, uint32_t played)
{
    shown *s = user;
    s->played = played;
    return replay_remake(&s->tape, &s->stage, played);
}

/* -- the command ----------------------------------------------------------------- */

static int run(shown *s, options *o)
{
    const screen_port *port = show_port(o->on ? o->on : "fb");
    if (!port)
        return fail(EXIT_USAGE, "tidepool show: --on %s: expected " SHOW_PORTS, o->on);
    int code = stage_load(&s->stage, o);
    if (!code)
        code = replay_open(&s->tape, &s->stage, o, REPLAY_SAME_WORLD);
    if (code)
        return code;
    const show what = {
        .port = port, .device = o->device,
        .width = o->sized ? o->width : 0, .height = o->sized ? o->height : 0,
        .counted = o->counted, .first = o->first, .last = o->last,
        .hold = o->hold, .hash = o->hash, .keep = o->keep,
        .scene = &s->stage.file.scene, .assets = &s->stage.assets.names,
        .world = s->stage.world, .world_bytes = s->stage.world_bytes,
        .user = s, .prepare = prepare, .draw = draw,
        .acts = o->tape ? acts : NULL, .taped = o->tape ? taped : NULL,
        .played = played, .remake = remake,
    };
    return show_run(&what);
}

int show_command(int argc, char **argv)
{
    options o;
    shown s;
    memset(&s, 0, sizeof s);
    s.options = &o;
    int code = args_read(&o, FOR_SHOW, argc, argv);
    if (!o.threads)
        o.threads = crew_usual();
    if (!code && o.help) {
        about_print(FOR_SHOW);
        code = finish_stdout();
    } else if (!code) {
        code = run(&s, &o);
    }
    replay_close(&s.tape);
    stage_close(&s.stage);
    free(o.settings);
    return code;
}
