/* SPDX-License-Identifier: MIT */
/* Clouds; see the header. Cumulus is ray-marched: 3-D noise above a threshold that is
 * lowest at the base and rises with height gives level bases and heaped tops; the cloud
 * between a sample and the sun dims the sample. */
#include "clouds.h"
#include "canvas.h"

enum {
    BASE = 1000,
    TOP = 2000,       /* m */
    CELL = 850,       /* size of the coarsest heaps, m */
    FARTHEST = 32000, /* m */
    STEPS = 64,
    ASIDE_X = 15700,
    ASIDE_Z = 44100, /* offset of this sky in the noise, m */
    DENSE = 70       /* distance in dense cloud that reduces light to 1 / e, m */
};

static vec along(vec dir, int32_t metres)
{
    vec p = { (int32_t)((int64_t)dir.x * metres / 16384),
              (int32_t)((int64_t)dir.y * metres / 16384),
              (int32_t)((int64_t)dir.z * metres / 16384) };
    return p;
}

static vec sum(vec a, vec b)
{
    vec v = { a.x + b.x, a.y + b.y, a.z + b.z };
    return v;
}

/* Threshold of the noise at a height: high under the base, and rising above the base. */
static int need_at(int32_t y, int cover)
{
    int h = (y - BASE) * 256 / (TOP - BASE);
    int low = h < 14 ? (14 - h) * 900 : 0;
    return 39500 - cover + low + h * 24 + h * h * 13 / 64;
}

/* As fractal3, for octaves in 1/256: the finest octave comes in gradually, so that the
 * number of octaves may depend on the distance without a border in the sky. */
static int fractal3_q8(vec place, int cell, int octaves_q8, uint32_t seed)
{
    int octaves = octaves_q8 >> 8, share = octaves_q8 & 255;
    int coarse = fractal3(place, cell, octaves, seed);
    return share ? mix_int(coarse, fractal3(place, cell, octaves + 1, seed), share)
                 : coarse;
}

/* Density, 0..256 of dense cloud, with the octaves of the fine noise. That noise adds at
 * most 12288; without a chance to reach the threshold the place is clear. */
static int density(vec p, int octaves_q8)
{
    if (p.y < BASE || p.y > TOP)
        return 0;
    p.x += ASIDE_X;
    p.z += ASIDE_Z;
    vec level = { p.x, 0, p.z };
    int cover = (fractal3(level, 5200, 2, 301) - 32768) / 5;
    int need = need_at(p.y, cover);
    int coarse = fractal3(p, CELL, 2, 302);
    if (coarse + 12288 < need)
        return 0;
    int fine = (fractal3_q8(p, CELL / 4, octaves_q8, 304) - 32768) * 3 / 8;
    return clamp_int((coarse + fine - need) / 14, 0, 256);
}

/* Transmittance 1 / e^tau for tau in 1/256, by the first terms; Q14. */
static int32_t fading(int tau_q8)
{
    int64_t t = tau_q8;
    return (int32_t)(16384 * 65536 / (65536 + t * 256 + t * t / 2));
}

/* Sunlight at a place, Q14. Multiple forward scattering reaches deeper than Beer's law: the
 * second term. */
static int32_t sunlight(vec p, vec sun)
{
    static const int32_t at[5] = { 40, 100, 190, 320, 520 };
    int tau = 0, from = 0;
    for (int i = 0; i < 5; i++) {
        tau +=
            density(sum(p, along(sun, (at[i] + from) / 2)), 256) * (at[i] - from) / DENSE;
        from = at[i];
    }
    return fading(tau) * 11 / 16 + fading(tau / 5) * 5 / 16;
}

/* Light of a sample towards the eye. */
static light sample_shine(vec p, vec sun)
{
    int high = clamp_int((p.y - BASE) * 16 / (TOP - BASE), 0, 16);
    light ambient = light_scale(light_of(0x8ea2ba), 16384 * (22 + high) / 36);
    return light_add(ambient, light_scale(light_of(0xc4b8a4), sunlight(p, sun)));
}

/* Octaves of the fine noise in 1/256: 4 near, 1 at 26 km, where a texel is 200 m. */
static int octaves_at(int32_t metres)
{
    return 256 + (26000 - clamp_int(metres, 4000, 26000)) * 768 / 22000;
}

cloud_look cumulus(vec dir, vec sun)
{
    cloud_look look = { 16384, { 0, 0, 0 }, 0 };
    if (dir.y * (FARTHEST / 64) < BASE * 256)
        return look;
    int32_t from = (int32_t)((int64_t)BASE * 16384 / dir.y);
    int32_t to = (int32_t)((int64_t)TOP * 16384 / dir.y);
    to = to > FARTHEST ? FARTHEST : to;
    int32_t step = (to - from) / STEPS;
    look.haze = 16384 - fading((from + to) / 2 * 256 / 15000);
    for (int i = 0; i < STEPS && look.through > 300; i++) {
        int32_t t = from + step * i + step / 2;
        vec p = along(dir, t);
        int dense = density(p, octaves_at(t));
        if (dense == 0)
            continue;
        int32_t left =
            (int32_t)((int64_t)look.through * fading(dense * step / DENSE) / 16384);
        light here = light_scale(sample_shine(p, sun), look.through - left);
        look.shine = light_add(look.shine, here);
        look.through = left;
    }
    return look;
}

/* Thickness of a layer 5 km up with noise stretched four times along z. */
int32_t cloud_bars(vec dir)
{
    if (dir.y < 500)
        return 0;
    int32_t reach = (int32_t)((int64_t)5000 * 16384 / (dir.y + 400));
    vec p = along(dir, reach);
    vec at = { p.x, 0, p.z / 4 };
    int warp = fractal3(at, 3000, 2, 311) - 32768;
    at.x += warp / 30;
    int n = fractal3_q8(at, 1500, 1280 - clamp_int(reach - 10000, 0, 20000) / 40, 315);
    vec wide = { p.x, 0, p.z / 3 };
    int cover = (fractal3(wide, 7000, 2, 321) - 32768) / 3;
    int thick = clamp_int((n + cover - 36500) * 2, 0, 16384);
    int32_t low = clamp_int((dir.y - 500) * 8, 0, 16384);
    int32_t high = clamp_int((11500 - dir.y) * 3, 0, 16384);
    return (int32_t)((int64_t)thick * low / 16384 * high / 16384);
}
