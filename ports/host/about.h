/* SPDX-License-Identifier: MIT */
/* What each command does, in whole sentences: for its --help and for the manual. */
#ifndef HOST_ABOUT_H
#define HOST_ABOUT_H

typedef struct {
    unsigned    command;        /* FOR_... of args.h */
    const char *usage;          /* "tidepool bench [OPTION]...", a line each */
    const char *text;           /* lines of a screen */
    const char *after;          /* more of them, behind the options; "": none */
    unsigned    exits;          /* 1 << EXIT_..., for each that it may exit with */
    const char *check;          /* the meaning of EXIT_CHECK here; NULL: it has none */
} about_row;

#define ABOUT_EXITS_BYTES 128

/* "Exit: 0 done, 2 usage, 3 bad input.": a line of the screen, without its end. */
void about_exits(const about_row *row, char text[ABOUT_EXITS_BYTES]);

const about_row *about_of(unsigned command);

/* The whole of its --help, on stdout: 24 lines at the most. */
void about_print(unsigned command);
#endif
