/* SPDX-License-Identifier: MIT */
/* Manual pages as source for man, on stdout: the macros of man(7), whose lines are given
 * as they are, and text, in which nothing is one. */
#ifndef HOST_ROFF_H
#define HOST_ROFF_H
#include "say.h"

/* ".TH ...", ".PP": ends the line of text before it. */
void roff_macro(const char *format, ...) HOST_PRINTF(1, 2);

/* Text goes on where the last one stopped, blanks and all; its lines fill. */
void roff_text(const char *text);
void roff_bold(const char *text);
void roff_italic(const char *text);

/* The end of the page, and its last line. */
void roff_end(void);
#endif
