/* SPDX-License-Identifier: MIT */
/*
 * Means of packed rgb565 pixels, for quality.blending: of two rows, and of the even
 * columns of a row.  Two bodies have the same results: one pixel at a time, and two pixels
 * in a word.  Columns in words need little-endian memory; other machines take the first body
 * for them.
 *
 * A mean of two levels is rounded up or down by its place in the picture, so that neither
 * rows nor columns get darker.  Pairs of columns and of rows take turns for the mean of two
 * rows, pairs of rows for the mean of two columns.  `be`, a literal: the bytes of
 * pixels are swapped, as rgb565be has them on little-endian machines.
 */
#ifndef TP_PIXEL_PACKED_BLEND_H
#define TP_PIXEL_PACKED_BLEND_H
#include "base/base.h"
#include "base/word_pairs.h"

#define TP_IS_LITTLE_ENDIAN (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)

/* -- one or two pixels --------------------------------------------------------------- */

/* All bits but the highest of each channel, of two pixels: half of a channel's difference
 * stays in the channel. */
#define TP_HALF_MASK_565 0x7bef7befu

/* Return the means of one or two pixels in a word, rounded up or down. */
TP_ALWAYS_INLINE uint32_t tp_floor_mean_565(uint32_t a, uint32_t b)
{
    return (a & b) + ((a ^ b) >> 1 & TP_HALF_MASK_565);
}

TP_ALWAYS_INLINE uint32_t tp_ceiling_mean_565(uint32_t a, uint32_t b)
{
    return (a | b) - ((a ^ b) >> 1 & TP_HALF_MASK_565);
}

TP_ALWAYS_INLINE uint32_t tp_mean_565(uint32_t a, uint32_t b, bool up)
{
    return up ? tp_ceiling_mean_565(a, b) : tp_floor_mean_565(a, b);
}

/* True if the mean of two rows at column x, between them row y, is rounded up; and the mean
 * of two columns of row y. */
TP_ALWAYS_INLINE bool tp_is_row_mean_ceiling(int32_t x, int32_t y)
{
    return ((x ^ y) >> 1 & 1) != 0;
}

TP_ALWAYS_INLINE bool tp_is_column_mean_ceiling(int32_t y)
{
    return (y >> 1 & 1) != 0;
}

TP_ALWAYS_INLINE uint32_t tp_swap_pixel(uint32_t pixel, int be)
{
    return be ? pixel >> 8 | (pixel & 0xff) << 8 : pixel;
}

TP_ALWAYS_INLINE uint32_t tp_swap_pixels(uint32_t pair, int be)
{
    return be ? tp_swap_bytes_of_halves(pair) : pair;
}

/* -- one pixel at a time ------------------------------------------------------------- */

/* Writes the means of `count` pixels of the rows above and below row y, from column x
 * on. */
TP_ALWAYS_INLINE void plain_mean_rows(uint16_t *to, const uint16_t *above,
                                      const uint16_t *below, int32_t x, int32_t y,
                                      int32_t count, int be)
{
    for (int32_t i = 0; i < count; i++)
        to[i] = (uint16_t)tp_swap_pixel(tp_mean_565(tp_swap_pixel(above[i], be),
                                                    tp_swap_pixel(below[i], be),
                                                    tp_is_row_mean_ceiling(x + i, y)), be);
}

/* Writes columns [i, end) of a run of `count` columns from column x of the picture on, in
 * row y.  `half` has the run's first column and its even columns, one after the other.  Odd
 * columns are means as in tp_quick_odd_fill. */
TP_ALWAYS_INLINE void plain_widen_columns(uint16_t *to, const uint16_t *half, int32_t x,
                                          int32_t y, int32_t i, int32_t end, int32_t count,
                                          int be)
{
    const int32_t odd = x & 1;
    const bool up = tp_is_column_mean_ceiling(y);

    for (; i < end; i++) {
        const uint16_t *from = half + ((i + odd) >> 1);
        const bool copied = ((x + i) & 15) == 15 || i + 1 == count || i == 0;

        if (i > 0 && ((x + i) & 1))
            from = half + ((i - 1 + odd) >> 1);
        to[i] = copied || !((x + i) & 1)
                    ? *from
                    : (uint16_t)tp_swap_pixel(tp_mean_565(tp_swap_pixel(from[0], be),
                                                          tp_swap_pixel(from[1], be), up),
                                              be);
    }
}

/* -- two pixels at a time ------------------------------------------------------------ */

TP_ALWAYS_INLINE void packed_mean_four(uint32_t *to, const uint32_t *above,
                                       const uint32_t *below, int index, int be)
{
    const tp_word_pair a = tp_load_pair(above, index), b = tp_load_pair(below, index);

    tp_store_pair(to, index,
                  tp_swap_pixels(tp_ceiling_mean_565(tp_swap_pixels(a.first, be),
                                                tp_swap_pixels(b.first, be)), be),
                  tp_swap_pixels(tp_floor_mean_565(tp_swap_pixels(a.second, be),
                                                  tp_swap_pixels(b.second, be)), be));
}

/* The same as plain_mean_rows; all pixels at multiples of 4 bytes, x even. */
TP_ALWAYS_INLINE void packed_mean_rows(uint16_t *to, const uint16_t *above,
                                       const uint16_t *below, int32_t x, int32_t y,
                                       int32_t count, int be)
{
    int32_t i = 0;

    if (!tp_is_row_mean_ceiling(x, y)) {    /* the loop begins with a pair rounded up */
        i = count < 2 ? count : 2;
        plain_mean_rows(to, above, below, x, y, i, be);
    }
    uint32_t *words = (uint32_t *)(void *)(to + i);
    const uint32_t *over = (const uint32_t *)(const void *)(above + i);
    const uint32_t *under = (const uint32_t *)(const void *)(below + i);
    for (; i + 8 <= count; i += 8, words += 4, over += 4, under += 4) {
        packed_mean_four(words, over, under, 0, be);
        packed_mean_four(words, over, under, 2, be);
    }
    plain_mean_rows(to + i, above + i, below + i, x + i, y, count - i, be);
}

/* Writes four columns: two even ones, a, each with the mean of it and the next; `next` has
 * the two even columns that follow. */
TP_ALWAYS_INLINE void packed_widen_pair(uint32_t *to, int index, uint32_t a, uint32_t next,
                                        bool up, int be)
{
    const uint32_t mean = tp_mean_565(a, tp_pack_low_halves(a >> 16, next), up);

    tp_store_pair(to, index, tp_swap_pixels(tp_pack_low_halves(a, mean), be),
                  tp_swap_pixels(tp_pack_high_halves(a, mean), be));
}

/* Writes a block of 16 columns of the picture from its 8 even columns; both at multiples of
 * 4 bytes. */
TP_ALWAYS_INLINE void packed_widen_block(uint32_t *to, const uint32_t *half, bool up,
                                         int be)
{
    const tp_word_pair p = tp_load_pair(half, 0), q = tp_load_pair(half, 2);
    const uint32_t a = tp_swap_pixels(p.first, be), b = tp_swap_pixels(p.second, be);
    const uint32_t c = tp_swap_pixels(q.first, be), d = tp_swap_pixels(q.second, be);

    packed_widen_pair(to, 0, a, b, up, be);
    packed_widen_pair(to, 2, b, c, up, be);
    packed_widen_pair(to, 4, c, d, up, be);
    packed_widen_pair(to, 6, d, d >> 16, up, be);
}

/* The same as plain_widen_columns, of a whole run.  Even columns of blocks of 16 columns
 * begin at multiples of 4 bytes in `half`, and pixels of even columns in `to`. */
TP_ALWAYS_INLINE void packed_widen_run(uint16_t *to, const uint16_t *half, int32_t x,
                                       int32_t y, int32_t count, int be)
{
    const int32_t begin = -x & 15, end = count - ((x + count) & 15);

    if (begin >= end || !TP_IS_LITTLE_ENDIAN) {
        plain_widen_columns(to, half, x, y, 0, count, count, be);
        return;
    }
    plain_widen_columns(to, half, x, y, 0, begin, count, be);
    uint32_t *words = (uint32_t *)(void *)(to + begin);
    uint32_t *const stop = words + (end - begin) / 2;
    const uint32_t *from =
        (const uint32_t *)(const void *)(half + ((begin + (x & 1)) >> 1));
    if (tp_is_column_mean_ceiling(y)) {
        for (; words != stop; words += 8, from += 4)
            packed_widen_block(words, from, true, be);
    } else {
        for (; words != stop; words += 8, from += 4)
            packed_widen_block(words, from, false, be);
    }
    plain_widen_columns(to, half, x, y, end, count, count, be);
}

#endif
