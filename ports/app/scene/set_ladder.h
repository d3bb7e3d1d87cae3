/* SPDX-License-Identifier: MIT */
/* The ladder of a scene: the sets of rungs from its exact picture to its cheapest one, with
 * the cost of each; cli/ladder_pictures.h measures their errors. */
#ifndef TP_APP_SCENE_SET_LADDER_H
#define TP_APP_SCENE_SET_LADDER_H
#include "app/files/log.h"
#include "loaded_scene.h"
#include "quality/rung_sets.h"

typedef struct {
    tp_rung_set set;
    tp_set_price price;         /* of a frame, by estimate */
    size_t   ram, flash;        /* of the baked program, program_memory.h */
    char     choices[640];      /* rows unlike the exact ones, apart by spaces */
    double   added, db;         /* rms, of 255, and PSNR against the exact picture */
    double   total;             /* rms against the reference at 16 samples; -1: unknown */
} ladder_step;

typedef struct {
    ladder_step step[TP_SET_STEPS];
    uint32_t    count;
} set_ladder;

/* Finds the steps of a scene for pictures of a size; the first one is the exact picture, or
 * what the scene names.  Measures nothing. */
void set_ladder_find(set_ladder *ladder, const loaded_scene *s, uint32_t width,
                     uint32_t height);

/* Returns the step of a plan. */
ladder_step set_ladder_step(const loaded_scene *s, const tp_plan *plan);

/* Finds step `at` of the scene for pictures of o's size, and sets the scene's rows to it.
 * Returns EXIT_INPUT, with the number of steps, if there is no such step. */
int set_ladder_take(loaded_scene *s, const options *o, uint32_t at);

/* Sets the scene's rows to a step, and loads the mesh that it names.  Returns an exit
 * code. */
int set_ladder_apply(loaded_scene *s, const options *o, const ladder_step *step);
#endif
