/* SPDX-License-Identifier: MIT */
/* The steps of a scene's ladder, and what the boards draw of the scene, as rows of the
 * charts "ladder" and "boards":
 *
 *     ladder SCENE
 *     ladder boards
 *         prints the boards: NAME INSTRUCTIONS_A_SECOND PROCESSOR
 *
 * Steps, errors and RAM are those of `tidepool plan SCENE --ladder --csv`, 320x240, costs
 * the plan's estimates.  A board has the step of `plan SCENE --board NAME --fps 10`: the
 * one that it draws 10 times a second beside 60 ticks, or the cheapest that keeps 28 dB.
 * Pictures a second are the board's instructions without those of the ticks, over those of
 * a picture. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "app/cli/ladder_pictures.h"
#include "app/scene/boards.h"
#include "app/scene/tick_cost.h"

#define LADDERS_BOARD "stm32f405"       /* whose step the chart "ladder" shows too */

enum { WIDTH = 320, HEIGHT = 240, FPS = 10, TICKS_A_SECOND = 60, LEAST_DB = 28 };

static set_ladder ladder;

static void print_step(const char *scene, const char *name, const ladder_step *s)
{
    printf("ladder,%s;%s,m4,%" PRIu64 "\n", scene, name, s->frame);
    printf("ladder,%s;%s,db,%.1f\n", scene, name, s->db);
    printf("ladder,%s;%s,added,%.2f\n", scene, name, s->added);
    printf("ladder,%s;%s,ram,%zu\n", scene, name, s->ram);
}

static void print_steps(const char *scene)
{
    for (uint32_t i = 0; i < ladder.count; i++) {
        char name[16];
        snprintf(name, sizeof name, "%u", (unsigned)i);
        print_step(scene, name, &ladder.step[i]);
    }
}

static void print_boards(void)
{
    for (size_t i = 0; i < board_count; i++)
        printf("%s %" PRIu64 " %s\n", boards[i].name, boards[i].speed,
               boards[i].processor);
}

/* Sets *step to the last measured step of the ladder that keeps LEAST_DB. */
static void find_best(ladder_step *step)
{
    *step = ladder.step[0];
    for (uint32_t i = 1; i < ladder.count; i++)
        if (ladder.step[i].db >= LEAST_DB)
            *step = ladder.step[i];
}

static int print_board(const loaded_scene *s, const options *o, const plan_board *b,
                       uint64_t tick)
{
    const uint64_t ticks = TICKS_A_SECOND * tick;
    const uint64_t left = b->speed > ticks ? b->speed - ticks : 0;
    const char *name = s->file.name;
    int code = EXIT_DONE;
    ladder_step step;

    if (set_ladder_within(&ladder, s, o->width, o->height, left / FPS, &step))
        code = ladder_pictures_measure(&step, 1, o, false);
    else
        find_best(&step);
    printf("boards,%s;%s,pictures,%.2f\n", name, b->name,
           (double)left / (double)step.frame);
    printf("boards,%s;%s,m4,%" PRIu64 "\n", name, b->name, step.frame);
    printf("boards,%s;%s,tick,%" PRIu64 "\n", name, b->name, tick);
    printf("boards,%s;%s,db,%.1f\n", name, b->name, step.db);
    printf("boards,%s;%s,ram,%zu\n", name, b->name, step.ram);
    printf("boards,%s;%s,fits,%d\n", name, b->name, step.ram <= b->ram);
    if (strcmp(b->name, LADDERS_BOARD) == 0)
        print_step(name, b->name, &step);
    return code;
}

static int print_all(const loaded_scene *s, const options *o)
{
    tick_cost tick = { 0 };
    int code;

    set_ladder_find(&ladder, s, o->width, o->height);
    code = ladder_pictures_measure(ladder.step, ladder.count, o, false);
    if (code)
        return code;
    print_steps(s->file.name);
    if (!tick_cost_estimate(&s->file.scene, &s->assets.names, &tick))
        tick.mean = 0;
    for (size_t i = 0; i < board_count && !code; i++)
        code = print_board(s, o, &boards[i], tick.mean);
    return code;
}

int main(int count, char **words)
{
    char path[160];
    const options o = { .command = "plan", .scene = path, .width = WIDTH,
                        .height = HEIGHT, .quiet = true };
    loaded_scene s;

    if (count != 2) {
        fprintf(stderr, "usage: ladder SCENE|boards\n");
        return 2;
    }
    if (strcmp(words[1], "boards") == 0) {
        print_boards();
        return 0;
    }
    snprintf(path, sizeof path, "assets/scenes/%s.ini", words[1]);
    int code = loaded_scene_load(&s, &o);
    code = code ? code : print_all(&s, &o);
    loaded_scene_close(&s);
    return code;
}
