/* SPDX-License-Identifier: MIT */
/* Lists the shipped scenes that use a method, for the charts' column `used`; reads the
 * scenes' files with the program's own reader. Run in the project's folder. */
#ifndef TP_TESTS_CHARTS_USED_H
#define TP_TESTS_CHARTS_USED_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/scene.h"

/* True if a scene uses the method; `of` is the caller's argument. */
typedef bool used_test(const tp_scene *scene, int32_t of);

/* Names of the scenes that use the method, separated by blanks; "all" or "-". Valid until
 * the next call. Ends the program with an error on stderr if a scene cannot be read. */
const char *used_by(used_test *test, int32_t of);

/* The names as a row of the sweep; a NULL test stands for a method that only the engine
 * has: all scenes. */
void used_row(const char *chart, const char *point, used_test *test, int32_t of);

/* True if a floor or wind changes the scene's waves. */
bool used_coast(const tp_scene *scene);

/* The shipped scenes in the order of their names; NULL beyond the last. */
const tp_scene *used_scene(size_t i, const char **name);
#endif
