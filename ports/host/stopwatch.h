/* SPDX-License-Identifier: MIT */
/* Nanoseconds by stage: while the figures are shown, the canvas draws by a program whose
 * stages are timed. */
#ifndef HOST_STOPWATCH_H
#define HOST_STOPWATCH_H
#include <stdbool.h>
#include <stdint.h>
#include "canvas.h"

/* Names of all stages, in the order of the list in program.h. */
extern const char *const stopwatch_name[];
extern const uint32_t    stopwatch_stages;

/* Puts timed stages into the canvas's program, or the machine's own stages back.  Call it
 * between pictures, and again after the canvas has been opened anew.  Pictures keep their
 * bits.  Times of all threads are added up.  Canvases timed at once share one machine. */
void     stopwatch_use(canvas *c, bool on);
void     stopwatch_zero(void);
uint64_t stopwatch_ns(uint32_t stage);          /* since the last zero */
#endif
