/* SPDX-License-Identifier: MIT */
/* Fresnel reflectance against the exact law [F1] in double precision, at every N.V of
 * Q1.14. */
#include <stdlib.h>
#include "shade/optics.h"
#include "tests/charts/spread.h"
#include "tests/charts/used.h"

enum { ONE = 16384 };

static double law(double c)
{
    const double n = TP_WATER_INDEX, ct = sqrt(1 - (1 - c * c) / (n * n));
    const double s = (c - n * ct) / (c + n * ct), p = (ct - n * c) / (ct + n * c);

    return (s * s + p * p) / 2;
}

/* Checks the reference itself: the exact law by angles, Rs = (sin(i - t) / sin(i + t))^2
 * and Rp with tangents. */
static void prove_law(void)
{
    for (int32_t nv = 1; nv < ONE; nv++) {
        const double i = acos(nv / (double)ONE), t = asin(sin(i) / TP_WATER_INDEX);
        const double s = sin(i - t) / sin(i + t), p = tan(i - t) / tan(i + t);
        const double off = (s * s + p * p) / 2 - law(nv / (double)ONE);
        if (!(fabs(off) < 1e-12)) {
            fprintf(stderr, "fresnel: two forms of the law differ by %g\n", off);
            exit(EXIT_FAILURE);
        }
    }
}

/* Value of 1 in a method's results: formulas are Q30, lines and the 32-bit Schlick form are
 * Q16, bytes are 1/256. */
static double one_of(const kernel *k)
{
    return begins(k->point, "law") || begins(k->point, "schlick;") ? TP_Q30_ONE
         : begins(k->point, "lines") || begins(k->point, "schlick-16") ? 65536 : 256;
}

static bool has_rule(const tp_scene *s, int32_t rule)
{
    return s->water.reflection > 0 && s->water.fresnel == rule;
}

static bool never(const tp_scene *s, int32_t unused)
{
    (void)s, (void)unused;
    return false;
}

static void say_who(const kernel *k)
{
    if (begins(k->point, "table;"))
        used_row(k->chart, k->point, has_rule, TP_FRESNEL_TABLE);
    else if (begins(k->point, "schlick-table;"))
        used_row(k->chart, k->point, has_rule, TP_FRESNEL_SCHLICK);
    else
        used_row(k->chart, k->point, never, 0);
}

void judge_fresnel(const kernel *k, const int32_t *counted, const int32_t *counted_out)
{
    static int32_t in[KERNEL_UNITS], out[KERNEL_UNITS];
    const double one = one_of(k);
    spread s = { 0 };

    (void)counted, (void)counted_out;
    prove_law();
    for (int32_t block = 0; block <= ONE; block += KERNEL_UNITS) {
        for (int32_t i = 0; i < KERNEL_UNITS; i++)
            in[i] = block + i <= ONE ? block + i : ONE;
        k->run(in, out);
        for (int32_t i = 0; i < KERNEL_UNITS && block + i <= ONE; i++)
            spread_add(&s, out[i] / one - law(in[i] / (double)ONE));
    }
    spread_rows(k, &s);
    say_who(k);
}
