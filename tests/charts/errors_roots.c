/* SPDX-License-Identifier: MIT */
/* Reciprocals and roots against double precision: relative errors over inputs 4093 or 2039
 * apart, over the whole range of the tasks in kernels_roots.c. */
#include "tests/charts/spread.h"
#include "tests/charts/used.h"

#define TWO_16 65536.0
#define TWO_47 140737488355328.0

enum { RECIP, ROOT, RSQRT };

static double truth(int what, double n)
{
    return what == RECIP ? TWO_16 / n * TWO_47 : what == ROOT ? TWO_16 * sqrt(n)
                                                              : TWO_47 / sqrt(n);
}

/* Functions of 16.16 receive n / 2^16, and their reference uses the truncated input too. */
static uint32_t given(const kernel *k, uint32_t n)
{
    return begins(method_of(k), "tp_fx") ? n & 0xffff0000u : n;
}

/* True if the scene has fields of foam or pools that bend normals: the only users of
 * tp_fx_recip. The engine uses the other functions in every scene, and never calls
 * tp_fx_rsqrt. */
static bool has_cells(const tp_scene *s, int32_t unused)
{
    (void)unused;
    return s->foam.cells > 0 || (s->pool.cols > 0 && s->water.pool_normal_strength > 0);
}

static bool never(const tp_scene *s, int32_t unused)
{
    (void)s, (void)unused;
    return false;
}

static const struct {
    const char *method;
    used_test  *test;
} engines[] = {
    { "tp_recip_norm", NULL }, { "tp_rsqrt_norm", NULL }, { "tp_isqrt64", NULL },
    { "tp_fx_div", NULL }, { "tp_fx_sqrt", NULL }, { "tp_fx_recip", has_cells },
};

static void say_who(const kernel *k)
{
    for (size_t i = 0; i < sizeof engines / sizeof *engines; i++)
        if (strcmp(engines[i].method, method_of(k)) == 0) {
            used_row(k->chart, k->point, engines[i].test, 0);
            return;
        }
    used_row(k->chart, k->point, never, 0);
}

void judge_roots(const kernel *k, const int32_t *counted, const int32_t *counted_out)
{
    static int32_t in[KERNEL_UNITS], out[KERNEL_UNITS];
    const int what = begins(k->point, "recip;") ? RECIP
                   : begins(k->point, "root;") ? ROOT : RSQRT;
    const uint32_t stride = what == RECIP ? 2039 : 4093;
    uint64_t n = what == RECIP ? 1u << 31 : 1u << 30;
    spread s = { 0 };

    (void)counted, (void)counted_out;
    while (n + (uint64_t)stride * KERNEL_UNITS <= 1ull << 32) {
        for (uint32_t i = 0; i < KERNEL_UNITS; i++, n += stride)
            in[i] = (int32_t)(uint32_t)n;
        k->run(in, out);
        for (uint32_t i = 0; i < KERNEL_UNITS; i++)
            spread_add(&s, (uint32_t)out[i] / truth(what, given(k, (uint32_t)in[i])) - 1);
    }
    spread_rows(k, &s);
    say_who(k);
}
