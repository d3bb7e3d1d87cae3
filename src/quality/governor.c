/* SPDX-License-Identifier: MIT */
/* The governor of the frame time compares windows of frames with the limit; a single late
 * frame has no effect.
 *
 * A step up is predicted, not tried.  The mean frame times before and after a step down
 * give the cost ratio of both rungs on this machine and scene.  The current mean times
 * this ratio predicts the frame time on the rung above.  Under a constant load the
 * prediction stays above the limit, so the governor stays on its rung and does not
 * oscillate. */
#include <stdbool.h>
#include "base/base.h"
#include "quality/plan.h"

#define WINDOW 8                /* frames per window */
#define CALM   8                /* consecutive windows with room before a step up */
#define SETTLE 2                /* frames ignored after a step */

void tp_governor_init(tp_governor *governor, const tp_ladder *ladder, uint32_t limit)
{
    *governor = (tp_governor){ .ladder = *ladder, .limit = limit };
}

tp_rungs tp_governor_rungs(const tp_governor *governor)
{
    TP_ASSERT(governor->at < governor->ladder.count);
    return governor->ladder.rung[governor->at];
}

tp_rung_mask tp_ladder_rung_mask(const tp_ladder *ladder)
{
    TP_ASSERT(ladder->count <= TP_LADDER);
    tp_rung_mask reach = { 1 << TP_VISIBILITY_TRIANGLES, 1 << TP_SHADING_EXACT,
                           1 << TP_RATE_FULL };

    for (uint32_t i = 0; i < ladder->count; i++) {
        reach.visibility |= (uint8_t)(1u << ladder->rung[i].visibility);
        reach.shading |= (uint8_t)(1u << ladder->rung[i].shading);
        reach.rate |= (uint8_t)(1u << ladder->rung[i].rate);
    }
    return reach;
}

/* Moves `steps` down the ladder, up if negative, and waits for the times to settle.
 * Returns `steps`. */
static int move_on_ladder(tp_governor *g, int steps)
{
    g->at += (uint32_t)steps;
    g->settling = SETTLE;
    g->calm = 0;
    return steps;
}

/* True if the predicted time on the rung above leaves 1/8 of the limit free.  Times are
 * below 2^32, so the product fits 64 bits.  The prediction is limited to four times the
 * current mean: if the load fell during the step down, the measured ratio is too high and
 * must not prevent a step up for ever. */
static bool can_raise_rung(const tp_governor *g)
{
    TP_ASSERT(g->at > 0 && g->after[g->at] > 0);
    const uint64_t most = 4 * (uint64_t)g->mean;
    const uint64_t above = (uint64_t)g->mean * g->before[g->at] / g->after[g->at];

    return (above < most ? above : most) <= g->limit - g->limit / 8;
}

/* Processes a full window.  The first window on a rung measures the result of the step
 * down to that rung. */
static int evaluate_window(tp_governor *g)
{
    if (g->at > 0 && g->after[g->at] == 0)
        g->after[g->at] = g->mean > 0 ? g->mean : 1;
    if (g->mean > g->limit) {
        g->calm = 0;
        if (g->at + 1 >= g->ladder.count)
            return 0;
        g->before[g->at + 1] = g->mean;
        g->after[g->at + 1] = 0;
        return move_on_ladder(g, 1);
    }
    g->calm = g->at > 0 && can_raise_rung(g) ? g->calm + 1 : 0;
    return g->calm >= CALM ? move_on_ladder(g, -1) : 0;
}

int tp_governor_add_frame_time(tp_governor *g, uint32_t took)
{
    if (g->limit == 0 || g->ladder.count < 2)
        return 0;
    if (g->settling > 0) {
        g->settling--;
        return 0;
    }
    g->sum += took;
    if (++g->frames < WINDOW)
        return 0;
    g->mean = (uint32_t)(g->sum / WINDOW);
    g->sum = 0;
    g->frames = 0;
    return evaluate_window(g);
}
