/* SPDX-License-Identifier: MIT */
/* Measures how far a scene's pictures lie from the reference at 16 samples a pixel, with
 * every feature on.
 *
 *     scene_errors [--camera NAME] SCENE.ini WIDTHxHEIGHT TICK...
 *         SCENE,TICK,RUNG,CAMERA,RMS,PSNR,SSIM for each tick, the exact rung and the
 *         shipped one; the camera is the scene's own unless another one is named
 *     scene_errors --twinkle SCENE.ini WIDTHxHEIGHT TICK
 *         SCENE,TICK,RUNG,MEAN,RMS: the second difference of 12 frames from TICK on, over
 *         that of the reference's frames, once as a mean magnitude and once as an rms
 *
 * RMS is in levels of 255 over all pixels and channels.  The second difference of a pixel
 * is p(t - 1) - 2 p(t) + p(t + 1), over all pixels, channels and frames. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "quality/plan.h"
#include "tests/charts/picture.h"
#include "tests/lib/reference_difference.h"

enum { THREADS = 2, FRAMES = 12 };

enum { EXACT, SHIPPED, RUNGS };

static const char *const rungs[RUNGS] = { [EXACT] = "exact", [SHIPPED] = "shipped" };

/* Cameras by their settings; the first is the scene's own. */
static const struct {
    const char *name, *setting[2];
    uint32_t    settings;
} cameras[] = {
    { "own", { NULL }, 0 },
    { "14-m", { "camera.y=14", "camera.pitch=-22" }, 2 },
    { "50-m", { "camera.y=50", "camera.pitch=-30" }, 2 },
};

enum { CAMERAS = sizeof cameras / sizeof *cameras };

typedef struct {
    const char *path, *name;
    uint32_t width, height, camera;
} request;

/* The pictures of one tick: of each rung, and the reference's. */
typedef struct {
    uint32_t *rung[RUNGS], *truth;
} pictures;

static uint32_t *copy_pixels(const uint32_t *pixels, size_t count)
{
    uint32_t *copy = malloc(count * sizeof *copy);

    if (!copy)
        abort();
    memcpy(copy, pixels, count * sizeof *copy);
    return copy;
}

static uint32_t *draw_truth(const request *r, const ref_stand *stand)
{
    const size_t count = (size_t)r->width * r->height;
    uint32_t *pixels = malloc(count * sizeof *pixels);
    ref_scene scene;
    ref_image image;

    if (!pixels)
        abort();
    ref_scene_open(&scene, &stand->file.scene, &stand->assets.names, stand->world, r->width,
                   r->height, false);
    ref_image_draw(&image, &scene, r->width, r->height, REF_SAMPLES, THREADS);
    for (size_t i = 0; i < count; i++)
        pixels[i] = ref_image_pixel(&image, (uint32_t)i % r->width, (uint32_t)i / r->width);
    ref_image_free(&image);
    ref_scene_close(&scene);
    return pixels;
}

/* Names exact rungs, or the shipped ones: the scene's own, with the plan's in open rows. */
static void name_rungs(ref_stand *stand, const request *r, uint32_t rung)
{
    const tp_rung_set exact = { .of = { 0 } };
    tp_scene *scene = &stand->file.scene;

    if (rung == EXACT) {
        tp_rung_set_apply(scene, &exact);
        return;
    }
    const tp_plan plan = tp_plan_make(scene, &stand->assets.names, r->width, r->height);
    tp_rung_set_apply_some(scene, &plan.set, plan.open);
}

static int open_stand(ref_stand *stand, const request *r, uint32_t rung, uint32_t tick)
{
    const int code = ref_stand_open(stand, r->path, cameras[r->camera].setting,
                                    cameras[r->camera].settings, tick);

    if (!code)
        name_rungs(stand, r, rung);
    return code;
}

/* Draws the scene at a tick. Rungs change no world, so one world serves all. */
static int draw_pictures(const request *r, uint32_t tick, pictures *to)
{
    const size_t count = (size_t)r->width * r->height;
    ref_stand stand;

    for (uint32_t i = 0; i < RUNGS; i++) {
        const int code = open_stand(&stand, r, i, tick);
        if (code)
            return code;
        drawn_image drawn = drawn_of(&stand, r->width, r->height);
        to->rung[i] = copy_pixels(drawn.pixel, count);
        drawn_free(&drawn);
        if (i + 1 == RUNGS)
            to->truth = draw_truth(r, &stand);
        ref_stand_close(&stand);
    }
    return EXIT_DONE;
}

static void free_pictures(pictures *p)
{
    for (uint32_t i = 0; i < RUNGS; i++)
        free(p->rung[i]);
    free(p->truth);
}

static int print_errors(const request *r, uint32_t tick)
{
    const size_t count = (size_t)r->width * r->height;
    pictures p;
    const int code = draw_pictures(r, tick, &p);

    if (code)
        return code;
    for (uint32_t i = 0; i < RUNGS; i++) {
        const double psnr = picture_psnr(p.truth, p.rung[i], count);
        printf("%s,%u,%s,%s,%.2f,%.2f,%.4f\n", r->name, (unsigned)tick, rungs[i],
               cameras[r->camera].name, 255 / pow(10, psnr / 20), psnr,
               picture_ssim(p.truth, p.rung[i], r->width, r->height));
    }
    fflush(stdout);
    free_pictures(&p);
    return EXIT_DONE;
}

/* -- twinkle ------------------------------------------------------------------------- */

/* Sums of second differences: of magnitudes and of squares. */
typedef struct {
    double magnitude, square;
} twinkle_sums;

static void add_second_differences(twinkle_sums *sum, const uint32_t *a,
                                   const uint32_t *b, const uint32_t *c, size_t pixels)
{
    for (size_t i = 0; i < pixels; i++)
        for (int shift = 0; shift < 24; shift += 8) {
            const int off = (int)(a[i] >> shift & 255) - 2 * (int)(b[i] >> shift & 255)
                          + (int)(c[i] >> shift & 255);
            sum->magnitude += abs(off);
            sum->square += off * off;
        }
}

static int print_twinkle(const request *r, uint32_t tick)
{
    const size_t count = (size_t)r->width * r->height;
    pictures p[FRAMES];
    twinkle_sums truth = { 0, 0 }, rung[RUNGS] = { { 0, 0 } };

    for (uint32_t k = 0; k < FRAMES; k++) {
        const int code = draw_pictures(r, tick + k, &p[k]);
        if (code)
            return code;
    }
    for (uint32_t k = 1; k + 1 < FRAMES; k++) {
        add_second_differences(&truth, p[k - 1].truth, p[k].truth, p[k + 1].truth, count);
        for (uint32_t i = 0; i < RUNGS; i++)
            add_second_differences(&rung[i], p[k - 1].rung[i], p[k].rung[i],
                                   p[k + 1].rung[i], count);
    }
    for (uint32_t i = 0; i < RUNGS; i++)
        printf("%s,%u,%s,%.3f,%.3f\n", r->name, (unsigned)tick, rungs[i],
               rung[i].magnitude / truth.magnitude, sqrt(rung[i].square / truth.square));
    for (uint32_t k = 0; k < FRAMES; k++)
        free_pictures(&p[k]);
    return EXIT_DONE;
}

/* -- command line -------------------------------------------------------------------- */

static int usage(void)
{
    fprintf(stderr,
            "usage: scene_errors [--camera NAME] SCENE.ini WIDTHxHEIGHT TICK...\n"
            "       scene_errors --twinkle SCENE.ini WIDTHxHEIGHT TICK\n");
    return EXIT_USAGE;
}

static bool read_number(const char *text, char end, uint32_t *number)
{
    char *stop;

    *number = (uint32_t)strtoul(text, &stop, 10);
    return *text >= '0' && *text <= '9' && *stop == end;
}

/* Finds a camera by its name; CAMERAS if there is none. */
static uint32_t find_camera(const char *name)
{
    uint32_t i = 0;

    while (i < CAMERAS && strcmp(cameras[i].name, name) != 0)
        i++;
    return i;
}

/* Reads the scene's path and the size; the name is the file's, without its folder and
 * ending. */
static bool read_request(char **argv, request *r)
{
    static char name[64];
    const char *slash = strrchr(argv[0], '/'), *by = strchr(argv[1], 'x');

    snprintf(name, sizeof name, "%s", slash ? slash + 1 : argv[0]);
    name[strcspn(name, ".")] = 0;
    r->path = argv[0];
    r->name = name;
    return by && read_number(argv[1], 'x', &r->width)
           && read_number(by + 1, 0, &r->height) && r->width > 0 && r->width <= 4096
           && r->height > 0 && r->height <= 4096;
}

int main(int argc, char **argv)
{
    const bool twinkle = argc > 1 && strcmp(argv[1], "--twinkle") == 0;
    const bool camera = argc > 2 && strcmp(argv[1], "--camera") == 0;
    const int first = twinkle ? 2 : camera ? 3 : 1;
    request r = { .camera = camera ? find_camera(argv[2]) : 0 };
    int code = EXIT_DONE;

    if (r.camera == CAMERAS || argc < first + 3 || (twinkle && argc != first + 3)
        || !read_request(argv + first, &r))
        return usage();
    for (int i = first + 2; i < argc && !code; i++) {
        uint32_t tick;
        if (!read_number(argv[i], 0, &tick))
            return usage();
        code = twinkle ? print_twinkle(&r, tick) : print_errors(&r, tick);
    }
    return code;
}
