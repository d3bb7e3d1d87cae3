/* SPDX-License-Identifier: MIT */
/* The glitter of a scene is the mean of its picture less the mean of its picture without
 * glint, over several ticks.  It is the same at every size of the picture: what smaller
 * pictures cannot show of ripples and waves is variance, which widens the lobe [V1].
 * from-above is left out: its glint has a third of a level. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/reference_difference.h"

enum { SIZES = 4, TICKS = 6, TICK_STEP = 120 };

static const uint32_t widths[SIZES] = { 160, 320, 640, 1280 };

typedef struct {
    const char *name;
    bool        shipped;        /* the scene's own rungs, which are fast; else exact */
    double      spread;         /* bound: largest over smallest glitter, less 1 */
} glitter_row;

/* The bound is 5 %.  Kurtosis of night-sea's ripple slopes is 2.7 to 3.2 in the levels 0 to
 * 5, where a Gaussian distribution has 3. */
static const glitter_row rows[] = {
    { "night-sea", false, 0.05 }, { "deep-sea", false, 0.05 },
    { "count-64", false, 0.05 },   { "count-64", true, 0.05 },
    { "count-100", true, 0.05 },   { "calm-bay", false, 0.05 },
    { "harbour", false, 0.05 },    { "raindrops", false, 0.05 },
};

static double picture_mean(const char *name, bool shipped, uint32_t width,
                           const char *setting, uint32_t tick)
{
    static const char *const exact[] = { "quality.visibility=triangles",
                                         "quality.shading=exact", "quality.rate=full" };
    const char *set[4] = { NULL };
    uint32_t settings = 0;
    char path[64];
    ref_stand stand;
    uint64_t sum = 0;

    for (uint32_t i = 0; i < 3 && !shipped; i++)
        set[settings++] = exact[i];
    if (setting)
        set[settings++] = setting;
    snprintf(path, sizeof path, "assets/scenes/%s.ini", name);
    assert_int_equal(ref_stand_open(&stand, path, set, settings, tick), 0);
    drawn_image drawn = drawn_of(&stand, width, width * 3 / 4);
    for (size_t i = 0; i < (size_t)width * (width * 3 / 4); i++)
        for (int c = 0; c < 24; c += 8)
            sum += drawn.pixel[i] >> c & 255;
    drawn_free(&drawn);
    ref_stand_close(&stand);
    return (double)sum / ((double)width * width * 3 / 4 * 3);
}

static double mean_glitter(const char *name, bool shipped, uint32_t width)
{
    double sum = 0;

    for (uint32_t tick = 0; tick < TICKS * TICK_STEP; tick += TICK_STEP)
        sum += picture_mean(name, shipped, width, NULL, tick)
             - picture_mean(name, shipped, width, "water.specular=0", tick);
    return sum / TICKS;
}

static void glitter_is_the_same_at_every_size(void **state)
{
    int above = 0;

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double least = 1e9, most = 0;
        printf("    %-12s%-8s", rows[i].name, rows[i].shipped ? "shipped" : "exact");
        for (int k = 0; k < SIZES; k++) {
            const double glitter = mean_glitter(rows[i].name, rows[i].shipped, widths[k]);
            printf("%8.3f", glitter);
            least = glitter < least ? glitter : least;
            most = glitter > most ? glitter : most;
        }
        printf("  apart by %.1f %%\n", 100 * (most / least - 1));
        above += !(most / least - 1 < rows[i].spread);
    }
    assert_int_equal(above, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(glitter_is_the_same_at_every_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
