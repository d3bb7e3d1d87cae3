/* SPDX-License-Identifier: MIT */
/* Absorption rate of a tint: halvings of light per metre, from the binary logarithm of
 * each channel over the distance at which the tint is reached. */
#include "shade/absorb.h"
#include "fx/fx.h"

const uint16_t tp_absorb_fall[65] = {
#include "shade/fall_table.inc"
};

/* log2(n) of 1 <= n < 2^16, Q16.  Each squaring of the mantissa yields one binary digit. */
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

/* A channel halves 9 times at most over `clear` metres.  If `clear` is 1/65536 m the rate
 * is below 2^36; larger rates than 32 bits saturate. */
void tp_absorb_init(tp_absorb *absorb, uint32_t tint, tp_fx clear)
{
    for (int k = 0; k < 3; k++) {
        uint32_t channel = tint >> (16 - 8 * k) & 0xff;
        uint64_t whole = 9 * 65536 - log2_q16(2 * channel + 1);
        uint64_t rate = (whole << 16) / (uint32_t)(clear > 0 ? clear : 1);
        absorb->halvings[k] = rate < UINT32_MAX ? (uint32_t)rate : UINT32_MAX;
    }
}
