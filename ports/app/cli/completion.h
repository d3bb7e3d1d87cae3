/* SPDX-License-Identifier: MIT */
/* Shell completion: one script per shell, printed on stdout.  The scripts are made from the
 * tables of commands, options and parameters and from the words of arguments
 * (argument_types.h). */
#ifndef TP_APP_CLI_COMPLETION_H
#define TP_APP_CLI_COMPLETION_H
#include "app/files/log.h"
#include "args_rows.h"
#include "argument_types.h"
#include "commands.h"

void completion_bash(void);
void completion_zsh(void);
void completion_fish(void);

/* Prints a text in single quotes, valid in all three shells. */
void completion_print_quoted(const char *text);

/* Print the words for `kind`, separated by blanks, or the names of parameters, each with
 * the suffix `tail`. */
void completion_print_words(const char *kind);
void completion_print_names(const char *tail);

/* Prints "boat.mesh|sky.east|...": the parameters that name files, each with the suffix
 * `tail`. */
void completion_print_file_names(const char *tail);

/* completion_next_choice returns the next distinct list of choices after `last` (NULL:
 * the first), or NULL.  completion_print_choosers prints the names of its parameters. */
const char *completion_next_choice(const char *last);
void        completion_print_choosers(const char *choice, const char *tail);

/* Prints the words of a list "off|on", each followed by a blank. */
void completion_print_choice(const char *choice);
#endif
