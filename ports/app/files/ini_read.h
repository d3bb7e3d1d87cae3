/* SPDX-License-Identifier: MIT */
/* INI files, with line numbers. */
#ifndef TP_APP_FILES_INI_READ_H
#define TP_APP_FILES_INI_READ_H
#include <limits.h>
#include <stdbool.h>
#include <stdint.h>

#define INI_LINE (PATH_MAX + 255)       /* bytes of a line, without its end and indent */

/* Takes one setting; false: refused, after a message with the reason. */
typedef bool ini_take(void *user, uint32_t line, const char *section, const char *name,
                      const char *value);

/* Returns EXIT_INPUT after a message if the file or a line is bad. */
int ini_read(const char *path, ini_take *take, void *user);
#endif
