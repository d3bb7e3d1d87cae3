/* SPDX-License-Identifier: MIT */
/* Division in 16.16, exact and rounded half up.  The 64-bit division is a library call of
 * some hundred cycles on a Cortex-M: use these functions in set-up code, never per
 * pixel. */
#include "base/assert.h"
#include "fx/fx.h"

/* Returns floor(n / d + 1/2), saturated to the range of tp_fx; |n| <= 2^47, d != 0. */
static tp_fx saturated_quotient(int64_t n, int64_t d)
{
    TP_ASSERT(d != 0);
    TP_ASSERT(n >= -((int64_t)1 << 47) && n <= (int64_t)1 << 47);
    const int64_t twice = 2 * n + d, whole = 2 * d;
    int64_t q = twice / whole;
    if (twice % whole != 0 && (twice < 0) != (whole < 0))
        q--;                            /* C rounds towards 0; floor rounds down */
    return tp_fx_saturate(q);
}

tp_fx tp_fx_div(tp_fx a, tp_fx b)
{
    if (b == 0)
        return a > 0 ? TP_FX_MAX : a < 0 ? TP_FX_MIN : 0;
    return saturated_quotient((int64_t)a * TP_FX_ONE, b);
}

tp_fx tp_fx_recip(tp_fx x)
{
    return x == 0 ? TP_FX_MAX : saturated_quotient((int64_t)TP_FX_ONE * TP_FX_ONE, x);
}
