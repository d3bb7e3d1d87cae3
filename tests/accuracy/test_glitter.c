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

enum { SIZES = 4, TICK_STEP = 120 };

static const uint32_t widths[SIZES] = { 160, 320, 640, 1280 };

typedef struct {
    const char *name;
    bool        shipped;        /* the scene's own rungs, which are fast; else exact */
    double      spread;         /* bound: largest over smallest glitter, less 1 */
    const char *also;           /* a further setting, or NULL */
    uint32_t    ticks;          /* of pictures; six with TP_SOAK */
} glitter_row;

/* The bound is 5 %.  Kurtosis of night-sea's ripple slopes is 2.7 to 3.2 in the levels 0 to
 * 5, where a Gaussian distribution has 3. */
static const glitter_row rows[] = {
    { "night-sea", false, 0.05, NULL, 6 }, { "deep-sea", false, 0.05, NULL, 3 },
    { "count-64", false, 0.05, NULL, 3 },  { "count-64", true, 0.05, NULL, 3 },
    { "count-100", true, 0.05, NULL, 3 },  { "calm-bay", false, 0.05, NULL, 3 },
    { "harbour", false, 0.05, NULL, 3 },   { "raindrops", false, 0.05, NULL, 3 },
};

/* Sum of a picture of the stand's world. */
static uint64_t picture_sum(const ref_stand *stand, uint32_t width)
{
    const size_t count = (size_t)width * (width * 3 / 4);
    uint64_t sum = 0;

    drawn_image drawn = drawn_of(stand, width, width * 3 / 4);
    for (size_t i = 0; i < count; i++)
        sum += (drawn.pixel[i] & 255) + (drawn.pixel[i] >> 8 & 255)
             + (drawn.pixel[i] >> 16 & 255);
    drawn_free(&drawn);
    return sum;
}

static void open_row(const glitter_row *row, ref_stand *stand)
{
    static const char *const exact[] = { "quality.visibility=triangles",
                                         "quality.shading=exact", "quality.rate=full" };
    const char *set[4] = { NULL };
    uint32_t settings = 0;
    char path[64];

    for (uint32_t i = 0; i < 3 && !row->shipped; i++)
        set[settings++] = exact[i];
    if (row->also)
        set[settings++] = row->also;
    snprintf(path, sizeof path, "assets/scenes/%s.ini", row->name);
    assert_int_equal(ref_stand_open(stand, path, set, settings, 0), 0);
}

/* The world steps without regard to glint, so pictures with and without show one world. */
static void find_glitter(double glitter[SIZES], const glitter_row *row)
{
    const uint32_t ticks = getenv("TP_SOAK") ? 6 : row->ticks;
    ref_stand stand;

    open_row(row, &stand);
    tp_scene *scene = &stand.file.scene;
    const tp_fx specular = scene->water.specular;
    for (int k = 0; k < SIZES; k++)
        glitter[k] = 0;
    for (uint32_t tick = 0; tick < ticks * TICK_STEP; tick++) {
        for (int k = 0; k < SIZES && tick % TICK_STEP == 0; k++) {
            const double samples = widths[k] * (widths[k] * 3 / 4) * 3.0;
            glitter[k] += (double)picture_sum(&stand, widths[k]) / samples / ticks;
            scene->water.specular = 0;
            glitter[k] -= (double)picture_sum(&stand, widths[k]) / samples / ticks;
            scene->water.specular = specular;
        }
        tp_world_step(&tp_program_all, stand.world, scene, NULL);
    }
    ref_stand_close(&stand);
}

/* Returns the largest glitter over the smallest, less 1. */
static double find_spread(const glitter_row *row)
{
    double glitter[SIZES], least = 1e9, most = 0;

    printf("    %-12s%-8s", row->name, row->shipped ? "shipped" : "exact");
    find_glitter(glitter, row);
    for (int k = 0; k < SIZES; k++) {
        printf("%8.3f", glitter[k]);
        least = glitter[k] < least ? glitter[k] : least;
        most = glitter[k] > most ? glitter[k] : most;
    }
    printf("  apart by %.1f %%\n", 100 * (most / least - 1));
    return most / least - 1;
}

static void glitter_is_the_same_at_every_size(void **state)
{
    int above = 0;

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        above += !(find_spread(&rows[i]) < rows[i].spread);
    assert_int_equal(above, 0);
}

/* The cheaper choice: what a pixel cannot show of ripples and waves is left out. */
static void without_rough_light_it_is_not(void **state)
{
    static const glitter_row row = { "night-sea", false, 0.2, "water.rough=off", 6 };

    (void)state;
    assert_true(find_spread(&row) > row.spread);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(glitter_is_the_same_at_every_size),
        cmocka_unit_test(without_rough_light_it_is_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
