/* SPDX-License-Identifier: MIT */
/* INI files, with the numbers of their lines. */
#ifndef HOST_INI_READ_H
#define HOST_INI_READ_H
#include <limits.h>
#include <stdbool.h>
#include <stdint.h>

#define INI_LINE (PATH_MAX + 255)       /* bytes of a line, without its end and indent */

/* Takes one setting; false: it refused it, and said why. */
typedef bool ini_take(void *user, uint32_t line, const char *section, const char *name,
                      const char *value);

/* EXIT_INPUT: the file or a line of it is bad, and it has been said. */
int ini_read(const char *path, ini_take *take, void *user);
#endif
