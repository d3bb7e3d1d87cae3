/* SPDX-License-Identifier: MIT */
/* reference SCENE: draws the picture that the engine's picture is compared with. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/picture.h"
#include "image.h"
#include "shipped_scene.h"

enum { SETTINGS = 64 };

typedef struct {
    const char *scene, *out;
    const char *setting[SETTINGS];
    uint32_t    settings, width, height, samples, frame, threads;
    bool        mesh;
} reference_options;

static void print_help(void)
{
    puts("usage: reference SCENE --out FILE.png [OPTION]...\n"
         "Draws one frame in double precision: each ray meets the exact surface.\n"
         "  --size WxH         320x240 by default\n"
         "  --samples N        a pixel: 1, 4, 16 or 64; 16 by default\n"
         "  --frame N          the world after N ticks of 1/60 s\n"
         "  --set NAME=VALUE   change one parameter of the scene; may be repeated\n"
         "  --threads N        2 by default\n"
         "  --levels           pictures have the engine's mipmap levels: to compare\n"
         "                     1 sample");
}

static bool read_number(const char *text, uint32_t low, uint32_t high, uint32_t *number)
{
    char *end;
    const unsigned long n = strtoul(text, &end, 10);

    if (*text < '0' || *text > '9' || *end || n < low || n > high)
        return false;
    *number = (uint32_t)n;
    return true;
}

static bool read_size(const char *text, reference_options *w)
{
    char wide[8] = "";
    const char *by = strchr(text, 'x');

    if (!by || by - text >= (int)sizeof wide)
        return false;
    memcpy(wide, text, (size_t)(by - text));
    return read_number(wide, 1, 4096, &w->width)
        && read_number(by + 1, 1, 4096, &w->height);
}

/* Reads one option. Returns false if the option is unknown or its value is invalid. */
static bool read_option(const char *name, const char *value, reference_options *w)
{
    if (strcmp(name, "--out") == 0)
        return (w->out = value) != NULL;
    if (strcmp(name, "--size") == 0)
        return read_size(value, w);
    if (strcmp(name, "--frame") == 0)
        return read_number(value, 0, 10000000, &w->frame);
    if (strcmp(name, "--threads") == 0)
        return read_number(value, 1, 64, &w->threads);
    if (strcmp(name, "--samples") == 0)
        return read_number(value, 1, 64, &w->samples)
            && (w->samples == 1 || w->samples == 4 || w->samples == 16
                || w->samples == 64);
    if (strcmp(name, "--set") == 0 && w->settings < SETTINGS)
        w->setting[w->settings++] = value;
    return strcmp(name, "--set") == 0 && w->settings <= SETTINGS;
}

static int read_words(int argc, char **argv, reference_options *w)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--levels") == 0)
            w->mesh = true;
        else if (argv[i][0] != '-' && !w->scene)
            w->scene = argv[i];
        else if (i + 1 >= argc || !read_option(argv[i], argv[i + 1], w))
            return log_fail(EXIT_USAGE, "reference: %s is not understood", argv[i]);
        else
            i++;
    }
    if (!w->scene || !w->out)
        return log_fail(EXIT_USAGE, "reference: it takes SCENE and --out FILE.png");
    return EXIT_DONE;
}

static int write_image(const ref_image *image, const char *name)
{
    const size_t pixels = (size_t)image->width * image->height;
    picture p = { TP_FORMAT_XRGB8888, image->width, image->height, image->width * 4,
                  malloc(pixels * 4) };

    if (!p.rows)
        return log_fail_memory(pixels * 4);
    for (uint32_t y = 0; y < p.height; y++)
        for (uint32_t x = 0; x < p.width; x++) {
            const uint32_t pixel = ref_image_pixel(image, x, y);
            memcpy(p.rows + y * p.row_bytes + x * 4, &pixel, 4);
        }
    const int code = picture_write_png(&p, name);
    free(p.rows);
    return code;
}

static int draw(const reference_options *w, const ref_stand *stand)
{
    ref_scene scene;
    ref_image image;

    ref_scene_open(&scene, &stand->file.scene, &stand->assets.names, stand->world,
                   w->width, w->height, w->mesh);
    ref_image_draw(&image, &scene, w->width, w->height, w->samples, w->threads);
    const int code = write_image(&image, w->out);
    ref_image_free(&image);
    ref_scene_close(&scene);
    return code;
}

int main(int argc, char **argv)
{
    reference_options w = { .width = 320, .height = 240, .samples = REF_SAMPLES,
                 .threads = 2 };
    ref_stand stand = { 0 };

    if (argc < 2 || strcmp(argv[1], "--help") == 0) {
        print_help();
        return argc < 2 ? EXIT_USAGE : EXIT_DONE;
    }
    int code = read_words(argc, argv, &w);
    if (!code)
        code = ref_stand_open(&stand, w.scene, w.setting, w.settings, w.frame);
    if (!code)
        code = draw(&w, &stand);
    ref_stand_close(&stand);
    return code;
}
