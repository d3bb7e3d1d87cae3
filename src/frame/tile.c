/* SPDX-License-Identifier: MIT */
/*
 * Draws one tile: the G-buffer, then colours, then pixels.  For the application: the depths
 * and kinds of a drawn tile, and spans of its own in a row of the tile.
 */
#include "base/base.h"
#include "frame/frame.h"
#include "frame/tools.h"
#include "pixel/pixel.h"

static size_t plane_size(const tp_frame *frame)
{
    const tp_config *c = &frame->config;
    return (size_t)c->tile_width * (c->tile_height + frame->extra_rows);
}

/* Returns the rows of a tile's samples. */
static tp_line_bounds line_bounds(const tp_frame *frame, const tp_tile *tile)
{
    const int32_t y0 = (int32_t)tile->y0, y1 = (int32_t)tile->y1;
    return tp_frame_has_half_lines(frame)
               ? frame->half_lines->bounds(y0, y1, (int32_t)frame->config.height)
               : (tp_line_bounds){ y0, y1 };
}

/* Returns the keys of row y, of a tile in view of its drawer. */
static const uint32_t *tile_keys(const tp_frame *frame, const void *scratch,
                                 const tp_tile *tile, uint32_t y)
{
    const uint32_t row = y - (uint32_t)line_bounds(frame, tile).y0;
    return (const uint32_t *)scratch + (size_t)row * frame->config.tile_width;
}

static tp_gbuffer make_samples(const tp_frame *frame, void *scratch, const tp_tile *tile)
{
    const tp_line_bounds rows = line_bounds(frame, tile);
    const size_t plane = plane_size(frame);
    uint32_t *at = scratch;
    tp_gbuffer samples = {
        (int32_t)tile->x0, rows.y0, (int32_t)tile->x1, rows.y1, frame->config.tile_width,
        at, at + plane, at + 2 * plane, at + 3 * plane, false, 0, NULL, 0, 0,
    };

    tp_frame_allow_outlines(frame, &samples);
    return samples;
}

static void *scratch_pixels(const tp_frame *frame, void *scratch)
{
    return (uint32_t *)scratch + (frame->outlined ? 8 : 4) * plane_size(frame);
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
    tile->x0 = i % frame->across * c->tile_width;
    tile->y0 = i / frame->across * c->tile_height;
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
static void draw_tile(const tp_frame *frame, void *scratch, const tp_tile *tile,
                      uint8_t *row)
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

/* -- depths and kinds, read from the keys in the scratch ----------------------------- */

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

tp_overlay tp_overlay_make(void (*row)(void *user, const tp_overlay_row *row), void *user)
{
    return (tp_overlay){ row, user, shade_row_with_overlay };
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
