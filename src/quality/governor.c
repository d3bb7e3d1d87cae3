/* SPDX-License-Identifier: MIT */
/* The governor of the frame time compares windows of frames with the limit; a single late
 * frame has no effect.
 *
 * A step up is predicted.  The estimated costs of two steps, or the mean frame times before
 * and after a step down by one, give the ratio of their times.  The current mean times this
 * ratio predicts the frame time of the step above.  An estimate may lead to a step that is
 * too slow; the step back measures the ratio, and the prediction stays above the limit:
 * under a constant load the governor comes to rest. */
#include <stdbool.h>
#include "base/base.h"
#include "quality/plan.h"

#define WINDOW 8                /* frames per window */
#define CALM   8                /* consecutive windows with room before a step up */
#define SETTLE 2                /* frames ignored after a step */

void tp_governor_init(tp_governor *governor, const tp_set_walk *walk, uint32_t limit)
{
    TP_ASSERT(walk->count > 0 && walk->count <= TP_SET_STEPS);
    *governor = (tp_governor){ .limit = limit, .steps = walk->count };
    for (uint32_t i = 0; i < walk->count; i++)
        governor->cost[i] = walk->price[i].cost;
}

/* Moves `steps` down the walk, up if negative, and waits for the times to settle.  Returns
 * `steps`. */
static int move_on_walk(tp_governor *g, int steps)
{
    g->at += (uint32_t)steps;
    g->settling = SETTLE;
    g->calm = 0;
    return steps;
}

/* Returns the predicted time of the step above: by the times around the last step down, if
 * it was a step by one, else by the estimated costs.  Times are below 2^32 and costs below 2^40;
 * costs are divided by 2^16.  The prediction is limited to four times the current mean: if
 * the load fell during the step down, the measured ratio is too high and must not prevent a
 * step up for ever. */
static uint64_t predict_raised_time(const tp_governor *g)
{
    TP_ASSERT(g->at > 0);
    const uint64_t most = 4 * (uint64_t)g->mean;
    const bool measured = g->before[g->at] > 0 && g->after[g->at] > 0;
    const uint64_t from = measured ? g->after[g->at] : (g->cost[g->at] >> 16) + 1;
    const uint64_t to = measured ? g->before[g->at] : (g->cost[g->at - 1] >> 16) + 1;
    const uint64_t above = (uint64_t)g->mean * to / from;

    return above < most ? above : most;
}

/* True if the predicted time leaves 1/8 of the limit free. */
static bool can_raise(const tp_governor *g)
{
    return predict_raised_time(g) <= g->limit - g->limit / 8;
}

/* Returns the number of steps to the first one whose cost suggests a time within the
 * limit, at least 1.  It is 1 if the time is up to 1/8 over the limit: noise of a load on the
 * limit may be the cause, and the times around a step by one are measured. */
static uint32_t count_lowered_steps(const tp_governor *g)
{
    const uint64_t here = g->cost[g->at] >> 16;
    uint32_t steps = 1;

    if (g->mean <= g->limit + g->limit / 8)
        return 1;
    while (g->at + steps + 1 < g->steps
           && (g->cost[g->at + steps] >> 16) * g->mean > here * g->limit)
        steps++;
    return steps;
}

/* Steps down: by one to the step from which the governor came, else by the estimates.  The
 * times around a step by one are the ratio of both. */
static int lower(tp_governor *g)
{
    const uint32_t steps = g->raised ? 1 : count_lowered_steps(g);

    g->before[g->at + steps] = steps == 1 ? g->mean : 0;
    g->after[g->at + steps] = 0;
    g->raised = false;
    return move_on_walk(g, (int)steps);
}

/* Processes a full window.  The first one of a step measures the result of a step down. */
static int evaluate_window(tp_governor *g)
{
    if (g->at > 0 && g->after[g->at] == 0)
        g->after[g->at] = g->mean > 0 ? g->mean : 1;
    if (g->mean > g->limit) {
        g->calm = 0;
        return g->at + 1 < g->steps ? lower(g) : 0;
    }
    g->calm = g->at > 0 && can_raise(g) ? g->calm + 1 : 0;
    if (g->calm < CALM)
        return 0;
    g->raised = true;
    return move_on_walk(g, -1);
}

int tp_governor_add_frame_time(tp_governor *g, uint32_t took)
{
    if (g->limit == 0 || g->steps < 2)
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
