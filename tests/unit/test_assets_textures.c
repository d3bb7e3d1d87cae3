/* SPDX-License-Identifier: MIT */
/* The pictures as they lie in assets/: seamless, balanced, normal maps of unit length.
 * Run in the sources' top folder, or name it in TP_ROOT. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <png.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

static FILE *open_asset(const char *name)
{
    const char *root = getenv("TP_ROOT");
    char path[1024];
    assert_true(snprintf(path, sizeof path, "%s/assets/%s", root ? root : ".", name)
                < (int)sizeof path);
    FILE *file = fopen(path, "rb");
    if (!file)
        fail_msg("%s cannot be opened", path);
    return file;
}

typedef struct {
    int w, h;
    uint8_t *rgb;
} picture;

static picture read_picture(const char *name)
{
    FILE *file = open_asset(name);
    png_image png = { .version = PNG_IMAGE_VERSION };
    assert_true(png_image_begin_read_from_stdio(&png, file));
    png.format = PNG_FORMAT_RGB;
    picture p = { (int)png.width, (int)png.height, malloc(PNG_IMAGE_SIZE(png)) };
    assert_non_null(p.rgb);
    assert_true(png_image_finish_read(&png, NULL, p.rgb, 0, NULL));
    fclose(file);
    return p;
}

/* Mean difference of colour between columns (or rows) a and b. */
static double step_between(const picture *p, int a, int b, bool rows)
{
    int n = rows ? p->w : p->h, sum = 0;
    for (int i = 0; i < 3 * n; i++) {
        int along = i / 3, one = rows ? a * p->w + along : along * p->w + a;
        int two = rows ? b * p->w + along : along * p->w + b;
        sum += abs(p->rgb[3 * one + i % 3] - p->rgb[3 * two + i % 3]);
    }
    return sum / (3.0 * n);
}

/* The seam is a step like the others: no bigger than twice the mean one. */
static void check_seam(const picture *p, const char *name, bool rows)
{
    int sides = rows ? p->h : p->w;
    double sum = 0.0, seam = step_between(p, sides - 1, 0, rows);
    for (int i = 0; i + 1 < sides; i++)
        sum += step_between(p, i, i + 1, rows);
    if (seam > 2.0 * sum / (sides - 1))
        fail_msg("%s: seam %.2f, other steps %.2f", name, seam, sum / (sides - 1));
}

static void textures_tile_without_a_seam(void **state)
{
    static const char *const tiles[] = {
        "textures/water.png",      "textures/water-normal.png", "textures/noise.png",
        "textures/distortion.png", "textures/foam.png",         "textures/lava.png",
    };
    (void)state;
    for (size_t i = 0; i < sizeof tiles / sizeof tiles[0]; i++) {
        picture p = read_picture(tiles[i]);
        check_seam(&p, tiles[i], false);
        check_seam(&p, tiles[i], true);
        free(p.rgb);
    }
    picture sky = read_picture("skies/day.png");
    check_seam(&sky, "day.png", false);
    free(sky.rgb);
}

static double mean_channel(const picture *p, int channel)
{
    double sum = 0.0;
    for (int i = 0; i < p->w * p->h; i++)
        sum += p->rgb[3 * i + channel];
    return sum / (p->w * p->h);
}

static void water_is_pale_and_distortion_rests_at_128(void **state)
{
    (void)state;
    picture water = read_picture("textures/water.png");
    double mean =
        (mean_channel(&water, 0) + mean_channel(&water, 1) + mean_channel(&water, 2)) / 3;
    assert_true(mean > 195.0 && mean < 205.0);
    free(water.rgb);
    picture push = read_picture("textures/distortion.png");
    assert_true(fabs(mean_channel(&push, 0) - 128.0) < 1.0);
    assert_true(fabs(mean_channel(&push, 1) - 128.0) < 1.0);
    free(push.rgb);
}

/* The steepest slope of a normal map whose normals are unit within 8 bits' rounding. */
static double steepest_slope(const char *name)
{
    picture p = read_picture(name);
    double steepest = 0.0;
    for (int i = 0; i < p.w * p.h; i++) {
        double x = p.rgb[3 * i] / 127.5 - 1.0, y = p.rgb[3 * i + 1] / 127.5 - 1.0;
        double z = p.rgb[3 * i + 2] / 127.5 - 1.0;
        assert_true(fabs(sqrt(x * x + y * y + z * z) - 1.0) < .01);
        assert_true(z > 0.0);
        steepest = fmax(steepest, hypot(x, y) / z);
    }
    free(p.rgb);
    print_message("%s: steepest %.3f\n", name, steepest);
    return steepest;
}

static void ripples_are_unit_normals_of_slopes_to_a_third(void **state)
{
    (void)state;
    double steepest = steepest_slope("textures/water-normal.png");
    assert_true(steepest > .25 && steepest < .36);
}

static void the_ship_s_normal_maps_are_unit(void **state)
{
    (void)state;
    assert_true(steepest_slope("boats/wood-normal.png") > .5);
    assert_true(steepest_slope("boats/carving-normal.png") > .5);
    assert_true(steepest_slope("boats/sail-normal.png") > .2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(textures_tile_without_a_seam),
        cmocka_unit_test(water_is_pale_and_distortion_rests_at_128),
        cmocka_unit_test(ripples_are_unit_normals_of_slopes_to_a_third),
        cmocka_unit_test(the_ship_s_normal_maps_are_unit),
    };
    return cmocka_run_group_tests_name("textures", tests, NULL, NULL);
}
