/* SPDX-License-Identifier: MIT */
/* Colour arithmetic of span stages: 0x00RRGGBB, channels 0..255, shares 0..256.  Products
 * are rounded unless a comment says otherwise; sums are clamped to 255.
 *
 * A colour with an alpha is 0xAARRGGBB.  For light, alpha is the intensity beyond white.
 * For a picture, alpha is the coverage. */
#ifndef TP_SHADE_COLOUR_H
#define TP_SHADE_COLOUR_H
#include "base/dsp.h"

/* Half a level in each lane.  Products are rounded: without rounding each stage of a list
 * would darken the picture by half a level. */
#define TP_HALF_RB 0x00800080u
#define TP_HALF_G  0x00008000u

/* Returns each channel times share / 256. */
static inline uint32_t tp_colour_scale(uint32_t colour, uint32_t share)
{
    uint32_t rb = tp_odd_bytes(tp_even_bytes(colour) * share + TP_HALF_RB);
    return rb | (((colour >> 8 & 0xff) * share + 128) & 0xff00);
}

/* Returns a mix: share / 256 of b and the rest of a; share 0..256. */
static inline uint32_t tp_colour_mix(uint32_t a, uint32_t b, uint32_t share)
{
    uint32_t rb = ((a & 0x00ff00ffu) * (256 - share) + (b & 0x00ff00ffu) * share
                   + TP_HALF_RB) >> 8;
    uint32_t g = ((a & 0x0000ff00u) * (256 - share) + (b & 0x0000ff00u) * share
                  + TP_HALF_G) >> 8;
    return (rb & 0x00ff00ffu) | (g & 0x0000ff00u);
}

/* tp_colour_mix of one channel, 0..255. */
static inline uint32_t tp_channel_mix(uint32_t a, uint32_t b, uint32_t share)
{
    return (a * (256 - share) + b * share + 128) >> 8;
}

/* A colour with split channels: red and blue in the halves of one word, green in another.
 * Saves repeated splitting where several operations follow each other. */
typedef struct {
    uint32_t rb, g;
} tp_split_rgb;

TP_ALWAYS_INLINE tp_split_rgb tp_split_rgb_make(uint32_t colour)
{
    return (tp_split_rgb){ tp_even_bytes(colour), colour >> 8 & 0xff };
}

TP_ALWAYS_INLINE uint32_t tp_split_rgb_join(tp_split_rgb p)
{
    return p.rb | p.g << 8;
}

/* tp_colour_mix of split channels */
TP_ALWAYS_INLINE tp_split_rgb tp_split_rgb_mix(tp_split_rgb a, tp_split_rgb b,
                                               uint32_t share)
{
    return (tp_split_rgb){
        tp_odd_bytes(a.rb * (256 - share) + b.rb * share + TP_HALF_RB),
        tp_channel_mix(a.g, b.g, share),
    };
}

/* Returns n / 255, rounded, for n <= 255 * 255. */
static inline uint32_t tp_divide_by_255(uint32_t n)
{
    n += 128;
    return (n + (n >> 8)) >> 8;
}

/* Product of each channel, where 255 stands for 1.  Red and blue apply
 * tp_divide_by_255 to both halves of a word at once. */
TP_ALWAYS_INLINE uint32_t tp_split_rgb_multiply(tp_split_rgb a, tp_split_rgb b)
{
    uint32_t r, blue, g = a.g * b.g + 128;

    if (TP_DSP) {
        r = tp_smlatb(a.rb, b.rb >> 16, 128);
        blue = tp_smlabb(a.rb, b.rb, 128);
    } else {
        r = (a.rb >> 16) * (b.rb >> 16) + 128;
        blue = (a.rb & 0xff) * (b.rb & 0xff) + 128;
    }
    uint32_t rb = r << 16 | blue;
    return tp_odd_bytes(tp_halves_add_odd_bytes(rb, rb)) | ((g + (g >> 8)) & 0xff00);
}

static inline uint32_t tp_colour_times(uint32_t a, uint32_t b)
{
    return tp_split_rgb_multiply(tp_split_rgb_make(a), tp_split_rgb_make(b));
}

/* Sum of each channel, clamped to 255. */
static inline uint32_t tp_colour_add(uint32_t a, uint32_t b)
{
    if (TP_DSP)
        return tp_uqadd8(a, b) & 0xffffff;
    uint32_t over = ((a & b) + ((a ^ b) >> 1 & 0x7f7f7f)) & 0x808080, carry = over << 1;
    return ((a & 0xffffff) + (b & 0xffffff) - carry) | (carry - (over >> 7));
}

/* Returns the channel times gain / 256, rounded down and clamped to 255.  The gain may be
 * above 1: caustics focus light. */
static inline uint32_t tp_channel_brighten(uint32_t c, uint32_t gain)
{
    c = c * gain >> 8;
    return c < 255 ? c : 255;
}

static inline uint32_t tp_colour_brighten(uint32_t colour, uint32_t gain)
{
    return tp_channel_brighten(colour >> 16 & 0xff, gain) << 16
         | tp_channel_brighten(colour >> 8 & 0xff, gain) << 8
         | tp_channel_brighten(colour & 0xff, gain);
}

/* Returns the diffuse light on a matt colour: the ambient share plus N.L of the rest.
 * `ambient` is 0..256, `nl` Q1.14 in 0..1. */
static inline int32_t tp_lit_share(int32_t ambient, int32_t nl)
{
    return ambient + ((256 - ambient) * nl >> 14);
}

/* -- colours with an alpha ----------------------------------------------------------- */

/* Mixes all four bytes: share / 256 of b and the rest of a, rounded down; share 0..256. */
TP_ALWAYS_INLINE uint32_t tp_argb_mix(uint32_t a, uint32_t b, uint32_t share)
{
    uint32_t rb = ((a & 0x00ff00ffu) * (256 - share) + (b & 0x00ff00ffu) * share) >> 8;
    uint32_t ag = (a >> 8 & 0x00ff00ffu) * (256 - share) + (b >> 8 & 0x00ff00ffu) * share;
    return (rb & 0x00ff00ffu) | (ag & 0xff00ff00u);
}

/* Mixes all four bytes: f / 32 of b and the rest of a, rounded; f 0..32. */
static inline uint32_t tp_argb_mix_32nds(uint32_t a, uint32_t b, uint32_t f)
{
    uint32_t low = (a & 0x00ff00ffu) * (32 - f) + (b & 0x00ff00ffu) * f + 0x00100010u;
    uint32_t high = (a >> 8 & 0x00ff00ffu) * (32 - f) + (b >> 8 & 0x00ff00ffu) * f
                  + 0x00100010u;
    return (low >> 5 & 0x00ff00ffu) | (high << 3 & 0xff00ff00u);
}

/* Lays `top`, a colour premultiplied by its alpha, over light whose alpha is the intensity
 * beyond white.  Covered light loses that intensity too. */
static inline uint32_t tp_colour_composite(uint32_t under, uint32_t top)
{
    uint32_t alpha = top >> 24, left = 256 - alpha - (alpha >> 7);
    uint32_t beyond = (under >> 24) * left >> 8;

    return tp_colour_add(tp_colour_scale(under, left), top & 0xffffff) | beyond << 24;
}
#endif
