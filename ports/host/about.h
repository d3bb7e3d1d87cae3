/* SPDX-License-Identifier: MIT */
/* What each command does, in whole sentences: for its --help and for the manual. */
#ifndef HOST_ABOUT_H
#define HOST_ABOUT_H

typedef struct {
    unsigned    command;        /* FOR_... of args.h */
    const char *usage;          /* "tidepool bench [OPTION]...", a line each */
    const char *text;           /* lines of a screen */
    const char *after;          /* more of them, behind the options; "": none */
} about_row;

const about_row *about_of(unsigned command);

/* The whole of its --help, on stdout: 24 lines at the most. */
void about_print(unsigned command);
#endif
