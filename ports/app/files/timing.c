/* SPDX-License-Identifier: MIT */
/* Clocks, medians, progress. */
#define _POSIX_C_SOURCE 200809L
#include "timing.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "log.h"

#define PATIENCE_US 2000000u
#define REDRAW_US   250000u

static uint64_t clock_us(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (uint64_t)now.tv_sec * 1000000u + (uint64_t)now.tv_nsec / 1000u;
}

uint64_t now_us(void)
{
    return clock_us(CLOCK_MONOTONIC);
}

uint64_t processor_us(void)
{
    return clock_us(CLOCK_PROCESS_CPUTIME_ID);
}

void timings_add(timings *t, uint64_t us)
{
    if (t->count == t->room) {
        const size_t room = t->room ? 2 * t->room : 64;
        uint32_t *more = realloc(t->us, room * sizeof *more);
        if (!more)
            return;
        t->us = more;
        t->room = room;
    }
    t->us[t->count++] = us > UINT32_MAX ? UINT32_MAX : (uint32_t)us;
}

static int by_size(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

uint32_t timings_median(timings *t)
{
    if (!t->count)
        return 0;
    qsort(t->us, t->count, sizeof *t->us, by_size);
    const uint64_t low = t->us[(t->count - 1) / 2], high = t->us[t->count / 2];
    return (uint32_t)((low + high) / 2);
}

void timings_free(timings *t)
{
    free(t->us);
    *t = (timings){ 0 };
}

progress progress_begin(void)
{
    return (progress){ .begin = now_us() };
}

/* True if the progress line is due; *left: remaining time, s. */
static bool is_due(progress *p, uint32_t done, uint32_t total, unsigned *left)
{
    const uint64_t now = now_us(), passed = now - p->begin;
    if (passed < PATIENCE_US || now - p->shown < REDRAW_US)
        return false;
    *left = done ? (unsigned)(passed * (total - done) / done / 1000000u) : 0;
    p->shown = now;
    return true;
}

void progress_show(progress *p, uint32_t done, uint32_t total)
{
    char text[96];
    unsigned left;
    if (!is_due(p, done, total, &left))
        return;
    snprintf(text, sizeof text, "frame %u of %u, %u%%, about %u s left", (unsigned)done,
             (unsigned)total, (unsigned)((uint64_t)done * 100 / total), left);
    log_progress(text);
}

void progress_figure(progress *p, uint32_t done, uint32_t total, const char *what,
                     const char *by)
{
    char text[96];
    unsigned left;
    if (!is_due(p, done, total, &left))
        return;
    snprintf(text, sizeof text, "figure %u of %u: %s by %.24s, about %u s left",
             (unsigned)done + 1, (unsigned)total, what, by, left);
    log_progress(text);
}

void progress_jobs(progress *p, uint32_t done, uint32_t total, const char *what)
{
    static const char full[] = "####################", empty[] = "....................";
    const int width = (int)sizeof full - 1;
    char text[96];
    unsigned left;
    if (!is_due(p, done, total, &left))
        return;
    const int part = (int)((uint64_t)done * (unsigned)width / (total ? total : 1));
    snprintf(text, sizeof text, "[%.*s%.*s] %u of %u %.16s, about %u s left", part, full,
             width - part, empty, (unsigned)done, (unsigned)total, what, left);
    log_progress(text);
}
