/* SPDX-License-Identifier: MIT */
/* See canvas.h.  Noise is value noise with the fade 6t^5 - 15t^4 + 10t^3 (Perlin 2002),
 * cells are those of Worley 1996, the hash is the finalizer of MurmurHash3. */
#include "canvas.h"

#include <png.h>
#include <stdio.h>
#include <stdlib.h>

int clamp_int(int v, int low, int high)
{
    return v < low ? low : v > high ? high : v;
}

int mix_int(int a, int b, int t_256)
{
    return (a * (256 - t_256) + b * t_256 + 128) / 256;
}

uint32_t rgb(int r, int g, int b)
{
    return (uint32_t)clamp_int(r, 0, 255) << 16 | (uint32_t)clamp_int(g, 0, 255) << 8
           | (uint32_t)clamp_int(b, 0, 255);
}

static int channel(uint32_t c, int shift)
{
    return (int)(c >> shift & 255);
}

uint32_t rgb_mix(uint32_t a, uint32_t b, int t_256)
{
    int t = clamp_int(t_256, 0, 256);
    return rgb(mix_int(channel(a, 16), channel(b, 16), t),
               mix_int(channel(a, 8), channel(b, 8), t),
               mix_int(channel(a, 0), channel(b, 0), t));
}

uint32_t rgb_scale(uint32_t c, int by_256)
{
    return rgb(channel(c, 16) * by_256 / 256, channel(c, 8) * by_256 / 256,
               channel(c, 0) * by_256 / 256);
}

uint32_t root_u64(uint64_t v)
{
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 31; bit != 0; bit >>= 1) {
        if ((root + bit) * (root + bit) <= v)
            root += bit;
    }
    return (uint32_t)root;
}

uint32_t hash(int x, int y, uint32_t seed)
{
    uint32_t h =
        (uint32_t)x * 0x9e3779b1u ^ (uint32_t)y * 0x85ebca77u ^ seed * 0xc2b2ae3du;
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return h ^ h >> 16;
}

/* Quarter wave by the odd polynomial of degree 5 in u = 4 turns that is exact at both ends:
 * (pi/2) u - (pi - 5/2) u^3 + (pi/2 - 3/2) u^5, error below 4.5e-4. */
int32_t sine_q14(int32_t turn_q16)
{
    int32_t t = turn_q16 & 65535;
    bool negative = t >= 32768;
    t &= 32767;
    int64_t u = t <= 16384 ? t : 32768 - t; /* Q14, 0..1 */
    int64_t u2 = u * u >> 14;
    int64_t s = (u * (25736 - (u2 * (10512 - (1160 * u2 >> 14)) >> 14))) >> 14;
    return (int32_t)(negative ? -s : s);
}

int wrap(int v, int period)
{
    int r = v % period;
    return r < 0 ? r + period : r;
}

static int floor_q8(int32_t v_q8)
{
    return (int)((v_q8 - (v_q8 & 255)) / 256);
}

/* 6t^5 - 15t^4 + 10t^3 for t in 1/256; 0..4096. */
static int fade_q12(int t)
{
    int64_t t3 = (int64_t)t * t * t;
    return (int)((t3 * (6 * t * t - 15 * 256 * t + 10 * 65536)) >> 28);
}

int noise(int32_t x_q8, int32_t y_q8, int px, int py, uint32_t seed)
{
    int x0 = wrap(floor_q8(x_q8), px), x1 = wrap(x0 + 1, px);
    int y0 = wrap(floor_q8(y_q8), py), y1 = wrap(y0 + 1, py);
    int64_t fx = fade_q12(x_q8 & 255), fy = fade_q12(y_q8 & 255);
    int64_t a = hash(x0, y0, seed) >> 16, b = hash(x1, y0, seed) >> 16;
    int64_t c = hash(x0, y1, seed) >> 16, d = hash(x1, y1, seed) >> 16;
    int64_t top = a * (4096 - fx) + b * fx, low = c * (4096 - fx) + d * fx;
    return (int)((top * (4096 - fy) + low * fy) >> 24);
}

int fractal(int x, int y, int w, int h, int nx, int ny, int octaves, uint32_t seed)
{
    int sum = 0, weights = 0;
    for (int i = 0; i < octaves; i++) {
        int weight = 256 >> i, px = nx << i, py = ny << i;
        sum += noise(x * 256 * px / w, y * 256 * py / h, px, py, seed + (uint32_t)i)
               * weight / 256;
        weights += weight;
    }
    return (int)((int64_t)sum * 256 / weights);
}

cells cells_at(int32_t x_q8, int32_t y_q8, int n, uint32_t seed)
{
    cells found = { 1 << 14, 1 << 14, 0 };
    int cx = floor_q8(x_q8), cy = floor_q8(y_q8);
    for (int j = cy - 2; j <= cy + 2; j++) {
        for (int i = cx - 2; i <= cx + 2; i++) {
            uint32_t h = hash(wrap(i, n), wrap(j, n), seed);
            int64_t dx = i * 256 + (int)(h & 255) - x_q8;
            int64_t dy = j * 256 + (int)(h >> 8 & 255) - y_q8;
            int32_t d = (int32_t)root_u64((uint64_t)(dx * dx + dy * dy));
            if (d < found.near) {
                found.next = found.near;
                found.near = d;
                found.id = h;
            } else if (d < found.next) {
                found.next = d;
            }
        }
    }
    return found;
}

/* Component v / length of a unit vector as 0..255 around 127.5, rounded. */
static int normal_channel(int64_t v, int64_t length)
{
    return (int)((v * 255 + length * 256) / (length * 2));
}

uint32_t normal_rgb(int32_t slope_x_q16, int32_t slope_up_q16)
{
    int64_t x = -(int64_t)slope_x_q16, y = -(int64_t)slope_up_q16, z = 65536;
    int64_t length = root_u64((uint64_t)(x * x + y * y + z * z));
    return rgb(normal_channel(x, length), normal_channel(y, length),
               normal_channel(z, length));
}

void relief_normals(const relief *from, canvas *to)
{
    int w = from->w, h = from->h;
    to->w = w;
    to->h = h;
    for (int y = 0; y < h; y++) {
        const int32_t *row = from->at + y * w;
        const int32_t *up = from->at + wrap(y - 1, h) * w;
        const int32_t *down = from->at + wrap(y + 1, h) * w;
        for (int x = 0; x < w; x++) {
            int32_t dx = row[wrap(x + 1, w)] - row[wrap(x - 1, w)];
            to->pixel[y * w + x] = normal_rgb(dx * 128, (up[x] - down[x]) * 128);
        }
    }
}

int relief_light(const relief *from, int x, int y)
{
    int w = from->w, h = from->h;
    int across = from->at[y * w + wrap(x - 1, w)] - from->at[y * w + wrap(x + 1, w)];
    int down = from->at[wrap(y - 1, h) * w + x] - from->at[wrap(y + 1, h) * w + x];
    return clamp_int(256 - (across + down) * 3 / 8, 64, 448);
}

static void fail(const char *path, const char *why)
{
    fprintf(stderr, "%s: %s\n", path, why);
    exit(3);
}

static void write_rows(png_structp png, const canvas *picture)
{
    for (int y = 0; y < picture->h; y++) {
        png_byte row[4 * CANVAS_SIDE], *at = row;
        for (int x = 0; x < picture->w; x++) {
            uint32_t c = picture->pixel[y * picture->w + x];
            *at++ = (png_byte)(c >> 16);
            *at++ = (png_byte)(c >> 8);
            *at++ = (png_byte)c;
            if (picture->alpha)
                *at++ = (png_byte)(c >> 24);
        }
        png_write_row(png, row);
    }
}

void canvas_save(const canvas *picture, const char *dir, const char *name)
{
    char path[1024];
    int length = snprintf(path, sizeof path, "%s/%s", dir, name);
    FILE *file = length < (int)sizeof path ? fopen(path, "wb") : NULL;
    if (file == NULL)
        fail(name, "cannot be written");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    if (info == NULL || setjmp(png_jmpbuf(png)))
        fail(path, "libpng failed");
    png_init_io(png, file);
    png_set_compression_level(png, 9);
    png_set_IHDR(png, info, (png_uint_32)picture->w, (png_uint_32)picture->h, 8,
                 picture->alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    write_rows(png, picture);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    if (fclose(file) != 0)
        fail(path, "cannot be written");
}
