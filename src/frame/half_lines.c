/* SPDX-License-Identifier: MIT */
/* Water at half the rows, for quality.lines = half: the water of a mean row is the mean of
 * the rows above and below, where these are alike.  Glints, outlines of mirrored objects
 * and steep crests differ from row to row: their blocks of eight columns are shaded.
 *
 * Mean rows are the odd rows of the picture except each sixteenth, so tiles of sixteen rows
 * need no row of a neighbour.  Tiles of other heights draw one row more above, below or both.
 * Everything but water, and outlines over water, are drawn in every row.  Colours lie in the
 * place of the samples' normals: no stage reads the normals of another run. */
#include "base/dsp.h"
#include "frame/frame.h"
#include "frame/renderers.h"

/* The rows that a tile needs: its own, and those beside its mean rows. */
static tp_line_bounds bounds(int32_t y0, int32_t y1, int32_t height)
{
    return (tp_line_bounds){ y0 - tp_is_mean_row(y0),
                             y1 + (y1 < height && tp_is_mean_row(y1 - 1)) };
}

/* Rows of memory beyond those of a tile; all tiles begin at multiples of its height. */
static uint32_t extra_rows(uint32_t tile_height, uint32_t height)
{
    return tile_height % 16 == 0 || tile_height >= height ? 0 : tile_height % 2 ? 2 : 1;
}

static size_t row_index(const tp_gbuffer *tile, int32_t y)
{
    return (size_t)(uint32_t)(y - tile->y0) * tile->stride;
}

/* True if the row of a tile drawn alone, see tp_water_rows, has one kind of sample. */
static bool is_alike(const tp_water_rows *found, int32_t y)
{
    return found && (y < found->sky_end || y >= found->water_begin);
}

static void shade_row(const tp_frame *frame, const tp_gbuffer *tile,
                      const tp_water_rows *found, int32_t y)
{
    uint32_t *to = tile->n + row_index(tile, y) - tile->x0;
    tp_run run;

    for (int32_t x = tile->x0; x < tile->x1; x += run.count) {
        const tp_shaders *list = tp_frame_begin_run(frame, tile, x, y,
                                                    is_alike(found, y), &run);
        tp_frame_shade_run(frame, list, !found, &run);
        memcpy(to + x, run.colour, (size_t)run.count * sizeof *to);
    }
}

/* -- mean rows ----------------------------------------------------------------------- */

/* Returns the number of pixels, up to `limit`, with water both above and below, or without;
 * *both says which. */
static int32_t count_alike(const uint32_t *above, const uint32_t *below, int32_t limit,
                           bool *both)
{
    int32_t n = 1;

    *both = !TP_MARK((above[0] ^ TP_MARK_WATER) | (below[0] ^ TP_MARK_WATER));
    while (*both && n + 2 <= limit
           && !TP_MARK((above[n] ^ TP_MARK_WATER) | (above[n + 1] ^ TP_MARK_WATER)
                       | (below[n] ^ TP_MARK_WATER) | (below[n + 1] ^ TP_MARK_WATER)))
        n += 2;
    while (n < limit
           && *both == !TP_MARK((above[n] ^ TP_MARK_WATER) | (below[n] ^ TP_MARK_WATER)))
        n++;
    return n;
}

#define BLOCK 8                 /* columns that are filled or shaded together */
#define APART (BLOCK * 16)      /* sum of a block's differences: 16 levels in the mean, or one
                                 * pixel of glint */

/* Returns the sum of the differences of green, the channel nearest to brightness.  All
 * channels find the same blocks, and cost a Cortex-M0+ three times as much. */
static uint32_t sum_differences(const uint32_t *above, const uint32_t *below, int32_t count)
{
    int32_t sum = 0;

    for (int32_t i = 0; i < count; i++) {
        const int32_t more = (int32_t)(above[i] >> 8 & 0xff) - (int32_t)(below[i] >> 8 & 0xff);
        sum += more < 0 ? -more : more;
    }
    return (uint32_t)sum;
}

/* Returns the number of pixels, from column x on and up to `limit`, in blocks whose rows are
 * all near each other, or all apart; *near says which. */
static int32_t count_near(const uint32_t *above, const uint32_t *below, int32_t x,
                          int32_t limit, bool *near)
{
    int32_t n = 0;

    while (n < limit) {
        const int32_t left = limit - n, to_edge = BLOCK - (x + n) % BLOCK;
        const int32_t count = to_edge < left ? to_edge : left;
        const bool is_near = sum_differences(above + n, below + n, count) < APART;
        if (n > 0 && is_near != *near)
            break;
        *near = is_near;
        n += count;
    }
    return n;
}

/* Returns the number of pixels from column x on, up to `limit`, that are means, or that are
 * none; *mean says which.  `at`: index of the first one in the tile. */
TP_NEVER_INLINE int32_t count_means(const tp_gbuffer *tile, size_t at, int32_t x,
                                    int32_t limit, bool *mean)
{
    const uint32_t *key = tile->key + at, *colour = tile->n + at;
    const size_t stride = tile->stride;
    const int32_t count = count_alike(key - stride, key + stride, limit, mean);

    return *mean ? count_near(colour - stride, colour + stride, x, count, mean) : count;
}

static void mix(uint32_t *to, const uint32_t *above, const uint32_t *below, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        to[i] = tp_uhadd8(above[i], below[i]);
}

/* Fills the row's colours: means of both neighbours where these are water too, and alike.
 * The rest is shaded, and so is the last row of a picture. */
static void fill_mean_row(const tp_frame *frame, const tp_gbuffer *tile,
                          const tp_water_rows *found, int32_t y)
{
    const size_t at = row_index(tile, y);
    const bool last = y + 1 >= tile->y1, alike = is_alike(found, y), level = !found;
    uint32_t *to = tile->n + at;
    tp_run run;

    for (int32_t x = tile->x0; x < tile->x1; x += run.count) {
        const int32_t i = x - tile->x0;
        const tp_shaders *list = tp_frame_begin_run(frame, tile, x, y,
                                                    alike, &run);
        bool mean = false;
        if (!last && TP_MARK(run.key[0]) == TP_MARK_WATER)
            run.count = count_means(tile, at + (size_t)i, x, run.count, &mean);
        if (mean) {
            mix(to + i, to + i - tile->stride, to + i + tile->stride, run.count);
            continue;
        }
        tp_frame_shade_run(frame, list, level, &run);
        memcpy(to + i, run.colour, (size_t)run.count * sizeof *to);
    }
}

/* -- pixels -------------------------------------------------------------------------- */

/* Blends the row's outlines over its colours. */
static void blend_outlines(const tp_frame *frame, const tp_gbuffer *tile, int32_t y)
{
    const struct tp_outlining *outlining = tp_frame_outlining(frame);
    uint32_t *row = tile->n + row_index(tile, y) - tile->x0;
    tp_run run;

    if (!tile->outline || !outlining->colour_row(frame, tile, y, TP_AT_END, &run))
        return;
    const int32_t end = tile->outline_x1;
    for (int32_t x = tile->outline_x0; x < end; x += run.count) {
        const int32_t most = TP_RUN - x % TP_RUN;
        run.x = x;
        run.y = y;
        run.count = most < end - x ? most : end - x;
        memcpy(run.colour, row + x, (size_t)run.count * sizeof *row);
        outlining->blend(tile, &run);
        memcpy(row + x, run.colour, (size_t)run.count * sizeof *row);
    }
}

TP_NEVER_INLINE void store_row(const tp_frame *frame, const tp_gbuffer *tile, int32_t y,
                               void *to)
{
    const int32_t count = tile->x1 - tile->x0;
    uint32_t *colours = tile->n + row_index(tile, y);

    blend_outlines(frame, tile, y);
    if (frame->config.overlay.draw)
        tp_frame_overlay_row(frame, tile, y, colours);
    if (frame->tone_map && !frame->config.overlay.draw)
        frame->store_tone_mapped(frame->tone_map, to, colours, count);
    else
        frame->program->store[frame->config.format](to, 0, tile->x0, y, colours, count);
}

static void draw_half_rows(const tp_frame *frame, const tp_gbuffer *samples,
                           const tp_water_rows *found, const tp_tile *tile, uint8_t *row)
{
    const int32_t y0 = (int32_t)tile->y0, y1 = (int32_t)tile->y1;

    for (int32_t y = samples->y0; y < samples->y1; y++)
        if (!tp_is_mean_row(y))
            shade_row(frame, samples, found, y);
    for (int32_t y = y0; y < y1; y++)
        if (tp_is_mean_row(y))
            fill_mean_row(frame, samples, found, y);
    for (int32_t y = y0; y < y1; y++, row += tile->stride)
        store_row(frame, samples, y, row);
}

const struct tp_draw_half_lines tp_draw_half_lines = { extra_rows, bounds, draw_half_rows };
