/* SPDX-License-Identifier: MIT */
/* The quality plan: chooses the rungs for drawing a scene.  The plan is a pure function
 * of scene, picture size and error budget.  It uses integers only, and costs in Cortex-M4
 * instructions on every machine, so all machines draw the same bits.
 *
 * A rung is one choice of a kind; its neighbours on the ladder are cheaper or more
 * exact. */
#ifndef TP_QUALITY_PLAN_H
#define TP_QUALITY_PLAN_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/assets.h"
#include "tidepool/scene.h"

typedef struct {
    tp_visibility visibility;   /* never AUTO; the same holds for the other members */
    tp_shading    shading;
    tp_rate       rate;
} tp_rungs;

/* Range of a picture's width and height, px. */
#define TP_PICTURE_SIDE_MIN 16
#define TP_PICTURE_SIDE_MAX 4096

/* The functions below check the scene (tp_scene_check) and the picture size.  If either
 * is refused, they return the exact rungs, in a report of zeros.  NULL assets: none. */

/* Returns the cheapest rungs with a total error within quality.error_px and
 * quality.error_colour.  Rungs named in quality.* are taken regardless of their error;
 * the other rungs are chosen with the rest of the budget.  Rungs without a known cost are
 * never chosen. */
tp_rungs tp_rungs_choose(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                         uint32_t height);

/* -- the choice and its reasons ------------------------------------------------------ */

#define TP_KINDS 3              /* visibility, shading, rate */
#define TP_KIND_RUNGS 4         /* most rungs of a kind */

typedef struct {
    uint64_t cost;              /* Cortex-M4 instructions per frame */
    tp_fx    error_px;          /* error of outlines, px, relative to the exact rungs */
    tp_fx    error_colour;      /* colour error, rms of 255, relative to the exact rungs */
    bool     known;             /* true if cost and errors have been measured */
} tp_price;

typedef enum {
    TP_WHY_CHOSEN,              /* the cheapest rung within the budget */
    TP_WHY_NAMED,               /* named by the scene */
    TP_WHY_OTHER_NAMED,
    TP_WHY_ERROR,               /* over the budget, alone or with the other errors */
    TP_WHY_COST,                /* more expensive than the chosen rung */
    TP_WHY_UNKNOWN,             /* not measured */
    TP_WHY_UNFIT                /* drawn by the exact rung instead: the camera or a
                                 * feature of the scene rules this rung out */
} tp_why;

/* Report of a rung: this rung replaces the chosen rung of its kind, the other kinds
 * stay. */
typedef struct {
    tp_price price;             /* cost: of the whole frame; errors: of this rung */
    tp_why   why;
} tp_rung_report;

typedef struct {
    tp_rungs rungs;
    tp_price total;
    uint32_t water_pixels, vertices, waves;     /* estimates; waves: those drawn */
    uint32_t waves_dropped;
    tp_fx    waves_px, waves_colour;            /* added by omitted waves; rms of 255 */
    tp_rung_report rung[TP_KINDS][TP_KIND_RUNGS];   /* indexed [kind][rung - 1] */
    uint8_t  rung_count[TP_KINDS];
} tp_plan_report;

tp_plan_report tp_plan_make(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                            uint32_t height);

/* -- the ladder and the governor ----------------------------------------------------- */

#define TP_LADDER 7             /* rungs of the plan, and a step for every cheaper rung */

/* Step 0 is the planned quality.  Each further step lowers one setting: the setting that
 * adds the least error per instruction saved.  With quality.frame_ms = 0 the ladder has
 * step 0 only.  A frame has memory for all steps of its ladder. */
typedef struct {
    tp_rungs rung[TP_LADDER];
    uint32_t count;             /* number of steps, from 1 */
} tp_ladder;

tp_ladder tp_ladder_make(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                         uint32_t height);

/* Rung masks: a bit 1 << rung for each rung of a kind that a frame may use, the exact
 * rungs and all rungs of its ladder.  A frame has no memory for other rungs and does not
 * draw with them. */
typedef struct {
    uint8_t visibility, shading, rate;
} tp_rung_mask;

tp_rung_mask tp_ladder_rung_mask(const tp_ladder *ladder);

/* Controls the frame time: steps down the ladder if frames take too long, and up again if
 * there is room.  The port owns the clock; it passes the duration of each frame, in any
 * unit, and hands the rungs to tp_frame_set_rungs.  Pictures then depend on the clock.
 * With a limit of 0, or a ladder of a single rung, the governor does nothing. */
typedef struct {
    tp_ladder ladder;
    uint32_t  limit;            /* time limit of a frame, in the port's unit; 0: off */
    uint32_t  at;               /* current step of the ladder */
    uint32_t  mean;             /* mean time of the last window of frames */
    uint64_t  sum;              /* private from here on; sum of frame times */
    uint32_t  frames, settling, calm;
    uint32_t  before[TP_LADDER], after[TP_LADDER];  /* mean times around a step down */
} tp_governor;

void tp_governor_init(tp_governor *governor, const tp_ladder *ladder, uint32_t limit);

/* Takes the time of the last frame.  Returns 1 for a step down, -1 for a step up, 0 for
 * none.  Steps down if the mean of 8 frames is above the limit.  Steps up if for 64
 * frames the predicted time on the rung above leaves an eighth of the limit free; the
 * prediction uses the time ratio of the last step down.  Under a constant load the
 * governor steps down and stays there. */
int tp_governor_add_frame_time(tp_governor *governor, uint32_t took);

tp_rungs tp_governor_rungs(const tp_governor *governor);
#endif
