/* SPDX-License-Identifier: MIT */
/* Draws one tile: the G-buffer, then colours, then pixels. */
#include "base/base.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "frame/tools.h"
#include "pixel/pixel.h"

static size_t plane_size(const tp_frame *frame)
{
    const tp_config *c = &frame->config;
    return (size_t)c->tile_width * (c->tile_height + frame->extra_rows);
}

static tp_gbuffer make_samples(const tp_frame *frame, void *scratch, tp_tile *tile)
{
    const tp_line_bounds rows = tp_frame_line_bounds(frame, tile);
    const size_t plane = plane_size(frame);
    uint32_t *at = (uint32_t *)scratch + tp_frame_first_sample(frame);
    tp_gbuffer samples = {
        (int32_t)tile->x0, rows.y0, (int32_t)tile->x1, rows.y1, frame->config.tile_width,
        at, at + plane, at + 2 * plane, at + 3 * plane, false, 0, NULL, 0, 0,
        NULL, NULL,
    };

    tp_frame_allow_outlines(frame, &samples);
    tp_frame_allow_wide_solids(frame, &samples, &tile->dropped);
    return samples;
}

static void *scratch_pixels(const tp_frame *frame, void *scratch)
{
    return (uint32_t *)scratch + tp_frame_first_sample(frame)
           + (frame->outlined ? 8 : 4) * plane_size(frame);
}

tp_kept_lines *tp_frame_kept_lines(const tp_frame *frame, const tp_gbuffer *tile,
                                   uint32_t line_bytes)
{
    const tp_kept_lines wanted = { (uintptr_t)frame, frame->picture, (uint32_t)tile->x0, 0,
                                   line_bytes };
    void *first = tile->key - tp_frame_first_sample(frame);

    return frame->kept_bytes ? frame->program->draw.kept_lines->open(
                                   first, frame->kept_bytes, &wanted, tile->y0 <= 0)
                             : NULL;
}

/* Returns the number of samples, up to `limit`, with the first sample's stencil value. */
static int32_t run_length(const uint32_t *key, int32_t limit)
{
    uint32_t mark = TP_MARK(key[0]);
    int32_t  n = 1;

    while (n + 4 <= limit && !TP_MARK((key[n] ^ mark) | (key[n + 1] ^ mark)
                                     | (key[n + 2] ^ mark) | (key[n + 3] ^ mark)))
        n += 4;
    while (n < limit && TP_MARK(key[n]) == mark)
        n++;
    return n;
}

const tp_shaders *tp_frame_begin_run(const tp_frame *frame, const tp_gbuffer *tile, int32_t x,
                                     int32_t y, bool alike, tp_run *run)
{
    TP_ASSERT(x >= tile->x0 && x < tile->x1 && y >= tile->y0 && y < tile->y1);
    int32_t most = TP_RUN - x % TP_RUN;
    size_t  at = (size_t)(uint32_t)(y - tile->y0) * tile->stride
               + (uint32_t)(x - tile->x0);

    run->key = tile->key + at;
    run->s = tile->s + at;
    run->t = tile->t + at;
    run->n = tile->n + at;
    run->ls = run->s;
    run->lt = run->t;
    run->x = x;
    run->y = y;
    most = most < tile->x1 - x ? most : tile->x1 - x;
    run->count = alike ? most : run_length(run->key, most);
    TP_ASSERT(run->count > 0 && x / TP_RUN == (x + run->count - 1) / TP_RUN);
    const tp_shaders *list = tp_frame_list(frame, TP_MARK(run->key[0]));
    run->material = TP_MARK(run->key[0]) - list->first;
    return list;
}

/* Begins the row's outlines.  Returns true if the row has any. */
static bool begin_row(const tp_frame *frame, const tp_gbuffer *tile, int32_t y, tp_run *run)
{
    return tile->outline
           && tp_frame_outlining(frame)->colour_row(frame, tile, y, TP_AT_END, run);
}

void tp_frame_run_stages(const tp_frame *frame, const tp_shaders *list, tp_run *run)
{
    for (const tp_shader *s = list->shader; s->stage; s++) {
        run->mine = s->mine;
        s->stage(&frame->shade, run);
    }
}

/* A function of its own: programs without fast rows have no stack for the keys. */
void tp_frame_shade_level_run(const tp_frame *frame, const tp_shaders *list, tp_run *run)
{
    uint32_t keys[TP_RUN];
    const uint32_t *const own = run->key;

    tp_frame_write_level_keys(frame, run->x, run->y, run->count, keys);
    run->key = keys;
    tp_frame_run_stages(frame, list, run);
    run->key = own;
}

/* `found`: the rows of a tile drawn alone, or NULL.  In its caller the run would take stack
 * while samples are drawn. */
TP_NEVER_INLINE void shade_row(const tp_frame *frame, const tp_gbuffer *tile,
                      const tp_water_rows *found, int32_t y, void *row)
{
    const tp_store store = frame->program->store[frame->config.format];
    const bool alike = found && (y < found->sky_end || y >= found->water_begin);
    tp_run run;
    const bool outlined = begin_row(frame, tile, y, &run);

    for (int32_t x = tile->x0; x < tile->x1; x += run.count) {
        const tp_shaders *plan = tp_frame_begin_run(frame, tile, x, y, alike, &run);
        tp_frame_shade_run(frame, plan, !found, &run);
        if (outlined)
            tp_frame_outlining(frame)->blend(tile, &run);
        if (frame->tone_map)
            frame->store_tone_mapped(frame->tone_map, (uint8_t *)row + 2 * (x - tile->x0),
                                     run.colour, run.count);
        else
            store(row, x - tile->x0, x, y, run.colour, run.count);
    }
}

void tp_frame_overlay_row(const tp_frame *frame, const tp_gbuffer *tile, int32_t y,
                          uint32_t *colours)
{
    const tp_overlay *overlay = &frame->config.overlay;
    const tp_overlay_row over = {
        (uint32_t)y, (uint32_t)tile->x0, (uint32_t)tile->x1, colours,
        tile->key + (size_t)(uint32_t)(y - tile->y0) * tile->stride,
        frame->projection.zi_near,
    };

    overlay->row(overlay->user, &over);
}

/* Draws a row with the application's spans.  Colours replace the row's normals run by run:
 * no stage reads the normals of another run. */
static void shade_row_with_overlay(const tp_frame *frame, const void *samples, int32_t y,
                                   void *row)
{
    const tp_gbuffer *tile = samples;
    const size_t at = (size_t)(uint32_t)(y - tile->y0) * tile->stride;
    uint32_t *to = tile->n + at;
    tp_run run;
    const bool outlined = begin_row(frame, tile, y, &run);

    for (int32_t x = tile->x0; x < tile->x1; x += run.count) {
        const tp_shaders *plan = tp_frame_begin_run(frame, tile, x, y, false, &run);
        tp_frame_shade_run(frame, plan, true, &run);
        if (outlined)
            tp_frame_outlining(frame)->blend(tile, &run);
        memcpy(to + (x - tile->x0), run.colour, (size_t)run.count * sizeof *to);
    }
    tp_frame_overlay_row(frame, tile, y, to);
    frame->program->store[frame->config.format](row, 0, tile->x0, y, to,
                                                tile->x1 - tile->x0);
}

tp_overlay tp_overlay_make(void (*row)(void *user, const tp_overlay_row *row), void *user)
{
    return (tp_overlay){ row, user, shade_row_with_overlay };
}

void tp_frame_colour_row(const tp_frame *frame, const tp_gbuffer *tile, int32_t y,
                         uint32_t *to)
{
    const uint32_t *key = tile->key + (size_t)(uint32_t)(y - tile->y0) * tile->stride;
    tp_run run;
    const bool outlined =
        tile->outline
        && tp_frame_outlining(frame)->colour_row(frame, tile, y, TP_AT_TONE, &run);

    for (int32_t x = tile->x0; x < tile->x1; ) {
        if (TP_MARK(key[x - tile->x0]) == TP_MARK_SKY) {
            to[x++ - tile->x0] = 0;
            continue;
        }
        const tp_shaders *plan = tp_frame_begin_run(frame, tile, x, y, false, &run);
        for (uint32_t i = 0; i < plan->count && plan->order[i] < TP_AT_TONE; i++) {
            run.mine = plan->shader[i].mine;
            plan->shader[i].stage(&frame->shade, &run);
        }
        for (int32_t k = 0; k < run.count; k++, x++)
            to[x - tile->x0] = run.colour[k] | 0xff000000u;
    }
    if (outlined)
        tp_frame_outlining(frame)->blend_map_row(tile, y, to);
}

/* Draws all geometry into the tile: solids first, the water after them.  Returns true if
 * water and sky are alone in it; *found has their rows. */
static bool draw_samples(const tp_frame *frame, tp_gbuffer *samples, void *memory,
                         tp_water_rows *found)
{
    TP_ASSERT(frame->world != NULL);

    if (tp_frame_draw_surface_alone(frame, samples, memory, found))
        return true;
    tp_gbuffer_clear(samples);
    tp_frame_draw_modules(frame, &frame->view, samples);
    tp_frame_draw_surface(frame, samples, memory);
    return false;
}

/* Sets the tile's box.  Returns false if tile i does not exist or `scratch` is unusable. */
static bool set_tile_bounds(const tp_frame *frame, uint32_t i, const void *scratch,
                            tp_tile *tile)
{
    const tp_config *c = &frame->config;

    if (i >= tp_frame_tiles(frame)
        || tp_pointer_check_aligned(scratch, 8, "scratch", NULL) != TP_OK)
        return false;
    tile->dropped = 0;
    tile->x0 = (c->kept_bytes ? i / frame->down : i % frame->across) * c->tile_width;
    tile->y0 = (c->kept_bytes ? i % frame->down : i / frame->across) * c->tile_height;
    tile->x1 = tile->x0 + c->tile_width < c->width ? tile->x0 + c->tile_width : c->width;
    tile->y1 = tile->y0 + c->tile_height < c->height ? tile->y0 + c->tile_height
                                                     : c->height;
    return true;
}

static void shade_rows_with_overlay(const tp_frame *frame, const tp_gbuffer *samples,
                                    const tp_tile *tile, uint8_t *row)
{
    for (int32_t y = samples->y0; y < samples->y1; y++, row += tile->stride)
        frame->config.overlay.draw(frame, samples, y, row);
}

/* Draws a tile; rows of pixels start at `row` and advance by the tile's stride. */
static void draw_tile(const tp_frame *frame, void *scratch, tp_tile *tile, uint8_t *row)
{
    tp_gbuffer samples = make_samples(frame, scratch, tile);
    tp_water_rows found;
    const bool alone =
        draw_samples(frame, &samples, scratch_pixels(frame, scratch), &found);
    if (tp_frame_has_packed_rows(frame)) {
        frame->packed_rows->draw(frame, &samples, alone ? &found : NULL, tile, row);
        return;
    }
    if (tp_frame_has_half_lines(frame)) {
        frame->half_lines->draw(frame, &samples, alone ? &found : NULL, tile, row);
        return;
    }
    if (frame->config.overlay.draw) {
        shade_rows_with_overlay(frame, &samples, tile, row);
        return;
    }
    for (int32_t y = samples.y0; y < samples.y1; y++, row += tile->stride)
        shade_row(frame, &samples, alone ? &found : NULL, y, row);
}

bool tp_frame_draw_tile(const tp_frame *frame, uint32_t i, void *scratch, tp_tile *tile)
{
    TP_ASSERT(tile != NULL);
    const tp_config *c = &frame->config;

    if (!set_tile_bounds(frame, i, scratch, tile))
        return false;
    tile->pixels = scratch_pixels(frame, scratch);
    tile->stride = tp_format_row_bytes(c->format, (int)c->tile_width);
    draw_tile(frame, scratch, tile, scratch_pixels(frame, scratch));
    return true;
}

/* The tile's pixels start at a whole byte, because tile widths are multiples of 16. */
bool tp_frame_draw_tile_direct(const tp_frame *frame, uint32_t i, void *scratch,
                               void *picture, size_t stride, tp_tile *tile)
{
    TP_ASSERT(tile != NULL);
    uint8_t *pixels = picture;

    if (picture == NULL || !set_tile_bounds(frame, i, scratch, tile))
        return false;
    pixels += tile->y0 * stride
            + tp_format_row_bytes(frame->config.format, (int)tile->x0);
    tile->pixels = pixels;
    tile->stride = stride;
    draw_tile(frame, scratch, tile, pixels);
    return true;
}
