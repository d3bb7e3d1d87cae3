/* SPDX-License-Identifier: MIT */
/*
 * The planar reflection by blocks of 16 columns, for quality.objects=fast and for fast
 * lists.  A block has one depth, one distance of the mirrored object and one set of
 * displacement factors, from the middle of its samples; only the slopes differ from column
 * to column.  Blocks farther than REACH from the map's box are passed over: a steep wave
 * farther away would mirror a masthead, which is left out.
 */
#include "base/dsp.h"
#include "features/reflection/reflection.h"
#include "shade/slope.h"

#define REACH   48              /* px around the map's box */
#define FACTOR_BITS 14          /* of twice the focal length, 28.4, in a factor */

/* A block's displacement.  u, v: of a column, without its slope, 28.4 px, to add to the
 * place in the picture; by_u, by_v: factors of the slopes x:z, scaled down by `down`
 * bits. */
typedef struct {
    uint32_t by_u, by_v;
    int32_t  u, v, down;
} block_shift;

/* A vector, Q12. */
typedef struct {
    int32_t x, y, z;
} short_axis;

static short_axis short_axis_make(tp_dir3 d)
{
    return (short_axis){ d.x >> 18, d.y >> 18, d.z >> 18 };
}

/* Returns a b - c d of Q12 numbers.  Rays are below 16, axes below 1, so products are below
 * 2^29. */
TP_ALWAYS_INLINE int32_t difference(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return (a * b - c * d) >> 12;
}

/* The factors of tp_mirror_push without the focal length, Q12. */
typedef struct {
    int32_t xu, xv, zu, zv, hu, hv, dy;
} short_push;

/* Returns the factors at a pixel: the formulas of tp_mirror_push_make in 32 bits, for rays
 * clamped to 4. */
static short_push short_push_make(const tp_shade *shade, int32_t x, int32_t y)
{
    const short_axis r = short_axis_make(shade->world.right),
                     up = short_axis_make(shade->world.up),
                     back = short_axis_make(shade->world.back);
    const int32_t qu = tp_quick_over_focal(shade, 16 * x + 8 - shade->u0) >> 2;
    const int32_t qv = tp_quick_over_focal(shade, shade->v0 - 16 * y - 8) >> 2;
    const int32_t dx = difference(qu, r.x, -qv, up.x) - back.x;
    const int32_t dy = difference(qu, r.y, -qv, up.y) - back.y;
    const int32_t dz = difference(qu, r.z, -qv, up.z) - back.z;
    const int32_t ax = difference(dx, back.y, dy, back.x);
    const int32_t az = difference(dz, back.y, dy, back.z);

    return (short_push){
        2 * (difference(dy, r.x, dx, r.y) - (qu * ax >> 12)),
        -2 * (difference(dy, up.x, dx, up.y) - (qv * ax >> 12)),
        2 * (difference(dy, r.z, dz, r.y) - (qu * az >> 12)),
        -2 * (difference(dy, up.z, dz, up.y) - (qv * az >> 12)),
        -2 * (r.y + (qu * back.y >> 12)), 2 * (up.y + (qv * back.y >> 12)), dy,
    };
}

/* Returns a factor times focal length and share, a product of 28.4 px, in 16 bits. */
static int32_t scaled_factor(int32_t factor, int32_t reach, int32_t down)
{
    const int32_t scaled = (int32_t)((int64_t)factor * reach >> (12 + down));
    return tp_clamp(scaled, -32768, 32767);
}

/* Returns the displacement in columns around x for water of a depth, by its key.  False: the
 * water lies behind all objects. */
static bool block_shift_make(const tp_shade *shade, const tp_mirror *look, int32_t x,
                             int32_t y, uint32_t key, block_shift *to)
{
    uint32_t zi;
    int32_t ratio;

    if (!tp_mirror_find_object(look, x, key, &zi, &ratio))
        return false;
    const short_push p = short_push_make(shade, x, y);
    const int32_t share = tp_clamp(65536 - ratio, 0, 65536) * look->bend >> 8;
    const int64_t high = ((int64_t)zi * look->height >> 27)
                       + ((int64_t)p.dy * ratio >> 12);
    const int32_t h = (int32_t)tp_clamp_abs(high, 1 << 20);
    const int32_t bits = 32 - tp_clz((uint32_t)shade->focal | 1);
    const int32_t down = bits > FACTOR_BITS ? bits - FACTOR_BITS : 0;
    const int32_t reach = (int32_t)((int64_t)shade->focal * share >> 16);
    const int64_t rise = (int64_t)shade->focal * h >> 16;

    *to = (block_shift){
        tp_pair16(scaled_factor(p.xu, reach, down), scaled_factor(p.zu, reach, down)),
        tp_pair16(scaled_factor(p.xv, reach, down), scaled_factor(p.zv, reach, down)),
        (int32_t)tp_clamp_abs(p.hu * rise >> 12, 1 << 15),
        (int32_t)tp_clamp_abs(p.hv * rise >> 12, 1 << 15), down,
    };
    return true;
}

/* True if the map may be seen in columns x to x + 15 of row y. */
static bool is_near_box(const tp_planar_map *map, int32_t x, int32_t y)
{
    const int by = map->halvings;
    return x + 16 > map->x0 * (1 << by) - REACH && x < map->x1 * (1 << by) + REACH
        && y >= map->y0 * (1 << by) - REACH && y < map->y1 * (1 << by) + REACH;
}

/* Returns the slope x:z of sample i; `packed`: of a fast list. */
TP_ALWAYS_INLINE uint32_t slope_pair(const tp_run *run, int32_t i, int packed)
{
    return packed ? run->slope[i] : tp_pair16(run->sx[i], run->sz[i]);
}

TP_ALWAYS_INLINE uint32_t sample_object(const tp_planar_map *map, const block_shift *shift,
                                        int32_t x, int32_t y, uint32_t slope, int rgb565)
{
    const int32_t du = shift->u + (tp_smuad(shift->by_u, slope) >> (12 - shift->down));
    const int32_t u = tp_planar_map_position(map, 16 * x + 8 + du);

    if (tp_planar_map_misses_column(map, u))
        return 0;
    const int32_t dv = shift->v + (tp_smuad(shift->by_v, slope) >> (12 - shift->down));
    return tp_mirror_sample(map, u, tp_planar_map_position(map, 16 * y + 8 + dv), rgb565);
}

/* Finds the objects in samples [i, stop) of a block, one for two columns unless a pixel of
 * the map is as narrow as a column.  Returns false if there are none. */
TP_ALWAYS_INLINE bool find_objects(const tp_shade *shade, const tp_mirror *look,
                                   const tp_run *run, int32_t i, int32_t stop, int packed,
                                   int rgb565, uint32_t *to)
{
    block_shift shift;
    uint32_t any = 0;
    const int32_t middle = (i + stop) >> 1, odd = look->map.halvings > 0;

    if (!is_near_box(&look->map, (run->x + i) & ~15, run->y)
        || !block_shift_make(shade, look, run->x + middle, run->y, run->key[middle], &shift))
        return false;
    while (i < stop) {
        const int32_t next = i + 1 + (odd & ~(run->x + i));
        const uint32_t seen = sample_object(&look->map, &shift, run->x + i, run->y,
                                            slope_pair(run, i, packed), rgb565);
        any |= seen;
        for (; i < next && i < stop; i++)
            *to++ = seen;
    }
    return any != 0;
}

TP_ALWAYS_INLINE void mirror_blocks(const tp_shade *shade, tp_run *run, int rgb565)
{
    const tp_mirror *look = run->mine;
    uint32_t seen[16];

    for (int32_t i = 0, stop; look->map.colour && i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        if (!find_objects(shade, look, run, i, stop, 0, rgb565, seen))
            continue;
        for (int32_t k = i; k < stop; k++)
            if (seen[k - i])
                run->mirror[k] = tp_colour_composite(run->mirror[k], seen[k - i]);
    }
}

void tp_stage_mirrored_fast(const tp_shade *shade, tp_run *run)
{
    mirror_blocks(shade, run, 0);
}

void tp_stage_mirrored_packed_fast(const tp_shade *shade, tp_run *run)
{
    mirror_blocks(shade, run, 1);
}

TP_ALWAYS_INLINE void find_objects_alone(const tp_shade *shade, tp_run *run, int rgb565)
{
    const tp_mirror *look = run->mine;

    run->objects = 0;
    for (int32_t i = 0, stop; look->map.colour && i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        if (find_objects(shade, look, run, i, stop, 1, rgb565, run->mirror + i))
            run->objects |= 1u << tp_block_number(run, i);
    }
}

void tp_stage_quick_objects(const tp_shade *shade, tp_run *run)
{
    find_objects_alone(shade, run, 0);
}

void tp_stage_quick_packed_objects(const tp_shade *shade, tp_run *run)
{
    find_objects_alone(shade, run, 1);
}
