/* SPDX-License-Identifier: MIT */
/* Compares the engine's foam and spray with the reference's: shipped scenes at 160x120, one
 * sample a pixel, both with the engine's extent of waves and mipmap levels. All pixels are
 * compared, and the same picture is compared with a reference without foam and spray.
 *
 * Foam lies over rest positions, and the engine interpolates them linearly over its
 * mesh's cells: a bubble's edge moves by a pixel or two where cells are coarse (storm
 * with foam of one white: 1.4). Narrow cells leave 0.9 to 1.9, where the pictures without
 * foam are 0.7 to 1.1 apart. Foam beyond the window adds the error of the mesh's slope,
 * whose fourth power counts, and the edge of old foam where that slope turns: storm, with
 * as much foam beyond as within, 3.7, with narrow cells 1.9; three-swells 2.0 and 1.4;
 * deep-sea 4.5, with narrow cells no less.
 *
 * Boats have plain outlines.  Light of rough water approximates the mean over a pixel, the
 * reference takes one sample: deep-sea, from-above and, by finer ripples, shallows differ
 * without foam, too.
 *
 * Spray covers few pixels: where the reference's spray changes a pixel, the picture is
 * compared by itself; foam's own error counts there, too. The engine rounds a
 * streak's middle, way and width to 1/16 pixel. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/reference_difference.h"

enum { WIDTH = 160, HEIGHT = 120, SETTINGS = 6 };

typedef struct {
    const char *name;
    uint32_t tick;
    double   both, most;        /* bounds of the mean error, of 255, and of its share of
                                 * the error without foam and spray in the reference */
    double   specks;            /* bound of the error in the pixels of spray, as a share of
                                 * the error without spray in the reference; 0: no spray */
    const char *set[SETTINGS];  /* further settings, ended by NULL */
} foam_row;

static const char *const off[] = {
    "water.caustics=0", "sky.stars=0", "mirror.distortion=1", "mirror.method=none",
    "quality.visibility=triangles", "quality.shading=exact", "quality.rate=full",
    "boat.edges=plain",
};

enum { OFF = sizeof off / sizeof *off };

static const foam_row rows[] = {
    { "storm", 850, 4.4, 0.12, 0.5, { NULL } },
    { "storm", 850, 2.25, 0.85, 0.34, { "foam.cells=0" } },
    { "storm", 850, 2.7, 0.08, 0, { "spray.count=0", "foam.texture=" } },
    { "deep-sea", 900, 4.9, 0.3, 0, { NULL } },
    { "three-swells", 600, 2.4, 0.65, 0, { NULL } },
    { "from-above", 600, 1.8, 0.2, 0, { NULL } },
    { "harbour", 600, 1.1, 0.55, 0, { NULL } },
    { "shallows", 600, 1.3, 0.85, 0, { NULL } },
    { "shore-break", 900, 2.8, 0.22, 0.75, { "surf.stretch=0" } },
    { "shore-break", 900, 2.5, 0.9, 0, { "surf.stretch=0", "camera.heading=150",
                                         "camera.pitch=-20", "camera.z=13" } },
    { "raindrops", 300, 1.5, 0.85, 0.2, { "spray.size=0.05", "spray.impact=3" } },
    { "raindrops", 400, 1.5, 0.92, 0.2, { "spray.size=0.05", "spray.impact=3" } },

    /* narrow cells */
    { "storm", 850, 2.0, 0.1, 0,
      { "spray.count=0", "grid.vertices=65536" } },
    { "three-swells", 600, 1.4, 0.45, 0, { "grid.vertices=65536" } },
};

/* Mean error of the pixels that the reference's spray changes by more than a level: with
 * the spray, and without. */
static uint32_t compare_specks(const drawn_image *drawn, const ref_image *with,
                               const ref_image *bare, double mean[2])
{
    uint32_t count = 0;

    mean[0] = mean[1] = 0;
    for (uint32_t i = 0; i < drawn->width * drawn->height; i++) {
        const ref_colour got = ref_colour_unpack(drawn->pixel[i]);
        double sum[3] = { 0 };
        for (int c = 0; c < 3; c++) {
            const double a = ref_clamp(with->colour[i].c[c], 0, 255);
            const double b = ref_clamp(bare->colour[i].c[c], 0, 255);
            sum[0] += fabs(got.c[c] - a) / 3;
            sum[1] += fabs(got.c[c] - b) / 3;
            sum[2] += fabs(a - b) / 3;
        }
        if (sum[2] > 1) {
            mean[0] += sum[0];
            mean[1] += sum[1];
            count++;
        }
    }
    return count;
}

static void open_row(const foam_row *r, ref_stand *stand)
{
    const char *set[OFF + SETTINGS];
    uint32_t sets = 0;
    char path[64];

    snprintf(path, sizeof path, "assets/scenes/%s.ini", r->name);
    for (int i = 0; i < OFF; i++)
        set[sets++] = off[i];
    for (int i = 0; i < SETTINGS && r->set[i]; i++)
        set[sets++] = r->set[i];
    assert_int_equal(ref_stand_open(stand, path, set, sets, r->tick), 0);
}

/* Draws the reference's picture, without foam and spray if told. */
static void draw_reference(const ref_scene *whole, bool foam, bool spray, ref_image *image)
{
    ref_scene scene = *whole;

    if (!foam)
        scene.foam.cover = NULL;
    if (!spray)
        scene.specks = 0;
    ref_image_draw(image, &scene, WIDTH, HEIGHT, 1, 1);
}

static bool is_near(const foam_row *r)
{
    ref_stand stand;
    ref_scene scene;
    ref_image image, bare, still;
    double spray[2] = { 0, 0 };
    uint32_t specks = 0;

    open_row(r, &stand);
    drawn_image drawn = drawn_of(&stand, WIDTH, HEIGHT);
    ref_scene_open(&scene, &stand.file.scene, &stand.assets.names, stand.world, WIDTH,
                   HEIGHT, true);
    scene.surface.memory = memory_new();
    draw_reference(&scene, true, true, &image);
    draw_reference(&scene, false, false, &bare);
    const double both = difference_mean(&drawn, &image),
                 without = difference_mean(&drawn, &bare);
    if (r->specks > 0) {
        draw_reference(&scene, true, false, &still);
        specks = compare_specks(&drawn, &image, &still, spray);
        ref_image_free(&still);
    }
    printf("    %-13s%-23s mean error %5.2f, without foam and spray %5.2f; share of"
           " spray's %4.2f in %4u pixels\n", r->name, r->set[0] ? r->set[0] : "", both,
           without, spray[0] / fmax(spray[1], 1e-9), specks);
    ref_image_free(&bare);
    ref_image_free(&image);
    free(scene.surface.memory);
    ref_scene_close(&scene);
    drawn_free(&drawn);
    ref_stand_close(&stand);
    return both <= r->both && both <= r->most * without
        && (r->specks == 0 || (specks > 10 && spray[0] <= r->specks * spray[1]));
}

static void foam_and_spray_are_near_the_reference(void **state)
{
    int above = 0;

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const bool near = is_near(&rows[i]);
        if (!near)
            print_error("%s is above its bounds\n", rows[i].name);
        above += !near;
    }
    assert_int_equal(above, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(foam_and_spray_are_near_the_reference),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
