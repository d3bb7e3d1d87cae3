/* SPDX-License-Identifier: MIT */
/* tidepool render: draws frames to files, hashes and figures. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/hashes.h"
#include "app/files/log.h"
#include "app/files/timing.h"
#include "app/scene/frame_governor.h"
#include "app/scene/frame_sink.h"
#include "app/scene/loaded_scene.h"
#include "app/scene/replay.h"
#include "command_help.h"
#include "commands.h"
#include "features/drops/drops.h"
#include "frame/tools.h"
#include "world/pools.h"

typedef struct {
    loaded_scene loaded;
    frame_sink sink;
    hashes   expected;
    replay   tape;
    timings  times;
    frame_governor governor;
    FILE    *report;            /* stream for hashes and figures */
} render;

/* Uses one frame.  The file is written before the comparison with the list: a frame that
 * differs can be inspected. */
static int use_frame(render *r, const options *o, uint32_t frame)
{
    const picture *p = &r->loaded.renderer.picture;
    int code = frame_sink_add(&r->sink, p, frame);
    if (code || (!o->hash && !o->expect))
        return code;
    const uint32_t crc = picture_crc(p);
    if (o->hash)
        hash_print(r->report, frame, crc);
    return o->expect ? hashes_check(&r->expected, frame, crc) : EXIT_DONE;
}

/* Advances from one picture to the next. */
static int move(render *r, const options *o)
{
    loaded_scene *s = &r->loaded;
    bool opened = false;
    int code = replay_acts(&r->tape, s, o, &opened);
    for (uint32_t ticks = code ? 0 : tp_world_advance_clock(s->world); ticks > 0;
         ticks--) {
        code = replay_acts(&r->tape, s, o, &opened);
        if (code)
            break;
        tp_world_step(&tp_program_all, s->world, &s->file.scene, replay_step(&r->tape));
    }
    if (!code && opened)
        frame_governor_begin(&r->governor, s);
    return code;
}

static int draw_frames(render *r, const options *o)
{
    loaded_scene *s = &r->loaded;
    progress p = progress_begin();
    frame_governor_begin(&r->governor, s);
    int code = EXIT_DONE;
    for (uint32_t n = 0; n <= o->last && !code; n++) {
        if (n > 0)
            code = move(r, o);
        if (n >= o->first && (n - o->first) % o->every == 0 && !code) {
            const uint64_t begin = now_us();
            frame_renderer_draw(&s->renderer, s->world);
            const uint64_t took = now_us() - begin;
            timings_add(&r->times, took);
            frame_governor_add_time(&r->governor, n, took);
            code = use_frame(r, o, n);
        }
        if (n >= o->first || n % 4096 == 0)
            progress_show(&p, n, o->last + 1);
    }
    log_progress("");
    return code;
}

/* Prints the statistics.  "frame" includes "vertices" and "tables"; "scratch" is the sum of
 * all threads. */
static void print_stats(render *r)
{
    const loaded_scene *s = &r->loaded;
    const frame_renderer *c = &s->renderer;
    const tp_draw_stats stats = tp_frame_stats(c->frame);
    const tp_ram_use ram = tp_frame_ram(c->frame);
    const tp_pool *water = tp_world_pool(s->world);
    const uint32_t cells = water ? water->cols * water->rows : 0;
    const tp_pool_state pool = water ? tp_pool_stats(water)
                                     : (tp_pool_state){ .at_rest = true };
    const tp_drops drops = tp_world_drops(s->world) ? *tp_world_drops(s->world)
                                                    : (tp_drops){ 0 };
    const size_t frames = r->times.count;
    const uint32_t median = timings_median(&r->times);
    fprintf(r->report,
            "{\"machine\": \"%s\", \"frames\": %zu, \"ms_median\": %" PRIu32 ".%03" PRIu32
            ", "
            "\"water_pixels\": %" PRIu32 ", \"vertices\": %" PRIu32 ", "
            "\"triangles\": %" PRIu32 ", \"dropped\": %" PRIu32 ", "
            "\"pool\": {\"cells\": %" PRIu32 ", \"max_height\": %" PRId32 ", "
            "\"max_velocity\": %" PRId32 ", \"at_rest\": %s}, "
            "\"drops\": {\"in_air\": %" PRIu32 ", \"rings\": %" PRIu32 ", "
            "\"dropped\": %" PRIu32 "}, "
            "\"ram_bytes\": {\"scene\": %zu, \"world\": %zu, \"frame\": %zu, "
            "\"vertices\": %zu, \"tables\": %zu, \"scratch\": %zu, "
            "\"mesh\": %zu, \"textures\": %zu}}\n",
            c->machine->name, frames, median / 1000, median % 1000, c->water_pixels,
            stats.vertices, stats.triangles, stats.dropped, cells, pool.highest,
            pool.fastest, pool.at_rest ? "true" : "false", drops.count, drops.rings,
            drops.dropped + drops.rings_dropped, sizeof(tp_scene), s->world_bytes,
            ram.frame, ram.vertices, ram.tables, ram.scratch * c->threads,
            s->assets.mesh_bytes, s->assets.texture_bytes);
}

static int run(render *r, const options *o)
{
    int code = frame_sink_open(&r->sink, o);
    if (!code && o->expect)
        code = hashes_read(&r->expected, o->expect);
    if (!code)
        code = loaded_scene_open(&r->loaded, o);
    if (!code)
        code = replay_open(&r->tape, &r->loaded, o, REPLAY_ALL);
    if (!code)
        code = draw_frames(r, o);
    if (code) {
        frame_sink_discard(&r->sink);
        return code;
    }
    code = frame_sink_close(&r->sink);
    if (!code && o->stats)
        print_stats(r);
    return code;
}

int render_command(int argc, char **argv)
{
    options o;
    render r;
    memset(&r, 0, sizeof r);
    int code = args_read(&o, FOR_RENDER, argc, argv);
    r.report = o.out && strcmp(o.out, "-") == 0 ? stderr : stdout;
    if (o.stepped && !o.sized) {        /* steps are planned for a board's panel */
        o.width = 320;
        o.height = 240;
    }
    if (!code && o.help)
        command_help_print(FOR_RENDER);
    else if (!code)
        code = run(&r, &o);
    const int end = r.report == stdout ? streams_finish() : EXIT_DONE;
    timings_free(&r.times);
    replay_close(&r.tape);
    hashes_free(&r.expected);
    loaded_scene_close(&r.loaded);
    free(o.settings);
    return code ? code : end;
}
