/* SPDX-License-Identifier: MIT */
/* Errors of the pictures of span.h, as rows of the sweep; NAME is the baked scene's.
 *
 *     span_errors-NAME span NAME      steps, against places in double precision
 *     span_errors-NAME filter NAME    filters and rates, against 8 x 8 samples a pixel:
 *                                     the exact stages' picture, eight times as large
 *     span_errors-NAME truth NAME     those samples of level water, against rays of the
 *                                     reference */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "raster/raster.h"
#include "tests/charts/span.h"
#include "tests/charts/span_used.h"
#include "tools/reference/image.h"
#include "tidepool/modules.h"

enum { WIDTH = 320, HEIGHT = 240, COUNT = WIDTH * HEIGHT, PARTS = 8, RAYS = 64 };

typedef struct {
    uint32_t pixel[COUNT], s[COUNT], t[COUNT];
    bool     water[COUNT];      /* the whole pixel is water */
} span_drawing;

static span_scene now;
static tp_world  *world;

static void *need(size_t bytes)
{
    void *block = calloc(1, bytes);

    if (!block)
        abort();
    return block;
}

static void stop(const char *why)
{
    fprintf(stderr, "span_errors: %s\n", why);
    exit(EXIT_FAILURE);
}

/* -- pictures ------------------------------------------------------------------------ */

static void gather(span_drawing *to, const uint32_t *samples, const uint32_t *pixels,
                   uint32_t parts)
{
    const uint32_t plane = COUNT * parts * parts, each = parts * parts;

    for (uint32_t i = 0; i < COUNT; i++) {
        uint32_t sum[3] = { 0, 0, 0 }, water = 0, at = 0;
        for (uint32_t k = 0; k < each; k++) {
            at = (i / WIDTH * parts + k / parts) * WIDTH * parts
               + i % WIDTH * parts + k % parts;
            water += TP_MARK(samples[at]) == TP_MARK_WATER;
            for (int c = 0; c < 3; c++)
                sum[c] += pixels[at] >> 8 * c & 255;
        }
        to->pixel[i] = 0;
        for (int c = 0; c < 3; c++)
            to->pixel[i] |= (sum[c] + each / 2) / each << 8 * c;
        to->water[i] = water == each;
        to->s[i] = samples[plane + at];
        to->t[i] = samples[2 * plane + at];
    }
}

/* Draws the present scene with `parts` x `parts` samples a pixel. */
static void draw(span_drawing *to, uint32_t parts)
{
    const tp_config config = { .width = WIDTH * parts,
                               .height = HEIGHT * parts,
                               .tile_height = HEIGHT * parts,
                               .assets = &now.assets };
    const size_t world_bytes = tp_world_bytes(&tp_program_all, &now.scene, &now.assets);
    void *block = need(tp_frame_bytes(&config, &now.scene));
    uint32_t *scratch = need(tp_frame_scratch_bytes(&config, &now.scene));
    tp_frame *frame;
    tp_tile   tile;

    free(world);
    world = need(world_bytes);
    if (tp_frame_init(&frame, &config, &now.scene, block,
                      tp_frame_bytes(&config, &now.scene), NULL)
        || tp_world_init(&tp_program_all, world, world_bytes, &now.scene, &now.assets,
                         NULL))
        stop("a scene cannot be drawn");
    tp_frame_begin(frame, world);
    tp_frame_draw_tile(frame, 0, scratch, &tile);
    gather(to, scratch, tile.pixels, parts);
    free(scratch);
    free(block);
}

static void begin(const span_row *row)
{
    if (!span_begin(&now, row))
        stop("a setting is not understood");
}

/* -- errors -------------------------------------------------------------------------- */

typedef struct {
    double colour, psnr;        /* rms of 255 of the worst channel; dB of all three */
    double texels, texels_most; /* of the first layer's finest level, rms and largest */
} span_error;

static double square_apart(uint32_t a, uint32_t b, int c)
{
    const double d = (double)(a >> 8 * c & 255) - (b >> 8 * c & 255);
    return d * d;
}

static double texels_apart(const span_drawing *a, const span_drawing *b, size_t i)
{
    const double per = (1u << now.assets.layer[0]->log2_w)
                     / (double)now.scene.layer[0].map.size;
    return per * hypot((int32_t)(a->s[i] - b->s[i]), (int32_t)(a->t[i] - b->t[i]));
}

static span_error error_of(const span_drawing *truth, const span_drawing *b)
{
    double sum[3] = { 0, 0, 0 }, texels = 0, most = 0;
    size_t count = 0;

    for (size_t i = 0; i < COUNT; i++) {
        if (!truth->water[i] || !b->water[i])
            continue;
        const double off = texels_apart(truth, b, i);
        texels += off * off;
        most = fmax(most, off);
        count++;
        for (int c = 0; c < 3; c++)
            sum[c] += square_apart(truth->pixel[i], b->pixel[i], c);
    }
    if (count == 0)
        stop("there is no water");
    const double n = (double)count;
    return (span_error){ sqrt(fmax(sum[0], fmax(sum[1], sum[2])) / n),
                         10 * log10(255 * 255 * 3 * n / (sum[0] + sum[1] + sum[2])),
                         sqrt(texels / n), most };
}

static char point[64];

static const char *point_of(const span_row *row, const char *name)
{
    snprintf(point, sizeof point, "%s%s%s", row->from ? "" : name, row->from ? "" : ";",
             row->key);
    return point;
}

static void say(const char *chart, const char *column, double value)
{
    if (isfinite(value))
        printf("%s,%s,%s,%.4g\n", chart, point, column, value);
}

/* -- scenes that use a row ----------------------------------------------------------- */

static bool by_triangles(const tp_scene *scene, const tp_rungs *rungs, const void *of)
{
    (void)scene, (void)of;
    return rungs->visibility == TP_VISIBILITY_TRIANGLES;
}

/* True if the scene is drawn with the row's settings; scenes without textures have no
 * filter. */
static bool as_row(const tp_scene *scene, const tp_rungs *rungs, const void *of)
{
    const tp_scene *row = of;

    return scene->layer[0].map.texture[0] != '\0'
        && (int32_t)rungs->shading == row->quality.shading
        && (int32_t)rungs->rate == row->quality.rate
        && (rungs->shading == TP_SHADING_QUICK
            || scene->water.filter == row->water.filter);
}

/* -- charts -------------------------------------------------------------------------- */

static span_drawing truth, other;

static void judge_steps(const char *name)
{
    for (const span_row *row = span_rows; row->chart; row++) {
        if (strcmp(row->chart, "span") != 0 || (row->from && strcmp(row->from, name) != 0))
            continue;
        begin(row);
        draw(&other, 1);
        span_step = SPAN_TRUE;
        draw(&truth, 1);
        const span_error e = error_of(&truth, &other);
        point_of(row, name);
        say("span", "texels_rms", e.texels);
        say("span", "texels_max", e.texels_most);
        say("span", "colour_rms", e.colour);
        say("span", "psnr", e.psnr);
        printf("span,%s,used,%s\n", point,
               row->step == 16 ? span_used(by_triangles, NULL) : "-");
    }
}

/* Reference samples: bilinear texels of all levels at each pixel, eight times the size
 * along each axis. */
static void begin_samples(void)
{
    const span_row *row = span_rows;

    while (strcmp(row->chart, "filter") != 0 || strcmp(row->key, "linear;full") != 0)
        row++;
    begin(row);
}

static void judge_filters(const char *name)
{
    begin_samples();
    draw(&truth, PARTS);
    for (const span_row *row = span_rows; row->chart; row++) {
        if (strcmp(row->chart, "filter") != 0)
            continue;
        begin(row);
        draw(&other, 1);
        const span_error e = error_of(&truth, &other);
        point_of(row, name);
        say("filter", "colour_rms", e.colour);
        say("filter", "psnr", e.psnr);
        printf("filter,%s,used,%s\n", point,
               row->one_level ? "-" : span_used(as_row, &now.scene));
    }
}

/* Level water only: a mesh of waves differs more from the exact surface than the filters
 * differ from each other. */
static void judge_samples(const char *name)
{
    ref_scene scene;
    ref_image image;

    begin_samples();
    for (int i = 0; i < TP_WAVES; i++)
        now.scene.wave[i].amplitude = 0;
    draw(&truth, PARTS);
    ref_scene_open(&scene, &now.scene, &now.assets, world, WIDTH, HEIGHT, false);
    ref_image_draw(&image, &scene, WIDTH, HEIGHT, RAYS, 1);
    other = truth;
    for (uint32_t i = 0; i < COUNT; i++)
        other.pixel[i] = ref_image_pixel(&image, i % WIDTH, i / WIDTH);
    const span_error e = error_of(&truth, &other);
    for (const span_row *row = span_rows; row->chart; row++)
        if (strcmp(row->chart, "filter") == 0) {
            point_of(row, name);
            say("filter", "floor_rms", e.colour);
        }
    ref_image_free(&image);
    ref_scene_close(&scene);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *chart;
        void (*judge)(const char *name);
    } charts[] = {
        { "span", judge_steps }, { "filter", judge_filters }, { "truth", judge_samples },
    };

    for (size_t i = 0; argc == 3 && i < sizeof charts / sizeof *charts; i++)
        if (strcmp(argv[1], charts[i].chart) == 0) {
            charts[i].judge(argv[2]);
            return EXIT_SUCCESS;
        }
    fprintf(stderr, "usage: span_errors-NAME span|filter|truth NAME\n");
    return 2;
}
