/* SPDX-License-Identifier: MIT */
/* Lists the shipped scenes by the plan's rungs, at 320x240 with their files read. */
#ifndef TP_TESTS_CHARTS_SPAN_USED_H
#define TP_TESTS_CHARTS_SPAN_USED_H
#include <stdbool.h>
#include "frame/tools.h"

typedef bool rungs_test(const tp_scene *scene, const tp_rungs *rungs, const void *of);

/* Names of the scenes that pass the test, separated by blanks, "all" or "-"; valid until
 * the next call. Ends the program if a scene cannot be read. */
const char *span_used(rungs_test *test, const void *of);
#endif
