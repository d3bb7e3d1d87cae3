/* SPDX-License-Identifier: MIT */
/* tidepool plan: prints for each rung of a scene its cost, error and bytes, and the reason
 * why the rung was chosen or not. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/scene/plan_sheet.h"
#include "app/scene/world_rungs.h"
#include "command_help.h"
#include "commands.h"
#include "frame/tools.h"
#include "plan_ladder.h"

#define BAND 16                 /* rows of a tile, as on a board */
#define MHZ  168                /* clock, MHz, and cycles per instruction of the estimate */
#define CPI  "1.3"
#define SPEED (MHZ * 1000000ull * 10 / 13)      /* instructions per second */

typedef struct {
    loaded_scene     *loaded;
    plan_sheet sheet;
    world_rungs world;
} plan;

/* -- output for programs ------------------------------------------------------------- */

static void print_csv(const plan *p)
{
    char word[32], px[24], colour[24];
    const tp_plan_report *r = &p->sheet.report;

    puts("kind,rung,why,instructions,error_px,error_colour,bytes");
    for (int k = 0; k < TP_KINDS; k++)
        for (int i = 0; i < r->rung_count[k]; i++) {
            const tp_rung_report *rung = &r->rung[k][i];
            plan_word(k, i, word);
            printf("%s,%s,%s,", plan_kind[k], word, plan_why[rung->why]);
            if (rung->price.known)
                printf("%" PRIu64 ",%s,%s", rung->price.cost,
                       plan_number(rung->price.error_px, px),
                       plan_number(rung->price.error_colour, colour));
            else
                printf(",,");
            printf(",%zu\n", p->sheet.bytes[k][i]);
        }
    if (p->world.now.mean)
        printf("tick,,,%" PRIu64 ",,,\n", p->world.now.mean);
    for (int i = 0; i < p->world.count; i++)
        printf("tick,%s,changes the world,%" PRIu64 ",,,\n", p->world.rung[i].text,
               p->world.rung[i].cost.mean);
    printf("total,,,%" PRIu64 ",%s,%s,%zu\n", r->total.cost,
           plan_number(r->total.error_px, px),
           plan_number(r->total.error_colour, colour),
           p->loaded->renderer.frame_bytes + p->loaded->renderer.scratch_bytes);
}

/* -- output for people --------------------------------------------------------------- */

static void print_head(const plan *p, const options *o)
{
    const tp_plan_report *r = &p->sheet.report;
    const tp_scene *scene = &p->loaded->file.scene;
    char px[24], colour[24];

    printf("%s, %ux%u: about %u pixels of water, %u vertices, %u wave%s",
           p->loaded->file.name, (unsigned)o->width, (unsigned)o->height,
           (unsigned)r->water_pixels, (unsigned)r->vertices, (unsigned)r->waves,
           r->waves == 1 ? "" : "s");
    if (r->waves_dropped)
        printf(" (%u more too faint)", (unsigned)r->waves_dropped);
    printf("\nbudget: outlines %s px, colours %s of 255 rms\n\n",
           plan_number(scene->quality.error_px, px),
           plan_number(scene->quality.error_colour, colour));
    printf("%-10s  %-9s %8s %6s %6s %9s  %s\n", "", "", "M instr", "px", "colour",
           "bytes", "why");
}

static void print_rung(const plan *p, int kind, int i)
{
    const tp_rung_report *rung = &p->sheet.report.rung[kind][i];
    const bool taken = rung->why == TP_WHY_CHOSEN || rung->why == TP_WHY_NAMED;
    char word[32], px[24] = "-", colour[24] = "-", cost[24] = "-";

    plan_word(kind, i, word);
    if (rung->price.known) {
        plan_number(rung->price.error_px, px);
        plan_number(rung->price.error_colour, colour);
        snprintf(cost, sizeof cost, "%.2f", (double)rung->price.cost / 1e6);
    }
    printf("%-10s %c%-9s %8s %6s %6s %9zu  %s\n", i ? "" : plan_kind[kind],
           taken ? '*' : ' ', word, cost, px, colour, p->sheet.bytes[kind][i],
           plan_why[rung->why]);
}

static void print_total(const plan *p)
{
    const tp_plan_report *r = &p->sheet.report;
    const tp_ram_use ram = tp_frame_ram(p->loaded->renderer.frame);
    const double cost = (double)r->total.cost;
    char px[24], colour[24];

    if (r->total.known)
        printf("\nin all: %.2f M instructions a frame, %.0f a water pixel; off %s px,"
               " %s\nestimate: %.1f frames/s at %d MHz if an instruction takes "
               CPI " cycles\n", cost / 1e6, r->water_pixels ? cost / r->water_pixels : 0,
               plan_number(r->total.error_px, px),
               plan_number(r->total.error_colour, colour),
               r->total.cost ? (double)SPEED / cost : 0, MHZ);
    else
        puts("\nin all: unknown, because a rung has no measured cost yet");
    printf("bytes: frame %zu (vertices %zu, tables %zu, mirror %zu),\n  a tile's scratch"
           " %zu, world %zu\n", ram.frame, ram.vertices, ram.tables, ram.mirror,
           ram.scratch, p->loaded->world_bytes);
    puts("Instructions: one frame on a Cortex-M4 at the scene's start, without ticks."
         "\nErrors: the largest measured, beyond those of the exact rungs.");
}

/* Prints settings in a line; of a group of rows only the first has the group's name. */
static void print_settings(const char *text)
{
    const char *last = "";
    size_t group = 0;

    for (size_t bytes; *text; text += bytes + (text[bytes] == ' ')) {
        bytes = strcspn(text, " ");
        const size_t name = strcspn(text, ".");
        const bool again = name == group && strncmp(text, last, name) == 0;
        printf(" %.*s", (int)(bytes - (again ? name : 0)), text + (again ? name : 0));
        last = text;
        group = name;
    }
    puts("");
}

#define WORLD_LINES 3           /* the plan of a shipped scene fits 24 lines */

/* Prints the cheapest values of the scene that make a tick cheaper, and last all together. */
static void print_world(const world_rungs *w)
{
    if (w->now.mean == 0)
        return;
    printf("a tick: %.2f M instructions, at most %.2f M%s\n", (double)w->now.mean / 1e6,
           (double)w->now.most / 1e6,
           w->count == 0            ? ""
           : w->count > WORLD_LINES ? "; with other water, by --set (--csv: more):"
                                    : "; with other water, by --set:");
    for (int i = 0; i < w->count; i++) {
        if (i >= WORLD_LINES - 1 && i + 1 < w->count)
            continue;
        printf(" %.2f M:", (double)w->rung[i].cost.mean / 1e6);
        if (w->rung[i].all)
            puts(" all values that make it cheaper");
        else
            print_settings(w->rung[i].text);
    }
}

static int run(const options *o)
{
    loaded_scene s;
    plan  p = { .loaded = &s };
    int code = loaded_scene_open(&s, o);

    if (!code && o->board) {
        code = plan_board_print(&s, o);
    } else if (!code && o->ladder) {
        code = plan_ladder_print(&s, o);
    } else if (!code) {
        p.sheet = plan_sheet_make(&s);
        p.world = world_rungs_find(&s, TP_PROCESSOR_M4);
        if (o->csv)
            print_csv(&p);
        else {
            print_head(&p, o);
            for (int k = 0; k < TP_KINDS; k++)
                for (int i = 0; i < p.sheet.report.rung_count[k]; i++)
                    print_rung(&p, k, i);
            print_total(&p);
            print_world(&p.world);
        }
    }
    loaded_scene_close(&s);
    return code;
}

int plan_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_PLAN, argc, argv);

    if (!o.band && !o.strip)
        o.band = BAND;
    if ((o.board || o.ladder) && !o.sized) {    /* a board's usual panel */
        o.width = 320;
        o.height = 240;
    }
    if (!code && o.help) {
        command_help_print(FOR_PLAN);
    } else if (!code) {
        code = run(&o);
    }
    free(o.settings);
    const int end = streams_finish();
    return code ? code : end;
}
