/* SPDX-License-Identifier: MIT */
/* Sines against the C library's, at phases 4093 of 2^32 apart: 4093 is prime, so the phases
 * fall anywhere within the steps of tables. */
#include "fixed/arithmetic.h"
#include "tests/charts/spread.h"
#include "tests/charts/used.h"

#define TURN   4294967296.0
#define PI     3.14159265358979323846
#define STRIDE 4093u

/* True if the method's results have the bits of the engine. Waves, foam and paddles of
 * every scene use tp_sin; rotations use another sine, visible only through
 * tp_rotation_from_angles. */
static bool is_the_engines(const kernel *k)
{
    static int32_t in[KERNEL_UNITS], out[KERNEL_UNITS];
    bool as_sin = true, as_rotation = true;

    k->fill(in);
    k->run(in, out);
    for (uint32_t i = 0; i < KERNEL_UNITS; i++) {
        const tp_turn a = (tp_turn)in[i];
        as_sin = as_sin && out[i] == tp_sin(a);
        as_rotation = as_rotation && out[i] == tp_rotation_from_angles(a, 0, 0).x.z;
    }
    return as_sin || as_rotation;
}

void judge_sine(const kernel *k, const int32_t *counted, const int32_t *counted_out)
{
    static int32_t in[KERNEL_UNITS], out[KERNEL_UNITS];
    spread s = { 0 };
    uint64_t phase = 0;

    (void)counted, (void)counted_out;
    while (phase >> 32 == 0) {
        for (uint32_t i = 0; i < KERNEL_UNITS; i++)
            in[i] = (int32_t)(uint32_t)(phase + i * STRIDE);
        k->run(in, out);
        for (uint32_t i = 0; i < KERNEL_UNITS; i++, phase += STRIDE)
            spread_add(&s, out[i] / 1073741824.0 - sin((uint32_t)in[i] * (2 * PI / TURN)));
    }
    spread_rows(k, &s);
    if (is_the_engines(k))
        used_row(k->chart, k->point, NULL, 0);
    else
        printf("%s,%s,used,-\n", k->chart, k->point);
}
