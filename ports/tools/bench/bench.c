/* SPDX-License-Identifier: MIT */
/* tidepool bench: times of scene S, for each rung and for other renderers, printed as a
 * text table or as CSV.  A round measures every figure once; rounds follow each other.  A
 * temporary slow-down of the machine then affects all figures alike. */
#include "bench.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/cli/args.h"
#include "app/cli/command_help.h"
#include "app/cli/commands.h"
#include "app/files/log.h"
#include "app/files/timing.h"
#include "world/text.h"

/* middle_us: median of the rounds' medians; spread_us: largest minus smallest of them. */
static uint32_t middle_us(const bench_figure *f)
{
    const uint32_t a = f->us[0], b = f->us[1], c = f->us[2];
    const uint32_t low = a < b ? a : b, high = a < b ? b : a;
    return c < low ? low : c > high ? high : c;
}

static uint32_t spread_us(const bench_figure *f)
{
    uint32_t low = f->us[0], high = f->us[0];
    for (int i = 1; i < BENCH_ROUNDS; i++) {
        low = f->us[i] < low ? f->us[i] : low;
        high = f->us[i] > high ? f->us[i] : high;
    }
    return high - low;
}

static void print_decibels(const bench_figure *f)
{
    if (f->decibels < 0)
        printf("       -");
    else if (isinf(f->decibels))
        printf("    same");
    else
        printf("%8.1f", f->decibels);
}

static void print_row(const bench_figure *f, const bench_figure *first)
{
    const double ms = middle_us(f) / 1000.0;
    char size[16];
    snprintf(size, sizeof size, "%ux%u", (unsigned)f->width, (unsigned)f->height);
    printf("%-8s %6u %-7s %-24s", size, (unsigned)f->points, bench_work_name[f->work],
           f->by);
    if (!middle_us(f)) {
        printf("  failed\n");
        return;
    }
    printf("%9.3f %5.0f %%%9.1f", ms, 100.0 * spread_us(f) / middle_us(f),
           f->water ? 1e6 * ms / f->water : 0);
    printf("%8.2f", middle_us(first) ? (double)middle_us(f) / middle_us(first) : 0);
    print_decibels(f);
    putchar('\n');
}

static void print_csv_row(const bench_figure *f)
{
    printf("%u,%u,%u,%s,%s,%.3f,%.3f,%" PRIu32 ",", (unsigned)f->width,
           (unsigned)f->height, (unsigned)f->points, bench_work_name[f->work], f->by,
           middle_us(f) / 1000.0, spread_us(f) / 1000.0, f->water);
    if (f->decibels < 0)
        printf("\n");
    else
        printf("%.2f\n", f->decibels);
}

static void bench_print(const bench_list *list, bool csv)
{
    const bench_figure *first = NULL;
    if (csv) {
        printf("width,height,points,work,by,ms,spread_ms,water_pixels,psnr_db\n");
    } else {
        printf("Scene S, whole frames, one thread, processor time: median of %d rounds of"
               " %" PRIu32 " frames.\n", BENCH_ROUNDS, list->frames);
        printf("%-8s %6s %-7s %-24s%9s%8s%9s%8s%8s\n", "size", "points", "work", "by",
               "ms", "spread", "ns/px", "ratio", "dB");
    }
    for (size_t i = 0; i < list->count; i++) {
        const bench_figure *f = &list->of[i];
        if (!first || !bench_same_case(first, f))
            first = f;
        if (csv)
            print_csv_row(f);
        else
            print_row(f, first);
    }
}

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

/* -- cases --------------------------------------------------------------------------- */

static size_t append_word(const tp_scene *scene, const char *name, char *text, size_t at)
{
    char word[BENCH_BY];
    tp_param_text(scene, tp_param_find(name, strlen(name)), word, sizeof word);
    const int more = snprintf(text + at, BENCH_BY - at, at ? " %s" : "%s", word);
    return at + (size_t)more < BENCH_BY ? at + (size_t)more : BENCH_BY - 1;
}

/* Writes the names of a figure's rungs, as "rows quick", with the values of
 * parameters. */
static void name_rungs(bench_figure *f)
{
    tp_scene scene;
    tp_scene_level(&scene);
    scene.quality.visibility = (int32_t)f->rungs.visibility;
    scene.quality.shading = (int32_t)f->rungs.shading;
    size_t at = append_word(&scene, "quality.visibility", f->by, 0);
    append_word(&scene, "quality.shading", f->by, at);
}

static bool add_rungs(bench_list *list, bench_figure f)
{
    for (int v = TP_VISIBILITY_TRIANGLES; v <= TP_VISIBILITY_FLAT; v++)
        for (int s = TP_SHADING_EXACT; s <= TP_SHADING_QUICK; s++) {
            f.rungs = (tp_rungs){ (tp_visibility)v, (tp_shading)s, TP_RATE_AUTO };
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

/* -- measuring ----------------------------------------------------------------------- */

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
