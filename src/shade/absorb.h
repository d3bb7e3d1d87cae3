/* SPDX-License-Identifier: MIT */
/* Beer's law: attenuation of a colour on its path through water.  Each channel keeps the
 * share tint^(distance / clear); the colour of deep water replaces the lost light.
 *
 * The share is 2^-x with x halvings on the path.  Shifts and one table, 64 entries for one
 * halving, serve every tint and any distance. */
#ifndef TP_SHADE_ABSORB_H
#define TP_SHADE_ABSORB_H
#include "base/base.h"
#include "tidepool/fixed.h"

typedef struct {
    uint32_t halvings[3];       /* halvings per metre of red, green and blue; Q16.16 */
} tp_absorb;

/* `tint` is the colour of white after `clear` metres.  A channel c of the tint counts as
 * (c + 1/2) / 256, which excludes the rates 0 and infinity. */
void tp_absorb_init(tp_absorb *absorb, uint32_t tint, tp_fx clear);

/* Entry i is 2^-(i / 64), Q0.16. */
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

/* Attenuates `colour` over `metres` of water of colour `deep`; both colours are
 * 0x00RRGGBB.  Negative distances count as 0. */
TP_ALWAYS_INLINE uint32_t tp_absorb_apply(const tp_absorb *absorb, uint32_t colour,
                                          uint32_t deep, tp_fx metres)
{
    const uint32_t *halvings = absorb->halvings;
    tp_fx way = metres > 0 ? metres : 0;

    return tp_absorbed_channel(halvings[0], way, colour >> 16, deep >> 16) << 16
         | tp_absorbed_channel(halvings[1], way, colour >> 8, deep >> 8) << 8
         | tp_absorbed_channel(halvings[2], way, colour, deep);
}
#endif
