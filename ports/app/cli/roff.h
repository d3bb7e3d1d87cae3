/* SPDX-License-Identifier: MIT */
/* Manual pages as roff source on stdout: macros of man(7), printed verbatim, and text,
 * escaped. */
#ifndef TP_APP_CLI_ROFF_H
#define TP_APP_CLI_ROFF_H
#include "app/files/log.h"

/* Prints a macro, as ".TH ..." or ".PP", on a line of its own. */
void roff_macro(const char *format, ...) LOG_PRINTF(1, 2);

/* Prints text after the previous text, blanks included; roff fills the lines. */
void roff_text(const char *text);
void roff_bold(const char *text);
void roff_italic(const char *text);

/* Ends the current source line; to call at the end of the page. */
void roff_end(void);
#endif
