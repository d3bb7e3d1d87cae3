/* SPDX-License-Identifier: MIT */
/* The quality plan: chooses the rungs for drawing a scene.  The plan is a pure function
 * of scene, assets, picture size and error budget.  It uses integers only, and costs in
 * Cortex-M4 instructions on every machine, so all machines draw the same bits.
 *
 * The plan looks at all kinds of rungs together (quality/rung_sets.h).  It changes no row
 * that a scene names.  A frame draws a row that is left open (`auto`) with the exact rung,
 * so the caller plans first:
 *
 *     tp_scene drawn = scene;
 *     const tp_plan plan = tp_plan_make(&drawn, &assets, width, height);
 *     tp_rung_set_apply_some(&drawn, &plan.set, plan.open);
 *     tp_frame_init(&frame, &config, &drawn, ...);
 */
#ifndef TP_QUALITY_PLAN_H
#define TP_QUALITY_PLAN_H
#include <stdbool.h>
#include <stdint.h>
#include "quality/rung_sets.h"
#include "tidepool/assets.h"
#include "tidepool/scene.h"

/* Range of a picture's width and height, px. */
#define TP_PICTURE_SIDE_MIN 16
#define TP_PICTURE_SIDE_MAX 4096

typedef struct {
    tp_rung_set  set;           /* the rungs of the picture */
    tp_set_price price;         /* of the picture, by estimate */
    uint32_t     open;          /* bits of the kinds that the plan chose */
} tp_plan;

/* Returns the cheapest set of rungs with an error within quality.error_colour, the rms of
 * 255 levels beyond the exact picture.  Errors of rungs that the scene names count too; if
 * they exceed the budget alone, the plan adds no more.  quality.mesh stays as it is: it
 * belongs to the assets.
 *
 * Checks the scene (tp_scene_check) and the picture's size; if either is refused, returns
 * the exact set with a price of 0.  NULL assets: none. */
tp_plan tp_plan_make(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                     uint32_t height);

/* Sets *view to the costs of a scene's view, by the measured prices, for all modules.
 * Returns false, and zeros, where tp_plan_make refuses. */
bool tp_plan_view(tp_view_costs *view, const tp_scene *scene, const tp_assets *assets,
                  uint32_t width, uint32_t height);

/* -- the governor -------------------------------------------------------------------- */

/* Controls the frame time: steps down a walk of sets (tp_set_walk_make) if frames take too
 * long, and up again if there is room.  The port owns the clock: it passes the duration of
 * each frame, in any unit, and draws with the set of the step.  Pictures then depend on the
 * clock.  With a limit of 0, or a walk of a single set, the governor does nothing. */
typedef struct {
    uint32_t limit;             /* time limit of a frame, in the port's unit; 0: off */
    uint32_t steps;             /* number of sets of the walk */
    uint32_t at;                /* current step */
    uint32_t mean;              /* mean time of the last window of frames */
    uint64_t cost[TP_SET_STEPS];        /* of each step, by estimate */
    uint64_t sum;               /* private from here on; sum of frame times */
    uint32_t frames, settling, calm;
    bool     raised;            /* the last move was a step up */
    uint32_t before[TP_SET_STEPS], after[TP_SET_STEPS]; /* mean times around a step down */
} tp_governor;

void tp_governor_init(tp_governor *governor, const tp_set_walk *walk, uint32_t limit);

/* Takes the time of the last frame.  Returns the number of steps down the walk, negative
 * for a step up, 0 for none.  Steps down if the mean of 8 frames is above the limit, to the
 * first set whose estimated cost suggests a time within it.  Steps up by one if for 64
 * frames the predicted time leaves an eighth of the limit free; the prediction uses the
 * time ratio of the last step down by one, or else the estimated costs.  Under a constant
 * load the governor comes to rest. */
int tp_governor_add_frame_time(tp_governor *governor, uint32_t took);
#endif
