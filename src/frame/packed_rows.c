/* SPDX-License-Identifier: MIT */
/* Rows of packed rgb565 pixels, for quality.blending = rgb565: columns and rows in between
 * are means of pixels, not of colours.
 *
 * Fast light of every second column (quality.light = fast) leaves the colours of even
 * columns; these alone are tone-mapped and packed.  With quality.lines = half a mean row is
 * made from the pixels of its neighbours, however they differ; so is the sky if it is the
 * fast one.  Pixels go straight to the tile and are read there again; those of rows beside
 * the tile take the place of the samples' normals: a run writes over normals of its own
 * columns and of columns before them.
 */
#include "frame/frame.h"
#include "frame/renderers.h"
#include "pixel/packed_blend.h"

/* A tile while it is drawn. */
typedef struct {
    const tp_frame      *frame;
    const tp_gbuffer    *tile;
    const tp_water_rows *found;
    const tp_tile       *to;
    uint8_t             *pixels;        /* row to->y0 */
    bool even_sky;              /* true: the sky of mean rows is a mean */
    bool aligned;               /* true: rows of the tile begin at multiples of 4 bytes */
    bool be;                    /* true: the bytes of pixels are swapped */
} packed_tile;

static size_t row_index(const tp_gbuffer *tile, int32_t y)
{
    return (size_t)(uint32_t)(y - tile->y0) * tile->stride;
}

static uint16_t *row_pixels(const packed_tile *t, int32_t y)
{
    if (y < (int32_t)t->to->y0 || y >= (int32_t)t->to->y1)
        return (uint16_t *)(void *)(t->tile->n + row_index(t->tile, y));
    const uint32_t row = (uint32_t)(y - (int32_t)t->to->y0);
    return (uint16_t *)(void *)(t->pixels + row * t->to->stride);
}

static bool is_alike(const packed_tile *t, int32_t y)
{
    return t->found && (y < t->found->sky_end || y >= t->found->water_begin);
}

/* -- pixels of a run ----------------------------------------------------------------- */

static void pack_colours(const packed_tile *t, uint16_t *to, const uint32_t *colours,
                         int32_t count)
{
    const tp_frame *frame = t->frame;

    if (frame->tone_map)
        frame->store_tone_mapped(frame->tone_map, to, colours, count);
    else
        frame->program->store[frame->config.format](to, 0, 0, 0, colours, count);
}

#define WIDEN(to, half, run, be) \
    (t->aligned ? packed_widen_run(to, half, (run)->x, (run)->y, (run)->count, be) \
                : plain_widen_columns(to, half, (run)->x, (run)->y, 0, (run)->count, \
                                      (run)->count, be))

/* Packs the run's even columns and fills the others. */
TP_NEVER_INLINE void pack_even_columns(const packed_tile *t, uint16_t *to,
                                       const tp_run *run)
{
    uint32_t words[TP_RUN / 4 + 5];     /* from the first column of a block on */
    uint16_t *half = (uint16_t *)(void *)words + ((run->x & 15) >> 1);

    pack_colours(t, half, run->even, ((run->x & 1) + run->count + 1) >> 1);
    if (t->be)
        WIDEN(to, half, run, 1);
    else
        WIDEN(to, half, run, 0);
}

TP_ALWAYS_INLINE void shade_packed_run(const packed_tile *t, const tp_shaders *list,
                                       uint16_t *to, tp_run *run)
{
    tp_frame_shade_run(t->frame, list, !t->found, run);
    if (t->frame->shade.evens_only && list->kind == TP_LIST_FAST)
        pack_even_columns(t, to, run);
    else
        pack_colours(t, to, run->colour, run->count);
}

TP_NEVER_INLINE void shade_packed_row(const packed_tile *t, int32_t y)
{
    const tp_gbuffer *tile = t->tile;
    uint16_t *to = row_pixels(t, y);
    tp_run run;

    for (int32_t x = tile->x0; x < tile->x1; x += run.count) {
        const tp_shaders *list = tp_frame_begin_run(t->frame, tile, x, y, is_alike(t, y),
                                                    &run);
        shade_packed_run(t, list, to + (x - tile->x0), &run);
    }
}

/* -- mean rows ----------------------------------------------------------------------- */

#define MEAN_ROWS(to, above, below, x, y, count, be) \
    (t->aligned && ((x) & 1) == 0 \
         ? packed_mean_rows(to, above, below, x, y, count, be) \
         : plain_mean_rows(to, above, below, x, y, count, be))

/* Writes the means of columns [i, i + count) of the tile. */
static void mean_columns(const packed_tile *t, int32_t y, int32_t i, int32_t count)
{
    uint16_t *to = row_pixels(t, y) + i;
    const uint16_t *above = row_pixels(t, y - 1) + i, *below = row_pixels(t, y + 1) + i;

    if (t->be)
        MEAN_ROWS(to, above, below, t->tile->x0 + i, y, count, 1);
    else
        MEAN_ROWS(to, above, below, t->tile->x0 + i, y, count, 0);
}

/* Pixels of a mean row. */
typedef enum { SHADED, COPIED, MEAN } filling;

/* Returns how a pixel with the stencil value is filled.  Water below the sky is copied from
 * the row below: in many tiles mean rows have no samples, see tp_fast_rows.means. */
static filling choose_filling(const uint32_t *above, const uint32_t *below, uint32_t mark)
{
    if (TP_MARK(*below) != mark)
        return SHADED;
    return TP_MARK(*above) == mark ? MEAN
         : TP_MARK(*above) == TP_MARK_SKY ? COPIED : SHADED;
}

/* Returns the number of pixels, up to `limit`, that are filled as the first is. */
static int32_t count_alike(const uint32_t *above, const uint32_t *below, int32_t limit,
                           uint32_t mark, filling *how)
{
    int32_t n = 1;

    *how = choose_filling(above, below, mark);
    while (*how == MEAN && n + 2 <= limit
           && !TP_MARK((above[n] ^ mark) | (above[n + 1] ^ mark) | (below[n] ^ mark)
                       | (below[n + 1] ^ mark)))
        n += 2;
    while (n < limit && choose_filling(above + n, below + n, mark) == *how)
        n++;
    return n;
}

static void copy_columns(const packed_tile *t, int32_t y, int32_t i, int32_t count)
{
    uint16_t *to = row_pixels(t, y) + i;
    const uint16_t *from = row_pixels(t, y + 1) + i;

    for (int32_t k = 0; k < count; k++)
        to[k] = from[k];
}

/* True if the row and its neighbours are all water, or all sky that may be a mean. */
static bool is_whole_mean(const packed_tile *t, int32_t y)
{
    return t->found && (y > t->found->water_begin
                        || (t->even_sky && y + 1 < t->found->sky_end));
}

/* Fills a row with means where both neighbours are of its kind.  The rest is copied or
 * shaded; the last row of a picture is shaded. */
TP_NEVER_INLINE void fill_packed_mean_row(const packed_tile *t, int32_t y)
{
    const tp_gbuffer *tile = t->tile;
    const uint32_t *keys = tile->key + row_index(tile, y);
    const bool last = y + 1 >= tile->y1;
    tp_run run;

    if (!last && is_whole_mean(t, y)) {
        mean_columns(t, y, 0, tile->x1 - tile->x0);
        return;
    }
    for (int32_t x = tile->x0; x < tile->x1; x += run.count) {
        const int32_t i = x - tile->x0;
        const tp_shaders *list = tp_frame_begin_run(t->frame, tile, x, y, is_alike(t, y),
                                                    &run);
        const uint32_t mark = TP_MARK(run.key[0]);
        filling how = SHADED;
        if (!last && (mark == TP_MARK_WATER || (mark == TP_MARK_SKY && t->even_sky)))
            run.count = count_alike(keys + i - tile->stride, keys + i + tile->stride,
                                    run.count, mark, &how);
        if (how == MEAN)
            mean_columns(t, y, i, run.count);
        else if (how == COPIED)
            copy_columns(t, y, i, run.count);
        else
            shade_packed_run(t, list, row_pixels(t, y) + i, &run);
    }
}

static packed_tile packed_tile_make(const tp_frame *frame, const tp_gbuffer *samples,
                                    const tp_water_rows *found, const tp_tile *tile,
                                    uint8_t *row)
{
    return (packed_tile){
        frame, samples, found, tile, row,
        frame->scene->quality.sky == TP_RUNG_FAST
            && tp_frame_list(frame, TP_MARK_SKY)->count == 1,
        (((uintptr_t)row | tile->stride) & 3) == 0,
        frame->config.format == TP_FORMAT_RGB565BE && TP_IS_LITTLE_ENDIAN,
    };
}

static void draw_packed_rows(const tp_frame *frame, const tp_gbuffer *samples,
                             const tp_water_rows *found, const tp_tile *tile, uint8_t *row)
{
    const packed_tile t = packed_tile_make(frame, samples, found, tile, row);
    const bool means = tp_frame_has_half_lines(frame);

    for (int32_t y = samples->y0; y < samples->y1; y++)
        if (!(means && tp_is_mean_row(y)))
            shade_packed_row(&t, y);
    for (int32_t y = (int32_t)tile->y0; y < (int32_t)tile->y1; y++)
        if (means && tp_is_mean_row(y))
            fill_packed_mean_row(&t, y);
}

const struct tp_draw_packed_rows tp_draw_packed_rows = { draw_packed_rows };
