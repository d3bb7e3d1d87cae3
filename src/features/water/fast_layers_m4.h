/* SPDX-License-Identifier: MIT */
/*
 * Loops of fast shading for processors with Arm's DSP extension and 13 registers.  Words
 * are loaded and stored in pairs; the lanes of a word are added in one instruction.
 * fast_layers_plain.h has the same loops with explanations and identical results.  Every
 * machine compiles and compares both.
 */
#ifndef TP_FEATURES_WATER_FAST_LAYERS_M4_H
#define TP_FEATURES_WATER_FAST_LAYERS_M4_H
#include "features/water/fast_shading.h"

/* -- look-ups ------------------------------------------------------------------------ */

/* Returns the look-up of a map.  The asm hides the side from the compiler, which would
 * otherwise replace the multiplication by a shift and an addition. */
TP_ALWAYS_INLINE tp_lookup packed_lookup(const tp_quick_map *map, int32_t mip_offset)
{
    tp_lookup l = tp_lookup_make(map, mip_offset);
#if TP_DSP
    __asm__("" : "+r"(l.side));
#endif
    return l;
}

TP_ALWAYS_INLINE uint32_t packed_texel(const tp_lookup *l, uint32_t s, uint32_t t)
{
    uint32_t u = (s * l->per_metre + l->drift_s) >> l->down;
    uint32_t v = (t * l->per_metre + l->drift_t) >> l->down;
    return l->texel[v * l->side + u];
}

TP_ALWAYS_INLINE void packed_write_texel_pair(const tp_lookup *l, const uint32_t *place,
                                              uint32_t *colour, int index)
{
    const tp_word_pair s = tp_load_pair(place, index);
    const tp_word_pair t = tp_load_pair(place, index + TP_RUN);

    tp_store_pair(colour, index, packed_texel(l, s.first, t.first),
                  packed_texel(l, s.second, t.second));
}

TP_LOOP packed_write_texels(const tp_quick_map *map, int32_t mip_offset,
                            const uint32_t *place, uint32_t *colour, int32_t count)
{
    const tp_lookup l = packed_lookup(map, mip_offset);
    const uint32_t *end = place + (count & ~7);

    for (; place != end; place += 8, colour += 8) {
        packed_write_texel_pair(&l, place, colour, 0);
        packed_write_texel_pair(&l, place, colour, 2);
        packed_write_texel_pair(&l, place, colour, 4);
        packed_write_texel_pair(&l, place, colour, 6);
    }
    for (end += count & 7; place != end; place++)
        *colour++ = packed_texel(&l, place[0], place[TP_RUN]);
}

TP_ALWAYS_INLINE void packed_add_texel_pair(const tp_lookup *l, const uint32_t *place,
                                            uint32_t *colour, int index)
{
    const tp_word_pair s = tp_load_pair(place, index);
    const tp_word_pair t = tp_load_pair(place, index + TP_RUN);
    uint32_t a = packed_texel(l, s.first, t.first);
    uint32_t b = packed_texel(l, s.second, t.second);
    const tp_word_pair c = tp_load_pair(colour, index);

    tp_store_pair(colour, index, tp_uqadd8(c.first, a), tp_uqadd8(c.second, b));
}

TP_LOOP packed_add_texels(const tp_quick_map *map, int32_t mip_offset,
                          const uint32_t *place, uint32_t *colour, int32_t count)
{
    const tp_lookup l = packed_lookup(map, mip_offset);
    const uint32_t *end = place + (count & ~7);

    for (; place != end; place += 8, colour += 8) {
        packed_add_texel_pair(&l, place, colour, 0);
        packed_add_texel_pair(&l, place, colour, 2);
        packed_add_texel_pair(&l, place, colour, 4);
        packed_add_texel_pair(&l, place, colour, 6);
    }
    for (end += count & 7; place != end; place++, colour++)
        *colour = tp_uqadd8(*colour, packed_texel(&l, place[0], place[TP_RUN]));
}

/* -- distortion ---------------------------------------------------------------------- */

TP_ALWAYS_INLINE uint32_t packed_add_offset_s(uint32_t s, uint32_t off)
{
    return s + (uint32_t)((int32_t)off >> 10);
}

TP_ALWAYS_INLINE uint32_t packed_add_offset_t(uint32_t t, uint32_t off_t)
{
    return t + (uint32_t)((int32_t)off_t >> 10);
}

TP_ALWAYS_INLINE void packed_distort_place(const tp_lookup *l, uint32_t s, uint32_t t,
                                           uint32_t *place)
{
    uint32_t off = packed_texel(l, s, t);

    place[0] = packed_add_offset_s(s, off);
    place[TP_RUN] = packed_add_offset_t(t, off << 16);
}

/* Distorts the next two places of *s and *t, both by the offset at the first place, into
 * place[index] and place[index + 1]. */
TP_ALWAYS_INLINE void packed_distort_pair(const tp_lookup *l, const uint32_t **s,
                                          const uint32_t **t, uint32_t *place, int index)
{
    const tp_word_pair ss = tp_load_next_pair(s), tt = tp_load_next_pair(t);
    uint32_t off = packed_texel(l, ss.first, tt.first), off_t = off << 16;

    tp_store_pair(place, index, packed_add_offset_s(ss.first, off),
                  packed_add_offset_s(ss.second, off));
    tp_store_pair(place, index + TP_RUN, packed_add_offset_t(tt.first, off_t),
                  packed_add_offset_t(tt.second, off_t));
}

TP_LOOP packed_distort_places(const tp_quick_map *map, int32_t mip_offset,
                              const tp_columns *columns, uint32_t *place)
{
    const tp_lookup l = packed_lookup(map, mip_offset);
    const uint32_t *s = columns->s, *t = columns->t;
    int32_t count = columns->count;

    if (columns->odd) {
        packed_distort_place(&l, *s++, *t++, place++);
        count--;
    }
    const uint32_t *end = place + (count & ~3);
    for (; place != end; place += 4) {
        packed_distort_pair(&l, &s, &t, place, 0);
        packed_distort_pair(&l, &s, &t, place, 2);
    }
    if (count & 2) {
        packed_distort_pair(&l, &s, &t, place, 0);
        place += 2;
    }
    if (count & 1)
        packed_distort_place(&l, *s, *t, place);
}

TP_LOOP packed_distort_even_places(const tp_quick_map *map, int32_t mip_offset,
                                   const tp_columns *columns, uint32_t *place)
{
    const tp_lookup l = packed_lookup(map, mip_offset);
    const uint32_t *s = columns->s, *t = columns->t;
    int32_t count = columns->count;

    if (columns->odd) {
        packed_distort_place(&l, *s++, *t++, place++);
        count--;
    }
    const uint32_t *end = place + (count >> 2 << 1);
    for (; place != end; place += 2, s += 4, t += 4) {
        const uint32_t a = packed_texel(&l, s[0], t[0]), b = packed_texel(&l, s[2], t[2]);
        tp_store_pair(place, 0, packed_add_offset_s(s[0], a), packed_add_offset_s(s[2], b));
        tp_store_pair(place, TP_RUN, packed_add_offset_t(t[0], a << 16),
                      packed_add_offset_t(t[2], b << 16));
    }
    if (count & 3)
        packed_distort_place(&l, s[0], t[0], place);
    if ((count & 3) == 3)
        packed_distort_place(&l, s[2], t[2], place + 1);
}

/* -- ripples and half rate colours --------------------------------------------------- */

TP_ALWAYS_INLINE void packed_add_ripple_slope_pair(const tp_lookup *l, const uint32_t **s,
                                                   const uint32_t **t,
                                                   const uint32_t **wave_slope,
                                                   uint32_t *sum, int index)
{
    const tp_word_pair ss = tp_load_next_pair(s), tt = tp_load_next_pair(t);
    uint32_t a = packed_texel(l, ss.first, tt.first);
    uint32_t b = packed_texel(l, ss.second, tt.second);
    const tp_word_pair nn = tp_load_next_pair(wave_slope);

    tp_store_pair(sum, index, tp_qadd16(nn.first, a), tp_qadd16(nn.second, b));
}

TP_LOOP packed_add_ripple_slopes(const tp_quick_map *map, int32_t mip_offset,
                                 const tp_columns *columns, uint32_t *slope)
{
    const tp_lookup l = packed_lookup(map, mip_offset);
    const uint32_t *s = columns->s, *t = columns->t, *n = columns->n;
    const uint32_t *end = slope + (columns->count & ~3);

    for (; slope != end; slope += 4) {
        packed_add_ripple_slope_pair(&l, &s, &t, &n, slope, 0);
        packed_add_ripple_slope_pair(&l, &s, &t, &n, slope, 2);
    }
    for (end += columns->count & 3; slope != end; slope++)
        *slope = tp_qadd16(*n++, packed_texel(&l, *s++, *t++));
}

TP_LOOP packed_upsample_colours(const uint32_t *half_rate, uint32_t *colour, int32_t pairs)
{
    const uint32_t *const end = half_rate + (pairs & ~1);
    uint32_t a = *half_rate;

    for (; half_rate != end; half_rate += 2, colour += 4) {
        uint32_t b = half_rate[1], c = half_rate[2];
        tp_store_pair(colour, 0, a, tp_uhadd8(a, b));
        tp_store_pair(colour, 2, b, tp_uhadd8(b, c));
        a = c;
    }
    if (pairs & 1)
        tp_store_pair(colour, 0, a, tp_uhadd8(a, half_rate[1]));
}

#endif
