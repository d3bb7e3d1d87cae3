/* SPDX-License-Identifier: MIT */
/*
 * For the application: the depths and kinds of a drawn tile, and spans of its own in a row
 * of the tile.
 */
#include "base/base.h"
#include "frame/frame.h"
#include "frame/renderers.h"

/* -- depths and kinds, read from the keys in the scratch ----------------------------- */

/* Returns the keys of row y, of a tile in view of its drawer. */
static const uint32_t *tile_keys(const tp_frame *frame, const void *scratch,
                                 const tp_tile *tile, uint32_t y)
{
    const uint32_t row = y - (uint32_t)tp_frame_line_bounds(frame, tile).y0;
    return (const uint32_t *)scratch + tp_frame_first_sample(frame)
           + (size_t)row * frame->config.tile_width;
}

uint32_t tp_frame_water_pixels(const tp_frame *frame, const void *scratch,
                               const tp_tile *tile)
{
    TP_ASSERT(scratch != NULL && tile->x0 < tile->x1);
    const uint32_t *key = tile_keys(frame, scratch, tile, tile->y0);
    uint32_t count = 0;

    for (uint32_t y = tile->y0; y < tile->y1; y++, key += frame->config.tile_width) {
        for (uint32_t x = 0; x < tile->x1 - tile->x0; x++)
            count += TP_MARK(key[x]) == TP_MARK_WATER;
    }
    return count;
}

/* Returns the depth in m.  A key keeps 24 bits of near / depth, rounded down: the middle
 * of the interval is used. */
static tp_fx key_depth(const tp_projection *projection, uint32_t key)
{
    const uint32_t zi = TP_ZI(key) + 0x40;

    return tp_fx_saturate(((int64_t)projection->zi_near * ((int64_t)1 << 31) + zi / 2)
                          / zi);
}

static void put_depths(const tp_frame *frame, const uint32_t *key, uint32_t count,
                       tp_fx *depth)
{
    for (uint32_t x = 0; x < count; x++)
        depth[x] = TP_MARK(key[x]) == TP_MARK_SKY ? TP_FX_MAX
                                                  : key_depth(&frame->projection, key[x]);
}

/* Returns the kind declared by the module of the sample's list. */
static tp_sample_kind mark_kind(const tp_frame *frame, uint32_t mark)
{
    const struct tp_drawing *owner;
    uint32_t kind = 0;

    if (mark < TP_MARK_SOLID)
        return mark == TP_MARK_SKY ? TP_SAMPLE_SKY : TP_SAMPLE_WATER;
    owner = tp_frame_list(frame, mark)->owner;
    for (const tp_use *u = frame->program->modules; u && u->module; u++)
        if (u->drawing == owner)
            kind = u->module->is >> TP_MODULE_KIND_SHIFT;
    return kind ? (tp_sample_kind)kind : TP_SAMPLE_OTHER;
}

static void put_kinds(const tp_frame *frame, const uint32_t *key, uint32_t count,
                      uint8_t *kind)
{
    uint32_t mark = TP_MARKS;
    uint8_t known = TP_SAMPLE_OTHER;

    for (uint32_t x = 0; x < count; x++) {
        if (TP_MARK(key[x]) != mark) {
            mark = TP_MARK(key[x]);
            known = (uint8_t)mark_kind(frame, mark);
        }
        kind[x] = known;
    }
}

void tp_frame_sample_row(const tp_frame *frame, const void *scratch, const tp_tile *tile,
                         uint32_t y, tp_fx *depth, uint8_t *kind)
{
    TP_ASSERT(frame != NULL && scratch != NULL && y >= tile->y0 && y < tile->y1);
    const uint32_t *key = tile_keys(frame, scratch, tile, y);

    if (depth)
        put_depths(frame, key, tile->x1 - tile->x0, depth);
    if (kind)
        put_kinds(frame, key, tile->x1 - tile->x0, kind);
}

/* -- spans drawn by the application into a row of a tile ----------------------------- */

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
