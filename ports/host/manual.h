/* SPDX-License-Identifier: MIT */
/* What the manual's two pages share. */
#ifndef HOST_MANUAL_H
#define HOST_MANUAL_H

/* The page's title and what it is about: "name - in a few words". */
void manual_head(const char *name, int section, const char *book, const char *what);

/* tidepool-scene(5), on stdout. */
void manual_scene(void);
#endif
