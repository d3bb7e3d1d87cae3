/* SPDX-License-Identifier: MIT */
/* The table of options, from which come the reading of command lines, `--help`, the
 * manual page and the completion of shells. */
#ifndef HOST_ARGS_ROWS_H
#define HOST_ARGS_ROWS_H
#include <stddef.h>
#include "args.h"

/* Several commands. */
#define ALL (FOR_RENDER | FOR_VIEW | FOR_PARAMS | FOR_SCENES | FOR_CHECK | FOR_BAKE \
             | FOR_PLAN | FOR_BENCH | FOR_CHARTS | FOR_JOIN | FOR_SHOW | FOR_MANUAL \
             | FOR_COMPLETION | FOR_HELP | FOR_VERSION)
#define DRAWERS (FOR_RENDER | FOR_VIEW | FOR_SHOW)
#define MANY (FOR_CHARTS | FOR_JOIN)
#define RARE 0x80000000u        /* --help names it alone, the manual says all of it */

/* Reads a value into *o; NULL, or what was expected instead. */
typedef const char *(*args_reader)(options *o, const char *value);

/* A name may have several rows, of different commands. */
typedef struct {
    const char *name, *value;   /* value: what kind it is, a word; NULL for a switch */
    unsigned    commands;       /* FOR_..., RARE */
    args_reader read;
    const char *help;
} option_row;

extern const option_row args_rows[];
extern const size_t     args_row_count;
#endif
