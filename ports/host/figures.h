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
    float       history[PANEL_HISTORY];     /* ms a picture, the newest last, and 0 before
                                               the first */
    uint32_t    pictures;                   /* so far */
    float       limit_ms;                   /* a line in the graph: 1000/60 */
    float       median_ms, shown_per_s;
    float       latency_ms;                 /* from the last inputs to their pictures */
    panel_time  parts[PANEL_TIMES];         /* of a picture, from world to window, and the
                                               rest: together its mean time */
    uint32_t    part_count;
    panel_time  stages[PANEL_TIMES];        /* of its pixels, dearest first; of all threads
                                               together */
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

/* -- as they are collected ----------------------------------------------------------- */

typedef enum {
    FIGURE_WORLD, FIGURE_GEOMETRY, FIGURE_PIXELS, FIGURE_COMPARE, FIGURE_UPLOAD,
    FIGURE_PANEL, FIGURE_PRESENT, FIGURE_PARTS
} figure_part;

typedef enum { FIGURE_RAM, FIGURE_PLAN, FIGURE_STATE, FIGURE_TEXTS } figure_text;

typedef struct figures figures;

figures *figures_begin(void);                   /* NULL: no memory */
void     figures_end(figures *f);

/* Times of the picture that is being made, us; what is told twice adds up.  Then it is
 * made, and took `us` in all, from world to window: what the graph shows. */
void figures_part(figures *f, figure_part part, uint64_t us);
void figures_picture(figures *f, uint64_t us);

/* Something was pressed at `now`, us of now_us(); a picture that was begun after it is on
 * the display.  Of several inputs before one picture the first counts. */
void figures_input(figures *f, uint64_t now);
void figures_shown(figures *f, uint64_t now);

void figures_limit(figures *f, float ms);       /* the graph's line; 1000/60 at first */

/* `on`: the canvas's program has the stopwatch (stopwatch.h), which this reads and zeroes. */
void figures_measures(figures *f, bool on);

/* Up to 2047 bytes, copied; more are cut. */
void figures_say(figures *f, figure_text which, const char *text);

/* All of it; texts are f's, and stay until it ends.  Times of stages are those of the
 * last quarter of a second. */
void figures_fill(figures *f, uint64_t now, panel_figures *to);

#ifdef __cplusplus
}
#endif
#endif
