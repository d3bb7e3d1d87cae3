/* SPDX-License-Identifier: MIT */
/* Collects times of the last pictures.  The graph shows all of them.  The parts are means
 * over the last second: means add up to the total, medians do not. */
#include "performance.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/scene/stopwatch.h"

enum { WINDOW = 60, ANSWERS = 15, TEXT_BYTES = 2048 };

#define STAGES_US 250000u       /* us between readings of the stopwatch */
#define SECOND_US 1000000u

/* Times of one picture, us. */
typedef struct {
    uint32_t all, part[PERFORMANCE_PARTS];
} times;

struct performance {
    times    now;               /* picture in progress */
    times    last[PANEL_HISTORY];       /* computed picture n is at n % PANEL_HISTORY */
    uint32_t pictures;          /* number of computed pictures */
    uint64_t shown_at[PANEL_HISTORY];   /* time when displayed picture n reached the
                                         * display, us; at n % PANEL_HISTORY */
    uint32_t shown;             /* number of displayed pictures */
    uint64_t pressed_at;        /* time of the first input since the last displayed
                                 * picture, us; 0: none */
    uint32_t answer[ANSWERS];   /* us from an input to its picture; a ring */
    uint32_t answers;           /* number of inputs answered */
    float    limit_ms;
    bool     measures;
    uint64_t stages_at;         /* time when the stopwatch was zeroed */
    uint32_t stages_from;       /* value of `pictures` at that time */
    panel_time stage[PANEL_TIMES];
    uint32_t stage_count;
    char     text[PERFORMANCE_TEXTS][TEXT_BYTES];
};

static const char *const part_name[PERFORMANCE_PARTS] = {
    [PERFORMANCE_WORLD] = "water moves", [PERFORMANCE_GEOMETRY] = "geometry",
    [PERFORMANCE_PIXELS] = "pixels",     [PERFORMANCE_COMPARE] = "the other picture",
    [PERFORMANCE_UPLOAD] = "upload",     [PERFORMANCE_PANEL] = "panel",
    [PERFORMANCE_PRESENT] = "present",
};

performance *performance_begin(void)
{
    performance *f = calloc(1, sizeof *f);

    if (f)
        f->limit_ms = 1000.0f / 60;
    return f;
}

void performance_end(performance *f)
{
    free(f);
}

/* -- collecting ---------------------------------------------------------------------- */

static uint32_t held(uint64_t us)
{
    return us < UINT32_MAX ? (uint32_t)us : UINT32_MAX;
}

void performance_add_time(performance *f, performance_part part, uint64_t us)
{
    f->now.part[part] = held(f->now.part[part] + us);
}

void performance_end_picture(performance *f, uint64_t us)
{
    f->now.all = held(us);
    f->last[f->pictures++ % PANEL_HISTORY] = f->now;
    f->now = (times){ 0 };
}

void performance_note_input(performance *f, uint64_t now)
{
    if (!f->pressed_at)
        f->pressed_at = now;
}

void performance_note_shown(performance *f, uint64_t now)
{
    f->shown_at[f->shown++ % PANEL_HISTORY] = now;
    if (f->pressed_at)
        f->answer[f->answers++ % ANSWERS] = held(now - f->pressed_at);
    f->pressed_at = 0;
}

void performance_set_limit(performance *f, float ms)
{
    f->limit_ms = ms;
}

void performance_set_stopwatch(performance *f, bool on)
{
    f->measures = on;
    f->stage_count = 0;
    f->stages_at = 0;
}

void performance_set_text(performance *f, performance_text which, const char *text)
{
    snprintf(f->text[which], sizeof f->text[which], "%s", text);
}

/* -- evaluation ---------------------------------------------------------------------- */

static int by_size(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* Returns the median of n <= WINDOW times, ms; 0 if n = 0. */
static float median_ms(uint32_t *us, uint32_t n)
{
    qsort(us, n, sizeof *us, by_size);
    return n ? (float)(us[(n - 1) / 2] / 2.0 + us[n / 2] / 2.0) / 1000 : 0;
}

/* Returns the k-th last picture, k >= 1. */
static const times *recent_times(const performance *f, uint32_t k)
{
    return &f->last[(f->pictures - k) % PANEL_HISTORY];
}

static void fill_history(const performance *f, panel_performance *to)
{
    const uint32_t n = f->pictures < PANEL_HISTORY ? f->pictures : PANEL_HISTORY;
    uint32_t us[WINDOW];
    uint32_t count = 0;

    memset(to->history, 0, sizeof to->history);
    for (uint32_t k = 1; k <= n; k++) {
        to->history[PANEL_HISTORY - k] = (float)recent_times(f, k)->all / 1000;
        if (count < WINDOW)
            us[count++] = recent_times(f, k)->all;
    }
    to->pictures = f->pictures;
    to->median_ms = median_ms(us, count);
}

static void add_time(panel_time *list, uint32_t *count, const char *name, double mean,
                     double all)
{
    if (mean > 0 && *count < PANEL_TIMES)
        list[(*count)++] = (panel_time){ name, (float)mean,
                                         (float)(all > 0 ? mean / all : 0) };
}

/* Lists the parts with a mean above 0. */
static void fill_parts(const performance *f, panel_performance *to)
{
    const uint32_t n = f->pictures < WINDOW ? f->pictures : WINDOW;
    double part[PERFORMANCE_PARTS] = { 0 }, all = 0, sum = 0;

    to->part_count = 0;
    for (uint32_t k = 1; k <= n; k++) {
        all += (double)recent_times(f, k)->all / n;
        for (int i = 0; i < PERFORMANCE_PARTS; i++)
            part[i] += (double)recent_times(f, k)->part[i] / n;
    }
    for (int i = 0; i < PERFORMANCE_PARTS; i++)
        sum += part[i];
    if (all < sum)
        all = sum;
    for (int i = 0; i < PERFORMANCE_PARTS; i++)
        add_time(to->parts, &to->part_count, part_name[i], part[i], all);
    add_time(to->parts, &to->part_count, "the rest", all - sum, all);
}

/* Returns the pictures per second, from the first to the last picture of the last second; 0
 * if no picture was shown. */
static float measure_frame_rate(const performance *f, uint64_t now)
{
    const uint32_t n = f->shown < PANEL_HISTORY ? f->shown : PANEL_HISTORY;
    const uint64_t last = n ? f->shown_at[(f->shown - 1) % PANEL_HISTORY] : 0;
    uint64_t first = last;
    uint32_t count = 0;

    for (uint32_t k = 1; k <= n; k++) {
        const uint64_t at = f->shown_at[(f->shown - k) % PANEL_HISTORY];
        if (at + SECOND_US < now)
            break;
        first = at;
        count++;
    }
    return last > first ? (float)((count - 1) * 1e6 / (double)(last - first)) : 0;
}

static int dearest(const void *a, const void *b)
{
    const float x = ((const panel_time *)a)->mean, y = ((const panel_time *)b)->mean;
    return (x < y) - (x > y);
}

/* Reads the stopwatch.  There are more stages than PANEL_TIMES, but no scene runs that
 * many. */
static void read_stages(performance *f, uint64_t now)
{
    const double pictures = f->pictures - f->stages_from;
    double sum = 0;

    if (pictures > 0 && f->stages_at) {
        f->stage_count = 0;
        for (uint32_t i = 0; i < stopwatch_stages; i++)
            sum += (double)stopwatch_ns(i);
        for (uint32_t i = 0; i < stopwatch_stages; i++)
            add_time(f->stage, &f->stage_count, stopwatch_name[i],
                     (double)stopwatch_ns(i) / 1000 / pictures, sum / 1000 / pictures);
        qsort(f->stage, f->stage_count, sizeof *f->stage, dearest);
    }
    stopwatch_zero();
    f->stages_at = now;
    f->stages_from = f->pictures;
}

void performance_fill(performance *f, uint64_t now, panel_performance *to)
{
    uint32_t us[ANSWERS];
    const uint32_t n = f->answers < ANSWERS ? f->answers : ANSWERS;

    fill_history(f, to);
    fill_parts(f, to);
    memcpy(us, f->answer, sizeof us);
    to->latency_ms = median_ms(us, n);
    to->limit_ms = f->limit_ms;
    to->shown_per_s = measure_frame_rate(f, now);
    if (f->measures && (!f->stages_at || now - f->stages_at >= STAGES_US))
        read_stages(f, now);
    memcpy(to->stages, f->stage, sizeof to->stages);
    to->stage_count = f->stage_count;
    to->ram = f->text[PERFORMANCE_RAM];
    to->plan = f->text[PERFORMANCE_PLAN];
    to->state = f->text[PERFORMANCE_STATE];
}
