/* SPDX-License-Identifier: MIT */
/* The plan: by which methods a scene is drawn.  A pure function of scene, picture size
 * and the scene's error budget, in integers, priced in Cortex-M4 instructions on every
 * machine: so every machine draws the same bits.
 *
 * A rung is one method of a kind, cheaper or closer to the truth than its neighbours. */
#ifndef TP_SCENE_PLAN_H
#define TP_SCENE_PLAN_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/assets.h"
#include "tidepool/scene.h"

typedef struct {
    tp_visibility visibility;   /* never AUTO, and so the others */
    tp_shading    shading;
    tp_rate       rate;
    tp_lod        lod;
} tp_rungs;

/* Pixels of a picture's side. */
#define TP_PICTURE_SIDE_MIN 16
#define TP_PICTURE_SIDE_MAX 4096

/* The functions below that take a scene check it (tp_scene_check) and the picture's size.
 * If one of them is refused, the exact rungs come back, in a report of zeros.  NULL assets
 * are none. */

/* The cheapest rungs whose errors together stay within quality.error_px and
 * quality.error_colour.  What quality.* names is taken whatever its error, and the rest
 * chosen with what it leaves of the budget.  Rungs without a price are never chosen. */
tp_rungs tp_rungs_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                     uint32_t height);

/* -- what was chosen, and why -------------------------------------------------------- */

#define TP_KINDS 4              /* visibility, shading, rate, lod */
#define TP_KIND_RUNGS 4         /* at the most */

typedef struct {
    uint64_t cost;              /* instructions of a Cortex-M4, a frame */
    tp_fx    error_px;          /* px of outlines, and ... */
    tp_fx    error_colour;      /* ... rms of 255, beyond the exact rungs' */
    bool     known;             /* it has been measured */
} tp_price;

typedef enum {
    TP_WHY_CHOSEN,              /* the cheapest within the budget */
    TP_WHY_NAMED,               /* by the scene */
    TP_WHY_OTHER_NAMED,
    TP_WHY_ERROR,               /* beyond the budget, alone or with the others */
    TP_WHY_COST,                /* dearer */
    TP_WHY_UNKNOWN,             /* not measured */
    TP_WHY_UNFIT                /* it is drawn by the exact one: the camera, or
                                   what the scene has, is none for it */
} tp_why;

/* A rung put in place of the chosen one, the other kinds' as chosen. */
typedef struct {
    tp_price price;             /* cost: of the whole frame; errors: of this rung */
    tp_why   why;
} tp_rung_report;

typedef struct {
    tp_rungs rungs;
    tp_price total;
    uint32_t water_pixels, vertices, waves;     /* as estimated, waves as drawn */
    uint32_t waves_dropped;
    tp_fx    waves_px, waves_colour;            /* errors that dropping waves adds */
    tp_rung_report rung[TP_KINDS][TP_KIND_RUNGS];   /* [kind][rung - 1] */
    uint8_t  rung_count[TP_KINDS];
} tp_plan_report;

tp_plan_report tp_plan_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                          uint32_t height);

/* -- the ladder and the governor ----------------------------------------------------- */

#define TP_LADDER 8             /* the plan's own, and a step for every cheaper rung */

/* The plan's rungs, then ever cheaper ones: each step is one rung of one kind, that which
 * adds the least error for the cost that it saves.  With quality.frame_ms = 0 the plan's
 * own alone.  A frame has memory for all of its ladder. */
typedef struct {
    tp_rungs rung[TP_LADDER];
    uint32_t count;             /* from 1 */
} tp_ladder;

tp_ladder tp_ladder_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                       uint32_t height);

/* Rungs of each kind as bits, 1 << rung: the exact ones, and all of a ladder.  By others
 * a frame is not drawn, as it has no memory for them. */
typedef struct {
    uint8_t visibility, shading, rate, lod;
} tp_reach;

tp_reach tp_reach_of(const tp_ladder *ladder);

/* Holds a frame's time by stepping down the ladder, and up again when there is room.  The
 * port owns the clock: it feeds in what each frame took, in any unit, and hands the rungs
 * to tp_frame_set_rungs.  Pictures then depend on the clock; with a limit of 0, or of one
 * rung, nothing ever happens. */
typedef struct {
    tp_ladder ladder;
    uint32_t  limit;            /* 0: off */
    uint32_t  at;               /* rung of the ladder */
    uint32_t  mean;             /* of the last window of frames */
    uint64_t  sum;              /* private, from here */
    uint32_t  frames, settling, calm;
    uint32_t  before[TP_LADDER], after[TP_LADDER];  /* means around a step down */
} tp_governor;

void tp_governor_init(tp_governor *governor, const tp_ladder *ladder, uint32_t limit);

/* The last frame's time.  1: a step down, -1: up, 0: none.  Down when the mean of 8
 * frames is above the limit; up when for 64 frames the rung above would have kept an
 * eighth below it, by what the last step between both changed.  So under a load that
 * stays it steps down and stays there. */
int tp_governor_feed(tp_governor *governor, uint32_t took);

tp_rungs tp_governor_rungs(const tp_governor *governor);
#endif
