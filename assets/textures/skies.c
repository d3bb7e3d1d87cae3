/* SPDX-License-Identifier: MIT */
/* Skies as cube maps; see the header. Each sky is a function of the direction alone, so the
 * faces join. */
#include "skies.h"
#include "canvas.h"
#include "clouds.h"

#include <stddef.h>
#include <stdio.h>

enum { FACE = 256, SIDE = 2 * FACE, ONE = 16384 };

/* Coverage of a disc: 256 within its radius, 0 outside, soft over a texel's width; Q14
 * radians. */
static int disc_at(int32_t off, int32_t radius)
{
    return clamp_int((radius + 80 - off) * 256 / 160, 0, 256);
}

/* Alpha of a disc, brightness above white, 0..255, with a glow of `glow` at the rim. The
 * alpha rises inside as a cube: at many times white, a steeper edge would show its
 * texels. */
static int disc_alpha(int32_t off, int32_t radius, int32_t reach, int glow)
{
    int64_t t = clamp_int((reach - off) * 256 / (reach - radius), 0, 256);
    int64_t disc = disc_at(off, radius);
    return mix_int((int)(glow * t * t * t >> 24), 255, (int)(disc * disc * disc >> 16));
}

/* Glow 1 / (1 + (off / width)^2): 1 at the middle; Q14. */
static int32_t glow_at(int32_t off, int32_t width)
{
    int64_t w = (int64_t)width * width;
    return (int32_t)(w * ONE / (w + (int64_t)off * off));
}

static uint32_t with_alpha(light l, int alpha)
{
    return light_rgb(l) | (uint32_t)alpha << 24;
}

/* -- day ----------------------------------------------------------------------------- */

static uint32_t day(vec dir)
{
    static const stop air[] = { { -16384, 0x4f6f86 }, { -2600, 0x7c9aae },
                                { -300, 0xb4c9d6 },   { 0, 0xcfdfea },
                                { 700, 0xc2d9ea },    { 2000, 0xa2c8e6 },
                                { 5000, 0x6ea5d9 },   { 10000, 0x4481c6 },
                                { 16384, 0x2f68b2 } };
    vec sun = heading_at(225, 42);
    int32_t off = chord(dir, sun);
    light sky = ramp_at(air, sizeof air / sizeof air[0], dir.y);
    if (dir.y > 0)
        sky = light_mix(sky, light_of(0xf4f6f4), glow_at(off, 3400) * 5 / 8);
    cloud_look cloud = cumulus(dir, sun);
    light shine =
        light_mix(cloud.shine, light_scale(sky, ONE - cloud.through), cloud.haze);
    sky = light_add(light_scale(sky, cloud.through), shine);
    int alpha = disc_alpha(off, 370, 900, 40) * cloud.through / ONE;
    return with_alpha(light_mix(sky, light_of(0xfffdf4), alpha * ONE / 255), alpha);
}

/* -- dusk ---------------------------------------------------------------------------- */

static light dusk_air(vec dir, int32_t towards)
{
    static const stop west[] = { { -16384, 0x33344a }, { -2600, 0x80565a },
                                 { -300, 0xc48058 },   { 0, 0xf2a862 },
                                 { 900, 0xf8a868 },    { 2200, 0xea8e70 },
                                 { 4200, 0xbf7a88 },   { 7600, 0x7d6a9a },
                                 { 16384, 0x333f78 } };
    static const stop east[] = { { -16384, 0x2a2e42 }, { -2600, 0x44475f },
                                 { -300, 0x5d5c78 },   { 0, 0x6c6786 },
                                 { 900, 0x7d7292 },    { 2600, 0xa3849e },
                                 { 5200, 0x7a78a4 },   { 8600, 0x545f98 },
                                 { 16384, 0x333f78 } };
    light lit = ramp_at(west, sizeof west / sizeof west[0], dir.y);
    light shade = ramp_at(east, sizeof east / sizeof east[0], dir.y);
    int32_t share = (ONE + towards) / 2;
    return light_mix(shade, lit, share * 2 / 5 + share * share / ONE * 3 / 5);
}

/* Thin cloud takes the low sun's colour; thick cloud keeps its own dusk colour. */
static light dusk_cloud(int32_t thick, int32_t towards, int32_t off)
{
    int32_t share = (ONE + towards) / 2;
    light far = light_mix(light_of(0x8d7496), light_of(0xf08a66), share);
    light lit = light_mix(far, light_of(0xffdc9c), glow_at(off, 4200));
    light dark = light_mix(light_of(0x4e4a68), light_of(0x865670), share);
    return light_mix(lit, dark, thick * 7 / 8);
}

static uint32_t dusk(vec dir)
{
    vec sun = heading_at(270, 6);
    int32_t off = chord(dir, sun), towards = cosine(dir, sun);
    light sky = dusk_air(dir, towards);
    sky =
        light_mix(sky, light_of(0xffdf9a), glow_at(off, dir.y > 0 ? 2300 : 1500) * 3 / 4);
    int32_t thick = cloud_bars(dir);
    int32_t cover = thick < 8192 ? thick * 2 : ONE;
    sky = light_mix(sky, dusk_cloud(thick, towards, off), cover * 7 / 8);
    int alpha = disc_alpha(off, 400, 900, 30) * (ONE - cover / 2) / ONE;
    alpha = alpha * clamp_int(dir.y + 300, 0, 600) / 600;
    return with_alpha(light_mix(sky, light_of(0xfff0c4), alpha * ONE / 255), alpha);
}

/* -- night --------------------------------------------------------------------------- */

static light milky_way(vec dir)
{
    vec pole = heading_at(150, 30);
    int32_t off = cosine(dir, pole);
    int cloud = fractal3(dir, 4600, 5, 331), rift = fractal3(dir, 3000, 4, 341);
    int32_t band = glow_at(off, 2700);
    int32_t core = (int32_t)((int64_t)band * band / ONE
                             * clamp_int(cloud - 18000, 0, 32768) / 32768);
    int dust = clamp_int(rift - 36000 + glow_at(off, 900) / 2, 0, 12000);
    core = (int32_t)((int64_t)core * (14000 - dust) / 14000);
    return light_mix(light_of(0), light_of(0x6e7488), core);
}

static int distance(int32_t v)
{
    return v < 0 ? -v : v;
}

/* True if a direction lies in a face's outermost texels, where two components are almost
 * equal; an edge would cut a star there in two. */
static bool at_edge(vec d)
{
    int x = distance(d.x), y = distance(d.y), z = distance(d.z);
    return distance(x - y) < x / 128 || distance(y - z) < y / 128
           || distance(z - x) < z / 128;
}

/* One texel in some hundred holds a star, chosen by its direction; few stars are bright. */
static light star(vec dir)
{
    light none = { 0, 0, 0 };
    uint32_t h = hash(dir.x, dir.y, 351 + (uint32_t)dir.z);
    if (dir.y < 300 || h % 96 != 0 || at_edge(dir))
        return none;
    int64_t b = h >> 8 & 255;
    int64_t power = b * b * b / 65536 * b / 256; /* 0..252, mostly small */
    uint32_t tint = h >> 16 & 1 ? 0xd4e0ff : h >> 17 & 1 ? 0xfff2e0 : 0xffffff;
    int32_t low = clamp_int((dir.y - 300) * 6, 0, ONE);
    return light_scale(light_of(tint), (int32_t)((20 + power) * low / 272));
}

static light moon_face(vec dir, vec moon)
{
    vec place = { dir.x - moon.x, dir.y - moon.y, dir.z - moon.z };
    int maria = clamp_int((fractal3(place, 360, 2, 361) - 26000), 0, ONE);
    return light_mix(light_of(0xf6f4ea), light_of(0xb4b6ba), maria);
}

static uint32_t night(vec dir)
{
    static const stop air[] = { { -16384, 0x05080e }, { -2600, 0x0c131d },
                                { -300, 0x17212f },   { 0, 0x1d2939 },
                                { 1500, 0x172234 },   { 5000, 0x0d1526 },
                                { 16384, 0x070b17 } };
    vec moon = heading_at(6, 20);
    int32_t off = chord(dir, moon);
    int alpha = disc_alpha(off, 380, 640, 6);
    int disc = disc_at(off, 380);
    light sky = ramp_at(air, sizeof air / sizeof air[0], dir.y);
    int32_t lift = clamp_int(dir.y * 4, 0, ONE);
    sky = light_add(sky, light_scale(milky_way(dir), lift));
    sky = light_add(sky, light_scale(light_of(0x8ea6c8), glow_at(off, 800) * 3 / 4));
    if (alpha == 0)
        sky = light_add(sky, star(dir));
    return with_alpha(light_mix(sky, moon_face(dir, moon), disc * 64), alpha);
}

/* -- faces --------------------------------------------------------------------------- */

typedef struct {
    const char *name;
    vec ahead, right, down;
} face;

static const face faces[6] = {
    { "east", { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } },
    { "west", { -1, 0, 0 }, { 0, 0, -1 }, { 0, -1, 0 } },
    { "up", { 0, 1, 0 }, { -1, 0, 0 }, { 0, 0, 1 } },
    { "down", { 0, -1, 0 }, { -1, 0, 0 }, { 0, 0, -1 } },
    { "south", { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 } },
    { "north", { 0, 0, -1 }, { 1, 0, 0 }, { 0, -1, 0 } },
};

/* Direction of a point of a face of SIDE half texels, on a cube whose faces are SIDE from
 * the centre. */
static vec point_at(const face *f, int column, int row)
{
    int32_t u = column - SIDE, v = row - SIDE;
    return unit(f->ahead.x * SIDE + f->right.x * u + f->down.x * v,
                f->ahead.y * SIDE + f->right.y * u + f->down.y * v,
                f->ahead.z * SIDE + f->right.z * u + f->down.z * v);
}

/* Colour of a texel from its middle. */
static uint32_t look_once(const face *f, int column, int row, uint32_t (*look)(vec dir))
{
    return look(point_at(f, 4 * column + 2, 4 * row + 2));
}

/* Mean colour of the middles of a texel's quarters: edges of clouds have no steps. Alpha is
 * that of the texel's middle, so that a disc keeps its brightness. */
static uint32_t look_4_times(const face *f, int column, int row,
                             uint32_t (*look)(vec dir))
{
    uint32_t even = 0x00020002, odd = 0x00020002;
    for (int k = 0; k < 4; k++) {
        uint32_t c =
            look(point_at(f, 4 * column + 1 + k % 2 * 2, 4 * row + 1 + k / 2 * 2));
        even += c & 0x00ff00ff;
        odd += c >> 8 & 0x00ff00ff;
    }
    uint32_t alpha = odd >> 18 ? look_once(f, column, row, look) & 0xff000000 : 0;
    return (even >> 2 & 0x00ff00ff) | (odd >> 2 & 0xff) << 8 | alpha;
}

typedef uint32_t sampling(const face *f, int column, int row, uint32_t (*look)(vec dir));

static void make_cube(const char *dir, const char *sky, sampling *sample,
                      uint32_t (*look)(vec dir))
{
    static canvas picture = { FACE, FACE, true, { 0 } };
    for (int i = 0; i < 6; i++) {
        char name[32];
        for (int n = 0; n < FACE * FACE; n++)
            picture.pixel[n] = sample(&faces[i], n % FACE, n / FACE, look);
        snprintf(name, sizeof name, "%s-%s.png", sky, faces[i].name);
        canvas_save(&picture, dir, name);
    }
}

void make_skies(const char *dir)
{
    make_cube(dir, "day", look_4_times, day);
    make_cube(dir, "dusk", look_4_times, dusk);
    make_cube(dir, "night", look_once, night);
}
