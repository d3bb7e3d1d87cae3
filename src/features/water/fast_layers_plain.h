/* SPDX-License-Identifier: MIT */
/*
 * Loops of fast shading in plain C, vectorized by compilers to eight lanes with gathers.
 * fast_layers_m4.h has the same loops with identical results.
 */
#ifndef TP_FEATURES_WATER_FAST_LAYERS_PLAIN_H
#define TP_FEATURES_WATER_FAST_LAYERS_PLAIN_H
#include "features/water/fast_shading.h"

TP_ALWAYS_INLINE uint32_t plain_texel(const tp_lookup *l, uint32_t s, uint32_t t)
{
    uint32_t u = (s * l->per_metre + l->drift_s) >> l->down;
    uint32_t v = (t * l->per_metre + l->drift_t) >> l->down;
    return l->texel[(int32_t)((v << (32 - l->down)) + u)];
}

/* Returns the sum of two colours 0x00RRGGBB; a channel with a carry saturates at 255. */
TP_ALWAYS_INLINE uint32_t plain_add_saturated(uint32_t a, uint32_t b)
{
    uint32_t over = (a & b) + ((a ^ b) >> 1 & 0x7f7f7f);

    over &= 0x808080;
    uint32_t carry = over << 1;
    return (a + b - carry) | (carry - (over >> 7));
}

/* Writes the texels of the first layer. */
TP_LOOP plain_write_texels(const tp_quick_map *map, int32_t mip_offset,
                           const uint32_t *restrict place, uint32_t *restrict colour,
                           int32_t count)
{
    const tp_lookup l = tp_lookup_make(map, mip_offset);

    for (int32_t i = 0; i < count; i++)
        colour[i] = plain_texel(&l, place[i], place[i + TP_RUN]);
}

/* Adds the texels of a further layer, saturated at white. */
TP_LOOP plain_add_texels(const tp_quick_map *map, int32_t mip_offset,
                         const uint32_t *restrict place, uint32_t *restrict colour,
                         int32_t count)
{
    const tp_lookup l = tp_lookup_make(map, mip_offset);

    for (int32_t i = 0; i < count; i++)
        colour[i] =
            plain_add_saturated(colour[i], plain_texel(&l, place[i], place[i + TP_RUN]));
}

/* Return an offset in m, 16.16.  The s offset keeps t's bits as a fraction, less than
 * 1/1024 m. */
TP_ALWAYS_INLINE uint32_t plain_unpack_offset_s(uint32_t off)
{
    return (uint32_t)((int32_t)off >> 10);
}

TP_ALWAYS_INLINE uint32_t plain_unpack_offset_t(uint32_t off)
{
    return (uint32_t)((int32_t)(off << 16) >> 10);
}

TP_ALWAYS_INLINE void plain_distort_place(const tp_lookup *l, const tp_columns *c,
                                          int32_t i, uint32_t *place)
{
    uint32_t off = plain_texel(l, c->s[i], c->t[i]);

    place[0] = c->s[i] + plain_unpack_offset_s(off);
    place[TP_RUN] = c->t[i] + plain_unpack_offset_t(off);
}

/* Distorts the places: two columns share the offset of the even column. */
TP_LOOP plain_distort_places(const tp_quick_map *map, int32_t mip_offset,
                             const tp_columns *columns, uint32_t *restrict place)
{
    const tp_lookup  l = tp_lookup_make(map, mip_offset);
    const tp_columns c = *columns;
    const int32_t    odd = (int32_t)c.odd, pairs = (c.count - odd) >> 1;
    const uint32_t *restrict s = c.s + odd, *restrict t = c.t + odd;
    uint32_t *restrict to = place + odd;

    if (odd)
        plain_distort_place(&l, &c, 0, place);
    for (int32_t k = 0; k < pairs; k++) {
        uint32_t off = plain_texel(&l, s[2 * k], t[2 * k]);
        to[2 * k] = s[2 * k] + plain_unpack_offset_s(off);
        to[2 * k + 1] = s[2 * k + 1] + plain_unpack_offset_s(off);
        to[2 * k + TP_RUN] = t[2 * k] + plain_unpack_offset_t(off);
        to[2 * k + 1 + TP_RUN] = t[2 * k + 1] + plain_unpack_offset_t(off);
    }
    if ((c.count - odd) & 1)
        plain_distort_place(&l, &c, c.count - 1, place + c.count - 1);
}

/* Distorts the places of the first column and of the even columns only. */
TP_LOOP plain_distort_even_places(const tp_quick_map *map, int32_t mip_offset,
                                  const tp_columns *columns, uint32_t *restrict place)
{
    const tp_lookup  l = tp_lookup_make(map, mip_offset);
    const tp_columns c = *columns;
    const int32_t    odd = (int32_t)c.odd, evens = (c.count - odd + 1) >> 1;
    const uint32_t *restrict s = c.s + odd, *restrict t = c.t + odd;
    uint32_t *restrict to = place + odd;

    if (odd)
        plain_distort_place(&l, &c, 0, place);
    for (int32_t k = 0; k < evens; k++) {
        uint32_t off = plain_texel(&l, s[2 * k], t[2 * k]);
        to[k] = s[2 * k] + plain_unpack_offset_s(off);
        to[k + TP_RUN] = t[2 * k] + plain_unpack_offset_t(off);
    }
}

/* Adds the ripple's slopes; both halves of the sum saturate at 16 bits. */
TP_LOOP plain_add_ripple_slopes(const tp_quick_map *map, int32_t mip_offset,
                                const tp_columns *columns, uint32_t *restrict slope)
{
    const tp_lookup l = tp_lookup_make(map, mip_offset);
    const uint32_t *restrict s = columns->s, *restrict t = columns->t;
    const uint32_t *restrict n = columns->n;
    const int32_t count = columns->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t p = plain_texel(&l, s[i], t[i]), q = n[i];
        int32_t  x = ((int32_t)p >> 16) + ((int32_t)q >> 16);
        int32_t  z = ((int32_t)(p << 16) >> 16) + ((int32_t)(q << 16) >> 16);
        x = x < INT16_MIN ? INT16_MIN : x > INT16_MAX ? INT16_MAX : x;
        z = z < INT16_MIN ? INT16_MIN : z > INT16_MAX ? INT16_MAX : z;
        slope[i] = (uint32_t)x << 16 | ((uint32_t)z & 0xffff);
    }
}
/* Expands half rate colours to pairs of columns: each colour, and its mean with the next.
 * The colour after the last pair is read too. */
TP_LOOP plain_upsample_colours(const uint32_t *restrict half_rate,
                               uint32_t *restrict colour, int32_t pairs)
{
    for (int32_t k = 0; k < pairs; k++) {
        uint32_t a = half_rate[k], b = half_rate[k + 1];
        colour[2 * k] = a;
        colour[2 * k + 1] = (a & b) + ((a ^ b) >> 1 & 0x7f7f7f);
    }
}

#endif
