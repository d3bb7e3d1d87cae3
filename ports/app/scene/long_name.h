/* SPDX-License-Identifier: MIT */
/* File names longer than a scene can hold, TP_NAME_BYTES.  The scene holds a short text
 * instead: "..." and the end of the long name.  The text stands for the long name until the
 * program ends: every copy of the text still means the same file.  Safe on several
 * threads. */
#ifndef TP_APP_SCENE_LONG_NAME_H
#define TP_APP_SCENE_LONG_NAME_H
#include <stddef.h>

/* Returns the short text for the first `bytes` of a long name, or NULL after a message: no
 * memory. */
const char *long_name_shorten(const char *name, size_t bytes);

/* Returns the long name of a short text; any other text is returned unchanged. */
const char *long_name_whole(const char *text);
#endif
