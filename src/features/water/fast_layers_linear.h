/* SPDX-License-Identifier: MIT */
/*
 * Loops of fast shading with bilinear look-ups, for textures whose texels show: the places
 * and the mipmap levels are those of the nearest look-ups.  Weights have 5 bits; the channels
 * of a colour are mixed in two words.
 */
#ifndef TP_FEATURES_WATER_FAST_LAYERS_LINEAR_H
#define TP_FEATURES_WATER_FAST_LAYERS_LINEAR_H
#include "features/water/fast_shading.h"

/* Returns a look-up whose places are half a texel less: the upper left one of the four
 * texels around a place. */
TP_ALWAYS_INLINE tp_lookup linear_lookup_make(const tp_quick_map *map, int32_t mip_offset)
{
    tp_lookup l = tp_lookup_make(map, mip_offset);

    l.drift_s -= 1u << (l.down - 1);
    l.drift_t -= 1u << (l.down - 1);
    return l;
}

/* The four texels around a place, and the weights of the right and of the lower ones,
 * 0..31. */
typedef struct {
    uint32_t a, b, c, d, right, below;
} texel_square;

TP_ALWAYS_INLINE texel_square linear_fetch(const tp_lookup *l, uint32_t s, uint32_t t)
{
    const uint32_t u = s * l->per_metre + l->drift_s, v = t * l->per_metre + l->drift_t;
    const uint32_t i = u >> l->down, j = v >> l->down, mask = l->side - 1;
    const uint32_t *row = l->texel + j * l->side;
    const uint32_t *next = l->texel + ((j + 1) & mask) * l->side;
    const uint32_t i1 = (i + 1) & mask;

    return (texel_square){ row[i], row[i1], next[i], next[i1],
                           u >> (l->down - 5) & 31, v >> (l->down - 5) & 31 };
}

/* Mixes two colours 0x00RRGGBB, f of 32 parts of b. */
TP_ALWAYS_INLINE uint32_t linear_mix(uint32_t a, uint32_t b, uint32_t f)
{
    const uint32_t rb = (a & 0xff00ff) * (32 - f) + (b & 0xff00ff) * f;
    const uint32_t g = (a & 0x00ff00) * (32 - f) + (b & 0x00ff00) * f;
    return (rb >> 5 & 0xff00ff) | (g >> 5 & 0x00ff00);
}

TP_ALWAYS_INLINE uint32_t linear_texel(const tp_lookup *l, uint32_t s, uint32_t t)
{
    const texel_square q = linear_fetch(l, s, t);

    if (((q.a ^ q.b) | (q.a ^ q.c) | (q.a ^ q.d)) == 0)
        return q.a;
    return linear_mix(linear_mix(q.a, q.b, q.right), linear_mix(q.c, q.d, q.right),
                      q.below);
}

TP_LOOP linear_write_texels(const tp_quick_map *map, int32_t mip_offset,
                            const uint32_t *restrict place, uint32_t *restrict colour,
                            int32_t count)
{
    const tp_lookup l = linear_lookup_make(map, mip_offset);

    for (int32_t i = 0; i < count; i++)
        colour[i] = linear_texel(&l, place[i], place[i + TP_RUN]);
}

TP_LOOP linear_add_texels(const tp_quick_map *map, int32_t mip_offset,
                          const uint32_t *restrict place, uint32_t *restrict colour,
                          int32_t count)
{
    const tp_lookup l = linear_lookup_make(map, mip_offset);

    for (int32_t i = 0; i < count; i++)
        colour[i] = tp_uqadd8(colour[i], linear_texel(&l, place[i], place[i + TP_RUN]));
}

/* Return the same halves of two words. */
TP_ALWAYS_INLINE uint32_t high_halves(uint32_t high, uint32_t low)
{
    return (high & 0xffff0000u) | low >> 16;
}

TP_ALWAYS_INLINE uint32_t low_halves(uint32_t high, uint32_t low)
{
    return high << 16 | (low & 0xffff);
}

/* Both halves of a texel: an offset s and t in 1/1024 m, or a slope x and z in Q12; Q10
 * more. */
typedef struct {
    int32_t high, low;
} linear_pair;

/* Returns the mean of the halves at a place. */
TP_ALWAYS_INLINE linear_pair linear_find_pair(const tp_lookup *l, uint32_t s,
                                              uint32_t t)
{
    const texel_square q = linear_fetch(l, s, t);
    const uint32_t across = q.right << 16 | (32 - q.right);
    const int32_t below = (int32_t)q.below, above = 32 - below;

    return (linear_pair){
        tp_smuad(high_halves(q.b, q.a), across) * above
            + tp_smuad(high_halves(q.d, q.c), across) * below,
        tp_smuad(low_halves(q.b, q.a), across) * above
            + tp_smuad(low_halves(q.d, q.c), across) * below,
    };
}

/* Adds the ripple's slopes; both halves of the sum saturate at 16 bits. */
TP_LOOP linear_add_ripple_slopes(const tp_quick_map *map, int32_t mip_offset,
                                 const tp_columns *columns, uint32_t *restrict slope)
{
    const tp_lookup l = linear_lookup_make(map, mip_offset);
    const tp_columns c = *columns;

    for (int32_t i = 0; i < c.count; i++) {
        const linear_pair p = linear_find_pair(&l, c.s[i], c.t[i]);
        slope[i] = tp_qadd16(tp_pair16(p.high >> 10, p.low >> 10), c.n[i]);
    }
}

/* Distorts the places of columns [i, next) by offsets from a to b. `by`: 1, or 2 for
 * every second column of the picture. */
TP_ALWAYS_INLINE uint32_t *linear_distort_group(const tp_columns *c, int32_t i,
                                                int32_t next, linear_pair a,
                                                linear_pair b, uint32_t *place, int by)
{
    const int32_t wide = next > i ? next - i : 1;
    const int32_t ds = (b.high - a.high) / wide, dt = (b.low - a.low) / wide;

    for (; i < next; i++, a.high += ds, a.low += dt)
        if (by == 1 || i == 0 || (((uint32_t)i + c->column) & 1) == 0) {
            place[0] = c->s[i] + (uint32_t)(a.high >> 4);
            place[TP_RUN] = c->t[i] + (uint32_t)(a.low >> 4);
            place++;
        }
    return place;
}

/* Distorts the places.  The offset is exact at the first, the eighth and the last column of
 * a block of 16, and linear between: distortions are wide. */
TP_ALWAYS_INLINE void linear_distort(const tp_quick_map *map, int32_t mip_offset,
                                     const tp_columns *columns, uint32_t *place, int by)
{
    const tp_lookup l = linear_lookup_make(map, mip_offset);
    const tp_columns c = *columns;

    for (int32_t i = 0; i < c.count; ) {
        const int32_t full = i + 16 - (int32_t)(((uint32_t)i + c.column) & 15);
        const int32_t stop = full < c.count ? full : c.count;
        linear_pair a = linear_find_pair(&l, c.s[i], c.t[i]);
        while (i < stop - 1) {
            int32_t next = i + 8 - (int32_t)(((uint32_t)i + c.column) & 7);
            next = next < stop - 1 ? next : stop - 1;
            const linear_pair b = linear_find_pair(&l, c.s[next], c.t[next]);
            place = linear_distort_group(&c, i, next, a, b, place, by);
            a = b;
            i = next;
        }
        place = linear_distort_group(&c, i, stop, a, a, place, by);
        i = stop;
    }
}

TP_LOOP linear_distort_places(const tp_quick_map *map, int32_t mip_offset,
                              const tp_columns *columns, uint32_t *restrict place)
{
    linear_distort(map, mip_offset, columns, place, 1);
}

/* Distorts the places of the first column and of the even columns only. */
TP_LOOP linear_distort_even_places(const tp_quick_map *map, int32_t mip_offset,
                                   const tp_columns *columns, uint32_t *restrict place)
{
    linear_distort(map, mip_offset, columns, place, 2);
}

#endif
