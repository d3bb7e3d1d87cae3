/* SPDX-License-Identifier: MIT */
/* Sines with sharpened crests, [A3] of the models: f = 2 ((sin th + 1) / 2)^power.  The
 * mean of f over a turn is subtracted; otherwise the water level would depend on the power.
 * The per-vertex part is tp_swell_sharpen in wave.h. */
#include "wave/wave.h"

/* 2 C(2n, n) / 4^n for n = 1..8: exact in 14 bits or fewer. */
static const int32_t mean_q14[8] = {
    16384, 12288, 10240, 8960, 8064, 7392, 6864, 6435
};

int32_t tp_sharp_mean(int32_t power)
{
    return mean_q14[tp_clamp(power, 1, 8) - 1] * (1 << 10);
}

/* 2 - mean is at least 1: a crest is never nearer to the mean than a trough. */
tp_fx tp_sharp_height(tp_fx amplitude, int32_t power)
{
    int64_t crest = 2 * (1 << 24) - tp_sharp_mean(power);
    return (tp_fx)((amplitude * crest + (1 << 24) - 1) >> 24);
}

/* f' is at most 1, 1.30, 1.55, 1.77 ... 2.47 [A3]; 1 + 0.3 (power - 1) is
 * at least as large. */
tp_fx tp_sharp_slope_bound(tp_q30 slope, int32_t power)
{
    int64_t n = tp_clamp(power, 1, 8) - 1, tenths = n ? 2 * (10 + 3 * n) : 10;
    return (tp_fx)((slope * tenths / 10 + (1 << 14) - 1) >> 14);
}
