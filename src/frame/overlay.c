/* SPDX-License-Identifier: MIT */
/* Spans drawn by the application into a row of a tile. */
#include "frame/frame.h"

/* Depth key: near / depth in the upper 24 bits.  A span at or before the near plane covers
 * everything. */
static uint32_t make_depth_key(tp_fx near, tp_fx depth)
{
    if (depth <= near)
        return UINT32_MAX;
    return (uint32_t)(((uint64_t)(uint32_t)near << 31) / (uint32_t)depth) << 1;
}

/* Blends one of three channels: a / 255 of `over` on `under`, rounded. */
static uint32_t blend_channel(uint32_t over, uint32_t under, int shift, uint32_t a)
{
    const uint32_t x = over >> shift & 255, y = under >> shift & 255;

    return (x * a + y * (255 - a) + 127) / 255 << shift;
}

static uint32_t blended(uint32_t over, uint32_t under)
{
    const uint32_t a = over >> 24;

    return blend_channel(over, under, 16, a) | blend_channel(over, under, 8, a)
           | blend_channel(over, under, 0, a);
}

tp_overlay tp_overlay_make(void (*row)(void *user, const tp_overlay_row *row), void *user)
{
    return (tp_overlay){ row, user, tp_frame_overlay_row };
}

void tp_overlay_span(const tp_overlay_row *row, int32_t x, uint32_t count, tp_fx depth,
                     const uint32_t *argb)
{
    TP_ASSERT(row != NULL && (argb != NULL || count == 0));
    const int64_t past = (int64_t)x + count;
    const int64_t begin = x > (int64_t)row->x0 ? x : (int64_t)row->x0;
    const int64_t end = past < (int64_t)row->x1 ? past : (int64_t)row->x1;
    const uint32_t nearer = make_depth_key(row->near, depth) & ~0xffu;

    for (int64_t i = begin; i < end; i++) {
        const uint32_t over = argb[i - x];
        uint32_t *to = row->colour + (i - row->x0);
        if (over >> 24 && nearer > (row->key[i - row->x0] & ~0xffu))
            *to = over >> 24 == 255 ? over & 0xffffff : blended(over, *to);
    }
}
