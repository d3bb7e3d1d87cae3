/* SPDX-License-Identifier: MIT */
/* What the preview's instruments show: times of the last pictures, by part and by stage,
 * from input to picture, memory, the plan of this moment.
 *
 * No type of the core's is named here: the panel is C++, which the core's headers are not
 * written for.  What texts say of a stage comes from figures_texts.h. */
#ifndef HOST_FIGURES_H
#define HOST_FIGURES_H
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* -- as they are shown --------------------------------------------------------------- */

/* A time of the last pictures, us. */
typedef struct {
    const char *name;           /* "water moves", "pixels" ... */
    float       mean, share;    /* us a picture; 0..1 of all */
} panel_time;

#define PANEL_HISTORY 240       /* pictures */
#define PANEL_TIMES   64

typedef struct {
    float       history[PANEL_HISTORY];     /* ms a picture, oldest first */
    uint32_t    pictures;                   /* of them, so far: up to PANEL_HISTORY */
    float       limit_ms;                   /* a line in the graph: 1000/60 */
    float       median_ms, shown_per_s;
    float       latency_ms;                 /* from the last inputs to their pictures */
    panel_time  parts[PANEL_TIMES];         /* of a picture, from world to window */
    uint32_t    part_count;
    panel_time  stages[PANEL_TIMES];        /* of its pixels, dearest first */
    uint32_t    stage_count;                /* 0: not measured now */
    const char *ram;                        /* lines, parted by \n: use, tab, bytes */
    const char *plan;                       /* lines: kind, tab, rung, tab, why ... */
    const char *state;                      /* one line: tick, clock, camera, tape, film */
} panel_figures;

typedef struct {
    const char *off;            /* "off", "split", "difference" */
    const char *against;        /* "exact", "rows" ... "reference" */
    double      psnr;           /* dB; above 99: the same bits; < 0: none yet */
    const char *note;           /* "the reference draws: 40%"; "" */
} panel_compare;

#ifdef __cplusplus
}
#endif
#endif
