/* SPDX-License-Identifier: MIT */
/* Slow motion and fast forward; the time scale changes continuously [D6].
 *
 * Each frame advances the clock by `scale` ticks, and the scale approaches its target: s
 * += (s* - s)(1 - exp(-dt / tau)), tau = 0.4 s, dt = 1/60 s.  The simulation steps whole
 * ticks only, so a recorded input replays bit for bit.  The fraction of a tick is used
 * for interpolation when drawing. */
#ifndef TP_SCENE_CLOCK_H
#define TP_SCENE_CLOCK_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/fixed.h"

#define TP_CLOCK_SLOWEST (TP_FX_ONE / 8)
#define TP_CLOCK_FASTEST (4 * TP_FX_ONE)

typedef struct {
    int64_t  scale_q40;     /* s; 40 fraction bits keep small steps */
    uint64_t ticks;         /* whole ticks in the sum of s */
    int64_t  fraction_q40;      /* fraction of the sum, 0..1 */
    tp_fx    target;        /* s*, clamped to 1/8..4 */
    int32_t  zero;          /* padding; equal clocks are equal byte by byte */
} tp_clock;

/* Starts at tick 0; clamps scale and target to TP_CLOCK_SLOWEST..TP_CLOCK_FASTEST. */
void tp_clock_init(tp_clock *clock, tp_fx scale);
void tp_clock_set_target(tp_clock *clock, tp_fx target);       /* clamps `target` */

/* Moves the target by `steps` along the scales 1/8, 1/4 .. 4: +1 halves the target, -1
 * doubles the target. */
void tp_clock_shift_target(tp_clock *clock, int32_t steps);

/* True if scale, target and part are in their ranges.  Use: the bytes of `clock` come
 * from outside the program. */
bool tp_clock_is_valid(const tp_clock *clock);

/* Advances by one frame: first updates the scale, then adds the scale to the time. */
void tp_clock_advance(tp_clock *clock);

tp_fx    tp_clock_scale(const tp_clock *clock);     /* s, rounded */
uint64_t tp_clock_ticks(const tp_clock *clock);     /* whole ticks so far */
tp_fx    tp_clock_fraction(const tp_clock *clock);  /* rest of a tick, 0 <= f < 1 */
#endif
