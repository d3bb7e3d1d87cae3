/* SPDX-License-Identifier: MIT */
/* The figures of the preview's instruments: times of the last pictures, by part and by
 * stage, latency from input to picture, memory, the current plan.
 *
 * The header uses no type of the core: the panel is C++, and the core's headers are C only.
 * performance_texts.h makes the texts about a loaded scene. */
#ifndef TP_APP_SESSION_PERFORMANCE_H
#define TP_APP_SESSION_PERFORMANCE_H
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* -- figures as displayed ------------------------------------------------------------ */

/* A mean time over the last pictures. */
typedef struct {
    const char *name;           /* "water moves", "pixels" ... */
    float       mean, share;    /* us per picture; fraction of the total, 0..1 */
} panel_time;

#define PANEL_HISTORY 240       /* pictures */
#define PANEL_TIMES   64

typedef struct {
    float       history[PANEL_HISTORY];     /* ms, newest last; 0: none yet */
    uint32_t    pictures;                   /* number of pictures until now */
    float       limit_ms;                   /* line in the graph: 1000/60 */
    float       median_ms, shown_per_s;
    float       latency_ms;                 /* from the last inputs to their pictures */
    panel_time  parts[PANEL_TIMES];         /* parts of a picture, from world to window, and
                                             * the rest; their sum is the mean time */
    uint32_t    part_count;
    panel_time  stages[PANEL_TIMES];        /* stages of the pixels, most expensive first;
                                             * sum of all threads */
    uint32_t    stage_count;                /* 0: not measured */
    const char *ram;                        /* lines, separated by \n: use, tab, bytes */
    const char *plan;                       /* lines: kind, tab, rung, tab, reason ... */
    const char *state;                      /* one line: tick, clock, camera, tape, film */
} panel_performance;

typedef struct {
    const char *off;            /* "off", "split", "difference" */
    const char *against;        /* "exact", "rows" ... "reference" */
    double      psnr;           /* dB; above 99: the same bits; < 0: none yet */
    const char *note;           /* "the reference draws: 40%"; "" */
} panel_compare;

/* -- collecting ---------------------------------------------------------------------- */

typedef enum {
    PERFORMANCE_WORLD,
    PERFORMANCE_GEOMETRY,
    PERFORMANCE_PIXELS,
    PERFORMANCE_COMPARE,
    PERFORMANCE_UPLOAD,
    PERFORMANCE_PANEL,
    PERFORMANCE_PRESENT,
    PERFORMANCE_PARTS
} performance_part;

typedef enum {
    PERFORMANCE_RAM,
    PERFORMANCE_PLAN,
    PERFORMANCE_STATE,
    PERFORMANCE_TEXTS
} performance_text;

typedef struct performance performance;

performance *performance_begin(void);                   /* NULL: no memory */
void     performance_end(performance *f);

/* performance_add_time adds the time of a part of the picture in progress, us;
 * repeated calls add up.  performance_end_picture ends the picture; us: its total time
 * from world to window, for the graph. */
void performance_add_time(performance *f, performance_part part, uint64_t us);
void performance_end_picture(performance *f, uint64_t us);

/* performance_note_input: an input at `now`, us of now_us().  performance_note_shown:
 * a picture begun after the input is on the display.  Of several inputs before a
 * picture the first counts. */
void performance_note_input(performance *f, uint64_t now);
void performance_note_shown(performance *f, uint64_t now);

void performance_set_limit(performance *f, float ms);       /* ms; initially 1000/60 */

/* on: the frame renderer's program has the stopwatch (stopwatch.h); performance_fill reads
 * and zeroes it. */
void performance_set_stopwatch(performance *f, bool on);

/* Copies a text of up to 2047 bytes; a longer text is cut. */
void performance_set_text(performance *f, performance_text which, const char *text);

/* Fills in all figures; their texts are owned by f and valid until performance_end.
 * Times of stages cover the last quarter of a second. */
void performance_fill(performance *f, uint64_t now, panel_performance *to);

#ifdef __cplusplus
}
#endif
#endif
