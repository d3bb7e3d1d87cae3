/* SPDX-License-Identifier: MIT */
/* The textures in assets/: seamless, balanced, normal maps of unit length, cubes with
 * continuous edges.  The working folder is the top folder of the sources, or TP_ROOT names
 * that folder. */
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
#include "tests/lib/asset_files.h"

typedef struct {
    int w, h;
    uint8_t *rgb;
} texture_picture;

static texture_picture read_format(const char *name, png_uint_32 format)
{
    FILE *file = open_asset(name);
    png_image png = { .version = PNG_IMAGE_VERSION };
    assert_true(png_image_begin_read_from_stdio(&png, file));
    png.format = format;
    texture_picture p = { (int)png.width, (int)png.height, malloc(PNG_IMAGE_SIZE(png)) };
    assert_non_null(p.rgb);
    assert_true(png_image_finish_read(&png, NULL, p.rgb, 0, NULL));
    fclose(file);
    return p;
}

static texture_picture read_picture(const char *name)
{
    return read_format(name, PNG_FORMAT_RGB);
}

/* Mean colour difference between columns (or rows) a and b. */
static double step_between(const texture_picture *p, int a, int b, bool rows)
{
    int n = rows ? p->w : p->h, sum = 0;
    for (int i = 0; i < 3 * n; i++) {
        int along = i / 3, one = rows ? a * p->w + along : along * p->w + a;
        int two = rows ? b * p->w + along : along * p->w + b;
        sum += abs(p->rgb[3 * one + i % 3] - p->rgb[3 * two + i % 3]);
    }
    return sum / (3.0 * n);
}

/* The step across the seam is at most twice the mean step between neighbours. */
static void check_seam(const texture_picture *p, const char *name, bool rows)
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
        "textures/crests.png",     "textures/lava-crust.png",   "textures/lava-glow.png",
        "textures/tiles.png",      "textures/stone.png",        "textures/sand.png",
        "textures/pebbles.png",
    };
    (void)state;
    for (size_t i = 0; i < sizeof tiles / sizeof tiles[0]; i++) {
        texture_picture p = read_picture(tiles[i]);
        check_seam(&p, tiles[i], false);
        check_seam(&p, tiles[i], true);
        free(p.rgb);
    }
}

static double mean_channel(const texture_picture *p, int channel)
{
    double sum = 0.0;
    for (int i = 0; i < p->w * p->h; i++)
        sum += p->rgb[3 * i + channel];
    return sum / (p->w * p->h);
}

static void water_is_pale_and_distortion_rests_at_128(void **state)
{
    (void)state;
    texture_picture water = read_picture("textures/water.png");
    double mean =
        (mean_channel(&water, 0) + mean_channel(&water, 1) + mean_channel(&water, 2)) / 3;
    assert_true(mean > 195.0 && mean < 205.0);
    free(water.rgb);
    texture_picture push = read_picture("textures/distortion.png");
    assert_true(fabs(mean_channel(&push, 0) - 128.0) < 1.0);
    assert_true(fabs(mean_channel(&push, 1) - 128.0) < 1.0);
    free(push.rgb);
}

/* A threshold at t leaves 1 - t / 256 of the texture. */
static void foam_s_greys_stand_equally_often(void **state)
{
    int count[256] = { 0 }, below = 0;
    double worst = 0.0;
    (void)state;
    texture_picture foam = read_picture("textures/foam.png");
    for (int i = 0; i < foam.w * foam.h; i++)
        count[foam.rgb[3 * i]]++;
    for (int t = 0; t < 256; t++) {
        worst = fmax(worst, fabs((double)below / (foam.w * foam.h) - t / 256.0));
        below += count[t];
    }
    print_message("foam: worst coverage off by %.4f\n", worst);
    assert_true(worst < .01);
    free(foam.rgb);
}

static void crests_are_threads_on_black(void **state)
{
    (void)state;
    texture_picture crests = read_picture("textures/crests.png");
    double mean = mean_channel(&crests, 1);
    print_message("crests: mean %.1f\n", mean);
    assert_true(mean > 8.0 && mean < 40.0);
    free(crests.rgb);
}

/* Steepest slope of a normal map; asserts unit normals within the rounding of 8 bits. */
static double steepest_slope(const char *name)
{
    texture_picture p = read_picture(name);
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

/* -- skies --------------------------------------------------------------------------- */

typedef struct {
    const char *name;
    int ahead[3], right[3], down[3];
} cube_face;

/* The faces as seen by an eye in the middle of the cube. */
static const cube_face faces[6] = {
    { "east", { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } },
    { "west", { -1, 0, 0 }, { 0, 0, -1 }, { 0, -1, 0 } },
    { "up", { 0, 1, 0 }, { -1, 0, 0 }, { 0, 0, 1 } },
    { "down", { 0, -1, 0 }, { -1, 0, 0 }, { 0, 0, -1 } },
    { "south", { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 } },
    { "north", { 0, 0, -1 }, { 1, 0, 0 }, { 0, -1, 0 } },
};

typedef struct {
    texture_picture face[6];
} cube;

static cube read_cube(const char *sky)
{
    cube c;
    for (int i = 0; i < 6; i++) {
        char name[64];
        snprintf(name, sizeof name, "skies/%s-%s.png", sky, faces[i].name);
        c.face[i] = read_format(name, PNG_FORMAT_RGBA);
        assert_int_equal(c.face[i].w, c.face[i].h);
        assert_int_equal(c.face[i].w, c.face[0].w);
    }
    return c;
}

static void free_cube(cube *c)
{
    for (int i = 0; i < 6; i++)
        free(c->face[i].rgb);
}

static int dot(const int a[3], const int b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Texel of face f at a point of the cube; the cube has half side n. */
static const uint8_t *texel_of(const cube *c, int f, const int at[3], int n)
{
    int column = (dot(at, faces[f].right) + n) / 2, row = (dot(at, faces[f].down) + n) / 2;
    column = column < n ? column : n - 1;
    row = row < n ? row : n - 1;
    return c->face[f].rgb + 4 * (row * n + column);
}

/* Mean difference of the texels on both sides of the edge between two faces. */
static double step_over(const cube *c, int f, int g)
{
    int n = c->face[0].w, sum = 0;
    for (int i = 0; i < n; i++) {
        int at[3];
        for (int k = 0; k < 3; k++) {
            int edge = faces[f].ahead[k] + faces[g].ahead[k];
            at[k] = edge != 0 ? edge * n : 2 * i + 1 - n;
        }
        const uint8_t *a = texel_of(c, f, at, n), *b = texel_of(c, g, at, n);
        for (int k = 0; k < 4; k++)
            sum += abs(a[k] - b[k]);
    }
    return sum / (4.0 * n);
}

static void skies_join_along_their_twelve_edges(void **state)
{
    static const char *const skies[] = { "day", "dusk", "night" };
    (void)state;
    for (int s = 0; s < 3; s++) {
        cube c = read_cube(skies[s]);
        double worst = 0.0;
        int edges = 0;
        for (int f = 0; f < 6; f++) {
            for (int g = 0; g < f; g++) {
                if (dot(faces[f].ahead, faces[g].ahead) != 0)
                    continue;
                worst = fmax(worst, step_over(&c, f, g));
                edges++;
            }
        }
        print_message("%s: steepest edge %.2f levels\n", skies[s], worst);
        assert_int_equal(edges, 12);
        assert_true(worst < 2.0);
        free_cube(&c);
    }
}

/* Angle in degrees between a texel and the direction of a heading and elevation. */
static double degrees_off(int f, int column, int row, int n, double heading, double up)
{
    double at[3], sun[3] = { cos(up) * sin(heading), sin(up), -cos(up) * cos(heading) };
    double along = 0.0, square = 0.0;
    for (int k = 0; k < 3; k++) {
        at[k] = faces[f].ahead[k] * n + faces[f].right[k] * (2 * column + 1 - n)
                + faces[f].down[k] * (2 * row + 1 - n);
        along += at[k] * sun[k];
        square += at[k] * at[k];
    }
    return acos(fmin(1.0, along / sqrt(square))) * 180.0 / acos(-1.0);
}

/* Asserts that alpha is full somewhere, and only near the single light. */
static void check_alpha(const char *sky, double heading, double elevation, double reach)
{
    cube c = read_cube(sky);
    double degree = acos(-1.0) / 180.0;
    int n = c.face[0].w, full = 0, stray = 0;
    for (int i = 0; i < 6 * n * n; i++) {
        int f = i / (n * n), column = i % n, row = i / n % n;
        int alpha = c.face[f].rgb[4 * (i % (n * n)) + 3];
        double off =
            degrees_off(f, column, row, n, heading * degree, elevation * degree);
        full += alpha == 255 && off < 2.0;
        stray += alpha > 0 && off > reach;
        stray += alpha > 200 && off > 2.0;
    }
    free_cube(&c);
    if (full < 8 || stray > 0)
        fail_msg("%s: %d full texels, %d stray", sky, full, stray);
}

static void alpha_is_the_sun_s_and_the_moon_s(void **state)
{
    (void)state;
    check_alpha("day", 225, 42, 4);
    check_alpha("dusk", 270, 6, 4);
    check_alpha("night", 6, 20, 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(textures_tile_without_a_seam),
        cmocka_unit_test(water_is_pale_and_distortion_rests_at_128),
        cmocka_unit_test(foam_s_greys_stand_equally_often),
        cmocka_unit_test(crests_are_threads_on_black),
        cmocka_unit_test(ripples_are_unit_normals_of_slopes_to_a_third),
        cmocka_unit_test(the_ship_s_normal_maps_are_unit),
        cmocka_unit_test(skies_join_along_their_twelve_edges),
        cmocka_unit_test(alpha_is_the_sun_s_and_the_moon_s),
    };
    return cmocka_run_group_tests_name("assets/textures", tests, NULL, NULL);
}
