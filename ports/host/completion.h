/* SPDX-License-Identifier: MIT */
/* Shell completion: one script per shell, printed on stdout.  The scripts are made from the
 * tables of commands, options and parameters and from the words of arguments (takes.h). */
#ifndef HOST_COMPLETION_H
#define HOST_COMPLETION_H
#include "args_rows.h"
#include "commands.h"
#include "say.h"
#include "takes.h"

void completion_bash(void);
void completion_zsh(void);
void completion_fish(void);

/* Prints a text in single quotes, valid in all three shells. */
void print_quoted(const char *text);

/* Print the words for `kind`, separated by blanks, or the names of parameters, each with
 * the suffix `tail`. */
void print_words(const char *kind);
void print_names(const char *tail);

/* Prints "boat.mesh|sky.east|...": the parameters that name files, each with the suffix
 * `tail`. */
void print_file_names(const char *tail);

/* next_choice returns the next distinct list of choices after `last` (NULL: the first), or
 * NULL.  print_choosers prints the names of its parameters. */
const char *next_choice(const char *last);
void        print_choosers(const char *choice, const char *tail);

/* Prints the words of a list "off|on", each followed by a blank. */
void print_choice(const char *choice);
#endif
