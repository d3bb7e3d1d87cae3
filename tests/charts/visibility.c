/* SPDX-License-Identifier: MIT */
/* Compares the water renderers, with several numbers of vertices, with the reference
 * renderer.
 *
 *     visibility points SCENE WIDTH HEIGHT
 *         prints each point as METHOD;GRID and words for board.sh
 *     visibility errors SCENE WIDTH HEIGHT TICK
 *         prints rows of the sweep
 *
 * Drawn without the boat and without features that the reference leaves out, with exact
 * stages at the full rate, no lines and no waves left out. Both pictures have one sample a
 * pixel: glints smaller than a pixel would hide the differences of the renderers. Both have
 * the engine's extent of waves and mipmap levels. Outline error: pixels that are water in
 * one picture only, over the number of changes between water and other surfaces down the
 * columns of the reference. Colour error: rms of 255 of the worst channel, over pixels that
 * are water in both. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/lib/reference_difference.h"
#include "quality/plan.h"
#include "tests/charts/words.h"

#define FOLDER "assets/scenes/"

static const char *const off[] = {
    REF_WITHOUT,
    "boat.mesh=", "quality.shading=exact", "quality.rate=full",
    "quality.error_px=0", "quality.error_colour=0",
};

typedef struct {
    double px, colour;
} visibility_error;

static visibility_error error_of(const drawn_image *a, const ref_image *b)
{
    double   sum[3] = { 0, 0, 0 };
    uint32_t count = 0, elsewhere = 0, borders = 0;

    for (uint32_t i = 0; i < b->width * b->height; i++) {
        const bool water = b->kind[i] == REF_WATER;
        elsewhere += water != (a->kind[i] == REF_WATER);
        borders += i >= b->width && water != (b->kind[i - b->width] == REF_WATER);
        if (!water || a->kind[i] != REF_WATER)
            continue;
        const ref_colour got = ref_colour_unpack(a->pixel[i]);
        for (int c = 0; c < 3; c++) {
            const double more = got.c[c] - ref_clamp(b->colour[i].c[c], 0, 255);
            sum[c] += more * more;
        }
        count++;
    }
    return (visibility_error){ elsewhere / fmax(borders, 1),
                               sqrt(greatest(sum) / (count ? count : 1)) };
}

/* -- points -------------------------------------------------------------------------- */

/* Vertices, in addition to the scene's own. */
static const int32_t grids[] = { 500, 2000, 8000, 32000 };
static const char *const methods[] = { "triangles", "rows", "projected", "flat" };

enum { GRIDS = sizeof grids / sizeof *grids, METHODS = 4, POINTS = METHODS * (GRIDS + 1) };

typedef struct {
    int     method;
    int32_t grid;
    bool    chosen;             /* renderer of the shipped scene */
} visibility_point;

typedef struct {
    visibility_point    of[POINTS];
    uint32_t count;
} points;

static points points_of(const ref_stand *shipped, uint32_t width, uint32_t height)
{
    const tp_scene *scene = &shipped->file.scene;
    const tp_plan plan = tp_plan_make(scene, &shipped->assets.names, width, height);
    points all = { .count = 0 };

    for (int m = 0; m < METHODS; m++) {
        const bool chosen = plan.set.of[TP_KIND_VISIBILITY] == m;
        bool own = false;
        for (int g = 0; g < GRIDS; g++) {
            const bool same = grids[g] == scene->grid.vertices;
            all.of[all.count++] = (visibility_point){ m, grids[g], chosen && same };
            own = own || same;
        }
        if (!own)
            all.of[all.count++] = (visibility_point){ m, scene->grid.vertices, chosen };
    }
    return all;
}

static void words_of(const visibility_point *p, char *words, size_t bytes)
{
    snprintf(words, bytes, "quality.visibility=%s grid=%d", methods[p->method],
             (int)p->grid);
}

static void list(const points *all)
{
    for (uint32_t i = 0; i < all->count; i++) {
        char words[80];
        words_of(&all->of[i], words, sizeof words);
        printf("%s;%d", methods[all->of[i].method], (int)all->of[i].grid);
        for (size_t k = 0; k < sizeof off / sizeof *off; k++)
            if (strncmp(off[k], "quality.", 8) == 0)
                printf(" %s", off[k]);
        printf(" %s bare\n", words);
    }
}

/* -- errors -------------------------------------------------------------------------- */

static void judge(const char *name, const visibility_point *p, const ref_stand *stand,
                  const ref_image *truth)
{
    ref_stand other = *stand;
    char words[80], key[80];

    words_of(p, words, sizeof words);
    if (!words_set(&other.file.scene, words))
        abort();
    drawn_image drawn = drawn_of(&other, truth->width, truth->height);
    const visibility_error e = error_of(&drawn, truth);
    snprintf(key, sizeof key, "%s;%s;%d", name, methods[p->method], (int)p->grid);
    printf("visibility,%s,px,%.4g\n", key, e.px);
    printf("visibility,%s,colour,%.4g\n", key, e.colour);
    printf("visibility,%s,used,%s\n", key, p->chosen ? name : "-");
    drawn_free(&drawn);
}

static void judge_all(const char *name, const points *all, const ref_stand *stand,
                      uint32_t width, uint32_t height)
{
    ref_scene scene;
    ref_image truth;

    ref_scene_open(&scene, &stand->file.scene, &stand->assets.names, stand->world, width,
                   height, true);
    ref_image_draw(&truth, &scene, width, height, 1, 1);
    for (uint32_t i = 0; i < all->count; i++)
        judge(name, &all->of[i], stand, &truth);
    ref_image_free(&truth);
    ref_scene_close(&scene);
}

static int usage(void)
{
    fprintf(stderr, "usage: visibility points SCENE WIDTH HEIGHT\n"
                    "       visibility errors SCENE WIDTH HEIGHT TICK\n");
    return 2;
}

int main(int argc, char **argv)
{
    const bool errors = argc == 6 && strcmp(argv[1], "errors") == 0;
    ref_stand stand;
    char path[128];

    if (!errors && !(argc == 5 && strcmp(argv[1], "points") == 0))
        return usage();
    const uint32_t width = word_number(argv[3]), height = word_number(argv[4]);
    snprintf(path, sizeof path, FOLDER "%s.ini", argv[2]);
    int code = ref_stand_open(&stand, path, NULL, 0, 0);
    if (code)
        return code;
    const points all = points_of(&stand, width, height);
    ref_stand_close(&stand);
    if (!errors) {
        list(&all);
        return 0;
    }
    code = ref_stand_open(&stand, path, off, sizeof off / sizeof *off,
                          word_number(argv[5]));
    if (!code)
        judge_all(argv[2], &all, &stand, width, height);
    ref_stand_close(&stand);
    return code;
}
