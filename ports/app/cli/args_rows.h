/* SPDX-License-Identifier: MIT */
/* The table of options.  The reader of command lines, `--help`, the manual page and shell
 * completion are all made from the table. */
#ifndef TP_APP_CLI_ARGS_ROWS_H
#define TP_APP_CLI_ARGS_ROWS_H
#include <stddef.h>
#include "args.h"

/* Groups of commands. */
#define ALL (FOR_RENDER | FOR_VIEW | FOR_PARAMS | FOR_SCENES | FOR_CHECK | FOR_BAKE \
             | FOR_PLAN | FOR_BENCH | FOR_CHARTS | FOR_JOIN | FOR_SHOW | FOR_MANUAL \
             | FOR_COMPLETION | FOR_HELP | FOR_VERSION)
#define DRAWERS (FOR_RENDER | FOR_VIEW | FOR_SHOW)
#define MANY (FOR_CHARTS | FOR_JOIN)
#define RARE 0x80000000u        /* `--help` prints the name, the manual the text */

/* Reads a value into *o.  Returns NULL, or a description of the expected values. */
typedef const char *(*args_reader)(options *o, const char *value);

/* One name may have several rows, each for other commands. */
typedef struct {
    const char *name, *value;   /* value: placeholder in the help, NULL: a switch */
    unsigned    commands;       /* set of FOR_..., RARE */
    args_reader read;
    const char *help;
} option_row;

extern const option_row args_rows[];
extern const size_t     args_row_count;
#endif
