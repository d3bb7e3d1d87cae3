/* SPDX-License-Identifier: MIT */
/* Measures ns per stage: while the figures are shown, the frame renderer draws with a
 * program of timed stages. */
#ifndef TP_APP_SCENE_STOPWATCH_H
#define TP_APP_SCENE_STOPWATCH_H
#include <stdbool.h>
#include <stdint.h>
#include "frame_renderer.h"

/* Names of all stages, in the order of TP_STAGE_LIST in tidepool/modules.h. */
extern const char *const stopwatch_name[];
extern const uint32_t    stopwatch_stages;

/* Puts timed stages into the frame renderer's program, or restores the machine's own
 * stages.  To call between pictures, and again after the frame renderer has been reopened.
 * Pictures keep their bits.  Times of all threads are summed.  Frame renderers timed at the
 * same time must have the same machine. */
void     stopwatch_use(frame_renderer *c, bool on);
void     stopwatch_zero(void);
uint64_t stopwatch_ns(uint32_t stage);          /* time since the last zero, ns */
#endif
