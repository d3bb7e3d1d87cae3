/* SPDX-License-Identifier: MIT */
/* Depths and kinds of a drawn tile, read from the depth_stencil keys in the scratch. */
#include "frame/frame.h"

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
    const uint32_t *key =
        (const uint32_t *)scratch + (size_t)(y - tile->y0) * frame->config.tile_width;

    if (depth)
        put_depths(frame, key, tile->x1 - tile->x0, depth);
    if (kind)
        put_kinds(frame, key, tile->x1 - tile->x0, kind);
}
