/* SPDX-License-Identifier: MIT */
/* Compares frames of the engine with the reference, caustics or stars in both pictures:
 * shipped scenes, one sample a pixel, exact rungs. The mean error over all pixels has a
 * bound, and is greater if the reference lacks the feature. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/reference_difference.h"
#include "tools/reference/caustics.h"

enum { SETTINGS = 6 };

typedef struct {
    const char *name;
    uint32_t tick, width;       /* pictures are 3/4 as high as wide */
    double   mean;              /* bound of the mean error, of 255 */
    const char *set[SETTINGS];  /* further settings, ended by NULL */
} light_row;

static const char *const always[] = {
    "foam.cells=0", "quality.visibility=triangles", "quality.shading=exact",
    "quality.rate=full",
};

enum { ALWAYS = sizeof always / sizeof *always };

/* Caustics: the engine's map has cells of 25 mm in the tank and of 0.25 m in the shallows,
 * the reference's lines of light are sharp. The engine's light of a cell is its level area,
 * the reference's the area across the sun's rays.
 *
 * Stars: the engine's dots are round on the cube's face, the reference's on the sphere;
 * towards a corner of the face the engine's are narrower.  The first row of the night has no
 * glitter: the engine's is the mean over a pixel and would hide the stars (5.7). */
static const light_row rows[] = {
    { "tank", 100, 160, 0.93, { NULL } },
    { "tank", 160, 160, 1.69, { "light.elevation=25" } },
    { "tank", 100, 160, 0.85,
      { "tank.kind=stone", "water.clarity=8", "water.caustics=1" } },
    { "shallows", 100, 160, 2.77,
      { "camera.pitch=-50", "camera.fov=30", "water.clarity=15", "water.caustic_size=32",
        "water.caustic_cells=128" } },
    { "night-sea", 100, 320, 1.12, { "water.specular=0" } },
    { "night-sea", 10, 160, 2.3, { "camera.pitch=40", "sky.stars=1" } },
    { "night-sea", 10, 640, 0.61, { "camera.pitch=40", "sky.stars=1" } },
};

static void open_stand(ref_stand *stand, const light_row *r)
{
    const char *set[ALWAYS + SETTINGS];
    uint32_t sets = 0;
    char path[64];

    for (int i = 0; i < ALWAYS; i++)
        set[sets++] = always[i];
    for (int i = 0; i < SETTINGS && r->set[i]; i++)
        set[sets++] = r->set[i];
    snprintf(path, sizeof path, "assets/scenes/%s.ini", r->name);
    assert_int_equal(ref_stand_open(stand, path, set, sets, r->tick), 0);
}

/* Mean errors: with the feature in both pictures, and without it in the reference. */
static void compare(const light_row *r, double mean[2])
{
    const uint32_t height = r->width * 3 / 4;
    ref_stand stand;
    ref_scene scene;

    open_stand(&stand, r);
    ref_scene_open(&scene, &stand.file.scene, &stand.assets.names, stand.world, r->width,
                   height, true);
    scene.surface.memory = memory_new();
    drawn_image drawn = drawn_of(&stand, r->width, height);
    for (int k = 0; k < 2; k++) {
        ref_image image;
        ref_image_draw(&image, &scene, r->width, height, 1, 1);
        mean[k] = difference_mean(&drawn, &image);
        ref_image_free(&image);
        ref_caustics_free(scene.caustics);
        scene.caustics = NULL;
        stand.file.scene.sky.stars = 0;
    }
    drawn_free(&drawn);
    free(scene.surface.memory);
    ref_scene_close(&scene);
    ref_stand_close(&stand);
}

static void frames_have_the_same_light(void **state)
{
    int above = 0;

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double mean[2];
        compare(&rows[i], mean);
        printf("    %-10s%4u %-19s mean error %.3f, without the feature %.3f\n",
               rows[i].name, rows[i].width, rows[i].set[0] ? rows[i].set[0] : "", mean[0],
               mean[1]);
        above += !(mean[0] < rows[i].mean && mean[0] < 0.96 * mean[1]);
    }
    assert_int_equal(above, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_have_the_same_light),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
