/* SPDX-License-Identifier: MIT */
/* The engine's frames against the reference's: shipped scenes at 160x120, one sample a
 * pixel, both with the waves' extent and the textures' levels of the engine.
 *
 * What is left is what the engine approximates: the surface by a mesh of cells with
 * slopes between their corners, its tables, its roundings. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "compare.h"

enum { WIDTH = 160, HEIGHT = 120, SETTINGS = 10 };

typedef struct {
    const char *name;
    uint32_t tick;
    double   whole, dull;       /* bounds of the rms of 255: as it is, without glitter */
    double   elsewhere;         /* of the share of pixels that show another thing */
    const char *set[SETTINGS];  /* besides; ended by NULL */
} row;

/* The goal is 3.  Above it, and why:
 *  - with glitter: a lobe of shininess n makes of a cosine that is short by e a light
 *    that is short by n e, and views are straight lines between every 16th column (at
 *    160 pixels e is 0.0015, a quarter of that at 320); slopes likewise between corners;
 *  - lava: blunt waves 3 m long on cells of 0.9 m move a picture of bright cracks by a
 *    texel or two (3.3 with cells of 0.3 m, 2.8 with 0.1 m);
 *  - deep-sea: waves of 8 m on cells of 1.8 m (2.0 with 0.6 m), slopes by differences;
 *  - a night that is exposed: what is wrong in the dark is brightened too, threefold;
 *  - shore-break: the reference leaves out what overhangs (1.8 with surf.stretch = 0). */
static const row rows[] = {
    { "minimal", 0, 2.5, 2, 0.0005, { NULL } },
    { "flat-calm", 0, 1.7, 1.7, 0.001, { NULL } },
    { "three-swells", 100, 2.5, 2.5, 0.002, { NULL } },
    { "calm-bay", 100, 8, 2, 0.001, { NULL } },
    { "storm", 100, 2.5, 2.5, 0.002, { NULL } },
    { "lava", 100, 18, 18, 0.0005, { NULL } },
    { "raindrops", 300, 5.2, 2, 0.0005, { NULL } },
    { "tank", 100, 9, 2, 0.001, { NULL } },
    { "pond", 100, 7.5, 2.5, 0.0005, { NULL } },
    { "harbour", 200, 5.3, 2.3, 0.0005, { NULL } },
    { "deep-sea", 100, 14.5, 4.5, 0.0005, { NULL } },
    { "night-sea", 100, 17.5, 2, 0.0005, { NULL } },
    { "shallows", 100, 2.7, 2.7, 0.002, { NULL } },
    { "shore-break", 100, 13.5, 6.8, 0.0005, { NULL } },
    { "from-above", 100, 4.8, 3.1, 0.0005, { NULL } },
    { "count-64", 100, 12, 3.2, 0.001, { NULL } },
    { "three-swells", 100, 2.5, 2.5, 0.002, { "sky.kind=day" } },
    { "three-swells", 100, 5.8, 2.5, 0.002,
      { "sky.kind=dusk", "light.heading=-20", "light.elevation=8", "hdr.share=0.5" } },
    { "night-sea", 100, 33, 7.1, 0.0005,
      { "sky.kind=night", "sky.stars=0", "hdr.exposure=auto", "light.model=blinn" } },
    { "storm", 100, 3.1, 3.1, 0.002,
      { "sky.kind=cube", "hdr.share=0.3", "sky.east=assets/skies/day-east.png",
        "sky.west=assets/skies/day-west.png", "sky.up=assets/skies/day-up.png",
        "sky.down=assets/skies/day-down.png", "sky.south=assets/skies/day-south.png",
        "sky.north=assets/skies/day-north.png" } },
    { "tank", 100, 7.8, 2, 0.001,
      { "tank.kind=stone", "tank.depth=0.8", "tank.rim=0.1", "water.clear=2" } },
    { "tank", 100, 5.4, 3.2, 0.003,
      { "tank.kind=glass", "tank.depth=0.8", "tank.rim=0.1", "water.clear=4",
        "camera.y=0.9", "camera.pitch=-14", "tank.wall=assets/textures/noise.png",
        "tank.floor=assets/textures/noise.png" } },
    { "shallows", 100, 2.2, 2.2, 0.002, { "water.clear=5" } },
};

/* Without glitter a lobe's height for a small error of its slopes does not count. */
static difference compare(const row *r, bool glitter)
{
    const char *set[SETTINGS + 1] = { "water.specular=0" };
    uint32_t sets = glitter ? 0 : 1;
    ref_stand stand;
    ref_scene scene;
    ref_image image;
    char path[64];

    snprintf(path, sizeof path, "assets/scenes/%s.ini", r->name);
    for (int i = 0; i < SETTINGS && r->set[i]; i++)
        set[sets++] = r->set[i];
    assert_int_equal(ref_stand_open(&stand, path, set, sets, r->tick), 0);
    ref_scene_open(&scene, &stand.file.scene, &stand.assets.names, stand.world, WIDTH,
                   HEIGHT, true);
    ref_image_draw(&image, &scene, WIDTH, HEIGHT, 1, 1);
    drawn_image drawn = drawn_of(&stand, WIDTH, HEIGHT);
    const difference d = difference_of(&drawn, &image);
    drawn_free(&drawn);
    ref_image_free(&image);
    ref_scene_close(&scene);
    ref_stand_close(&stand);
    return d;
}

static void print(const char *name, const char *what, const difference *d)
{
    printf("    %-13s%-6s rms %5.2f %5.2f %5.2f, mean %5.2f %5.2f %5.2f,"
           " worst %3.0f %3.0f %3.0f of %5u; elsewhere %.4f\n", name, what, d->rms[0],
           d->rms[1], d->rms[2], d->mean[0], d->mean[1], d->mean[2], d->worst[0],
           d->worst[1], d->worst[2], d->water, (double)d->elsewhere / d->pixels);
}

static void frames_are_near_the_reference(void **state)
{
    int above = 0;

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const row *r = &rows[i];
        const difference whole = compare(r, true), dull = compare(r, false);
        print(r->name, r->set[0] ? strchr(r->set[0], '=') : "", &whole);
        print("", "dull", &dull);
        const bool near = greatest(whole.rms) <= r->whole && greatest(dull.rms) <= r->dull
                       && whole.elsewhere <= r->elsewhere * whole.pixels;
        if (!near)
            print_error("%s is above its bounds\n", r->name);
        above += !near;
    }
    assert_int_equal(above, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_near_the_reference),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
