/* SPDX-License-Identifier: MIT */
/* First half of fast shading: a distortion, three layers and ripples, by look-ups of the
 * nearest texel of baked textures; distortion and layers bilinear too.
 *
 * Distances are quantized to half a mipmap level, once per 16 columns.  Neighbours of
 * equal distance form a span; in a span a texture has one level.
 *
 * Half rate stages have places and layers for every second column only: the even columns
 * of the picture and the run's first column.  The places are stored densely until the
 * layers are shaded and the columns in between are filled; if light comes first, until
 * the even columns are lit. */
#include "base/dsp.h"
#include "features/water/fast_shading.h"
#include "features/water/fast_layers_linear.h"
#include "shade/shade.h"
#if TP_DSP
#include "features/water/fast_layers_m4.h"
#define LOOP(name) packed_##name
#else
#include "features/water/fast_layers_plain.h"
#define LOOP(name) plain_##name
#endif

#define HALF 128                /* half a level, Q8 */

static int32_t half_rate_place_count(const tp_run *run, int32_t end)
{
    return (end + (run->x & 1) + 1) >> 1;
}

/* Divides the run into spans of equal mipmap level, by the distance from the eye, for the
 * later stages.  Draws nothing. */
void tp_stage_quick_mip_spans(const tp_shade *shade, tp_run *run)
{
    uint32_t spans = 0;

    for (int32_t i = 0; i < run->count; ) {
        int32_t depth = tp_log_depth(shade, run->key[i]);
        int32_t mip_offset = ((depth > 0 ? depth + depth / 2 : depth) & -HALF) + HALF / 2;
        i = tp_block_end(run, i);
        if (spans == 0 || run->span[spans - 1].mip_offset != mip_offset)
            run->span[spans++].mip_offset = (int16_t)mip_offset;
        run->span[spans - 1].end = (uint8_t)i;
        run->span[spans - 1].places = (uint8_t)half_rate_place_count(run, i);
    }
    run->spans = spans;
}

static tp_columns make_columns(const tp_run *run, int32_t first, int32_t end)
{
    return (tp_columns){ run->s + first, run->t + first, run->n + first, end - first,
                         (uint32_t)(run->x + first), (uint32_t)(run->x + first) & 1 };
}

/* Copies words of a run, four at a time: `memcpy` of small C libraries copies bytes. */
TP_ALWAYS_INLINE void copy_words(uint32_t *to, const uint32_t *from,
                                 int32_t count)
{
    const uint32_t *const end = from + count;

    for (; from + 4 <= end; to += 4) {
        const tp_word_pair a = tp_load_next_pair(&from), b = tp_load_next_pair(&from);
        tp_store_pair(to, 0, a.first, a.second);
        tp_store_pair(to, 2, b.first, b.second);
    }
    while (from != end)
        *to++ = *from++;
}

/* -- places of layers ---------------------------------------------------------------- */

void tp_stage_quick_still(const tp_shade *shade, tp_run *run)
{
    (void)shade;
    copy_words(run->place, run->s, run->count);
    copy_words(run->place + TP_RUN, run->t, run->count);
}

void tp_stage_quick_still_thin(const tp_shade *shade, tp_run *run)
{
    const int32_t odd = run->x & 1, places = half_rate_place_count(run, run->count);
    const uint32_t *s = run->s, *t = run->t;
    uint32_t *place = run->place;

    (void)shade;
    place[0] = s[0];
    place[TP_RUN] = t[0];
    for (int32_t j = 1; j < places; j++) {
        place[j] = s[2 * j - odd];
        place[j + TP_RUN] = t[2 * j - odd];
    }
}

/* A loop over columns that reads a map: it writes places, or slopes. */
typedef void (*map_loop)(const tp_quick_map *map, int32_t mip_offset,
                         const tp_columns *columns, uint32_t *restrict to);

TP_ALWAYS_INLINE void distort(tp_run *run, int half_rate, map_loop loop)
{
    const tp_quick_layers *quick = run->mine;

    for (uint32_t k = 0, at = 0; k < run->spans; at = run->span[k++].end) {
        const tp_columns c = make_columns(run, (int32_t)at, run->span[k].end);
        const uint32_t first = !half_rate ? at : k ? run->span[k - 1].places : 0;
        loop(&quick->bend, run->span[k].mip_offset, &c, run->place + first);
    }
}

#define DISTORT_STAGE(name, half_rate, loop) \
    void tp_stage_quick_##name(const tp_shade *shade, tp_run *run) \
    { (void)shade; distort(run, half_rate, loop); }
DISTORT_STAGE(bend, 0, LOOP(distort_places))
DISTORT_STAGE(bend_thin, 1, LOOP(distort_even_places))
DISTORT_STAGE(bend_linear, 0, linear_distort_places)
DISTORT_STAGE(bend_linear_thin, 1, linear_distort_even_places)

/* -- layers -------------------------------------------------------------------------- */

typedef void (*texel_loop)(const tp_quick_map *map, int32_t mip_offset,
                           const uint32_t *restrict place, uint32_t *restrict colour,
                           int32_t count);

TP_ALWAYS_INLINE void shade_layer(const tp_quick_map *map, const tp_run *run,
                                  uint32_t *colour, int half_rate, texel_loop loop)
{
    for (uint32_t k = 0, at = 0; k < run->spans; k++) {
        const uint32_t  end = half_rate ? run->span[k].places : run->span[k].end;
        loop(map, run->span[k].mip_offset, run->place + at, colour + at,
             (int32_t)(end - at));
        at = end;
    }
}

/* Shades all layers.  Without a base texture the water's colour replaces the first
 * layer. */
TP_ALWAYS_INLINE void shade_layers(const tp_shade *shade, const tp_run *run,
                                   uint32_t *colour, int half_rate, int linear)
{
    const tp_quick_map *layer = ((const tp_quick_layers *)run->mine)->layer;

    if (layer[0].level)
        shade_layer(&layer[0], run, colour, half_rate,
                    linear ? linear_write_texels : LOOP(write_texels));
    else
        for (int32_t i = 0;
             i < (half_rate ? half_rate_place_count(run, run->count) : run->count); i++)
            colour[i] = shade->water_colour;
    for (int k = 1; k < TP_QUICK_LAYERS; k++)
        if (layer[k].level)
            shade_layer(&layer[k], run, colour, half_rate,
                        linear ? linear_add_texels : LOOP(add_texels));
}

void tp_stage_quick_layers(const tp_shade *shade, tp_run *run)
{
    shade_layers(shade, run, run->colour, 0, 0);
}

void tp_stage_quick_layers_linear(const tp_shade *shade, tp_run *run)
{
    shade_layers(shade, run, run->colour, 0, 1);
}

/* Fills the columns in between with the mean of their neighbours.  At the end of a block
 * of 16 columns, a possible tile border, and at the run's end, a column copies the column
 * before. */
static void fill_odd_columns(const uint32_t *restrict half_rate, tp_run *run)
{
    const int32_t odd = run->x & 1, count = run->count, pairs = (count - odd) >> 1;
    uint32_t *restrict colour = run->colour + odd;

    run->colour[0] = half_rate[0];
    half_rate += odd;
    LOOP(upsample_colours)(half_rate, colour, pairs);
    if ((count - odd) & 1)
        colour[2 * pairs] = half_rate[pairs];
    else if (pairs > 0)
        colour[2 * pairs - 1] = half_rate[pairs - 1];
    for (int32_t i = 15 - (run->x & 15); i < count; i += 16)
        if (i > 0)
            run->colour[i] = run->colour[i - 1];
}

/* Shades the layers at half rate.  The slopes' array is free until the slopes are made,
 * so the array holds the half rate colours. */
void tp_stage_quick_layers_thin(const tp_shade *shade, tp_run *run)
{
    shade_layers(shade, run, run->slope, 1, 0);
    fill_odd_columns(run->slope, run);
}

void tp_stage_quick_layers_linear_thin(const tp_shade *shade, tp_run *run)
{
    shade_layers(shade, run, run->slope, 1, 1);
    fill_odd_columns(run->slope, run);
}

void tp_stage_quick_layers_even(const tp_shade *shade, tp_run *run)
{
    shade_layers(shade, run, run->even, 1, 0);
}

void tp_quick_odd_fill(tp_run *run)
{
    fill_odd_columns(run->even, run);
}

void tp_stage_quick_odd_fill(const tp_shade *shade, tp_run *run)
{
    (void)shade;
    tp_quick_odd_fill(run);
}

/* -- slopes -------------------------------------------------------------------------- */

TP_ALWAYS_INLINE void add_ripples(tp_run *run, map_loop loop)
{
    const tp_quick_layers *quick = run->mine;

    for (uint32_t k = 0, at = 0; k < run->spans; at = run->span[k++].end) {
        const tp_columns c = make_columns(run, (int32_t)at, run->span[k].end);
        loop(&quick->ripple, run->span[k].mip_offset, &c, run->slope + at);
    }
}

void tp_stage_quick_ripple(const tp_shade *shade, tp_run *run)
{
    (void)shade;
    add_ripples(run, LOOP(add_ripple_slopes));
}

void tp_stage_quick_ripple_linear(const tp_shade *shade, tp_run *run)
{
    (void)shade;
    add_ripples(run, linear_add_ripple_slopes);
}

void tp_stage_quick_slopes(const tp_shade *shade, tp_run *run)
{
    (void)shade;
    copy_words(run->slope, run->n, run->count);
}
