/* SPDX-License-Identifier: MIT */
/* Prints the ladder of a scene, and the step for a board: what a board draws in real time,
 * and what the scene gives up for it. */
#include "plan_ladder.h"
#include <inttypes.h>
#include <stdio.h>
#include "app/scene/scene_plan.h"
#include "app/scene/world_rungs.h"
#include "ladder_pictures.h"

enum { FPS = 1000000 / BOARD_FRAME_US };

static double millions(uint64_t n)
{
    return (double)n / 1e6;
}

/* -- the ladder ---------------------------------------------------------------------- */

static void print_csv(const set_ladder *ladder, uint64_t tick)
{
    puts("step,choices,frame_m,tick_m,ram,flash,added,total,db");
    for (uint32_t i = 0; i < ladder->count; i++) {
        const ladder_step *s = &ladder->step[i];
        printf("%u,%s,%.2f,%.2f,%zu,%zu,%.2f,%.2f,%.1f\n", (unsigned)i, s->choices,
               millions(s->price.cost), millions(tick), s->ram, s->flash, s->added, s->total,
               s->db);
    }
}

/* Prints the rows by which a step differs from the one before. */
static void print_change(const ladder_step *before, const ladder_step *now)
{
    for (int k = 0; k < TP_RUNG_KINDS; k++)
        if (before->set.of[k] != now->set.of[k])
            printf(" %s", tp_rung_kind_row(k));
    puts("");
}

static void print_steps(const set_ladder *ladder, const loaded_scene *s, uint64_t tick)
{
    printf("%s: a tick takes %.2f M instructions of a Cortex-M4 at every step\n\n"
           "step  M instr  RAM KB  flash KB  added  total     dB  what is cheaper\n",
           s->file.name, millions(tick));
    for (uint32_t i = 0; i < ladder->count; i++) {
        const ladder_step *l = &ladder->step[i];
        printf("%4u %8.2f %7zu %9zu %6.2f %6.2f %6.1f ", (unsigned)i, millions(l->price.cost),
               l->ram / 1024, l->flash / 1024, l->added, l->total, l->db);
        if (i)
            print_change(&ladder->step[i - 1], l);
        else
            puts(" the exact picture");
    }
    puts("\nadded: rms of 255 against the exact picture; total: against the reference at\n"
         "16 samples; ticks 60 and 300.  `tidepool render SCENE --step N` draws a step.");
}

static uint64_t tick_estimate(const loaded_scene *s, tp_processor processor)
{
    tick_cost tick = { 0 };

    return world_rungs_tick(&s->file.scene, &s->assets.names, processor, &tick) ? tick.mean
                                                                              : 0;
}

int plan_ladder_print(const loaded_scene *s, const options *o)
{
    static set_ladder ladder;
    const uint64_t tick = tick_estimate(s, TP_PROCESSOR_M4);

    set_ladder_find(&ladder, s, o->width, o->height);
    const int code = ladder_pictures_measure(ladder.step, ladder.count, o, true);
    if (!code && o->csv)
        print_csv(&ladder, tick);
    else if (!code)
        print_steps(&ladder, s, tick);
    return code;
}

/* -- a board ------------------------------------------------------------------------- */

/* Prints the settings of a step, as many in a line as fit a terminal. */
static void print_choices(const char *text)
{
    int column = 0;

    for (; *text; text++) {
        if (*text == ' ' && column > 60) {
            printf("\n   ");
            column = 0;
        }
        putchar(*text);
        column++;
    }
    puts("");
}

static void print_board_csv(const plan_board *b, uint32_t fps, uint64_t tick,
                            const ladder_step *step, bool real_time)
{
    puts("board,fps,real_time,choices,frame_m,tick_m,ram,flash,added,db,speed_m");
    printf("%s,%u,%s,%s,%.2f,%.2f,%zu,%zu,%.2f,%.1f,%.1f\n", b->name, (unsigned)fps,
           real_time ? "yes" : "no", step->choices, millions(step->price.cost), millions(tick),
           step->ram, step->flash, step->added, step->db, millions(b->speed));
}

/* Prints what makes ticks cheaper, where the scene's values allow it. */
static void print_world(const loaded_scene *s, tp_processor processor)
{
    const world_rungs world = world_rungs_find(s, processor);

    if (world.count)
        printf("cheaper ticks, by values of the scene (--set):\n    %s: %.2f M\n",
               world.rung[world.count - 1].text,
               millions(world.rung[world.count - 1].cost.mean));
}

static void print_memory(const plan_board *b, const options *o, const ladder_step *step)
{
    const bool other = !b->own || b->priced_as != TP_PROCESSOR_M4;

    printf("RAM %zu of %u KB, flash %zu of %u KB%s; tiles of %ux%u\n", step->ram / 1024,
           (unsigned)b->ram / 1024, step->flash / 1024, (unsigned)b->flash / 1024,
           other ? " with code of a Cortex-M4" : "",
           (unsigned)(o->strip ? o->strip : o->width), (unsigned)o->band);
    if (step->ram > b->ram)
        printf("too much RAM: %s--band and --strip save some\n", o->stream ? "" : "--stream, ");
    else if (o->stream && b->ram - step->ram >= 2048)
        printf("%zu KB stay free: with --kept%s fewer lines are computed again\n",
               (b->ram - step->ram) / 1024, o->kept ? " of more bytes" : "");
    if (o->stream)
        puts("a picture is counted without the lines that are computed again");
    if (step->flash > b->flash)
        puts("too much flash: --texels of bake saves some");
}

static void print_board(const loaded_scene *s, const options *o, uint32_t fps,
                        uint64_t tick, const ladder_step *step, bool real_time)
{
    const plan_board *b = o->board;
    const board_frame second = { b, 1000000, tick };
    const uint64_t left = board_frame_budget(&second);

    printf("%s on %s (%s, %u MHz, %.0f M instructions %sa second; %s)\n"
           "multiplies %s; %s\n\n",
           s->file.name, b->name, b->processor, (unsigned)b->mhz, millions(b->speed),
           b->own ? "" : "of a Cortex-M4 ", b->speed_from, b->multiplier, b->source);
    printf("real time, %u pictures and %d ticks a second: %s; ", (unsigned)fps,
           TICKS_A_SECOND, real_time ? "yes" : "no");
    if (left && step->price.cost)
        printf("at most %.1f pictures\n", (double)left / (double)step->price.cost);
    else
        printf("ticks alone take %.0f M\n", millions(TICKS_A_SECOND * tick));
    printf("a picture %.2f M, a tick %.2f M instructions; off by %.2f of 255, %.1f dB\n",
           millions(step->price.cost), millions(tick), step->added, step->db);
    print_memory(b, o, step);
    printf("%s\n    ", step->choices[0] ? "gives up:" : "gives up nothing");
    print_choices(step->choices);
    if (!real_time)
        print_world(s, b->priced_as);
}

int plan_board_print(const loaded_scene *s, const options *o)
{
    const uint32_t fps = o->fps ? o->fps : FPS;
    const board_frame frame = { o->board, 1000000 / fps, tick_estimate(s, o->board->priced_as) };
    bool real_time;
    const tp_plan plan = scene_plan_make(s, &frame, o->width, o->height, &real_time);
    ladder_step step = set_ladder_step(s, &plan);
    const int code = ladder_pictures_measure(&step, 1, o, false);

    if (!code && o->csv)
        print_board_csv(o->board, fps, frame.tick, &step, real_time);
    else if (!code)
        print_board(s, o, fps, frame.tick, &step, real_time);
    return code;
}
