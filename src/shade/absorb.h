/* SPDX-License-Identifier: MIT */
/* Beer's law: what of a colour is left after a way through water.  Of each channel the
 * share tint^(way / clear) comes through; what is lost the deep water's colour replaces. */
#ifndef TP_SHADE_ABSORB_H
#define TP_SHADE_ABSORB_H
#include "tidepool/fx.h"

#define TP_ABSORB 64            /* steps of an eighth of the clear way each */

typedef struct {
    uint16_t share[3][TP_ABSORB + 1];   /* red, green, blue, Q1.15 */
    uint32_t per_metre;                 /* steps, 16.16 */
} tp_absorb;

/* `clear` metres turn white into `tint`; clear > 0. */
void tp_absorb_init(tp_absorb *absorb, uint32_t tint, tp_fx clear);

/* Of a way in steps, 24.8: between entries, twice through the table where one is too
 * short, no more than 16 clear ways in all.  Q1.15. */
static inline int32_t tp_absorb_share(const uint16_t *share, uint32_t steps)
{
    const uint32_t end = TP_ABSORB << 8;
    int32_t before = 1 << 15;

    if (steps >= end) {
        before = share[TP_ABSORB];
        steps = steps < 2 * end ? steps - end : end - 1;
    }
    const uint16_t *at = share + (steps >> 8);
    int32_t rest = at[0] + ((at[1] - at[0]) * (int32_t)(steps & 0xff) >> 8);
    return before * rest >> 15;
}

static inline uint32_t tp_absorbed(uint32_t colour, uint32_t deep, int32_t share)
{
    int32_t c = (int32_t)(colour & 0xff), d = (int32_t)(deep & 0xff);
    return (uint32_t)(d + (((c - d) * share + 0x4000) >> 15));
}

/* Both colours 0x00RRGGBB. */
static inline uint32_t tp_absorb_at(const tp_absorb *absorb, uint32_t colour,
                                    uint32_t deep, tp_fx metres)
{
    uint64_t way = (uint64_t)(metres > 0 ? metres : 0) * absorb->per_metre >> 24;
    uint32_t steps = way < 1u << 30 ? (uint32_t)way : 1u << 30;
    uint32_t r = tp_absorbed(colour >> 16, deep >> 16,
                             tp_absorb_share(absorb->share[0], steps));
    uint32_t g = tp_absorbed(colour >> 8, deep >> 8,
                             tp_absorb_share(absorb->share[1], steps));
    uint32_t b = tp_absorbed(colour, deep, tp_absorb_share(absorb->share[2], steps));
    return r << 16 | g << 8 | b;
}
#endif
