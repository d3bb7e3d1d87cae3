/* SPDX-License-Identifier: MIT */
/* Times of frames, their median, and a progress line for long tasks. */
#ifndef TP_APP_FILES_TIMING_H
#define TP_APP_FILES_TIMING_H
#include <stddef.h>
#include <stdint.h>

uint64_t now_us(void);          /* monotonic clock, us */
uint64_t processor_us(void);    /* us of all threads, without other programs */

typedef struct {
    uint32_t *us;
    size_t    count, room;
} timings;

void     timings_add(timings *t, uint64_t us);  /* no memory: time is dropped */
uint32_t timings_median(timings *t);            /* us; sorts the times; 0: none */
void     timings_free(timings *t);

typedef struct {
    uint64_t begin, shown;      /* times, us */
} progress;

progress progress_begin(void);
/* Show a line on the terminal four times a second, after the first two seconds: `done` of
 * `total` frames, or of figures with the name of the current figure. */
void     progress_show(progress *p, uint32_t done, uint32_t total);
void     progress_figure(progress *p, uint32_t done, uint32_t total, const char *what,
                         const char *by);
/* The same with a bar, for parallel jobs. */
void     progress_jobs(progress *p, uint32_t done, uint32_t total, const char *what);
#endif
