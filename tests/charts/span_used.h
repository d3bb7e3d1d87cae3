/* SPDX-License-Identifier: MIT */
/* Which shipped scenes the plan draws by what, at 320x240 with their files read. */
#ifndef CHARTS_SPAN_USED_H
#define CHARTS_SPAN_USED_H
#include <stdbool.h>
#include "scene/plan.h"

typedef bool rungs_test(const tp_scene *scene, const tp_rungs *rungs, const void *of);

/* Their names parted by blanks, "all" or "-"; until the next call.  Ends the program if a
 * scene cannot be read. */
const char *span_used(rungs_test *test, const void *of);
#endif
