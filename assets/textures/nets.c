/* SPDX-License-Identifier: MIT */
/* Nets of warped cells; see the header. */
#include "nets.h"

enum { SIDE = 256 };

/* Signed offset from noise with n cells a tile, +-reach pixels, in 1/256 pixel. */
static int offset_q8(int x, int y, int n, int octaves, int reach_px, uint32_t seed)
{
    return (fractal(x, y, SIDE, SIDE, n, n, octaves, seed) - 32768) * reach_px / 128;
}

/* Nearness of a point to the border between cells, 0..256; `width` in 1/256 cell. */
static int border(const cells *c, int width)
{
    int gap = clamp_int(c->next - c->near, 0, width);
    int t = 256 - gap * 256 / width;
    return t * t / 256;
}

/* Cells of a warped tile. The warp bends straight borders into lines that look like
 * water. */
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

void paint_water(canvas *to)
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

/* -- foam ---------------------------------------------------------------------------- */

/* Spreads the levels evenly over 0..255: the share 1 - t / 256 of the picture lies above a
 * threshold t. `level` is 0..RANKS - 1. */
enum { RANKS = 4096 };

static void spread_evenly(const int *level, canvas *to)
{
    static int below[RANKS + 1];
    int n = to->w * to->h;
    for (int i = 0; i <= RANKS; i++)
        below[i] = 0;
    for (int i = 0; i < n; i++)
        below[level[i] + 1]++;
    for (int i = 0; i < RANKS; i++)
        below[i + 1] += below[i];
    for (int i = 0; i < n; i++) {
        int middle = (below[level[i]] + below[level[i] + 1]) / 2;
        int grey = clamp_int((int)((int64_t)middle * 256 / n), 0, 255);
        to->pixel[i] = rgb(grey, grey, grey);
    }
}

/* Films between bubbles of three sizes: thin foam is torn lace; in thick foam the smallest
 * bubbles close last. */
void paint_foam(canvas *to)
{
    static int level[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        cells large = warped_cells(x, y, 7, 20, 51);
        cells middle = warped_cells(x, y, 15, 9, 52);
        cells small = warped_cells(x, y, 34, 4, 54);
        int patch = fractal(x, y, SIDE, SIDE, 5, 5, 4, 53) / 64;
        int film =
            border(&large, 110) * 4 + border(&middle, 110) * 3 + border(&small, 120) * 2;
        int bubble = large.near + middle.near;
        level[i] = clamp_int(film + bubble + patch * 3 / 2 - 200, 0, RANKS - 1);
    }
    spread_evenly(level, to);
}

/* -- crests -------------------------------------------------------------------------- */

/* 0..256: a thin line where a sum of waves passes 0; waves go up and down the tile. */
static int thread(int x_q8, int y_q8, int steep, int width, uint32_t seed)
{
    int sum = 0;
    for (int i = 0; i < 12; i++) {
        int kx = (int)(hash(i, 0, seed) % 9) - 4;
        int ky = steep + (int)(hash(i, 1, seed) % 7) - 3;
        int64_t way = (int64_t)kx * x_q8 + (int64_t)ky * y_q8;
        sum += sine_q14((int32_t)way + (int32_t)(hash(i, 2, seed) >> 16)) / 12;
    }
    int t = 256 - clamp_int((sum < 0 ? -sum : sum) * 16 / width, 0, 256);
    return t * t / 256;
}

/* Broken threads of light: two families of lines, each visible where a cloud of noise
 * permits. */
void paint_crests(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        int px = x * 256 + offset_q8(x, y, 9, 3, 7, 71);
        int py = y * 256 + offset_q8(x, y, 9, 3, 7, 72);
        int one =
            clamp_int((fractal(x, y, SIDE, SIDE, 5, 8, 3, 73) - 24500) / 50, 0, 256);
        int two =
            clamp_int((fractal(x, y, SIDE, SIDE, 7, 7, 3, 74) - 29000) / 50, 0, 256);
        int sum = thread(px, py, 6, 90, 75) * one / 256
                  + thread(px, py, 10, 110, 76) * two * 3 / 1024;
        int level = clamp_int(sum, 0, 256) * clamp_int(sum + 80, 0, 256) / 256;
        to->pixel[i] = rgb(level * 15 / 16, level, level);
    }
}

/* -- lava ---------------------------------------------------------------------------- */

/* Black crust, dull red, orange, yellow: colours of a black body from 800 to 1400 K. */
static uint32_t glow(int heat_256)
{
    static const uint32_t ramp[6] = { 0x120c0b, 0x3a0d06, 0x9c1c04,
                                      0xe8520a, 0xffa51e, 0xfff0a0 };
    int at = clamp_int(heat_256, 0, 255) * 5;
    return rgb_mix(ramp[at / 256], ramp[at / 256 + 1], at % 256);
}

void paint_lava(canvas *to)
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

/* Layers of one lava: crust and glow have the same plates, so the layers may lie on each
 * other or drift apart. The crust: ropes of rock, black except the rim. */
void paint_lava_crust(canvas *to)
{
    static relief rock = { SIDE, SIDE, { 0 } };
    static int rim[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        cells plate = warped_cells(x, y, 5, 34, 61);
        int rope = fractal(x, y, SIDE, SIDE, 7, 7, 3, 65) * 5 + plate.near * 128;
        int rough = fractal(x, y, SIDE, SIDE, 24, 24, 3, 66) / 60;
        rim[i] = border(&plate, 110);
        rock.at[i] = sine_q14(rope) / 34 + rough - rim[i] * 4;
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        int lit = relief_light(&rock, i % SIDE, i / SIDE);
        uint32_t crust = rgb_scale(0x2c2624, lit);
        to->pixel[i] =
            rgb_mix(crust, glow(rim[i] / 2), clamp_int(rim[i] * 2 - 120, 0, 256));
    }
}

/* Glow on black: veins with a dull halo, hotter in places. */
void paint_lava_glow(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        cells plate = warped_cells(x, y, 5, 34, 61);
        cells crack = warped_cells(x, y, 13, 14, 62);
        int warm = (fractal(x, y, SIDE, SIDE, 5, 5, 2, 64) - 27000) / 170;
        int heat = border(&plate, 90) * 3 / 4 + border(&plate, 260) / 4
                   + border(&crack, 60) * clamp_int(warm, 20, 130) / 256
                   + clamp_int(warm, 0, 90) / 4;
        to->pixel[i] = rgb_mix(0x000000, glow(heat), clamp_int(heat * 3 - 24, 0, 256));
    }
}
