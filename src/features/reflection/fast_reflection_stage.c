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

#define REACH   48              /* px around the map's box */
#define BESIDE  (65536 + 8192)  /* as for the exact stage: an eighth beyond the object */
#define FACTOR_BITS 14          /* of twice the focal length, 28.4, in a factor */

/* A block's displacement.  u, v: of a column, without its slope, 28.4 px, to add to the
 * place in the picture; by_u, by_v: factors of the slopes x:z, scaled down by `down`
 * bits. */
typedef struct {
    uint32_t by_u, by_v;
    int32_t  u, v, down;
} block_shift;

/* Returns a factor times the share, Q16, in 16 bits. */
static int32_t scaled_factor(int32_t factor, int32_t share, int32_t down)
{
    const int32_t scaled = (int32_t)((int64_t)factor * share >> (16 + down));
    return tp_clamp(scaled, -32768, 32767);
}

/* Returns the displacement in columns around x for water of a depth, by its key.  False: the
 * water lies behind all objects. */
static bool block_shift_make(const tp_shade *shade, const tp_mirror *look, int32_t x,
                             int32_t y, uint32_t key, block_shift *to)
{
    const tp_planar_map *map = &look->map;
    const tp_mirrored_zi *column = &look->zi[tp_clamp(
        (x >> (1 + map->coarser)) - map->x0, 0, map->x1 - map->x0 - 1)];
    uint32_t zi = column->near;
    int32_t  ratio = tp_mirror_depth_ratio(zi, key);

    if (ratio > BESIDE) {
        zi = column->far;
        ratio = tp_mirror_depth_ratio(zi, key);
        if (ratio > 65536)
            return false;
    }
    const tp_mirror_push p = tp_mirror_push_make(shade, x, y);
    const int32_t share = tp_clamp(65536 - ratio, 0, 65536) * look->bend >> 8;
    const int64_t high = ((int64_t)zi * look->height >> 27) + ((int64_t)p.dy * ratio >> 16);
    const int32_t h = (int32_t)tp_clamp_abs(high, 1 << 20);
    const int32_t bits = 32 - tp_clz((uint32_t)shade->focal | 1);
    const int32_t down = bits > FACTOR_BITS ? bits - FACTOR_BITS : 0;

    *to = (block_shift){
        tp_pair16(scaled_factor(p.xu, share, down), scaled_factor(p.zu, share, down)),
        tp_pair16(scaled_factor(p.xv, share, down), scaled_factor(p.zv, share, down)),
        (int32_t)tp_clamp_abs((int64_t)p.hu * h >> 16, 1 << 15),
        (int32_t)tp_clamp_abs((int64_t)p.hv * h >> 16, 1 << 15), down,
    };
    return true;
}

/* True if the map may be seen in columns x to x + 15 of row y. */
static bool is_near_box(const tp_planar_map *map, int32_t x, int32_t y)
{
    const int by = 1 + map->coarser;
    return x + 16 > map->x0 * (1 << by) - REACH && x < map->x1 * (1 << by) + REACH
        && y >= map->y0 * (1 << by) - REACH && y < map->y1 * (1 << by) + REACH;
}

/* Returns the slope x:z of sample i; `packed`: of a fast list. */
TP_ALWAYS_INLINE uint32_t slope_pair(const tp_run *run, int32_t i, int packed)
{
    return packed ? run->slope[i] : tp_pair16(run->sx[i], run->sz[i]);
}

TP_ALWAYS_INLINE uint32_t sample_object(const tp_planar_map *map, const block_shift *shift,
                                        int32_t x, int32_t y, uint32_t slope)
{
    const int32_t du = shift->u + (tp_smuad(shift->by_u, slope) >> (12 - shift->down));
    const int32_t u = (16 * x + 8 + du) >> map->coarser;

    if (tp_planar_map_misses_column(map, u))
        return 0;
    const int32_t dv = shift->v + (tp_smuad(shift->by_v, slope) >> (12 - shift->down));
    return tp_planar_map_sample(map, u, (16 * y + 8 + dv) >> map->coarser);
}

/* Lays the objects over the sky's reflection in samples [i, stop) of an exact list. */
static void shade_block(const tp_shade *shade, const tp_mirror *look, tp_run *run,
                        int32_t i, int32_t stop)
{
    block_shift shift;
    const int32_t middle = (i + stop) >> 1;

    if (!block_shift_make(shade, look, run->x + middle, run->y, run->key[middle], &shift))
        return;
    for (; i < stop; i++) {
        const uint32_t top = sample_object(&look->map, &shift, run->x + i, run->y,
                                           slope_pair(run, i, 0));
        if (top)
            run->mirror[i] = tp_colour_composite(run->mirror[i], top);
    }
}

void tp_stage_mirrored_fast(const tp_shade *shade, tp_run *run)
{
    const tp_mirror *look = run->mine;

    for (int32_t i = 0, stop; look->map.colour && i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        if (is_near_box(&look->map, (run->x + i) & ~15, run->y))
            shade_block(shade, look, run, i, stop);
    }
}

/* Writes the objects in samples [i, stop) of a fast list.  Returns false if there are
 * none. */
static bool find_objects(const tp_shade *shade, const tp_mirror *look, tp_run *run,
                         int32_t i, int32_t stop)
{
    block_shift shift;
    uint32_t any = 0;
    const int32_t middle = (i + stop) >> 1;

    if (!block_shift_make(shade, look, run->x + middle, run->y, run->key[middle], &shift))
        return false;
    for (; i < stop; i++) {
        run->mirror[i] = sample_object(&look->map, &shift, run->x + i, run->y,
                                       slope_pair(run, i, 1));
        any |= run->mirror[i];
    }
    return any != 0;
}

void tp_stage_quick_objects(const tp_shade *shade, tp_run *run)
{
    const tp_mirror *look = run->mine;

    run->objects = 0;
    for (int32_t i = 0, stop; look->map.colour && i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        if (is_near_box(&look->map, (run->x + i) & ~15, run->y)
            && find_objects(shade, look, run, i, stop))
            run->objects |= 1u << tp_block_number(run, i);
    }
}
