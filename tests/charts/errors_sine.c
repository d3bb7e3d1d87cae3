/* SPDX-License-Identifier: MIT */
#include "tests/charts/errors.h"

void judge_sine(const kernel *k, const int32_t *in, const int32_t *out)
{
    (void)k, (void)in, (void)out;
}
