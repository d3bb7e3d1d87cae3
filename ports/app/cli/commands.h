/* SPDX-License-Identifier: MIT */
/* The commands of the program.  Each takes its own name as argv[0] and returns an exit
 * code; a code other than 0 follows after a message with the reason. */
#ifndef TP_APP_CLI_COMMANDS_H
#define TP_APP_CLI_COMMANDS_H
#include <stdbool.h>
#include <stddef.h>
#include "app/files/log.h"

int render_command(int argc, char **argv);
int view_command(int argc, char **argv);
int show_command(int argc, char **argv);
int scenes_command(int argc, char **argv);
int params_command(int argc, char **argv);
int bake_command(int argc, char **argv);
int check_command(int argc, char **argv);
int plan_command(int argc, char **argv);
int bench_command(int argc, char **argv);
int charts_command(int argc, char **argv);
int join_command(int argc, char **argv);
int manual_command(int argc, char **argv);
int completion_command(int argc, char **argv);
int help_command(int argc, char **argv);
int version_command(int argc, char **argv);

/* The table of commands, in the order of the help. */
typedef struct {
    const char *name, *takes;
    unsigned    options;                /* FOR_... of args.h */
    bool        lists;                  /* the command only prints */
    int       (*run)(int argc, char **argv);
    const char *help;
} command_row;

extern const command_row commands[];
extern const size_t      command_count;

/* Finds a command.  Returns NULL after a message with the nearest name. */
const command_row *command_find(const char *name);

/* Meanings of the exit codes, indexed by code: a few words, and a sentence. */
typedef struct { const char *words, *sentence; } exit_row;
extern const exit_row exits[EXIT_CODES];
#endif
