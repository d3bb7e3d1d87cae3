/* SPDX-License-Identifier: MIT */
/* Times of frames: their median, and a progress line for what takes long. */
#ifndef HOST_TIMING_H
#define HOST_TIMING_H
#include <stddef.h>
#include <stdint.h>

uint64_t now_us(void);          /* a clock that never goes back */
uint64_t processor_us(void);    /* of all threads of this program: other work is not in */

typedef struct {
    uint32_t *us;
    size_t    count, room;
} timings;

void     timings_add(timings *t, uint64_t us);  /* without memory: left out */
uint32_t timings_median(timings *t);            /* us; sorts; 0 of none */
void     timings_free(timings *t);

typedef struct {
    uint64_t begin, shown;      /* us */
} progress;

progress progress_begin(void);
/* `done` of `total` frames: a line on the terminal four times a second, once two
 * seconds have passed; or of figures, and which comes now. */
void     progress_show(progress *p, uint32_t done, uint32_t total);
void     progress_figure(progress *p, uint32_t done, uint32_t total, const char *what,
                         const char *by);
/* The same as a bar, of what several do at once. */
void     progress_jobs(progress *p, uint32_t done, uint32_t total, const char *what);
#endif
