/* SPDX-License-Identifier: MIT */
/* Which of the shipped scenes use a method: the charts' column `used`, worked out of the
 * scenes' files as the program reads them.  Run in the project's folder. */
#ifndef USED_H
#define USED_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/scene.h"

/* Whether a scene uses the method; `of` is what the caller gave. */
typedef bool used_test(const tp_scene *scene, int32_t of);

/* The names of the scenes that do, parted by blanks; "all" or "-".  The text lasts until
 * the next call.  Ends the program, with words on stderr, if a scene cannot be read. */
const char *used_by(used_test *test, int32_t of);

/* The same as a row of the sweep; NULL asks for a method that the engine has alone: all
 * scenes. */
void used_row(const char *chart, const char *point, used_test *test, int32_t of);

/* Whether a scene's waves feel a floor or a wind. */
bool used_coast(const tp_scene *scene);

/* The shipped scenes themselves, in the order of their names: NULL beyond the last. */
const tp_scene *used_scene(size_t i, const char **name);
#endif
