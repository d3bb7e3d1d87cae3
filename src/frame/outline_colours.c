/* SPDX-License-Identifier: MIT */
/* Colours the samples of outlines, and blends them over the colours behind them.
 *
 * Once a row is coloured, a sample's s is its colour and the low byte of its key its share.
 * Key 0 stands for no outline, or a hidden one. */
#include "frame/frame.h"

/* Points the run at the row's outlines from column x on. */
static void set_run(const tp_gbuffer *tile, int32_t x, int32_t y, tp_run *run)
{
    const size_t at = (size_t)(uint32_t)(y - tile->y0) * tile->stride
                    + (uint32_t)(x - tile->x0);
    const ptrdiff_t plane = tile->s - tile->key;

    run->key = tile->outline + at;
    run->ls = run->s = run->key + plane;
    run->lt = run->t = run->s + plane;
    run->n = run->t + plane;
    run->x = x;
    run->y = y;
}

/* Returns the number of visible outlines of one kind in a row, at most `limit`, from `key`
 * on; `front` is the tile's key there. */
static int32_t count_visible(const uint32_t *key, const uint32_t *front, int32_t limit)
{
    int32_t n = 0;

    while (n < limit && key[n] && TP_MARK(key[n]) == TP_MARK(key[0])
           && key[n] >= (front[n] & ~(uint32_t)0xff))
        n++;
    return n;
}

/* Returns the first index from i on, or `end`, with an outline.  Most have none: four keys
 * are tested at once. */
static int32_t find_outline(const uint32_t *key, int32_t i, int32_t end)
{
    while (i + 4 <= end && !(key[i] | key[i + 1] | key[i + 2] | key[i + 3]))
        i += 4;
    while (i < end && key[i] == 0)
        i++;
    return i;
}

/* Replaces the marks by the shares, and leaves the face numbers in t. */
static void take_shares(uint32_t *key, ptrdiff_t plane, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        uint32_t *t = &key[i + 2 * plane];
        const uint32_t share = tp_outline_share(*t, t[plane]);
        key[i] = (key[i] & ~(uint32_t)0xff) | (share > 255 ? 255 : share);
        *t &= TP_OUTLINE_FACES - 1;
    }
}

static void colour_run(const tp_frame *frame, const tp_shaders *list, uint32_t end,
                       uint32_t *colour, tp_run *run)
{
    for (uint32_t i = 0; i < list->count && list->order[i] < end; i++) {
        run->mine = list->shader[i].mine;
        list->shader[i].stage(&frame->shade, run);
    }
    memcpy(colour, run->colour, (size_t)run->count * sizeof *colour);
}

static bool colour_row(const tp_frame *frame, const tp_gbuffer *tile, int32_t y,
                       uint32_t end, tp_run *run)
{
    const size_t row = (size_t)(uint32_t)(y - tile->y0) * tile->stride;
    const ptrdiff_t plane = tile->s - tile->key;
    uint32_t *const key = tile->outline + row;
    const uint32_t *const front = tile->key + row;
    const int32_t width = tile->outline_x1 - tile->x0;
    bool any = false;

    for (int32_t i = tile->outline_x0 - tile->x0; (i = find_outline(key, i, width)) < width; ) {
        const int32_t x = tile->x0 + i, most = TP_RUN - x % TP_RUN;
        run->count = count_visible(&key[i], &front[i], most < width - i ? most : width - i);
        if (run->count == 0) {
            key[i++] = 0;
            continue;
        }
        const tp_shaders *list = tp_frame_list(frame, TP_MARK(key[i]));
        set_run(tile, x, y, run);
        run->material = TP_MARK(key[i]) - list->first;
        take_shares(&key[i], plane, run->count);
        colour_run(frame, list, end, &key[i + plane], run);
        i += run->count;
        any = true;
    }
    return any;
}

static uint32_t share_of_key(uint32_t key)
{
    return (key & 0xff) + (key >> 7 & 1);
}

static void blend(const tp_gbuffer *tile, tp_run *run)
{
    const uint32_t *key = tile->outline
                        + (size_t)(uint32_t)(run->y - tile->y0) * tile->stride
                        + (uint32_t)(run->x - tile->x0);
    const uint32_t *colour = key + (tile->s - tile->key);

    const int32_t before = tile->outline_x0 - run->x, past = tile->outline_x1 - run->x,
                  end = past < run->count ? past : run->count;

    for (int32_t i = before > 0 ? before : 0; (i = find_outline(key, i, end)) < end; i++)
        run->colour[i] = tp_colour_mix(run->colour[i], colour[i], share_of_key(key[i]));
}

static void blend_map_row(const tp_gbuffer *tile, int32_t y, uint32_t *to)
{
    const uint32_t *key =
        tile->outline + (size_t)(uint32_t)(y - tile->y0) * tile->stride;
    const uint32_t *colour = key + (tile->s - tile->key);
    const int32_t width = tile->outline_x1 - tile->x0;

    for (int32_t i = tile->outline_x0 - tile->x0;
         (i = find_outline(key, i, width)) < width; i++)
        to[i] = tp_argb_mix(to[i], colour[i] | 0xff000000u, share_of_key(key[i]));
}

const struct tp_outlining tp_outlining_by_share = {
    .colour_row = colour_row, .blend = blend, .blend_map_row = blend_map_row,
};
