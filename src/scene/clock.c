/* SPDX-License-Identifier: MIT */
/* The slow-motion clock, [D6] of the models.
 *
 * Each frame moves the scale towards its target by the share 1 - exp(-1/24) of the
 * remaining distance.  The scale has 40 fraction bits, so small steps are not lost.  A
 * remaining distance below 2 LSB of Q16.16 is covered in a single step. */
#include <stdbool.h>
#include "base/assert.h"
#include "fx/fx.h"
#include "scene/clock.h"

#define ONE_Q40   ((int64_t)1 << 40)
#define SLIDE_Q32 ((int64_t)175279947)      /* 1 - exp(-dt / tau), dt / tau = 1/24 */
#define SNAP_Q40  ((int64_t)2 << 24)        /* 2 LSB of 16.16 */

static int64_t q40(tp_fx x)
{
    return (int64_t)x * (1 << 24);
}

static tp_fx clamp_scale(tp_fx scale)
{
    return tp_clamp(scale, TP_CLOCK_SLOWEST, TP_CLOCK_FASTEST);
}

void tp_clock_init(tp_clock *clock, tp_fx scale)
{
    *clock =
        (tp_clock){ .scale_q40 = q40(clamp_scale(scale)), .target = clamp_scale(scale) };
}

void tp_clock_set_target(tp_clock *clock, tp_fx target)
{
    clock->target = clamp_scale(target);
}

void tp_clock_shift_target(tp_clock *clock, int32_t steps)
{
    tp_fx target = clock->target;

    for (; steps > 0 && target > TP_CLOCK_SLOWEST; steps--)
        target /= 2;
    for (; steps < 0 && target < TP_CLOCK_FASTEST; steps++)
        target *= 2;
    tp_clock_set_target(clock, target);
}

bool tp_clock_is_valid(const tp_clock *clock)
{
    return clock->scale_q40 >= q40(TP_CLOCK_SLOWEST)
        && clock->scale_q40 <= q40(TP_CLOCK_FASTEST)
        && clock->fraction_q40 >= 0 && clock->fraction_q40 < ONE_Q40
        && clock->target == clamp_scale(clock->target) && clock->zero == 0;
}

/* The distance is below 2^42 in Q40 and SLIDE_Q32 is below 2^28.  The distance is shifted
 * to Q28 first, so the product stays below 2^58. */
void tp_clock_advance(tp_clock *clock)
{
    TP_ASSERT(clock->scale_q40 > 0 && clock->fraction_q40 >= 0
              && clock->fraction_q40 < ONE_Q40);
    int64_t way = q40(clock->target) - clock->scale_q40;

    if (way < SNAP_Q40 && way > -SNAP_Q40)
        clock->scale_q40 += way;
    else
        clock->scale_q40 += (((way + (1 << 11)) >> 12) * SLIDE_Q32 + (1 << 19)) >> 20;
    clock->fraction_q40 += clock->scale_q40;
    clock->ticks += (uint64_t)(clock->fraction_q40 >> 40);
    clock->fraction_q40 &= ONE_Q40 - 1;
}

tp_fx tp_clock_scale(const tp_clock *clock)
{
    return (tp_fx)((clock->scale_q40 + (1 << 23)) >> 24);
}

uint64_t tp_clock_ticks(const tp_clock *clock)
{
    return clock->ticks;
}

tp_fx tp_clock_fraction(const tp_clock *clock)
{
    return (tp_fx)(clock->fraction_q40 >> 24);
}
