/* SPDX-License-Identifier: MIT */
/* How fast a tint takes light: its binary logarithm over the metres it is meant for. */
#include "shade/absorb.h"
#include "fx/fx.h"

const uint16_t tp_absorb_fall[65] = {
#include "shade/fall_table.inc"
};

/* log2 of 1 <= n < 2^16 in Q16: the digits by squaring what is left of n. */
static uint32_t log2_q16(uint32_t n)
{
    int      zeros = tp_clz(n);
    uint32_t digits = (uint32_t)(31 - zeros);
    uint64_t m = (uint64_t)n << zeros;                  /* Q1.31 */

    for (int i = 0; i < 16; i++) {
        m = m * m >> 31;
        digits = digits << 1 | (uint32_t)(m >> 32);
        m >>= m >> 32;
    }
    return digits;
}

/* Halvings of a channel are 9 at the most; over 1/65536 m that is below 2^36: held. */
void tp_absorb_init(tp_absorb *absorb, uint32_t tint, tp_fx clear)
{
    for (int k = 0; k < 3; k++) {
        uint32_t channel = tint >> (16 - 8 * k) & 0xff;
        uint64_t whole = 9 * 65536 - log2_q16(2 * channel + 1);
        uint64_t rate = (whole << 16) / (uint32_t)(clear > 0 ? clear : 1);
        absorb->halvings[k] = rate < UINT32_MAX ? (uint32_t)rate : UINT32_MAX;
    }
}
