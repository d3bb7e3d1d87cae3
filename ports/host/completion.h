/* SPDX-License-Identifier: MIT */
/* What shells complete: one script for each, printed on stdout from the tables of
 * commands, options and parameters and the words that they take (takes.h). */
#ifndef HOST_COMPLETION_H
#define HOST_COMPLETION_H
#include "args_rows.h"
#include "commands.h"
#include "say.h"
#include "takes.h"

void completion_bash(void);
void completion_zsh(void);
void completion_fish(void);

/* A text in single quotes, as all three shells read it. */
void print_quoted(const char *text);

/* The words for `kind`, parted by blanks, or the parameters' names with `tail` behind. */
void print_words(const char *kind);
void print_names(const char *tail);

/* "boat.mesh|sky.east|...": parameters that name files, each with `tail` behind. */
void print_file_names(const char *tail);

/* The next list of choices after `last` (NULL: the first) that no parameter before had,
 * or NULL, and its parameters' names likewise. */
const char *next_choice(const char *last);
void        print_choosers(const char *choice, const char *tail);

/* Its words, "off|on", each with a blank behind. */
void print_choice(const char *choice);
#endif
