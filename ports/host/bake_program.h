/* SPDX-License-Identifier: MIT */
/* The part of a baked file that a program is linked by: NAME_program, which lists what the
 * scene needs at one size and format, and NAME_config, those two. */
#ifndef HOST_BAKE_PROGRAM_H
#define HOST_BAKE_PROGRAM_H
#include <stdio.h>
#include "args.h"
#include "dry_find.h"

typedef struct bake_program {
    dry_wish  wish;
    dry_found found;
    tp_scene  scene;            /* that goes with the list */
} bake_program;

/* True if the command line asks for a list: it names a size or a format. */
bool bake_has_program(const options *o);

/* EXIT_USAGE, and said so: an option is of a list, and none is asked for. */
int  bake_check_options(const options *o);

/* Finds the list.  `baked` are the assets that the file will have; what the list never
 * looks at is dropped from them.  Returns an exit code and has said why. */
int  bake_find_program(bake_program *p, const options *o, const tp_scene *scene,
                       const tp_assets *assets, tp_assets *baked);

/* Lines of the file's head, and the list. */
void bake_put_pieces(const bake_program *p, FILE *out);
void bake_put_program(const bake_program *p, FILE *out, const char *name);
#endif
