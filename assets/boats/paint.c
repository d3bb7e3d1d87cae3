/* SPDX-License-Identifier: MIT */
/* Textures of the longship, painted in integers. A texture with relief gets its normal map
 * from the same relief as its colours, so colour and bumps agree. */
#include "../textures/canvas.h"
#include "longship.h"

#include <stdlib.h>

static canvas colour, bumps;
static relief height;

static void start(int w, int h)
{
    colour.w = height.w = w;
    colour.h = height.h = h;
}

static void put(int x, int y, uint32_t c, int raised_q8)
{
    colour.pixel[y * colour.w + x] = c;
    height.at[y * height.w + x] = raised_q8;
}

static void save(const char *dir, const char *name, const char *normal_name)
{
    canvas_save(&colour, dir, name);
    if (normal_name != NULL) {
        relief_normals(&height, &bumps);
        canvas_save(&bumps, dir, normal_name);
    }
}

/* -- wood: four planks, one above the other ------------------------------------------ */

enum { WOOD = 256, PLANK = 64 };

/* Fine streaks along the plank, 0..65535, bent a little by a slow drift. */
static int grain(int x, int y)
{
    int plank = y / PLANK;
    int drift = (fractal(x, y, WOOD, WOOD, 3, 6, 2, 80) - 32768) / 40;
    int row = (y * 256 + drift) & 65535;
    int fine = noise(x * 8, row / 3 * 2, 8, 171, 81 + (uint32_t)plank);
    int broad = noise(x * 4, row / 8, 4, 32, 91 + (uint32_t)plank);
    return (fine * 3 + broad * 2) / 5;
}

/* Iron rivets in a row above the lap; 0..256, greatest at a rivet's middle. */
static int rivet(int x, int row)
{
    int dx = (x + 8) % 32 - 16, dy = row - 9, d2 = dx * dx + dy * dy;
    return d2 < 9 ? 256 - d2 * 24 : 0;
}

static void paint_wood(const char *dir)
{
    static const int tone[4] = { 0, 14, -12, 6 }, joint[4] = { 40, 190, 110, 240 };
    start(WOOD, WOOD);
    for (int i = 0; i < WOOD * WOOD; i++) {
        int x = i % WOOD, y = i / WOOD, plank = y / PLANK;
        int row = PLANK - 1 - y % PLANK; /* from the plank's lower edge */
        int streak = (grain(x, y) - 32768) / 256;
        int worn = (fractal(x, y, WOOD, WOOD, 4, 4, 4, 85) - 32768) / 256;
        uint32_t wood =
            rgb(158 + streak * 4 / 10 + tone[plank], 120 + streak * 4 / 10 + tone[plank],
                82 + streak / 3 + tone[plank] * 2 / 3);
        wood = rgb_mix(wood, 0x8f8a7e, clamp_int(worn * 2, 0, 90));
        wood = rgb_mix(wood, 0x4a3220, clamp_int(-worn * 2, 0, 60));
        int seam = row == 0 ? 190 : row == 1 ? 110 : row > 50 ? (row - 50) * 11 : 0;
        int split = abs(x - joint[plank]) < 1 ? 150 : 0;
        int nail = rivet(x, row);
        wood = rgb_mix(wood, 0x241910, seam > split ? seam : split);
        wood = rgb_mix(wood, 0x2e2a28, nail);
        put(x, y, wood, streak * 5 / 2 + nail * 3 - ((row < 2 ? seam : 0) + split) * 2);
    }
    save(dir, "wood.png", "wood-normal.png");
}

/* -- carving: a braid of three bands ------------------------------------------------- */

enum { CARVING_W = 128, CARVING_H = 64 };

/* Relief of the braid at a point, 0 for the ground. Band i swings as sin a and passes over
 * or under as sin 2a, a = x + i/3 turn. */
static int braid(int x, int y)
{
    int best = 0, top = -32768;
    for (int i = 0; i < 3; i++) {
        int32_t a = x * 65536 / 64 + i * 65536 / 3;
        int centre = 32 * 256 + sine_q14(a) * 19 / 64;
        int off = abs(y * 256 + 128 - centre) / 8; /* 1/32 pixel */
        int over = sine_q14(2 * a) / 64;
        if (off < 190 && over > top) {
            top = over;
            best = 300 + over / 3 + 240 - off * off / 150;
            if (off > 158)
                best = 60; /* groove around the band */
        }
    }
    return best;
}

static void paint_carving(const char *dir)
{
    start(CARVING_W, CARVING_H);
    for (int i = 0; i < CARVING_W * CARVING_H; i++) {
        int x = i % CARVING_W, y = i / CARVING_W;
        int cut = braid(x, y), border = y < 4 || y >= CARVING_H - 4;
        int streak = (grain(x * 2, y * 2) - 32768) / 256;
        int raised = border ? 420 : cut;
        int light = 256 - (520 - clamp_int(raised, 0, 520)) * 120 / 520;
        uint32_t wood = rgb(164 + streak / 4, 124 + streak / 4, 84 + streak / 5);
        put(x, y, rgb_scale(wood, light), raised + streak);
    }
    save(dir, "carving.png", "carving-normal.png");
}

/* -- sail: one red and one cream cloth ----------------------------------------------- */

enum { SAIL = 128 };

static void paint_sail(const char *dir)
{
    start(SAIL, SAIL);
    for (int i = 0; i < SAIL * SAIL; i++) {
        int x = i % SAIL, y = i / SAIL;
        int cloth = (fractal(x, y, SAIL, SAIL, 4, 3, 4, 95) - 32768) / 256;
        int fold = (fractal(x, y, SAIL, SAIL, 2, 4, 2, 96) - 32768) / 24;
        int thread = ((x + y) & 1) * 6 - 3 + (int)(hash(x, y, 97) & 7) - 3;
        int across = x % 64, near = across < 32 ? across : 63 - across;
        int seam = near < 1 || y < 1 ? 1 : 0, hem = near < 3 || y < 3 || y > SAIL - 3;
        int level = thread + cloth / 5 - seam * 42 - hem * 9;
        uint32_t dyed = x < 64 ? rgb(150 + level, 30 + level / 2, 26 + level / 2)
                               : rgb(226 + level, 208 + level, 172 + level);
        put(x, y, dyed, fold + thread * 4 + hem * 70 - seam * 120);
    }
    save(dir, "sail.png", "sail-normal.png");
}

/* -- shields: four designs ----------------------------------------------------------- */

enum { SHIELDS_SIDE = 128, QUARTER = 64 };

/* x, y from the shield's middle in half pixels, y up. */
static uint32_t design(int which, int x, int y, int r)
{
    static const uint32_t paint[4][2] = {
        { 0x8e1f1a, 0xdccaa0 },
        { 0xd09a2c, 0x2a2523 },
        { 0x24466e, 0xdccaa0 },
        { 0x2f5a35, 0xc9a13c },
    };
    int eighth = (x > 0) ^ (y > 0) ^ (abs(x) > abs(y));
    int second = which == 0   ? eighth
                 : which == 1 ? abs(x) < 9 || abs(y) < 9
                 : which == 2 ? (x > 0) == (y > 0)
                              : r > 26 && r < 40;
    return paint[which][second != 0];
}

static void paint_shields(const char *dir)
{
    start(SHIELDS_SIDE, SHIELDS_SIDE);
    for (int i = 0; i < SHIELDS_SIDE * SHIELDS_SIDE; i++) {
        int px = i % SHIELDS_SIDE, py = i / SHIELDS_SIDE;
        int x = 2 * (px % QUARTER) - 63, y = 63 - 2 * (py % QUARTER);
        int r = (int)root_u64((uint64_t)(x * x + y * y));
        int which = px / QUARTER + 2 * (1 - py / QUARTER);
        int worn =
            (fractal(px, py, SHIELDS_SIDE, SHIELDS_SIDE, 16, 16, 3, 101) - 32768) / 256;
        int board = (px % QUARTER) % 11 == 0 ? 36 : 0;
        uint32_t c = rgb_scale(design(which, x, y, r), 256 + worn - board);
        c = rgb_mix(c, 0x6a5036, clamp_int(worn * 3 - 110, 0, 200)); /* bare wood */
        if (r > 54)
            c = rgb_scale(0x4a3626, 256 + worn + ((px + py) % 6 == 0 ? 70 : 0));
        if (r > 60)
            c = rgb_scale(0x6b4d30, 230 + worn);
        if (r < 17)
            c = rgb_scale(0x55565a, 256 + worn + (y - x) * 6); /* a painted boss */
        put(px, py, c, 0);
    }
    save(dir, "shields.png", NULL);
}

/* -- small things -------------------------------------------------------------------- */

enum { SMALL = 32 };

static void paint_rope(const char *dir)
{
    start(SMALL, SMALL);
    for (int i = 0; i < SMALL * SMALL; i++) {
        int x = i % SMALL, y = i / SMALL;
        int level = sine_q14((x + y) * 8192) / 400 + (int)(hash(x, y, 111) & 31) - 16;
        put(x, y, rgb(196 + level, 180 + level, 146 + level), 0);
    }
    save(dir, "rope.png", NULL);
}

static void paint_mottle(const char *dir)
{
    start(SMALL, SMALL);
    for (int i = 0; i < SMALL * SMALL; i++) {
        int level =
            205
            + (fractal(i % SMALL, i / SMALL, SMALL, SMALL, 4, 4, 3, 121) - 32768) / 400;
        put(i % SMALL, i / SMALL, rgb(level, level, level), 0);
    }
    save(dir, "mottle.png", NULL);
}

void paint_all(const char *dir)
{
    paint_wood(dir);
    paint_carving(dir);
    paint_sail(dir);
    paint_shields(dir);
    paint_rope(dir);
    paint_mottle(dir);
}
