/* SPDX-License-Identifier: MIT */
/* tidepool show: a scene on a screen without a window system.  The loop, the console and
 * the interface of screens are in app/fullscreen, the devices in kms and linuxfb; the
 * program adds files, threads and tapes here. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/timing.h"
#include "app/fullscreen/fullscreen.h"
#include "app/scene/frame_governor.h"
#include "app/scene/loaded_scene.h"
#include "app/scene/replay.h"
#include "command_help.h"
#include "commands.h"

typedef struct {
    options  *options;
    loaded_scene loaded;
    replay    tape;
    uint32_t  played;           /* entries of the tape taken by the kept world */
    frame_governor governor;
} show_state;

/* -- callbacks of the loop ----------------------------------------------------------- */

static int prepare(void *user, uint32_t width, uint32_t height, tp_format format)
{
    show_state *s = user;
    options *o = s->options;
    o->width = width;
    o->height = height;
    o->format = o->formatted ? o->format : format;
    replay_skip(&s->tape, &s->loaded, s->played);
    const int code = loaded_scene_open_renderer(&s->loaded, o);
    if (!code)
        frame_governor_begin(&s->governor, &s->loaded);
    return code;
}

static const picture *draw(void *user, const tp_world *world, uint32_t frame)
{
    show_state *s = user;
    const uint64_t begin = now_us();
    frame_renderer_draw(&s->loaded.renderer, world);
    frame_governor_add_time(&s->governor, frame, now_us() - begin);
    return &s->loaded.renderer.picture;
}

static int acts(void *user)
{
    show_state *s = user;
    bool opened = false;
    const int code = replay_acts(&s->tape, &s->loaded, s->options, &opened);
    if (!code && opened)
        frame_governor_begin(&s->governor, &s->loaded);
    return code;
}

static const tp_input *taped(void *user)
{
    show_state *s = user;
    return replay_step(&s->tape);
}

static uint32_t played(void *user)
{
    const show_state *s = user;
    return replay_played(&s->tape);
}

static bool remake(void *user, uint32_t played)
{
    show_state *s = user;
    s->played = played;
    return replay_remake(&s->tape, &s->loaded, played);
}

/* -- the command --------------------------------------------------------------------- */

static int run(show_state *s, options *o)
{
    const screen_port *port = show_port(o->on ? o->on : "fb");
    if (!port)
        return log_fail(EXIT_USAGE, "tidepool show: --on %s: expected " SHOW_PORTS, o->on);
    int code = loaded_scene_load(&s->loaded, o);
    if (!code)
        code = replay_open(&s->tape, &s->loaded, o, REPLAY_SAME_WORLD);
    if (code)
        return code;
    const show what = {
        .port = port, .device = o->device,
        .width = o->sized ? o->width : 0, .height = o->sized ? o->height : 0,
        .counted = o->counted, .first = o->first, .last = o->last,
        .hold = o->hold, .hash = o->hash, .keep = o->keep,
        .scene = &s->loaded.file.scene, .assets = &s->loaded.assets.names,
        .world = s->loaded.world, .world_bytes = s->loaded.world_bytes,
        .user = s, .prepare = prepare, .draw = draw,
        .acts = o->tape ? acts : NULL, .taped = o->tape ? taped : NULL,
        .played = played, .remake = remake,
    };
    return show_run(&what);
}

int show_command(int argc, char **argv)
{
    options o;
    show_state s;
    memset(&s, 0, sizeof s);
    s.options = &o;
    int code = args_read(&o, FOR_SHOW, argc, argv);
    if (!o.threads)
        o.threads = thread_pool_default_size();
    if (!code && o.help) {
        command_help_print(FOR_SHOW);
        code = streams_finish();
    } else if (!code) {
        code = run(&s, &o);
    }
    replay_close(&s.tape);
    loaded_scene_close(&s.loaded);
    free(o.settings);
    return code;
}
