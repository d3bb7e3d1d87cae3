/* SPDX-License-Identifier: MIT */
/* tidepool plan: prints the rungs of a scene's plan, with what each saves and adds. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/scene/plan_sheet.h"
#include "app/scene/ram_rungs.h"
#include "app/scene/world_rungs.h"
#include "command_help.h"
#include "commands.h"
#include "frame/tools.h"
#include "plan_ladder.h"
#include "tools/bake/program_memory.h"

#define BAND 16                 /* rows of a tile, as on a board */
#define MHZ  168                /* clock, MHz, and cycles per instruction of the estimate */
#define CPI  "1.3"
#define SPEED (MHZ * 1000000ull * 10 / 13)      /* instructions per second */

typedef struct {
    loaded_scene *loaded;
    plan_sheet    sheet;
    world_rungs   world;
    ram_rungs     ram;
    program_memory memory;      /* of the plan's baked program */
} plan;

static double millions(double n)
{
    return n / 1e6;
}

/* -- output for programs ------------------------------------------------------------- */

static void print_csv(const plan *p)
{
    const plan_sheet *sheet = &p->sheet;

    puts("kind,rung,why,saves,adds");
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        const plan_kind kind = plan_sheet_kind(sheet, &p->loaded->file.scene, k);
        printf("%s,%s,%s,%.0f,%.2f\n", tp_rung_kind_row(k), kind.word,
               kind.named ? "named" : "chosen", kind.saves, kind.adds);
    }
    if (p->world.now.mean)
        printf("tick,,now,%" PRIu64 ",\n", p->world.now.mean);
    for (int i = 0; i < p->world.count; i++)
        printf("tick,%s,changes the world,%" PRIu64 ",\n", p->world.rung[i].text,
               p->world.now.mean - p->world.rung[i].cost.mean);
    for (int i = 0; i < p->ram.count; i++)
        printf("less ram,%s,bytes,%zu,%.2f\n", p->ram.rung[i].text, p->ram.rung[i].bytes,
               p->ram.rung[i].error);
#define X(use) printf("ram," #use ",bytes,%zu,\n", p->memory.use);
    PROGRAM_RAM_LIST(X)
#undef X
#define X(use) printf("flash," #use ",bytes,%zu,\n", p->memory.use);
    PROGRAM_FLASH_LIST(X)
#undef X
    printf("exact,,,%" PRIu64 ",0.00\n", sheet->exact.cost);
    printf("total,,,%" PRIu64 ",%.2f\n", sheet->plan.price.cost,
           plan_error(sheet->plan.price));
}

/* -- output for people --------------------------------------------------------------- */

static void print_head(const plan *p, const options *o)
{
    const tp_view_costs *v = &p->sheet.view;
    const tp_scene *scene = &p->loaded->file.scene;
    const uint32_t waves = v->culled.left, faint = v->estimate.waves - waves;
    const board_frame *frame = &p->loaded->frame;

    printf("%s, %ux%u: about %u pixels of water, %u vertices, %u wave%s",
           p->loaded->file.name, (unsigned)o->width, (unsigned)o->height,
           (unsigned)v->water, (unsigned)v->estimate.vertices, (unsigned)waves,
           waves == 1 ? "" : "s");
    if (faint)
        printf(" (%u more too faint)", (unsigned)faint);
    if (frame->board)
        printf("\nfor %s, %.3g ms a picture: %s\n", frame->board->name,
               frame->frame_us / 1000.0, p->sheet.real_time ? "kept" : "not kept");
    else
        printf("\nbudget: %.2f of 255 rms beyond the exact picture\n",
               scene->quality.error_colour / 65536.0);
    printf("the exact picture: %.2f M instructions\n\n",
           millions((double)p->sheet.exact.cost));
    printf("%-20s %-10s %8s %6s\n", "row", "rung", "saves M", "adds");
}

/* Prints the kinds with a cheaper rung. */
static void print_kinds(const plan *p)
{
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        const plan_kind kind = plan_sheet_kind(&p->sheet, &p->loaded->file.scene, k);
        if (p->sheet.plan.set.of[k])
            printf("%-20s %-10s %8.2f %6.2f  %s\n", tp_rung_kind_row(k), kind.word,
                   millions(kind.saves), kind.adds, kind.named ? "set by the scene" : "");
    }
}

static void print_total(const plan *p, const options *o)
{
    const tp_set_price price = p->sheet.plan.price;
    const double cost = (double)price.cost, water = p->sheet.view.water;

    printf("\nin all: %.2f M instructions a frame, %.0f a water pixel; off %.2f of 255\n"
           "estimate: %.1f frames/s at %d MHz if an instruction takes " CPI " cycles\n",
           millions(cost), water > 0 ? cost / water : 0, plan_error(price),
           cost > 0 ? (double)SPEED / cost : 0, MHZ);
    program_memory_print(&p->memory, stdout, "");
    printf("Instructions: one frame on a Cortex-M4 at the scene's start, without %s.\n",
           o->stream ? "ticks,\nand without the lines that --stream and --kept compute again"
                     : "ticks");
    puts("Errors: rms beyond the exact picture, kept by 95 of 100 views; see --ladder.");
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

/* Prints the values of the scene that take less RAM. */
static void print_ram(const ram_rungs *r)
{
    if (r->count)
        puts("less RAM, by --set; off at tick 60:");
    for (int i = 0; i < r->count; i++)
        printf(" %zu KB, off %.2f of 255: %s\n", r->rung[i].bytes / 1024, r->rung[i].error,
               r->rung[i].text);
}

/* Sets the memory of the program that bake writes for the plan. */
static int find_memory(plan *p, const options *o)
{
    tp_scene scene = p->loaded->file.scene;
    options baked = *o;

    tp_rung_set_apply_some(&scene, &p->loaded->plan.set, p->loaded->plan.open);
    baked.format = o->formatted ? o->format : TP_FORMAT_RGB565;
    return program_memory_find(&p->memory, &scene, &p->loaded->assets.names, &baked, NULL);
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
        plan_sheet_make(&p.sheet, &s);
        p.world = world_rungs_find(&s, TP_PROCESSOR_M4);
        code = ram_rungs_find(&p.ram, &s);
        code = code ? code : find_memory(&p, o);
        if (!code && o->csv) {
            print_csv(&p);
        } else if (!code) {
            print_head(&p, o);
            print_kinds(&p);
            print_total(&p, o);
            print_world(&p.world);
            print_ram(&p.ram);
        }
    }
    loaded_scene_close(&s);
    return code;
}

int plan_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_PLAN, argc, argv);

    if (!o.band)
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
