/* SPDX-License-Identifier: MIT */
/* The part of a baked file for linking a program: NAME_program lists the components that
 * the scene needs at one size and format; NAME_config has the size and the format. */
#ifndef TP_TOOLS_BAKE_BAKE_PROGRAM_H
#define TP_TOOLS_BAKE_BAKE_PROGRAM_H
#include <stdio.h>
#include "app/cli/args.h"
#include "bake_tables.h"
#include "component_search.h"

typedef struct bake_program {
    component_search_request request;
    component_search_result found;
    tp_scene  scene;            /* scene to bake with the list; its rungs may be named */
    bake_tables tables;         /* of its frames */
} bake_program;

/* True if the command line asks for a program list: a size or a format is given. */
bool bake_has_program(const options *o);

/* Returns EXIT_USAGE after a message if an option needs a program list but none is asked
 * for. */
int  bake_check_options(const options *o);

/* Finds the list.  baked: assets of the file; assets that the list never reads are dropped.
 * *baked gets the tables of *p.  worlds: those of an earlier list, or NULL.
 * Returns an exit code, and prints the reason of a failure; the caller calls
 * bake_close_program in every case. */
int  bake_find_program(bake_program *p, const options *o, const tp_scene *scene,
                       const tp_assets *assets, tp_assets *baked,
                       component_search_worlds *worlds);

void bake_close_program(bake_program *p);

/* Write the components as lines of the file's head, and the list; world: the program has the
 * constant NAME_world. */
void bake_put_pieces(const bake_program *p, FILE *out);
void bake_put_program(const bake_program *p, FILE *out, const char *name, bool world);
#endif
