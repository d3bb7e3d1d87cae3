/* SPDX-License-Identifier: MIT */
/* Textures: scales a picture to sides of powers of two, and makes its mipmap levels.
 *
 * The levels lie one after the other.  Resampling treats the picture as a repeating tile.
 * Destination texel i has its centre at (i + 1/2) w / w2 of the source; the four source
 * pixels around the centre are weighted by 8-bit fractions. */
#include <stdbool.h>
#include "base/base.h"
#include "tidepool/assets.h"

enum { MOST = 4096 };

static uint32_t ceil_log2(uint32_t n)
{
    uint32_t log2 = 0;
    while (1u << log2 < n)
        log2++;
    return log2;
}

static uint32_t level_side(uint32_t log2, uint32_t level)
{
    return log2 > level ? 1u << (log2 - level) : 1;
}

static bool is_valid_size(uint32_t w, uint32_t h)
{
    return w >= 1 && w <= MOST && h >= 1 && h <= MOST;
}

/* At most 4/3 of 4096 x 4096 texels plus the thin end: 22.4 million, 90 MB. */
size_t tp_texture_bytes(uint32_t w, uint32_t h)
{
    if (!is_valid_size(w, h))
        return 0;
    const uint32_t log2_w = ceil_log2(w), log2_h = ceil_log2(h);
    size_t texels = 0;
    for (uint32_t level = 0; level <= log2_w || level <= log2_h; level++)
        texels += (size_t)level_side(log2_w, level) * level_side(log2_h, level);
    return texels * sizeof(uint32_t);
}

/* -- resampling ---------------------------------------------------------------------- */

/* Two neighbours along one axis, and the weight of the second in 1/256. */
typedef struct { uint32_t first, second, weight; } tap;

/* i < 2^log2 <= 4096 and n <= 4096: the product stays below 2^41. */
static tap make_tap(uint32_t i, uint32_t n, uint32_t log2)
{
    TP_ASSERT(n > 0 && n <= MOST && i >> log2 == 0);
    const int64_t centre = ((int64_t)(2 * i + 1) * n * 256 >> (log2 + 1)) - 128;
    const uint32_t at = (uint32_t)(centre < 0 ? centre + (int64_t)n * 256 : centre);
    const uint32_t first = at >> 8;
    return (tap){ first, first + 1 < n ? first + 1 : 0, at & 255 };
}

/* Blends one channel of four pixels.  The weights add up to 2^16: 24 bits with rounding. */
static uint32_t blend_texel_channel(const uint32_t pixel[4], const uint32_t weight[4],
                                    uint32_t channel_shift)
{
    uint32_t sum = 0x8000;
    for (int i = 0; i < 4; i++)
        sum += (pixel[i] >> channel_shift & 255) * weight[i];
    return sum >> 16 << channel_shift;
}

static uint32_t sample_bilinear(const uint32_t *pixels, uint32_t w, tap x, tap y)
{
    const uint32_t *const upper = pixels + (size_t)y.first * w;
    const uint32_t *const lower = pixels + (size_t)y.second * w;
    const uint32_t pixel[4] = { upper[x.first], upper[x.second],
                                lower[x.first], lower[x.second] };
    const uint32_t weight[4] = {
        (256 - x.weight) * (256 - y.weight), x.weight * (256 - y.weight),
        (256 - x.weight) * y.weight,         x.weight * y.weight };
    return blend_texel_channel(pixel, weight, 0) | blend_texel_channel(pixel, weight, 8)
           | blend_texel_channel(pixel, weight, 16)
           | blend_texel_channel(pixel, weight, 24);
}

static void fill_first_level(uint32_t *to, uint32_t log2_w, uint32_t log2_h,
                             const uint32_t *pixels, uint32_t w, uint32_t h)
{
    for (uint32_t y = 0; y < level_side(log2_h, 0); y++) {
        const tap row = make_tap(y, h, log2_h);
        for (uint32_t x = 0; x < level_side(log2_w, 0); x++)
            *to++ = sample_bilinear(pixels, w, make_tap(x, w, log2_w), row);
    }
}

/* -- mipmap levels ------------------------------------------------------------------- */

/* Averages two channels at a time, 16 bits each: four times 255 and the rounding fit. */
static uint32_t average_pixels(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    const uint32_t mask = 0x00ff00ff, half = 0x00020002;
    const uint32_t low = (a & mask) + (b & mask) + (c & mask) + (d & mask) + half;
    const uint32_t high = (a >> 8 & mask) + (b >> 8 & mask) + (c >> 8 & mask)
                        + (d >> 8 & mask) + half;
    return (low >> 2 & mask) | (high >> 2 & mask) << 8;
}

/* Halves a picture of w x h.  A side of 1 stays 1: its texels count twice. */
static void halve(uint32_t *to, const uint32_t *from, uint32_t w, uint32_t h)
{
    const uint32_t right = w > 1, below = h > 1 ? w : 0;
    for (uint32_t y = 0; y < h; y += 2) {
        for (uint32_t x = 0; x < w; x += 2) {
            const uint32_t *const at = from + (size_t)y * w + x;
            *to++ = average_pixels(at[0], at[right], at[below], at[below + right]);
        }
    }
}

tp_status tp_texture_init(tp_texture *texture, const uint32_t *pixels, uint32_t w,
                          uint32_t h, void *memory, size_t bytes, tp_error *err)
{
    if (!is_valid_size(w, h))
        return TP_FAIL(err, TP_E_TEXTURE, 0, w, h);
    tp_status status = tp_pointer_check(texture, "texture", err);
    if (status == TP_OK)
        status = tp_pointer_check(pixels, "pixels", err);
    if (status == TP_OK)
        status = tp_pointer_check_aligned(memory, 4, "memory", err);
    if (status != TP_OK)
        return status;
    if (bytes < tp_texture_bytes(w, h))
        return TP_FAIL(err, TP_E_NOSPACE, 0, tp_texture_bytes(w, h), bytes);
    const uint32_t log2_w = ceil_log2(w), log2_h = ceil_log2(h);
    const uint32_t levels = (log2_w > log2_h ? log2_w : log2_h) + 1;
    *texture = (tp_texture){ .log2_w = (uint8_t)log2_w, .log2_h = (uint8_t)log2_h,
                             .levels = (uint8_t)levels };
    uint32_t *at = memory;
    for (uint32_t level = 0; level < levels; level++) {
        texture->level[level] = at;
        if (level == 0)
            fill_first_level(at, log2_w, log2_h, pixels, w, h);
        else
            halve(at, texture->level[level - 1], level_side(log2_w, level - 1),
                  level_side(log2_h, level - 1));
        at += (size_t)level_side(log2_w, level) * level_side(log2_h, level);
    }
    return TP_OK;
}
