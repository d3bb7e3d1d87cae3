/* SPDX-License-Identifier: MIT */
/* Paints the scenes' own textures and the sky, in integers, the same everywhere.
 *
 *     cc -std=c11 -O2 assets/textures/?*.c -lpng -o textures
 *     ./textures assets/textures assets/skies
 *
 * water.png         256x256  pale net of light with streaks, mean 200: multiply a colour
 * water-normal.png  256x256  capillary ripples, tangent space, green up, slopes to 0.35
 * noise.png         256x256  grey, six octaves
 * distortion.png     64x64   red and green: smooth offsets, 128 is none
 * foam.png          256x256  white bubbles and films on black
 * lava.png          256x256  cooling crust over glowing cracks
 * day.png           256x128  the sky's upper half: azimuth along s from -z by +x, the top
 *                            row is the zenith, the bottom row the horizon
 * All but day.png tile both ways, day.png along s.  The pictures are CC0-1.0. */
#include "canvas.h"
#include "maps.h"

#include <stdio.h>

enum { SIDE = 256 };

/* A signed offset from noise of n cells a tile, +-reach / 256 of a pixel about 0. */
static int offset_q8(int x, int y, int n, int octaves, int reach_px, uint32_t seed)
{
    return (fractal(x, y, SIDE, SIDE, n, n, octaves, seed) - 32768) * reach_px / 128;
}

/* How near, 0..256, a point lies to the border between cells; `width` in 1/256 cell. */
static int border(const cells *c, int width)
{
    int gap = clamp_int(c->next - c->near, 0, width);
    int t = 256 - gap * 256 / width;
    return t * t / 256;
}

/* Cells of a warped tile.  The warp is what makes straight borders run like water. */
static cells warped_cells(int x, int y, int n, int reach_px, uint32_t seed)
{
    int32_t px = x * 256 + offset_q8(x, y, n, 3, reach_px, seed + 100);
    int32_t py = y * 256 + offset_q8(x, y, n, 3, reach_px, seed + 200);
    return cells_at(px * n / SIDE, py * n / SIDE, n, seed);
}

/* -- water --------------------------------------------------------------------------- */

static int water_light(int x, int y)
{
    cells coarse = warped_cells(x, y, 7, 26, 11);
    cells fine = warped_cells(x, y, 13, 16, 12);
    int cloud = fractal(x, y, SIDE, SIDE, 3, 4, 5, 13);
    int streak = fractal(x, y, SIDE, SIDE, 6, 18, 3, 14);
    return border(&coarse, 150) * 70 + border(&fine, 190) * 45 + coarse.near * 18
           + cloud * 2 / 5 + streak * 2 / 5;
}

static void paint_water(canvas *to)
{
    static int light[SIDE * SIDE];
    int64_t sum = 0, spread = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        light[i] = water_light(i % SIDE, i / SIDE);
        sum += light[i];
    }
    int mean = (int)(sum / (SIDE * SIDE));
    for (int i = 0; i < SIDE * SIDE; i++)
        spread += light[i] < mean ? mean - light[i] : light[i] - mean;
    spread /= SIDE * SIDE;
    for (int i = 0; i < SIDE * SIDE; i++) {
        int level = 200 + clamp_int((int)((light[i] - mean) * 14 / spread), -42, 50);
        int bright = level - 200;
        to->pixel[i] = rgb(level - 16 + bright / 4, level + 4, level + 12 - bright / 5);
    }
}

/* -- ripples ------------------------------------------------------------------------- */

enum { RIPPLES = 56, RIPPLE_SLOPE_Q16 = 1530 };

typedef struct {
    int32_t kx, ky;    /* whole waves a tile, so that the tile closes */
    int32_t length_q8; /* of (kx, ky) */
    int32_t phase_q16;
} ripple;

/* Wave vectors drawn evenly from a ring; those outside are drawn again. */
static void draw_ripples(ripple r[RIPPLES])
{
    int n = 0;
    for (int i = 0; n < RIPPLES; i++) {
        int kx = (int)(hash(i, 0, 21) % 39) - 19, ky = (int)(hash(i, 1, 21) % 39) - 19;
        int k2 = kx * kx + ky * ky;
        if (k2 < 12 || k2 > 19 * 19)
            continue;
        r[n].kx = kx;
        r[n].ky = ky;
        r[n].length_q8 = (int32_t)root_u64((uint64_t)k2 << 16);
        r[n].phase_q16 = (int32_t)(hash(i, 2, 21) >> 16);
        n++;
    }
}

/* Slopes of the sum at a point in 1/256 pixel; long waves are a little steeper. */
static void ripple_slopes(const ripple *r, int32_t x_q8, int32_t y_q8, int32_t slope[2])
{
    int64_t sx = 0, sy = 0;
    for (int i = 0; i < RIPPLES; i++) {
        int32_t phase = r[i].kx * x_q8 + r[i].ky * y_q8 + r[i].phase_q16;
        int64_t s = (int64_t)sine_q14(phase) * RIPPLE_SLOPE_Q16 / 16384;
        s = s * 2400 / (r[i].length_q8 / 2 + 1200);
        sx += s * r[i].kx * 256 / r[i].length_q8;
        sy += s * r[i].ky * 256 / r[i].length_q8;
    }
    slope[0] = (int32_t)sx;
    slope[1] = (int32_t)sy;
}

/* Reading the slopes a little uphill pulls the crests together, as real ripples do. */
static void paint_ripples(canvas *to)
{
    ripple r[RIPPLES];
    draw_ripples(r);
    for (int i = 0; i < SIDE * SIDE; i++) {
        int32_t x = i % SIDE * 256, y = i / SIDE * 256, slope[2];
        ripple_slopes(r, x, y, slope);
        ripple_slopes(r, x + slope[0] / 24, y + slope[1] / 24, slope);
        to->pixel[i] = normal_rgb(slope[0], -slope[1]);
    }
}

/* -- noise, distortion, foam --------------------------------------------------------- */

static void paint_noise(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int n = fractal(i % SIDE, i / SIDE, SIDE, SIDE, 4, 4, 6, 31);
        int level = 128 + (n - 32768) * 2 / 256;
        to->pixel[i] = rgb(level, level, level);
    }
}

/* The mean is taken off, or the distortion would push the whole picture aside. */
static void paint_distortion(canvas *to)
{
    int w = to->w, h = to->h, sum[2] = { 0, 0 };
    for (int i = 0; i < 2 * w * h; i++)
        sum[i % 2] +=
            fractal(i / 2 % w, i / 2 / w, w, h, 5, 5, 2, 41 + 2 * (uint32_t)(i % 2))
            / 128;
    for (int i = 0; i < w * h; i++) {
        int r = fractal(i % w, i / w, w, h, 5, 5, 2, 41) / 128 - sum[0] / (w * h);
        int g = fractal(i % w, i / w, w, h, 5, 5, 2, 43) / 128 - sum[1] / (w * h);
        to->pixel[i] = rgb((128 * 2 + r + 1) / 2, (128 * 2 + g + 1) / 2, 128);
    }
}

static void paint_foam(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        cells large = warped_cells(x, y, 9, 14, 51);
        cells small = warped_cells(x, y, 23, 6, 52);
        int patch = (fractal(x, y, SIDE, SIDE, 7, 7, 4, 53) - 20000) / 110;
        int film = border(&large, 120) * 3 / 4 + border(&small, 110) / 2;
        int level =
            film * clamp_int(patch + 90, 40, 300) / 256 + clamp_int(patch - 90, 0, 90);
        to->pixel[i] = rgb(level - 6, level, level + 2);
    }
}

/* -- lava ---------------------------------------------------------------------------- */

/* Black crust, dull red, orange, yellow: what a black body shows from 800 to 1400 K. */
static uint32_t glow(int heat_256)
{
    static const uint32_t ramp[6] = { 0x120c0b, 0x3a0d06, 0x9c1c04,
                                      0xe8520a, 0xffa51e, 0xfff0a0 };
    int at = clamp_int(heat_256, 0, 255) * 5;
    return rgb_mix(ramp[at / 256], ramp[at / 256 + 1], at % 256);
}

static void paint_lava(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        cells plate = warped_cells(x, y, 5, 34, 61);
        cells crack = warped_cells(x, y, 13, 14, 62);
        int rough = (fractal(x, y, SIDE, SIDE, 16, 16, 4, 63) - 32768) / 256;
        int warm = (fractal(x, y, SIDE, SIDE, 5, 5, 2, 64) - 27000) / 170;
        int heat = border(&plate, 90)
                   + border(&crack, 60) * clamp_int(warm, 20, 130) / 256
                   + clamp_int(warm, 0, 90) / 3;
        uint32_t crust = rgb(44 + rough / 3, 34 + rough / 3, 33 + rough / 3);
        to->pixel[i] =
            rgb_mix(crust, glow(heat + rough / 5), clamp_int(heat * 3 - 60, 0, 256));
    }
}

/* -- sky ----------------------------------------------------------------------------- */

static uint32_t clear_sky(int elevation_256)
{
    uint32_t low = rgb_mix(0xdbe6ea, 0x9cc3e0, clamp_int(elevation_256 * 4, 0, 256));
    return rgb_mix(low, 0x2f6bb4, elevation_256);
}

/* How much cloud, 0..256, a flat layer shows in a direction: noise read where the ray
 * meets the layer, so that clouds shrink and crowd towards the horizon. */
static int cloud_cover(int32_t azimuth_q16, int32_t elevation_q16, int32_t shift_q8)
{
    int32_t up = sine_q14(elevation_q16) + 1100;
    int32_t along = sine_q14(elevation_q16 + 16384);
    int64_t reach = (int64_t)along * 640 / up; /* 1/256 cell */
    int32_t x = (int32_t)(reach * sine_q14(azimuth_q16) / 16384) + 40000 + shift_q8;
    int32_t y = (int32_t)(reach * sine_q14(azimuth_q16 + 16384) / 16384) + 40000;
    int sum = 0;
    for (int i = 0; i < 6; i++)
        sum += noise(x * (1 << i), y * (1 << i), 1 << 14, 1 << 14, 71 + (uint32_t)i)
               >> (i + 1);
    return clamp_int((sum - 33500) / 44, 0, 256);
}

static void paint_day(canvas *to)
{
    for (int i = 0; i < to->w * to->h; i++) {
        int row = i / to->w;
        int32_t azimuth = i % to->w * 65536 / to->w;
        int32_t elevation = (2 * to->h - 1 - 2 * row) * 16384 / (2 * to->h);
        int cover = cloud_cover(azimuth, elevation, 0);
        int shade = cloud_cover(azimuth, elevation, 70); /* thickness sunwards */
        int high = elevation / 64;
        uint32_t cloud = rgb_mix(0xfafaf6, 0xb4bfcb, (cover + shade) * 3 / 8);
        uint32_t sky = clear_sky(high);
        cloud = rgb_mix(sky, cloud, clamp_int(high * 6, 0, 230));
        to->pixel[i] = rgb_mix(sky, cloud, cover);
    }
}

/* ------------------------------------------------------------------------------------ */

static void make(const char *dir, const char *name, int w, int h, void (*paint)(canvas *))
{
    static canvas picture;
    picture.w = w;
    picture.h = h;
    paint(&picture);
    canvas_save(&picture, dir, name);
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: textures FOLDER SKY-FOLDER\n");
        return 2;
    }
    make(argv[1], "water.png", SIDE, SIDE, paint_water);
    make(argv[1], "water-normal.png", SIDE, SIDE, paint_ripples);
    make(argv[1], "noise.png", SIDE, SIDE, paint_noise);
    make(argv[1], "distortion.png", 64, 64, paint_distortion);
    make(argv[1], "foam.png", SIDE, SIDE, paint_foam);
    make(argv[1], "lava.png", SIDE, SIDE, paint_lava);
    make(argv[1], "shoal.png", SIDE, SIDE, paint_shoal);
    make(argv[1], "harbour.png", 240, 240, paint_harbour);
    make(argv[2], "day.png", 256, 128, paint_day);
    return 0;
}
