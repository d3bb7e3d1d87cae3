/* SPDX-License-Identifier: MIT */
/* The sea floor: none, a straight slope, or a height map.
 *
 * The samples of a map lie in the middle of its pixels and are interpolated bilinearly.
 * Beyond the outermost samples the floor goes on level.  Rises are the slopes of the
 * bilinear patch and jump from pixel to pixel; tp_coastal_water keeps smoothed slopes. */
#include "waves/coastal_tables.h"

#define RISE_MAX TP_FX(8)

tp_way tp_way_from_degrees(tp_fx degrees)
{
    const tp_rotation turned = tp_rotation_from_angles(tp_turn_of_degrees(degrees), 0, 0);
    return (tp_way){ turned.x.z, -turned.x.x };
}

/* |x|, |z| <= 2^31 and a direction of length 1 in Q30: the sum of products is below
 * 2^62. */
tp_fx tp_way_project(tp_way way, tp_fx x, tp_fx z)
{
    return tp_fx_saturate(((int64_t)way.x * x + (int64_t)way.z * z + (1 << 29)) >> 30);
}

static tp_floor_at sample_plane(const tp_floor *floor, tp_fx x, tp_fx z)
{
    const tp_way up = tp_way_from_degrees(floor->heading);
    const int64_t rise = (int64_t)floor->slope * tp_way_project(up, x, z);

    return (tp_floor_at){
        .depth = tp_fx_saturate(floor->depth - ((rise + 0x8000) >> 16)),
        .rise_x = tp_q30_mul(floor->slope, up.x),
        .rise_z = tp_q30_mul(floor->slope, up.z),
    };
}

/* A coordinate on a map: the sample before the point, the next sample, and the fraction
 * between the two. */
typedef struct {
    uint32_t sample, next;
    int32_t  part;              /* Q16, 0..1 */
    bool     outside;
} map_place;

/* `distance` is the distance from the middle of the map; `samples` samples have a
 * pitch of `size` / `map_cols` metres.  |way| < 2^32 and across <= 2^12 leave room for
 * 16 more bits. */
static map_place locate_sample(int64_t distance, uint32_t samples, uint32_t map_cols,
                               tp_fx size)
{
    TP_ASSERT(samples > 0 && map_cols > 0 && map_cols <= 4096 && size > 0);
    const int64_t at = distance * (int64_t)map_cols * TP_FX_ONE / size
                     + ((int64_t)samples - 1) * (TP_FX_ONE / 2);
    const int64_t last = ((int64_t)samples - 1) * TP_FX_ONE;

    if (at < 0)
        return (map_place){ .outside = true };
    if (at >= last)
        return (map_place){ samples - 1, samples - 1, 0, at > last };
    const uint32_t sample = (uint32_t)(at >> 16);
    return (map_place){ sample, sample + 1, (int32_t)(at & 0xffff), false };
}

/* Returns map range (33 bits) times a sample of 24 bits, over white. */
static int64_t scale_to_map_range(const tp_floor *floor, int64_t sample_q8)
{
    const int64_t range = (int64_t)floor->map_high - floor->map_low;
    const int64_t white = (int64_t)65535 << 8, product = range * sample_q8;
    return tp_div_rounded(product, white);
}

/* Converts a difference of neighbours (17 bits) to a slope, m/m.  The range has 33 bits and
 * the number of columns 12: the product fits 64 bits.  The factor 2^16 / 65535 of white is
 * approximated by 1 + 1/65535. */
static tp_fx map_slope_from_difference(const tp_floor *floor, int64_t sample_difference)
{
    const int64_t range = (int64_t)floor->map_high - floor->map_low;
    const int64_t rise = range * floor->map->cols * sample_difference / floor->map_size;
    return (tp_fx)tp_clamp_abs(rise + rise / 65535, RISE_MAX);
}

static int64_t interpolate_scaled_q16(int64_t a, int64_t b, int32_t part)
{
    return a * TP_FX_ONE + (b - a) * part;
}

static tp_floor_at sample_map(const tp_floor *floor, tp_fx x, tp_fx z)
{
    const tp_grey *map = floor->map;
    const map_place u = locate_sample((int64_t)x - floor->map_x, map->cols, map->cols,
                             floor->map_size);
    const map_place v = locate_sample((int64_t)z - floor->map_z, map->rows, map->cols,
                             floor->map_size);
    const uint16_t *north = map->sample + (size_t)v.sample * map->cols;
    const uint16_t *south = map->sample + (size_t)v.next * map->cols;
    const int64_t high = interpolate_scaled_q16(north[u.sample], north[u.next], u.part);
    const int64_t low = interpolate_scaled_q16(south[u.sample], south[u.next], u.part);
    const int64_t west = interpolate_scaled_q16(north[u.sample], south[u.sample], v.part);
    const int64_t east = interpolate_scaled_q16(north[u.next], south[u.next], v.part);
    const int64_t middle = (interpolate_scaled_q16(high, low, v.part) + (1 << 23)) >> 24;

    return (tp_floor_at){
        .depth = tp_fx_saturate(-(floor->map_low + scale_to_map_range(floor, middle))),
        .rise_x = u.outside
                      ? 0
                      : map_slope_from_difference(floor, (east - west + 0x8000) >> 16),
        .rise_z =
            v.outside ? 0 : map_slope_from_difference(floor, (low - high + 0x8000) >> 16),
    };
}

tp_floor_at tp_floor_sample(const tp_floor *floor, tp_fx x, tp_fx z)
{
    if (floor->map != NULL)
        return sample_map(floor, x, z);
    if (floor->depth == 0)
        return (tp_floor_at){ .depth = TP_FX_MAX };
    return sample_plane(floor, x, z);
}
