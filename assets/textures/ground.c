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

/* Pebble at a point: depth from the cell's border or from a circle, whichever is nearer. */
static pebble pebble_at(int x, int y)
{
    int px = x * 256 + (fractal(x, y, SIDE, SIDE, 18, 18, 2, 103) - 32768) / 40;
    int py = y * 256 + (fractal(x, y, SIDE, SIDE, 18, 18, 2, 104) - 32768) / 40;
    cells c = cells_at(px * 13 / SIDE, py * 13 / SIDE, 13, 105);
    int border = (c.next - c.near) * 5 - 90, circle = (190 - c.near) * 12;
    int gap = border - circle;
    int soft = (int)root_u64((uint64_t)((int64_t)gap * gap + 400 * 400));
    pebble p = { (border + circle - soft) / 2 + 120, c.id };
    return p;
}

void paint_pebbles(canvas *to)
{
    static const uint32_t tones[8] = { 0xaca8a1, 0x878b8d, 0xccbda3, 0xe1daca,
                                       0x94816d, 0xecece6, 0x707577, 0xb49c81 };
    for (int i = 0; i < SIDE * SIDE; i++) {
        pebble p = pebble_at(i % SIDE, i / SIDE);
        shape.at[i] = bevel(p.depth_q8, 6 * 256, 1300);
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        pebble p = pebble_at(x, y);
        int cloud = (fractal(x, y, SIDE, SIDE, 16, 16, 4, 106) - 32768) / 900;
        uint32_t tone =
            rgb_add(tones[p.id >> 16 & 7], cloud + (int)(p.id >> 20 & 15) - 8);
        tone = rgb_scale(tone, relief_light(&shape, x, y));
        uint32_t gravel = rgb_add(0x4a453c, grain(x, y, 16, 107));
        to->pixel[i] = rgb_mix(gravel, tone, clamp_int(p.depth_q8 + 64, 0, 256));
    }
}
