/* SPDX-License-Identifier: MIT */
/*
 * The fast view into the water: colours of a block whose floor is visible.  See
 * fast_refraction_stage.c.
 *
 * Floor and mix are computed in every second column of a block from the first one on and in
 * the last column: the samples of a block.  The columns between take the mean.
 */
#include "base/dsp.h"
#include "features/underwater/fast_refraction.h"
#include "shade/colour.h"
#include "shade/material.h"

/* A loop stays a function of its own: inlined it would run out of registers. */
#if defined(__GNUC__)
#define LOOP static __attribute__((noinline)) void
#else
#define LOOP static void
#endif

TP_ALWAYS_INLINE uint32_t place_of_column(uint32_t rest, uint32_t way, uint32_t step,
                                          int32_t k, uint32_t slope, uint32_t by_slope)
{
    return rest + way + (uint32_t)k * step + (uint32_t)(tp_smuad(slope, by_slope) >> 6);
}

/* Sets the places on the floor of all samples. */
LOOP set_places(const tp_floor_block *block, const tp_run *run,
                tp_floor_place *restrict to)
{
    const uint32_t *s = run->s + block->first, *t = run->t + block->first;
    const uint32_t *slope = run->slope + block->first;
    const uint32_t x = (uint32_t)block->x, z = (uint32_t)block->z;
    const uint32_t step_x = (uint32_t)block->step_x, step_z = (uint32_t)block->step_z;
    const uint32_t by_x = block->by_slope_x, by_z = block->by_slope_z;
    const int32_t last = block->count - 1;

    for (int32_t k = 0; ; to++) {
        to->s = s[k];
        to->t = t[k];
        to->x = place_of_column(s[k], x, step_x, k, slope[k], by_x);
        to->z = place_of_column(t[k], z, step_z, k, slope[k], by_z);
        if (k == last)
            return;
        k = k + 2 < last ? k + 2 : last;
    }
}

/* Returns the bilinear mean of four texels of a square mipmap level; weights of 1/256. */
TP_ALWAYS_INLINE uint32_t square_texel(const tp_mip_level *level, uint32_t s, uint32_t t)
{
    const uint32_t su = s >> level->down_s, tv = t >> level->down_s;
    const uint32_t u = su >> 8, v = tv >> 8, fs = su & 0xff, ft = tv & 0xff;
    const uint32_t right = (u + 1) & level->last_s, below = (v + 1) & level->last_s;
    const uint32_t *over = level->texel + (v << level->log2_w);
    const uint32_t *under = level->texel + (below << level->log2_w);
    const uint32_t d = fs * ft >> 8, b = fs - d, c = ft - d, a = 256 - fs - c;
    const uint32_t rb = tp_even_bytes(over[u]) * a + tp_even_bytes(over[right]) * b
                      + tp_even_bytes(under[u]) * c + tp_even_bytes(under[right]) * d;
    const uint32_t g = tp_odd_bytes(over[u]) * a + tp_odd_bytes(over[right]) * b
                     + tp_odd_bytes(under[u]) * c + tp_odd_bytes(under[right]) * d;

    return tp_odd_bytes(rb + TP_HALF_RB) | ((g + TP_HALF_G / 256) & 0xff00);
}

LOOP read_square_texels(const tp_mip_level *level, uint32_t per_metre, int32_t samples,
                        const tp_floor_place *at, uint32_t *restrict texel)
{
    const tp_mip_level l = *level;

    for (int32_t j = 0; j < samples; j++)
        texel[j] = square_texel(&l, at[j].x * per_metre - l.half_s,
                                at[j].z * per_metre - l.half_s);
}

/* Reads the floor's texels: the mean of four. */
LOOP read_texels(const tp_wall_material *floor, const tp_floor_block *block,
                 const tp_floor_place *at, uint32_t *restrict texel)
{
    if (!floor->texture) {
        for (int32_t j = 0; j < block->samples; j++)
            texel[j] = 0xffffff;
        return;
    }
    const tp_mip_level level = tp_wall_material_level(floor, block->far, true);
    if (level.last_s == level.last_t) {
        read_square_texels(&level, floor->per_metre, block->samples, at, texel);
        return;
    }
    for (int32_t j = 0; j < block->samples; j++)
        texel[j] = tp_mip_level_sample_linear(&level, at[j].x * floor->per_metre,
                                              at[j].z * floor->per_metre);
}

/* True if red or blue is shifted by a texel or more anywhere in the block. */
static bool is_shift_visible(const tp_mip_level *level, uint32_t per_metre,
                             const tp_floor_block *block)
{
    const int32_t last = block->count - 1;
    const tp_fx x = block->shift_x, end_x = x + last * block->shift_step_x;
    const tp_fx z = block->shift_z, end_z = z + last * block->shift_step_z;
    const tp_fx most_x = tp_abs(x) > tp_abs(end_x) ? tp_abs(x) : tp_abs(end_x);
    const tp_fx most_z = tp_abs(z) > tp_abs(end_z) ? tp_abs(z) : tp_abs(end_z);

    return (uint64_t)(uint32_t)most_x * per_metre >= 2ull * level->half_s
        || (uint64_t)(uint32_t)most_z * per_metre >= 2ull * level->half_t;
}

/* Replaces red and blue of the texels by those at shifted places. */
LOOP shift_texels(const tp_mip_level *level, uint32_t per_metre, const tp_floor_block *block,
                  const tp_floor_place *at, uint32_t *restrict texel)
{
    for (int32_t j = 0; j < block->samples; j++) {
        const uint32_t k = (uint32_t)tp_fast_column(block, j);
        const uint32_t dx = (uint32_t)block->shift_x + k * (uint32_t)block->shift_step_x;
        const uint32_t dz = (uint32_t)block->shift_z + k * (uint32_t)block->shift_step_z;
        const uint32_t s = at[j].x * per_metre, ds = dx * per_metre;
        const uint32_t t = at[j].z * per_metre, dt = dz * per_metre;
        texel[j] = (texel[j] & 0xff00)
                 | tp_mip_level_channel_linear(level, s + ds, t + dt, 16) << 16
                 | tp_mip_level_channel_linear(level, s - ds, t - dt, 0);
    }
}

/* Reads the floor's texels, with red and blue at shifted places where that is visible. */
static void read_shifted_texels(const tp_wall_material *floor, const tp_floor_block *block,
                                const tp_floor_place *at, uint32_t *texel)
{
    read_texels(floor, block, at, texel);
    if (!floor->texture)
        return;
    const tp_mip_level level = tp_wall_material_level(floor, block->far, true);
    if (is_shift_visible(&level, floor->per_metre, block))
        shift_texels(&level, floor->per_metre, block, at, texel);
}

/* Returns a channel: the texel and the water's own colour in the halves of a word times
 * their weights, whose sum is at most 2^14. */
TP_ALWAYS_INLINE uint32_t mix_channel(uint32_t colours, uint32_t weights)
{
    return (uint32_t)tp_usat(tp_smlad(colours, weights, 8192), 14, 8);
}

/* Mixes the floor's texels and the water's own colours. */
LOOP mix_floor(const tp_floor_block *block, uint32_t deep, const uint32_t *restrict texel,
               const uint32_t *restrict unlit, uint32_t *restrict mixed)
{
    const uint32_t red_step = 2 * block->weights_step[0];
    const uint32_t green_step = 2 * block->weights_step[1];
    const uint32_t blue_step = 2 * block->weights_step[2];
    const int32_t last = block->count - 1;
    uint32_t red = block->weights[0], green = block->weights[1], blue = block->weights[2];
    uint32_t before = unlit[0], own = tp_fast_own_colour(deep, before, block->lit);

    for (int32_t k = 0; ; ) {
        const uint32_t here = unlit[k], t = *texel++;
        if (here != before) {
            before = here;
            own = tp_fast_own_colour(deep, here, block->lit);
        }
        const uint32_t rb = tp_even_bytes(t), own_rb = tp_even_bytes(own);
        const uint32_t g = tp_pack_low_halves(tp_odd_bytes(own), tp_odd_bytes(t));
        *mixed++ = mix_channel(tp_pack_high_halves(own_rb, rb), red) << 16
                 | mix_channel(g, green) << 8
                 | mix_channel(tp_pack_low_halves(own_rb, rb), blue);
        if (k == last)
            return;
        red += red_step;
        green += green_step;
        blue += blue_step;
        k = k + 2 < last ? k + 2 : last;
    }
}

/* Writes the samples' colours and their means. */
static void fill_columns(const tp_floor_block *block, const uint32_t *restrict mixed,
                         uint32_t *restrict colour)
{
    const int32_t last = block->samples - 1;
    uint32_t here = mixed[0];

    for (int32_t j = 0; j < last; j++) {
        const uint32_t next = mixed[j + 1];
        colour[2 * j] = here;
        colour[2 * j + 1] = tp_uhadd8(here, next);
        here = next;
    }
    colour[block->count - 1] = here;
}

TP_ALWAYS_INLINE void shade_floor(const tp_shade *shade, const tp_floor_block *block,
                                  tp_run *run, int shifted)
{
    const tp_underwater *in = shade->underwater;
    uint32_t texel[TP_FAST_SAMPLES], mixed[TP_FAST_SAMPLES];
    uint32_t *colour = run->colour + block->first;
    tp_floor_place place[TP_FAST_SAMPLES];

    set_places(block, run, place);
    if (shifted)
        read_shifted_texels(&in->floor, block, place, texel);
    else
        read_texels(&in->floor, block, place, texel);
    if (shade->caustic)
        tp_fast_caustics_light(shade, block, place, texel);
    mix_floor(block, in->deep, texel, colour, mixed);
    if (in->walled || in->island)
        tp_fast_walls(shade, block, place, colour, mixed);
    fill_columns(block, mixed, colour);
}

void tp_fast_floor_shade(const tp_shade *shade, const tp_floor_block *block, tp_run *run)
{
    shade_floor(shade, block, run, 0);
}

void tp_fast_floor_shade_shifted(const tp_shade *shade, const tp_floor_block *block,
                                 tp_run *run)
{
    shade_floor(shade, block, run, 1);
}
