/* SPDX-License-Identifier: MIT */
/* Paints the scenes' own textures and the skies, in integers, equal on all machines.
 *
 *     cc -std=c11 -O2 assets/textures/?*.c -lpng -o textures
 *     ./textures assets/textures assets/skies
 *
 * water.png         pale net of light with streaks, mean 200: multiply by a colour
 * water-normal.png  capillary ripples, tangent space, green up, slopes to 0.35
 * crests.png        threads of light on black: add
 * noise.png         grey, six octaves
 * distortion.png    64x64, red and green: smooth offsets, 128 is none
 * foam.png          films of bubbles; all greys equally frequent: a threshold sets the
 *                   coverage
 * lava.png          cooling crust over glowing cracks; lava-crust.png and lava-glow.png
 *                   are the same in two layers
 * tiles.png, stone.png, sand.png, pebbles.png    walls and floors
 * shoal.png, harbour.png    maps that scenes read as numbers; see maps.h
 *
 * Pictures are 256x256 unless noted, and all except the maps tile along both axes. The
 * skies are cubes of six faces; see skies.h. The pictures are CC0-1.0. */
#include "canvas.h"
#include "ground.h"
#include "maps.h"
#include "nets.h"
#include "skies.h"

#include <stddef.h>
#include <stdio.h>

enum { SIDE = 256 };

/* -- ripples ------------------------------------------------------------------------- */

enum { RIPPLES = 56, RIPPLE_SLOPE_Q16 = 1530 };

typedef struct {
    int32_t kx, ky;    /* whole waves a tile, so that the tile wraps */
    int32_t length_q8; /* length of (kx, ky) */
    int32_t phase_q16;
} ripple;

/* Wave vectors uniform in a ring, by rejection: vectors outside are drawn again. */
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

/* Slopes of the sum at a point in 1/256 pixel; long waves are slightly steeper. */
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

/* Reading the slopes slightly uphill sharpens the crests, as in real ripples. */
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

/* -- noise and distortion ------------------------------------------------------------ */

static void paint_noise(canvas *to)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        int n = fractal(i % SIDE, i / SIDE, SIDE, SIDE, 4, 4, 6, 31);
        int level = 128 + (n - 32768) * 2 / 256;
        to->pixel[i] = rgb(level, level, level);
    }
}

enum { PUSHES = 14, PUSH_SIDE = 64 };

/* Waves of two to five a tile, with amplitudes that fade like a sea's: smooth along both
 * axes, with mean 0, since a mean offset would shift the whole picture. */
static int push(int x, int y, uint32_t seed)
{
    int sum = 0;
    for (int i = 0; i < PUSHES; i++) {
        int kx = (int)(hash(i, 0, seed) % 7) - 3, ky = (int)(hash(i, 1, seed) % 7) - 3;
        int k2 = kx * kx + ky * ky;
        int turn = (kx * x + ky * y) * 65536 / PUSH_SIDE + (int)(hash(i, 2, seed) >> 16);
        sum += k2 < 3 ? 0 : sine_q14(turn) / (k2 + 5);
    }
    return sum;
}

static void paint_distortion(canvas *to)
{
    for (int i = 0; i < to->w * to->h; i++) {
        int r = push(i % to->w, i / to->w, 41), g = push(i % to->w, i / to->w, 43);
        to->pixel[i] = rgb(128 + r / 48, 128 + g / 48, 128);
    }
}

/* ------------------------------------------------------------------------------------ */

typedef struct {
    const char *name;
    int side;
    void (*paint)(canvas *);
} picture;

static const picture pictures[] = {
    { "water.png", SIDE, paint_water },
    { "water-normal.png", SIDE, paint_ripples },
    { "crests.png", SIDE, paint_crests },
    { "noise.png", SIDE, paint_noise },
    { "distortion.png", PUSH_SIDE, paint_distortion },
    { "foam.png", SIDE, paint_foam },
    { "lava.png", SIDE, paint_lava },
    { "lava-crust.png", SIDE, paint_lava_crust },
    { "lava-glow.png", SIDE, paint_lava_glow },
    { "tiles.png", SIDE, paint_tiles },
    { "stone.png", SIDE, paint_stone },
    { "sand.png", SIDE, paint_sand },
    { "pebbles.png", SIDE, paint_pebbles },
    { "shoal.png", SIDE, paint_shoal },
    { "harbour.png", 240, paint_harbour },
};

static void make(const char *dir, const picture *p)
{
    static canvas to;
    to.w = p->side;
    to.h = p->side;
    p->paint(&to);
    canvas_save(&to, dir, p->name);
}

int main(int argc, char **argv)
{
    if (argc < 2 || argc > 3) {
        fprintf(stderr, "usage: textures FOLDER [SKY-FOLDER]\n");
        return 2;
    }
    for (size_t i = 0; i < sizeof pictures / sizeof pictures[0]; i++)
        make(argv[1], &pictures[i]);
    if (argc == 3)
        make_skies(argv[2]);
    return 0;
}
