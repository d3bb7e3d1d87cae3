/* SPDX-License-Identifier: MIT */
/* The steps of a scene's ladder, and what the boards draw of the scene, as rows of the
 * charts "ladder" and "boards":
 *
 *     ladder SCENE
 *     ladder boards
 *         prints the boards: NAME INSTRUCTIONS_A_SECOND PROCESSOR
 *
 * Steps, errors and RAM are those of `tidepool plan SCENE --ladder --csv`, 320x240, costs
 * the plan's estimates.  A board has the step of `plan SCENE --board NAME`, in instructions
 * of the processor by which it is priced.  Pictures a second are the board's instructions
 * without those of the ticks, over those of a picture. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "app/cli/ladder_pictures.h"
#include "app/scene/scene_plan.h"
#include "app/scene/world_rungs.h"

#define LADDERS_BOARD "stm32f405"       /* whose step the chart "ladder" shows too */

enum { WIDTH = 320, HEIGHT = 240 };

static set_ladder ladder;

static void print_step(const char *scene, const char *name, const ladder_step *s)
{
    printf("ladder,%s;%s,m4,%" PRIu64 "\n", scene, name, s->price.cost);
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
    for (size_t i = 0; i < TP_BOARDS - 1; i++)
        printf("%s %" PRIu64 " %s\n", boards[i].name, boards[i].speed,
               boards[i].processor);
}

static int print_board(const loaded_scene *s, const options *o, const plan_board *b)
{
    tick_cost tick = { 0 };
    const char *name = s->file.name;

    if (!world_rungs_tick(&s->file.scene, &s->assets.names, b->priced_as, &tick))
        tick.mean = 0;
    const board_frame frame = { b, BOARD_FRAME_US, tick.mean };
    const board_frame second = { b, 1000000, tick.mean };
    const tp_plan plan = scene_plan_make(s, &frame, o->width, o->height, NULL);
    ladder_step step = set_ladder_step(s, &plan);
    const int code = ladder_pictures_measure(&step, 1, o, false);
    printf("boards,%s;%s,pictures,%.2f\n", name, b->name,
           (double)board_frame_budget(&second) / (double)step.price.cost);
    printf("boards,%s;%s,cost,%" PRIu64 "\n", name, b->name, step.price.cost);
    printf("boards,%s;%s,tick,%" PRIu64 "\n", name, b->name, tick.mean);
    printf("boards,%s;%s,db,%.1f\n", name, b->name, step.db);
    printf("boards,%s;%s,ram,%zu\n", name, b->name, step.ram);
    printf("boards,%s;%s,fits,%d\n", name, b->name, step.ram <= b->ram);
    if (strcmp(b->name, LADDERS_BOARD) == 0)
        print_step(name, b->name, &step);
    return code;
}

static int print_all(const loaded_scene *s, const options *o)
{
    set_ladder_find(&ladder, s, o->width, o->height);
    int code = ladder_pictures_measure(ladder.step, ladder.count, o, false);
    if (code)
        return code;
    print_steps(s->file.name);
    for (size_t i = 0; i < TP_BOARDS - 1 && !code; i++)
        code = print_board(s, o, &boards[i]);
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
