/* SPDX-License-Identifier: MIT */
/* Prints the benchmark's figures as a text table or as CSV. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include "bench.h"

/* middle_us: median of the rounds' medians; spread_us: largest minus smallest of them. */
static uint32_t middle_us(const bench_figure *f)
{
    const uint32_t a = f->us[0], b = f->us[1], c = f->us[2];
    const uint32_t low = a < b ? a : b, high = a < b ? b : a;
    return c < low ? low : c > high ? high : c;
}

static uint32_t spread_us(const bench_figure *f)
{
    uint32_t low = f->us[0], high = f->us[0];
    for (int i = 1; i < BENCH_ROUNDS; i++) {
        low = f->us[i] < low ? f->us[i] : low;
        high = f->us[i] > high ? f->us[i] : high;
    }
    return high - low;
}

static void print_decibels(const bench_figure *f)
{
    if (f->decibels < 0)
        printf("       -");
    else if (isinf(f->decibels))
        printf("    same");
    else
        printf("%8.1f", f->decibels);
}

static void print_row(const bench_figure *f, const bench_figure *first)
{
    const double ms = middle_us(f) / 1000.0;
    char size[16];
    snprintf(size, sizeof size, "%ux%u", (unsigned)f->width, (unsigned)f->height);
    printf("%-8s %6u %-7s %-24s", size, (unsigned)f->points, bench_work_name[f->work],
           f->by);
    if (!middle_us(f)) {
        printf("  failed\n");
        return;
    }
    printf("%9.3f %5.0f %%%9.1f", ms, 100.0 * spread_us(f) / middle_us(f),
           f->water ? 1e6 * ms / f->water : 0);
    printf("%8.2f", middle_us(first) ? (double)middle_us(f) / middle_us(first) : 0);
    print_decibels(f);
    putchar('\n');
}

static void print_csv_row(const bench_figure *f)
{
    printf("%u,%u,%u,%s,%s,%.3f,%.3f,%" PRIu32 ",", (unsigned)f->width,
           (unsigned)f->height, (unsigned)f->points, bench_work_name[f->work], f->by,
           middle_us(f) / 1000.0, spread_us(f) / 1000.0, f->water);
    if (f->decibels < 0)
        printf("\n");
    else
        printf("%.2f\n", f->decibels);
}

void bench_print(const bench_list *list, bool csv)
{
    const bench_figure *first = NULL;
    if (csv) {
        printf("width,height,points,work,by,ms,spread_ms,water_pixels,psnr_db\n");
    } else {
        printf("Scene S, whole frames, one thread, processor time: median of %d rounds of"
               " %" PRIu32 " frames.\n", BENCH_ROUNDS, list->frames);
        printf("%-8s %6s %-7s %-24s%9s%8s%9s%8s%8s\n", "size", "points", "work", "by",
               "ms", "spread", "ns/px", "ratio", "dB");
    }
    for (size_t i = 0; i < list->count; i++) {
        const bench_figure *f = &list->of[i];
        if (!first || !bench_same_case(first, f))
            first = f;
        if (csv)
            print_csv_row(f);
        else
            print_row(f, first);
    }
}
