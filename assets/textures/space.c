/* SPDX-License-Identifier: MIT */
/* Directions, light and noise in space; see the header. */
#include "space.h"
#include "canvas.h"

vec unit(int32_t x, int32_t y, int32_t z)
{
    int64_t square = (int64_t)x * x + (int64_t)y * y + (int64_t)z * z;
    int64_t length = root_u64((uint64_t)square << 8); /* 16 times it, for a fine division */
    int64_t half = length / 2;
    vec v = { (int32_t)(((int64_t)x * (1 << 18) + (x < 0 ? -half : half)) / length),
              (int32_t)(((int64_t)y * (1 << 18) + (y < 0 ? -half : half)) / length),
              (int32_t)(((int64_t)z * (1 << 18) + (z < 0 ? -half : half)) / length) };
    return v;
}

vec heading_at(int32_t heading_degrees, int32_t elevation_degrees)
{
    int32_t heading = heading_degrees * 65536 / 360;
    int32_t elevation = elevation_degrees * 65536 / 360;
    int32_t level = sine_q14(elevation + 16384);
    return unit(level * sine_q14(heading) / 16384, sine_q14(elevation),
                level * sine_q14(heading + 16384) / -16384);
}

int32_t cosine(vec a, vec b)
{
    return (a.x * b.x + a.y * b.y + a.z * b.z) / 16384;
}

int32_t chord(vec a, vec b)
{
    int64_t x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return (int32_t)root_u64((uint64_t)(x * x + y * y + z * z));
}

light light_of(uint32_t rgb)
{
    light l = { (int32_t)(rgb >> 16 & 255) * 256, (int32_t)(rgb >> 8 & 255) * 256,
                (int32_t)(rgb & 255) * 256 };
    return l;
}

uint32_t light_rgb(light l)
{
    return rgb((l.r + 128) / 256, (l.g + 128) / 256, (l.b + 128) / 256);
}

static int32_t mix_q14(int32_t a, int32_t b, int32_t t)
{
    return a + (int32_t)((int64_t)(b - a) * t / 16384);
}

light light_mix(light a, light b, int32_t t_q14)
{
    light l = { mix_q14(a.r, b.r, t_q14), mix_q14(a.g, b.g, t_q14),
                mix_q14(a.b, b.b, t_q14) };
    return l;
}

light light_scale(light l, int32_t by_q14)
{
    light none = { 0, 0, 0 };
    return light_mix(none, l, by_q14);
}

light light_add(light a, light b)
{
    light l = { a.r + b.r, a.g + b.g, a.b + b.b };
    return l;
}

light ramp_at(const stop *stops, int count, int32_t y)
{
    int i = 0;
    while (i + 2 < count && y >= stops[i + 1].y)
        i++;
    int32_t span = stops[i + 1].y - stops[i].y;
    int32_t t = clamp_int((y - stops[i].y) * 16384 / span, 0, 16384);
    return light_mix(light_of(stops[i].rgb), light_of(stops[i + 1].rgb), t);
}

static int32_t floor_cell(int32_t v_q8)
{
    return (v_q8 - (v_q8 & 255)) / 256;
}

/* Smoothstep 3t^2 - 2t^3 of t in 1/256; 0..4096. */
static int64_t smooth(int32_t t)
{
    return (int64_t)t * t * (3 * 256 - 2 * t) >> 12;
}

/* Bilinear mix of the four corners of a cell's floor or ceiling. */
static int64_t level_of(int32_t x, int32_t z, int64_t fx, int64_t fz, uint32_t seed)
{
    int64_t a = hash(x, z, seed) >> 16, b = hash(x + 1, z, seed) >> 16;
    int64_t c = hash(x, z + 1, seed) >> 16, d = hash(x + 1, z + 1, seed) >> 16;
    int64_t near = a * (4096 - fx) + b * fx, far = c * (4096 - fx) + d * fx;
    return (near * (4096 - fz) + far * fz) >> 24;
}

int noise3(int32_t x_q8, int32_t y_q8, int32_t z_q8, uint32_t seed)
{
    int32_t x = floor_cell(x_q8), y = floor_cell(y_q8), z = floor_cell(z_q8);
    int64_t fx = smooth(x_q8 & 255), fy = smooth(y_q8 & 255), fz = smooth(z_q8 & 255);
    uint32_t low = seed + (uint32_t)y * 7919u, high = low + 7919u;
    return (int)((level_of(x, z, fx, fz, low) * (4096 - fy)
                  + level_of(x, z, fx, fz, high) * fy)
                 >> 12);
}

int fractal3(vec place, int cell, int octaves, uint32_t seed)
{
    int sum = 0, weights = 0;
    for (int i = 0; i < octaves; i++) {
        int weight = 256 >> i, n = 256 << i;
        sum += noise3((int32_t)((int64_t)place.x * n / cell),
                      (int32_t)((int64_t)place.y * n / cell),
                      (int32_t)((int64_t)place.z * n / cell), seed + (uint32_t)i)
               * weight / 256;
        weights += weight;
    }
    return (int)((int64_t)sum * 256 / weights);
}
