/* SPDX-License-Identifier: MIT */
/* Ground under water and walls around water; see the header. Each picture starts with a
 * relief, then gets the colours of its parts, then light from the relief. */
#include "ground.h"

enum { SIDE = 256 };

static relief shape = { SIDE, SIDE, { 0 } };

static int grain(int x, int y, int reach, uint32_t seed)
{
    return (int)(hash(x, y, seed) % (uint32_t)(2 * reach + 1)) - reach;
}

static uint32_t rgb_add(uint32_t c, int v)
{
    return rgb((int)(c >> 16 & 255) + v, (int)(c >> 8 & 255) + v, (int)(c & 255) + v);
}

/* Depth in 1/256 pixel of a point inside a rectangle around 0 with rounded corners;
 * negative outside. */
static int inside_q8(int x_q8, int y_q8, int half_w_q8, int half_h_q8, int round_q8)
{
    int dx = (x_q8 < 0 ? -x_q8 : x_q8) - half_w_q8 + round_q8;
    int dy = (y_q8 < 0 ? -y_q8 : y_q8) - half_h_q8 + round_q8;
    if (dx > 0 && dy > 0)
        return round_q8 - (int)root_u64((uint64_t)((int64_t)dx * dx + (int64_t)dy * dy));
    return round_q8 - (dx > dy ? dx : dy);
}

/* Bevel: rises over `width` along a quarter circle to `height`. */
static int bevel(int depth_q8, int width_q8, int height_q8)
{
    int64_t rest = width_q8 - clamp_int(depth_q8, 0, width_q8);
    uint64_t square = (uint64_t)((int64_t)width_q8 * width_q8 - rest * rest);
    return (int)((int64_t)root_u64(square) * height_q8 / width_q8);
}

/* -- tiles --------------------------------------------------------------------------- */

enum { TILE = 64, TILE_HALF_Q8 = 31 * 256 - 64 };

static int tile_depth(int x, int y)
{
    return inside_q8(x % TILE * 256 + 128 - TILE * 128, y % TILE * 256 + 128 - TILE * 128,
                     TILE_HALF_Q8, TILE_HALF_Q8, 4 * 256);
}

/* Uneven glaze: each tile has its own tint, clouds, and a paler rim. */
static uint32_t glaze(int x, int y, int depth)
{
    uint32_t id = hash(x / TILE, y / TILE, 81);
    uint32_t tint = rgb_mix(0xb4dcd4, 0x8ccbcb, (int)(id & 255));
    int cloud = (fractal(x, y, SIDE, SIDE, 10, 10, 4, 82) - 32768) / 1100;
    int rim = clamp_int(24 - depth / 40, 0, 24);
    int sheen = (TILE - x % TILE - y % TILE) / 8;
    return rgb_add(tint, (int)(id >> 8 & 15) - 8 + cloud + rim + sheen);
}

void paint_tiles(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        shape.at[i] = bevel(tile_depth(x, y), 5 * 256, 460)
                      + fractal(x, y, SIDE, SIDE, 12, 12, 2, 83) / 400;
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE, depth = tile_depth(x, y);
        uint32_t grout = rgb_add(0x93a09a, grain(x, y, 9, 84));
        uint32_t glazed = rgb_scale(glaze(x, y, depth), relief_light(&shape, x, y));
        to->pixel[i] = rgb_mix(grout, glazed, clamp_int(depth + 128, 0, 256));
    }
}

/* -- stone --------------------------------------------------------------------------- */

enum { COURSES = 4, COURSE = SIDE / COURSES };

typedef struct {
    int depth_q8; /* depth in the block from its joint */
    uint32_t id;
} block;

/* Three blocks a course; the joints are offset from the courses above and below, at
 * irregular places. Half a course lies at the top, so that no joint runs along the seam. */
static block block_at(int x, int y)
{
    static const int joint[COURSES][4] = { { 76, 166, 242, 332 },
                                           { 44, 126, 214, 300 },
                                           { 14, 84, 184, 270 },
                                           { 52, 152, 226, 308 } };
    int rough_x = (fractal(x, y, SIDE, SIDE, 14, 14, 3, 85) - 32768) / 50;
    int rough_y = (fractal(x, y, SIDE, SIDE, 14, 14, 3, 86) - 32768) / 50;
    int row = (y + COURSE / 2) % SIDE, course = row / COURSE, k = 0;
    int at = x < joint[course][0] ? x + SIDE : x;
    while (at >= joint[course][k + 1])
        k++;
    int left = joint[course][k], right = joint[course][k + 1];
    int across = at * 256 + 128 - (left + right) * 128 + rough_x;
    int down = row % COURSE * 256 + 128 - COURSE * 128 + rough_y;
    block b = { inside_q8(across, down, (right - left) * 128 - 300, COURSE * 128 - 300,
                          1500),
                hash(course, k, 87) };
    return b;
}

void paint_stone(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        block b = block_at(x, y);
        int rough = fractal(x, y, SIDE, SIDE, 12, 12, 5, 88) / 55;
        int pits =
            clamp_int(fractal(x, y, SIDE, SIDE, 40, 40, 2, 89) - 43000, 0, 20000) / 90;
        shape.at[i] = bevel(b.depth_q8, 7 * 256, 1100) + rough - pits;
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        block b = block_at(x, y);
        uint32_t tone = rgb_mix(0xa39a88, 0x8b8c8a, (int)(b.id & 255));
        int cloud = (fractal(x, y, SIDE, SIDE, 5, 5, 4, 92) - 32768) / 900;
        int stain =
            clamp_int((fractal(x, y, SIDE, SIDE, 14, 3, 3, 93) - 36000) / 90, 0, 120);
        tone = rgb_add(tone, (int)(b.id >> 8 & 31) - 16 + cloud + grain(x, y, 4, 94));
        tone = rgb_mix(tone, 0x5f6350, stain);
        tone = rgb_scale(tone, relief_light(&shape, x, y));
        to->pixel[i] = rgb_mix(rgb_add(0x47443e, grain(x, y, 7, 95)), tone,
                               clamp_int(b.depth_q8 / 2 + 100, 0, 256));
    }
}

/* -- sand ---------------------------------------------------------------------------- */

/* Sand ripples are steeper on one side, wander, and are worn down in places. */
static int sand_height(int x, int y)
{
    int wander = (fractal(x, y, SIDE, SIDE, 3, 3, 3, 96) - 32768) * 5 / 2;
    int fork = (fractal(x, y, SIDE, SIDE, 7, 5, 2, 97) - 32768) * 2 / 3;
    int phase = y * 65536 * 15 / SIDE + wander + fork;
    int lean = sine_q14(phase) / 3;
    int worn = 90 + fractal(x, y, SIDE, SIDE, 4, 4, 3, 98) / 400;
    return (int)((int64_t)sine_q14(phase + lean) * worn / 8000);
}

void paint_sand(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        shape.at[i] = sand_height(x, y) * 3 / 2 + grain(x, y, 24, 99);
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        int cloud = (fractal(x, y, SIDE, SIDE, 4, 4, 5, 101) - 32768) / 1100;
        int dark = hash(x, y, 102) % 97 == 0 ? 26 : 0;
        int lit = (relief_light(&shape, x, y) * 3 + 7 * 256) / 10;
        uint32_t tone =
            rgb_mix(0xd3c19a, 0xe9dcba, clamp_int(128 + shape.at[i] / 3, 0, 256));
        to->pixel[i] = rgb_scale(rgb_add(tone, cloud - dark), lit);
    }
}

/* -- pebbles ------------------------------------------------------------------------- */

typedef struct {
    int depth_q8; /* depth in the pebble from its rim */
    uint32_t id;
} pebble;

/* Depth of a point, from a pebble's middle in 1/256 cell, in the rounded ellipse of a random
 * size, shape and heading; 1/256 cell. */
static int depth_in_pebble(int dx, int dy, uint32_t id)
{
    int32_t turn = (int32_t)(id >> 16 & 255) * 256;
    int c = sine_q14(turn + 16384), s = sine_q14(turn);
    int64_t along = (dx * c + dy * s) / 16384, across = (dy * c - dx * s) / 16384;
    int radius = 105 + (int)(id >> 24 & 63), stretch = 256 + (int)(id >> 27 & 31) * 7;

    across = across * stretch / 256;
    return radius - (int)root_u64((uint64_t)(along * along + across * across));
}

/* Pebble of n x n at a point, in 1/256 cell; the deepest of the neighbours. */
static pebble pebble_of_layer(int x_q8, int y_q8, int n, uint32_t seed)
{
    pebble found = { -(1 << 14), 0 };

    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            int cx = x_q8 / 256 + i, cy = y_q8 / 256 + j;
            uint32_t h = hash((cx + n) % n, (cy + n) % n, seed);
            int depth = depth_in_pebble(x_q8 - cx * 256 - 64 - (int)(h & 127),
                                        y_q8 - cy * 256 - 64 - (int)(h >> 8 & 127), h);
            if (depth > found.depth_q8)
                found = (pebble){ depth, h };
        }
    found.depth_q8 = found.depth_q8 * SIDE / n;
    return found;
}

/* Pebble at a point: large pebbles lie on small ones. */
static pebble pebble_at(int x, int y)
{
    static const int many[4] = { 9, 12, 17, 25 };
    int px = x * 256 + (fractal(x, y, SIDE, SIDE, 18, 18, 2, 103) - 32768) / 60;
    int py = y * 256 + (fractal(x, y, SIDE, SIDE, 18, 18, 2, 104) - 32768) / 60;
    pebble p = { 0, 0 };

    px = (px + SIDE * 256) % (SIDE * 256);
    py = (py + SIDE * 256) % (SIDE * 256);
    for (int i = 0; i < 4; i++) {
        p = pebble_of_layer(px * many[i] / SIDE, py * many[i] / SIDE, many[i],
                            105 + (uint32_t)i);
        if (p.depth_q8 > 0 && (i > 0 || (p.id >> 4 & 3) != 0))
            return p;
    }
    return p;
}

void paint_pebbles(canvas *to)
{
    static const uint32_t tones[8] = { 0xaca8a1, 0x878b8d, 0xccbda3, 0xe1daca,
                                       0x94816d, 0xd4d2c8, 0x707577, 0xb49c81 };
    for (int i = 0; i < SIDE * SIDE; i++) {
        pebble p = pebble_at(i % SIDE, i / SIDE);
        shape.at[i] = bevel(p.depth_q8, 9 * 256, 1100);
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        pebble p = pebble_at(x, y);
        int cloud = (fractal(x, y, SIDE, SIDE, 16, 16, 4, 106) - 32768) / 900;
        uint32_t tone =
            rgb_add(tones[p.id >> 13 & 7], cloud + (int)(p.id >> 20 & 15) - 8);
        tone = rgb_scale(tone, relief_light(&shape, x, y));
        uint32_t gravel = rgb_add(0x4a453c, grain(x, y, 16, 107));
        to->pixel[i] = rgb_mix(gravel, tone, clamp_int(p.depth_q8 / 3 + 40, 0, 256));
    }
}
