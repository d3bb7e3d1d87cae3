/* SPDX-License-Identifier: MIT */
/* Values of a scene that take less RAM: narrower cells of pools, smaller mirrors.  Nothing
 * sets them but the scene itself, or a --set. */
#ifndef TP_APP_SCENE_RAM_RUNGS_H
#define TP_APP_SCENE_RAM_RUNGS_H
#include "loaded_scene.h"

#define RAM_RUNGS 4

typedef struct {
    const char *text;           /* a setting: "pool.cell_bits=8" */
    size_t      bytes;          /* that it saves */
    double      error;          /* rms of 255 that it adds to the exact picture at tick 60 */
} ram_rung;

typedef struct {
    ram_rung rung[RAM_RUNGS];
    int      count;
} ram_rungs;

/* Finds the values of a scene that take less RAM and that its checks accept, each alone.
 * Runs a second of the scene and draws its picture for each.  Returns an exit code. */
int ram_rungs_find(ram_rungs *to, const loaded_scene *s);
#endif
