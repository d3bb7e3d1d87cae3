/* SPDX-License-Identifier: MIT */
/* Tables for span stages: constant tables, and tables computed in integers when a number
 * of the scene changes. */
#include "shade/shade.h"

const tp_entry16 tp_steep_table[TP_STEEP + 1] = {
#include "shade/steep_table.inc"
};

const tp_entry8 tp_fresnel_table[257] = {
#include "shade/fresnel_table.inc"
};

const tp_entry8 tp_schlick_table[257] = {
#include "shade/schlick_table.inc"
};

const uint8_t tp_drop_gloss[TP_GLOSS] = {
#include "shade/gloss_table.inc"
};

/* Returns base^n for base in 0..1, Q2.30, by repeated squaring. */
static tp_q30 power(tp_q30 base, uint32_t n)
{
    TP_ASSERT(base >= 0 && base <= TP_Q30_ONE);
    tp_q30 result = TP_Q30_ONE;

    for (; n; n >>= 1) {
        if (n & 1)
            result = tp_q30_mul(result, base);
        base = tp_q30_mul(base, base);
    }
    return result;
}

static uint32_t exponent(tp_fx shininess)
{
    return (uint32_t)tp_clamp(shininess >> 16, 1, 1000);
}

/* Blinn's lobe (N.H)^(4 n) [F5] as a function of c = 2 (N.H)^2 - 1: ((1 + c) / 2)^(2 n). */
static tp_q30 blinn_lobe_double_angle(tp_q30 cos_double, uint32_t n)
{
    return power(cos_double / 2 + TP_Q30_ONE / 2, 2 * n);
}

/* Converts a lobe value of 0..1 into a table entry, scaled by the strength. */
static uint16_t shine_entry(tp_q30 lobe, tp_fx strength)
{
    return (uint16_t)(tp_fx_mul(lobe >> 14, strength) >> 8);
}

void tp_shade_shine(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess, tp_fx strength)
{
    TP_ASSERT(shine != NULL && strength >= 0);
    for (int32_t i = 0; i <= TP_SHINE; i++)
        shine[i] = shine_entry(power(i * (TP_Q30_ONE / TP_SHINE), exponent(shininess)),
                               strength);
}

void tp_shade_shine_blinn(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess, tp_fx strength)
{
    TP_ASSERT(shine != NULL && strength >= 0);
    for (int32_t i = 0; i <= TP_SHINE; i++)
        shine[i] = shine_entry(
            blinn_lobe_double_angle(i * (TP_Q30_ONE / TP_SHINE), exponent(shininess)),
            strength);
}

void tp_shade_gloss(uint8_t gloss[TP_GLOSS], tp_fx shininess)
{
    for (int32_t i = 0; i < TP_GLOSS; i++)
        gloss[i] = (uint8_t)(power(i * (TP_Q30_ONE / (TP_GLOSS - 1)),
                                   exponent(shininess)) >> 22);
}

void tp_shade_gloss_blinn(uint8_t gloss[TP_GLOSS], tp_fx shininess)
{
    for (int32_t i = 0; i < TP_GLOSS; i++)
        gloss[i] = (uint8_t)(blinn_lobe_double_angle(i * (TP_Q30_ONE / (TP_GLOSS - 1)),
                                   exponent(shininess)) >> 22);
}
