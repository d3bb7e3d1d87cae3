/* SPDX-License-Identifier: MIT */
/* Keys of water by the depth of level water, one number a row of pixels if the picture does
 * not roll: what the stages of fast rows and of walked water read. */
#include "base/word_pairs.h"
#include "frame/frame.h"
#include "raster/scanline_cover.h"

/* Returns the key of water for near / depth of level water, Q1.43.  Water before the near
 * plane has the largest depth, water beyond the horizon the smallest. */
static uint32_t make_level_key(int64_t zi)
{
    const int64_t zi_q31 = zi >> TP_LEVEL_ZI;
    return make_water_key(zi_q31 < 0x80 ? 0x80 : zi_q31 > INT32_MAX ? INT32_MAX
                                                                    : (uint32_t)zi_q31);
}

/* Writes `count` equal words. */
static void fill_words(uint32_t *to, uint32_t value, int32_t count)
{
    uint32_t *const end = to + count, *const whole = to + (count & ~7);

    for (; to != whole; to += 8) {
        tp_store_pair(to, 0, value, value);
        tp_store_pair(to, 2, value, value);
        tp_store_pair(to, 4, value, value);
        tp_store_pair(to, 6, value, value);
    }
    while (to != end)
        *to++ = value;
}

void tp_frame_write_level_keys(const tp_frame *frame, int32_t x, int32_t y, int32_t count,
                               uint32_t *key)
{
    const tp_level_linear *zi = frame->level_zi;
    int64_t now = tp_level_evaluate(zi, x, y);

    if (zi->x == 0) {
        fill_words(key, make_level_key(now), count);
        return;
    }
    for (int32_t i = 0; i < count; i++, now += zi->x)
        key[i] = make_level_key(now);
}

/* Sets the keys of a row between sky and water. */
static void write_mixed_keys(const tp_frame *frame, const tp_fast_rows *rows, int32_t y,
                             uint32_t *key)
{
    const tp_gbuffer *tile = rows->tile;

    tp_frame_write_level_keys(frame, tile->x0, y, tile->x1 - tile->x0, key);
    for (int32_t x = tile->x0; x < tile->x1; x++)
        if (!tp_fast_rows_is_water(rows, x, y))
            key[x - tile->x0] = TP_MARK_SKY;
}

void tp_frame_write_alone_keys(const tp_frame *frame, const tp_fast_rows *rows,
                               const tp_water_rows *found)
{
    const tp_gbuffer *tile = rows->tile;
    const int32_t width = tile->x1 - tile->x0;
    uint32_t *key = tile->key;

    for (int32_t y = tile->y0; y < tile->y1; y++, key += tile->stride) {
        if (y < found->sky_end)
            fill_words(key, TP_MARK_SKY, width);
        else if (y < found->water_begin)
            write_mixed_keys(frame, rows, y, key);
        else
            tp_frame_write_level_keys(frame, tile->x0, y, width, key);
    }
}
