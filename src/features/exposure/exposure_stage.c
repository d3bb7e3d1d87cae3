/* SPDX-License-Identifier: MIT */
/* The camera's exposure E, as one table for every channel of every pixel.
 *
 * Of t in 0..1 it makes E t / (1 + (E - 1) t^k), a rule of our own: E t in the dark, 1 at
 * 1, so that what was beyond white stays white and highlights keep their shape; nothing
 * at all for E = 1.  Brightening takes k = 1, with which two exposures one after the other
 * are their product; darkening takes 4, so that only what is close to white is held. */
#include "features/exposure/exposure.h"
#include "shade/shade.h"

void tp_exposure_tone(tp_entry8 tone[256], tp_fx exposure)
{
    int64_t e = tp_clamp(exposure, TP_FX_ONE / 8, 8 * TP_FX_ONE);

    for (int64_t i = 0; i < 256; i++) {
        int64_t bent = e > TP_FX_ONE ? i * 65536 / 255
                                     : i * i * i * i * 65536 / (255ll * 255 * 255 * 255);
        int64_t below = TP_FX_ONE + ((e - TP_FX_ONE) * bent >> 16);
        tone[i] = (uint8_t)((e * i + below / 2) / below);
    }
}

void tp_stage_expose(const tp_shade *restrict shade, tp_run *restrict run)
{
    TP_ASSERT(run->mine != NULL);
    const tp_exposure *exposure = run->mine;
    const tp_entry8 *tone = exposure->tone;
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
