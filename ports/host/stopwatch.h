/* SPDX-License-Identifier: MIT */
/* Nanoseconds by stage: a program whose stages are timed, put in place of a canvas's while
 * somebody looks at the figures. */
#ifndef HOST_STOPWATCH_H
#define HOST_STOPWATCH_H
#include <stdbool.h>
#include <stdint.h>
#include "canvas.h"

/* Of every stage of the list in program.h, by its place there. */
extern const char *const stopwatch_name[];
extern const uint32_t    stopwatch_stages;

/* Puts timed stages into the canvas's program, or its own ones back; between its pictures, and
 * again when it has been opened anew.  The bits of pictures stay the same.  Threads add
 * up.  Canvases that are timed at once are of one machine. */
void     stopwatch_use(canvas *c, bool on);
void     stopwatch_zero(void);
uint64_t stopwatch_ns(uint32_t stage);          /* since the last zero */
#endif
