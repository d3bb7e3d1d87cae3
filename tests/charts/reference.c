/* SPDX-License-Identifier: MIT */
/* Convergence of the reference renderer, measured against itself.
 *
 *     reference samples WIDTH HEIGHT TICK SCENE...
 *         rows of the chart reference-samples: 1, 4, 16 and 64 samples a pixel against
 *         256, and the slope of a line through their logarithms
 *     reference tolerance WIDTH HEIGHT TICK SCENE...
 *         rows of reference-tolerance: accuracy of a ray's root, 1e-2 to 1e-10 m,
 *         against 1e-12, with one sample a pixel
 *     reference times WIDTH HEIGHT TICK SCENE...
 *         time of these pictures on this machine, ms, least of three runs
 *
 * Differences are of 255, before rounding. Differences below 1e-6 are raised to 1e-6:
 * smaller ones depend on the C library's functions. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/timing.h"
#include "tests/charts/words.h"
#include "tools/reference/image.h"
#include "tools/reference/shipped_scene.h"

#define FOLDER "assets/scenes/"
#define LEAST  1e-6

enum { TRUTH = 256, SHARPEST = 12, COARSEST = 2, FINEST = 10, REPEATS = 3 };

static const uint32_t samples[] = { 1, 4, 16, 64 };
enum { COUNTS = sizeof samples / sizeof *samples };

typedef struct {
    const char *name;
    uint32_t    width, height;
    ref_stand   stand;
    ref_scene   scene;
} reference_place;

static ref_image draw(reference_place *p, uint32_t count, double close)
{
    ref_image image;

    p->scene.surface.close = close;
    ref_image_draw(&image, &p->scene, p->width, p->height, count, 1);
    return image;
}

/* -- differences --------------------------------------------------------------------- */

typedef struct {
    double rms, most;
} reference_difference;

static reference_difference apart(const ref_image *a, const ref_image *b)
{
    const size_t pixels = (size_t)a->width * a->height;
    reference_difference d = { 0, 0 };

    for (size_t i = 0; i < pixels; i++)
        for (int k = 0; k < 3; k++) {
            const double off = a->colour[i].c[k] - b->colour[i].c[k];
            d.rms += off * off;
            d.most = fmax(d.most, fabs(off));
        }
    d.rms = fmax(LEAST, sqrt(d.rms / (3.0 * (double)pixels)));
    d.most = fmax(LEAST, d.most);
    return d;
}

/* Slope of ln rms over ln samples, by least squares. */
static double slope_of(const reference_difference d[COUNTS])
{
    double x = 0, y = 0, xx = 0, xy = 0;

    for (int i = 0; i < COUNTS; i++) {
        const double u = log(samples[i]) / COUNTS, v = log(d[i].rms) / COUNTS;
        x += u;
        y += v;
        xx += u * u * COUNTS;
        xy += u * v * COUNTS;
    }
    return (xy - x * y) / (xx - x * x);
}

static void row(const char *chart, const reference_place *p, const char *point,
                const char *column, double value)
{
    printf("%s,%s;%ux%u;%s,%s,%.4g\n", chart, p->name, (unsigned)p->width,
           (unsigned)p->height, point, column, value);
}

/* Row "used": pictures with this setting are the references of other charts, in each
 * scene. */
static void used_row(const char *chart, const reference_place *p, const char *point,
                     bool used)
{
    printf("%s,%s;%ux%u;%s,used,%s\n", chart, p->name, (unsigned)p->width,
           (unsigned)p->height, point, used ? "all" : "-");
}

/* -- command line -------------------------------------------------------------------- */

static void judge_samples(reference_place *p)
{
    static const char chart[] = "reference-samples";
    ref_image truth = draw(p, TRUTH, REF_CLOSE);
    reference_difference d[COUNTS];

    for (int i = 0; i < COUNTS; i++) {
        ref_image image = draw(p, samples[i], REF_CLOSE);
        d[i] = apart(&image, &truth);
        ref_image_free(&image);
    }
    for (int i = 0; i < COUNTS; i++) {
        char point[16];
        snprintf(point, sizeof point, "%u", (unsigned)samples[i]);
        row(chart, p, point, "rms", d[i].rms);
        row(chart, p, point, "most", d[i].most);
        row(chart, p, point, "slope", slope_of(d));
        used_row(chart, p, point, samples[i] == REF_SAMPLES);
    }
    ref_image_free(&truth);
}

static void judge_tolerance(reference_place *p)
{
    static const char chart[] = "reference-tolerance";
    ref_image truth = draw(p, 1, pow(10, -SHARPEST));

    for (int n = COARSEST; n <= FINEST; n++) {
        const double close = pow(10, -n);
        ref_image image = draw(p, 1, close);
        const reference_difference d = apart(&image, &truth);
        char point[16];
        snprintf(point, sizeof point, "1e-%02d", n);
        row(chart, p, point, "rms", d.rms);
        row(chart, p, point, "most", d.most);
        used_row(chart, p, point, fabs(log(close / REF_CLOSE)) < 0.1);
        ref_image_free(&image);
    }
    ref_image_free(&truth);
}

static void time_tolerance(reference_place *p)
{
    for (int n = COARSEST; n <= FINEST; n++) {
        uint64_t least = UINT64_MAX;
        char point[16];
        for (int i = 0; i < REPEATS; i++) {
            const uint64_t begin = processor_us();
            ref_image image = draw(p, 1, pow(10, -n));
            const uint64_t took = processor_us() - begin;
            least = took < least ? took : least;
            ref_image_free(&image);
        }
        snprintf(point, sizeof point, "1e-%02d", n);
        row("reference-tolerance", p, point, "ms", (double)least / 1000);
    }
}

static int judge(const char *name, uint32_t width, uint32_t height, uint32_t tick,
                 void (*how)(reference_place *))
{
    reference_place p = { .name = name, .width = width, .height = height };
    char path[128];

    snprintf(path, sizeof path, FOLDER "%s.ini", name);
    const int code = ref_stand_open(&p.stand, path, NULL, 0, tick);
    if (!code) {
        ref_scene_open(&p.scene, &p.stand.file.scene, &p.stand.assets.names,
                       p.stand.world, width, height, false);
        how(&p);
        ref_scene_close(&p.scene);
    }
    ref_stand_close(&p.stand);
    return code;
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        void      (*how)(reference_place *);
    } ways[] = {
        { "samples", judge_samples }, { "tolerance", judge_tolerance },
        { "times", time_tolerance },
    };

    for (size_t w = 0; argc > 5 && w < sizeof ways / sizeof *ways; w++) {
        if (strcmp(argv[1], ways[w].name) != 0)
            continue;
        int code = 0;
        for (int i = 5; i < argc && !code; i++)
            code = judge(argv[i], word_number(argv[2]), word_number(argv[3]),
                         word_number(argv[4]), ways[w].how);
        return code;
    }
    fprintf(stderr, "usage: reference samples|tolerance|times WIDTH HEIGHT TICK "
                    "SCENE...\n");
    return 2;
}
