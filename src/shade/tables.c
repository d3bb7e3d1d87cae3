/* SPDX-License-Identifier: MIT */
/* The tables that stages look into, made in integers at init or when a number changes. */
#include "shade/shade.h"
#include "tidepool/light.h"

/* base^n for base in Q2.30, 0..1, by squaring. */
static tp_q30 power(tp_q30 base, uint32_t n)
{
    tp_q30 result = TP_Q30_ONE;

    for (; n; n >>= 1) {
        if (n & 1)
            result = tp_q30_mul(result, base);
        base = tp_q30_mul(base, base);
    }
    return result;
}

void tp_shade_tables(tp_shade *shade)
{
    for (uint32_t i = 0; i <= TP_STEEP; i++)            /* 1 / sqrt(1 + i / 128) */
        shade->steep[i] = (uint16_t)(tp_isqrt64(((uint64_t)128 << 32) / (128 + i) << 28)
                                     >> 16);
    for (int32_t i = 0; i <= 256; i++) {
        tp_q30 r = tp_fresnel(i * (TP_Q30_ONE / 256));
        shade->fresnel[i] = (uint8_t)tp_clamp((r + (1 << 21)) >> 22, 0, 255);
    }
    for (uint32_t i = 0; i <= TP_HAZE; i++)             /* 32^2 / (32^2 + i^2) */
        shade->haze[i] = (uint8_t)(255 * 1024 / (1024 + i * i));
}

void tp_shade_shine(tp_shade *shade, tp_fx shininess, tp_fx strength)
{
    uint32_t n = (uint32_t)tp_clamp(shininess >> 16, 1, 1000);

    for (int32_t i = 0; i <= TP_SHINE; i++) {
        int32_t lobe = power(i * (TP_Q30_ONE / TP_SHINE), n) >> 14;     /* Q16 */
        shade->shine[i] = (uint16_t)(tp_fx_mul(lobe, strength) >> 8);
    }
}

void tp_shade_gloss(uint8_t gloss[TP_GLOSS], tp_fx shininess)
{
    uint32_t n = (uint32_t)tp_clamp(shininess >> 16, 1, 1000);

    for (int32_t i = 0; i < TP_GLOSS; i++)
        gloss[i] = (uint8_t)(power(i * (TP_Q30_ONE / (TP_GLOSS - 1)), n) >> 22);
}
