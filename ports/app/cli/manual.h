/* SPDX-License-Identifier: MIT */
/* Functions shared by the two pages of the manual. */
#ifndef TP_APP_CLI_MANUAL_H
#define TP_APP_CLI_MANUAL_H

/* Prints the title, and the section NAME with `what`: "name - in a few words". */
void manual_head(const char *name, int section, const char *book, const char *what);

/* Prints tidepool-scene(5) on stdout. */
void manual_scene(void);
#endif
