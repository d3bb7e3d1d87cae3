/* SPDX-License-Identifier: MIT */
/* Names of files that are longer than a scene holds, TP_NAME_BYTES.  The scene then has a
 * short one, "..." and the end of the long one, which stands for it until the program
 * ends: copies of the text still mean the file.  Threads may do so at once. */
#ifndef HOST_LONG_NAME_H
#define HOST_LONG_NAME_H
#include <stddef.h>

/* The short name of the first `bytes` of a long one, or NULL: no memory, and it said so. */
const char *long_name_shorten(const char *name, size_t bytes);

/* The long name that the text stands for, or the text. */
const char *long_name_whole(const char *text);
#endif
