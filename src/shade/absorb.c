/* SPDX-License-Identifier: MIT */
/* The table of absorption: an eighth root, then products. */
#include "shade/absorb.h"

/* x^(1/8) of Q2.30, by three roots. */
static tp_q30 eighth(tp_q30 x)
{
    for (int i = 0; i < 3; i++)
        x = (tp_q30)tp_isqrt64((uint64_t)(uint32_t)x << 30);
    return x;
}

void tp_absorb_init(tp_absorb *absorb, uint32_t tint, tp_fx clear)
{
    const tp_fx way = clear < TP_FX_ONE / 256 ? TP_FX_ONE / 256 : clear;

    absorb->per_metre = (uint32_t)tp_fx_div(8 * TP_FX_ONE, way);
    for (int c = 0; c < 3; c++) {
        const uint32_t level = tint >> (16 - 8 * c) & 0xff;
        const tp_q30 step = eighth((tp_q30)(((uint64_t)level << 30) / 255));
        tp_q30 left = TP_Q30_ONE;
        for (int i = 0; i <= TP_ABSORB; i++) {
            absorb->share[c][i] = (uint16_t)((left + (1 << 14)) >> 15);
            left = tp_q30_mul(left, step);
        }
    }
}
