/* SPDX-License-Identifier: MIT */
/* The tone mapping of the exposure E: one table for every channel of every pixel.
 *
 * A channel t in 0..1 becomes E t / (1 + (E - 1) t^k), the project's own rule.  The
 * result is E t in the dark and 1 at t = 1, so highlights keep their shape and white
 * stays white.  For E = 1 the curve is the identity.  Brightening uses k = 1; two
 * exposures in sequence then equal their product.  Darkening uses k = 4, so only values
 * close to white are compressed. */
#include "features/exposure/exposure.h"
#include "shade/shade.h"

/* Returns t^k for t = i / 255, Q16, rounded down.  The factor is 2^47 / 255^4, rounded up;
 * for each i its product gives what the division by 255^4 gives. */
static int32_t bend(uint32_t i, bool brightens)
{
    const uint32_t fourth = i * i * i * i;

    return (int32_t)(brightens ? i * 65536 / 255
                               : (uint32_t)((uint64_t)fourth * 2181368338u >> 47));
}

/* Exposures are below 2^20, so E t fits 32 bits. */
void tp_exposure_make_tone_curve(tp_entry8 tone[256], tp_fx exposure)
{
    const tp_fx e = tp_clamp(exposure, TP_FX_ONE / 8, 8 * TP_FX_ONE);

    for (uint32_t i = 0; i < 256; i++) {
        const int64_t bent = (int64_t)(e - TP_FX_ONE) * bend(i, e > TP_FX_ONE);
        const uint32_t below = (uint32_t)(TP_FX_ONE + (int32_t)(bent >> 16));
        tone[i] = (uint8_t)(((uint32_t)e * i + below / 2) / below);
    }
}

void tp_stage_expose(const tp_shade *restrict shade, tp_run *restrict run)
{
    TP_ASSERT(run->mine != NULL);
    const tp_exposure *exposure = run->mine;
    const tp_entry8 *tone = exposure->tones->tone;
    const int32_t count = run->count;

    (void)shade;
    for (int32_t i = 0; i < count; i++) {
        uint32_t c = run->colour[i];
        run->colour[i] = (uint32_t)tone[c >> 16 & 0xff] << 16
                       | (uint32_t)tone[c >> 8 & 0xff] << 8 | tone[c & 0xff];
    }
}

const tp_stage tp_exposure_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_exposure(X)
#undef X
};
