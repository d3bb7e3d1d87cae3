/* SPDX-License-Identifier: MIT */
/* Beer's law: what of a colour is left after a way through water.  Of each channel the
 * share tint^(way / clear) comes through; what is lost the deep water's colour replaces.
 *
 * The share is 2^-x, x the halvings on the way: shifts and one table of a halving's 64
 * parts serve every tint and any distance. */
#ifndef TP_SHADE_ABSORB_H
#define TP_SHADE_ABSORB_H
#include "base/base.h"
#include "tidepool/fixed.h"

typedef struct {
    uint32_t halvings[3];       /* a metre, of red, green and blue; Q16.16 */
} tp_absorb;

/* `clear` metres turn white into `tint`.  A channel c of it counts as (c + 1/2) / 256: no
 * light is lost at once or kept for ever. */
void tp_absorb_init(tp_absorb *absorb, uint32_t tint, tp_fx clear);

/* 2^-(i / 64), Q0.16. */
extern const uint16_t tp_absorb_fall[65];

TP_ALWAYS_INLINE uint32_t tp_absorbed_channel(uint32_t halvings, tp_fx metres,
                                              uint32_t colour, uint32_t deep)
{
    uint64_t x = (uint64_t)halvings * (uint32_t)metres >> 16;
    int32_t  c = (int32_t)(colour & 0xff), d = (int32_t)(deep & 0xff);

    if (x >= 16u << 16)
        return (uint32_t)d;
    const uint16_t *at = tp_absorb_fall + ((uint32_t)x >> 10 & 63);
    int32_t left = (at[0] - ((at[0] - at[1]) * (int32_t)(x & 1023) >> 10)) >> (x >> 16);
    return (uint32_t)(d + (((c - d) * left + 0x8000) >> 16));
}

/* Both colours 0x00RRGGBB; no way is shorter than 0. */
TP_ALWAYS_INLINE uint32_t tp_absorb_at(const tp_absorb *absorb, uint32_t colour,
                                       uint32_t deep, tp_fx metres)
{
    const uint32_t *halvings = absorb->halvings;
    tp_fx way = metres > 0 ? metres : 0;

    return tp_absorbed_channel(halvings[0], way, colour >> 16, deep >> 16) << 16
         | tp_absorbed_channel(halvings[1], way, colour >> 8, deep >> 8) << 8
         | tp_absorbed_channel(halvings[2], way, colour, deep);
}
#endif
