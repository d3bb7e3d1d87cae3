/* SPDX-License-Identifier: MIT */
/* Compares whole frames at each rung of quality with the reference renderer.
 *
 *     frames rungs SCENE WIDTH HEIGHT
 *         prints the scene's rungs, one a line: NAME;WORDS, the format of board.sh
 *     frames errors SCENE WIDTH HEIGHT TICK
 *         prints rows of the sweep
 *
 * The reference (ports/tools/reference, double precision, rays) takes 16 samples a pixel of
 * the exact surface, not of the engine's mesh. Foam, spray, caustics and stars are left out
 * of both pictures (tests/accuracy/scene_errors.c has them); mirrors bend to first order.
 * Costs are those of the shipped scenes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/lib/reference_difference.h"
#include "tests/charts/picture.h"
#include "tests/charts/words.h"
#include "app/scene/plan_sheet.h"

#define FOLDER "assets/scenes/"

enum { THREADS = 2, RUNGS = 16, WORDS_BYTES = 800 };

static const char *const off[] = { REF_WITHOUT };

/* Exact rung. Each other rung changes only the setting that it is named after, except the
 * plan's and the least. */
#define EXACT "quality.visibility=triangles quality.shading=exact quality.rate=full " \
              "quality.error_px=0 quality.error_colour=0"

typedef struct {
    char name[16], words[WORDS_BYTES];
} rung;

typedef struct {
    rung     of[RUNGS];
    uint32_t count;
} rungs;

/* -- list of rungs ------------------------------------------------------------------- */

static void add(rungs *all, const char *name, const char *words)
{
    rung *r = &all->of[all->count++];

    snprintf(r->name, sizeof r->name, "%s", name);
    snprintf(r->words, sizeof r->words, "%s", words);
}

static void add_exact(rungs *all, const char *name, const char *more, bool there)
{
    char words[WORDS_BYTES];

    snprintf(words, sizeof words, EXACT "%s%s", *more ? " " : "", more);
    if (there)
        add(all, name, words);
}

static void add_set(rungs *all, const char *name, const tp_scene *scene,
                    const tp_rung_set *set)
{
    static const tp_rung_set exact = { .of = { 0 } };
    char words[WORDS_BYTES];

    plan_write_changes(scene, &exact, set, words, sizeof words);
    add_exact(all, name, words, true);
}

/* Lists the scene's rungs: the plan's are those of its error budget, the least those of the
 * last step below it, where the frame governor would end. */
static rungs rungs_of(const tp_scene *shipped, const tp_assets *names, uint32_t width,
                      uint32_t height)
{
    const tp_plan_input in = { tp_program_all.modules, shipped, names, width, height };
    const tp_view_estimate o = tp_view_estimate_make(&in);
    const uint8_t *fits = o.fits;
    const tp_plan plan = tp_plan_make(shipped, names, width, height);
    tp_view_costs view;
    tp_set_walk walk;
    rungs all = { .count = 0 };

    tp_view_costs_make(&view, &tp_prices_measured, &in);
    tp_set_walk_make(&walk, &view, plan.set, plan.open);
    add_exact(&all, "exact", "", true);
    add_exact(&all, "rows", "quality.visibility=rows", fits[TP_VISIBILITY_ROWS - 1]);
    add_exact(&all, "projected", "quality.visibility=projected",
              fits[TP_VISIBILITY_PROJECTED - 1]);
    add_exact(&all, "flat", "quality.visibility=flat", fits[TP_VISIBILITY_FLAT - 1]);
    add_exact(&all, "grid/2", "grid/2", true);
    add_exact(&all, "grid/4", "grid/4", true);
    add_exact(&all, "quick", "quality.shading=quick", o.quick);
    add_exact(&all, "quick-layers", "quality.shading=quick quality.rate=layers", o.quick);
    add_exact(&all, "quick-colour", "quality.shading=quick quality.rate=colour", o.quick);
    add_set(&all, "plan", shipped, &plan.set);
    add_set(&all, "least", shipped, &walk.set[walk.count - 1]);
    return all;
}

/* -- errors -------------------------------------------------------------------------- */

typedef struct {
    uint32_t  width, height;
    uint32_t *pixel;
    uint8_t  *shows;
} frame_view;

static uint8_t shows_of(uint8_t kind)
{
    return kind == REF_SKY ? SHOWS_SKY : kind == REF_WATER ? SHOWS_WATER : SHOWS_OTHER;
}

static frame_view view_of(uint32_t width, uint32_t height)
{
    frame_view v = { width, height, malloc((size_t)width * height * 4),
                     malloc((size_t)width * height) };

    if (!v.pixel || !v.shows)
        abort();
    return v;
}

/* Reference picture. The kind of surface is taken at pixel centres, like the engine's. */
static frame_view truth_of(const ref_stand *stand, uint32_t width, uint32_t height)
{
    frame_view v = view_of(width, height);
    ref_scene scene;
    ref_image image;

    ref_scene_open(&scene, &stand->file.scene, &stand->assets.names, stand->world, width,
                   height, false);
    ref_image_draw(&image, &scene, width, height, REF_SAMPLES, THREADS);
    for (uint32_t i = 0; i < width * height; i++)
        v.pixel[i] = ref_image_pixel(&image, i % width, i / width);
    ref_image_free(&image);
    ref_image_draw(&image, &scene, width, height, 1, 1);
    for (uint32_t i = 0; i < width * height; i++)
        v.shows[i] = shows_of(image.kind[i]);
    ref_image_free(&image);
    ref_scene_close(&scene);
    return v;
}

static void judge(const char *name, const rung *r, const ref_stand *stand,
                  const frame_view *truth)
{
    const uint32_t width = truth->width, height = truth->height;
    ref_stand other = *stand;

    if (!words_set(&other.file.scene, r->words))
        abort();
    drawn_image drawn = drawn_of(&other, width, height);
    for (uint32_t i = 0; i < width * height; i++)
        drawn.kind[i] = shows_of(drawn.kind[i]);
    const double psnr = picture_psnr(truth->pixel, drawn.pixel, (size_t)width * height);
    const border_shift shift = picture_shift(truth->shows, drawn.kind, width, height);
    printf("frames,%s;%s,rms,%.4g\n", name, r->name, 255 / pow(10, psnr / 20));
    printf("frames,%s;%s,psnr,%.4g\n", name, r->name, psnr);
    printf("frames,%s;%s,ssim,%.4g\n", name, r->name,
           picture_ssim(truth->pixel, drawn.pixel, width, height));
    printf("frames,%s;%s,shift_max,%.4g\n", name, r->name, shift.most);
    printf("frames,%s;%s,shift_mean,%.4g\n", name, r->name, shift.mean);
    printf("frames,%s;%s,used,%s\n", name, r->name,
           strcmp(r->name, "plan") == 0 ? name : "-");
    drawn_free(&drawn);
}

static void judge_all(const char *name, const rungs *all, const ref_stand *stand,
                      uint32_t width, uint32_t height)
{
    frame_view truth = truth_of(stand, width, height);

    for (uint32_t i = 0; i < all->count; i++)
        judge(name, &all->of[i], stand, &truth);
    free(truth.pixel);
    free(truth.shows);
}

/* -- command line -------------------------------------------------------------------- */

static int usage(void)
{
    fprintf(stderr, "usage: frames rungs SCENE WIDTH HEIGHT\n"
                    "       frames errors SCENE WIDTH HEIGHT TICK\n");
    return 2;
}

int main(int argc, char **argv)
{
    const bool errors = argc == 6 && strcmp(argv[1], "errors") == 0;
    char path[128];
    ref_stand stand;

    if (!errors && !(argc == 5 && strcmp(argv[1], "rungs") == 0))
        return usage();
    const uint32_t width = word_number(argv[3]), height = word_number(argv[4]);
    snprintf(path, sizeof path, FOLDER "%s.ini", argv[2]);
    int code = ref_stand_open(&stand, path, NULL, 0, 0);
    if (code)
        return code;
    const rungs all = rungs_of(&stand.file.scene, &stand.assets.names, width, height);
    ref_stand_close(&stand);
    for (uint32_t i = 0; i < all.count && !errors; i++)
        printf("%s;%s\n", all.of[i].name, all.of[i].words);
    if (!errors)
        return 0;
    code = ref_stand_open(&stand, path, off, sizeof off / sizeof *off,
                          word_number(argv[5]));
    if (!code)
        judge_all(argv[2], &all, &stand, width, height);
    ref_stand_close(&stand);
    return code;
}
