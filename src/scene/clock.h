/* SPDX-License-Identifier: MIT */
/* Slow motion and fast forward, continuous both ways [D6].
 *
 * Each picture advances the clock by `scale` ticks, and the scale slides towards its
 * target: s += (s* - s)(1 - exp(-dt / tau)), tau = 0.4 s, dt = 1/60 s.  Whole ticks alone
 * are ever stepped, so a recorded input replays bit for bit; the fraction is for
 * drawing. */
#ifndef TP_SCENE_CLOCK_H
#define TP_SCENE_CLOCK_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/fixed.h"

#define TP_CLOCK_SLOWEST (TP_FX_ONE / 8)
#define TP_CLOCK_FASTEST (4 * TP_FX_ONE)

typedef struct {
    int64_t  scale_q40;     /* s: small steps are not lost */
    uint64_t ticks;         /* sum of s: whole ticks, and ... */
    int64_t  part_q40;      /* ... the rest, 0..1 */
    tp_fx    target;        /* s*, clamped to 1/8..4 */
    int32_t  zero;          /* so that equal clocks are equal byte by byte */
} tp_clock;

/* At tick 0, with scale and target clamped to the ends. */
void tp_clock_init(tp_clock *clock, tp_fx scale);
void tp_clock_aim(tp_clock *clock, tp_fx target);       /* clamped to its ends */

/* `steps` up or down the scales 1/8, 1/4 .. 4: +1 halves the target, -1 doubles it. */
void tp_clock_shift(tp_clock *clock, int32_t steps);

/* Whether a clock whose bytes come from outside can go on: scale, target and part are in
 * their ranges. */
bool tp_clock_is_valid(const tp_clock *clock);

/* One picture further: the scale slides, then time passes. */
void tp_clock_next(tp_clock *clock);

tp_fx    tp_clock_scale(const tp_clock *clock);     /* s, rounded */
uint64_t tp_clock_ticks(const tp_clock *clock);     /* whole ticks so far */
tp_fx    tp_clock_fraction(const tp_clock *clock);  /* and the rest, 0 <= f < 1 */
#endif
