/* SPDX-License-Identifier: MIT */
/* Sines of a turn: as the engine does it. */
#include "tests/charts/kernels.h"

static void fill(int32_t *in)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++)
        in[i] = (int32_t)(i * KERNEL_STEP);
}

/* The name begins with run_: by it callgrind knows what to count. */
static void run_engine(const int32_t *in, int32_t *out)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++)
        out[i] = tp_sin((tp_turn)in[i]);
}

const kernel kernels_sine[] = {
    { "sine", "engine", fill, run_engine, 1, 1, 0 },
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
