/* SPDX-License-Identifier: MIT */
/* tidepool bench: times of scene S, for each rung and for other renderers.  A round
 * measures every figure once; rounds follow each other.  A temporary slow-down of the
 * machine then affects all figures alike. */
#include "bench.h"
#include "scene/value.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "about.h"
#include "args.h"
#include "commands.h"
#include "say.h"
#include "timing.h"

#define FRAMES 10               /* frames per round */

bool bench_same_case(const bench_figure *a, const bench_figure *b)
{
    return a->width == b->width && a->height == b->height && a->points == b->points
        && a->work == b->work;
}

bool bench_add(bench_list *list, const bench_figure *figure)
{
    if (list->count == list->room) {
        const size_t room = list->room ? 2 * list->room : 64;
        bench_figure *more = realloc(list->of, room * sizeof *more);
        if (!more)
            return false;
        list->of = more;
        list->room = room;
    }
    list->of[list->count++] = *figure;
    return true;
}

/* -- cases ------------------------------------------------------------------------- */

static size_t append_word(const tp_scene *scene, const char *name, char *text, size_t at)
{
    char word[BENCH_BY];
    tp_param_text(scene, tp_param_find(name, strlen(name)), word, sizeof word);
    const int more = snprintf(text + at, BENCH_BY - at, at ? " %s" : "%s", word);
    return at + (size_t)more < BENCH_BY ? at + (size_t)more : BENCH_BY - 1;
}

/* Writes the names of a figure's rungs, as "rows quick lod", with the values of
 * parameters. */
static void name_rungs(bench_figure *f)
{
    tp_scene scene;
    tp_scene_level(&scene);
    scene.quality.visibility = (int32_t)f->rungs.visibility;
    scene.quality.shading = (int32_t)f->rungs.shading;
    size_t at = append_word(&scene, "quality.visibility", f->by, 0);
    at = append_word(&scene, "quality.shading", f->by, at);
    if (f->rungs.lod == TP_LOD_ON)
        snprintf(f->by + at, BENCH_BY - at, " lod");
}

static bool add_rungs(bench_list *list, bench_figure f)
{
    for (int v = TP_VISIBILITY_TRIANGLES; v <= TP_VISIBILITY_FLAT; v++)
        for (int s = TP_SHADING_EXACT; s <= TP_SHADING_QUICK; s++)
            for (int l = TP_LOD_OFF; l <= TP_LOD_ON; l++) {
                f.rungs = (tp_rungs){ (tp_visibility)v, (tp_shading)s, TP_RATE_AUTO,
                                      (tp_lod)l };
                name_rungs(&f);
                if (!bench_add(list, &f))
                    return false;
            }
    return true;
}

static bool add_case(bench_list *list, const options *o, bench_figure f)
{
    if (o->rungs)
        return add_rungs(list, f);
    snprintf(f.by, sizeof f.by, "tidepool");
    return bench_add(list, &f) && (!o->peers || bench_peers_add(list, f));
}

/* Adds the cases of the benchmark.  An option that is not given means all values; --rungs
 * and --peers default to 128 points. */
static bool add_cases(bench_list *list, const options *o)
{
    static const uint32_t width[] = { 640, 320 }, points[] = { 64, 100, 128, 256 };
    const uint32_t usual = o->rungs || o->peers ? 128 : 0;
    const uint32_t only = o->points ? o->points : usual;
    for (int i = 0; i < (o->sized ? 1 : 2); i++)
        for (int k = 0; k < (only ? 1 : 4); k++)
            for (int w = 0; w < BENCH_WORKS; w++) {
                const bench_figure f = {
                    .width = o->sized ? o->width : width[i],
                    .height = o->sized ? o->height : width[i] * 3 / 4,
                    .points = only ? only : points[k], .work = (bench_work)w,
                    .decibels = -1,
                };
                if ((o->work < 0 || o->work == w) && !add_case(list, o, f))
                    return false;
            }
    return true;
}

/* -- measuring --------------------------------------------------------------------- */

static int measure(bench_list *list, bench_scene *s, const options *o)
{
    const char *folder = o->peers ? BENCH_FOLDER : NULL;
    const uint32_t all = (uint32_t)(BENCH_ROUNDS * list->count);
    progress p = progress_begin();
    uint32_t done = 0;
    int code = EXIT_DONE;
    for (int round = 0; round < BENCH_ROUNDS; round++) {
        const bench_figure *first = NULL;
        for (size_t i = 0; i < list->count && !code; i++) {
            bench_figure *f = &list->of[i];
            const bool is_first = !first || !bench_same_case(first, f);
            first = is_first ? f : first;
            progress_figure(&p, done++, all, bench_work_name[f->work], f->by);
            f->water = first->water;
            if (f->peer)
                bench_peer_run(list, f, round);
            else
                code = bench_draw(list, s, f, round, is_first, folder);
        }
    }
    log_progress("");
    return code;
}

static int run(bench_list *list, bench_scene *s, const options *o)
{
    int code = bench_scene_open(s);
    if (!code && o->peers)
        code = bench_peers_build();
    list->frames = o->last ? o->last + 1 : FRAMES;
    if (!code && !add_cases(list, o))
        code = log_fail_memory(2 * list->room * sizeof *list->of);
    if (!code)
        code = measure(list, s, o);
    if (!code)
        bench_print(list, o->csv);
    return code;
}

int bench_command(int argc, char **argv)
{
    options o;
    bench_list list = { 0 };
    bench_scene s = { .memory = NULL };
    int code = args_read(&o, FOR_BENCH, argc, argv);
    if (!code && o.help)
        command_help_print(FOR_BENCH);
    else if (!code)
        code = run(&list, &s, &o);
    const int end = streams_finish();
    bench_scene_close(&s);
    free(list.kept);
    free(list.of);
    free(o.settings);
    return code ? code : end;
}
