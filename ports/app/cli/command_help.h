/* SPDX-License-Identifier: MIT */
/* The description of each command in whole sentences, for `--help` and for the manual. */
#ifndef TP_APP_CLI_COMMAND_HELP_H
#define TP_APP_CLI_COMMAND_HELP_H

typedef struct {
    unsigned    command;        /* FOR_... of args.h */
    const char *usage;          /* "tidepool bench [OPTION]...", one usage per line */
    const char *text;           /* description, wrapped to the width of a screen */
    const char *after;          /* text printed after the options; "": none */
    unsigned    exits;          /* set of exit codes, bits 1 << EXIT_... */
    const char *check;          /* meaning of EXIT_CHECK for the command; NULL: unused */
} command_help_row;

#define COMMAND_HELP_EXITS_BYTES 128

/* Writes "Exit: 0 done, 2 usage, 3 bad input." into text: one line, without a line feed. */
void command_help_exits(const command_help_row *row, char text[COMMAND_HELP_EXITS_BYTES]);

const command_help_row *command_help_find(unsigned command);

/* Prints the whole `--help` of a command on stdout: at most 24 lines. */
void command_help_print(unsigned command);
#endif
