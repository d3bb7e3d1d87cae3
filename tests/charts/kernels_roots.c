/* SPDX-License-Identifier: MIT */
/* Reciprocals and roots of one normalised number n, three tasks by many methods:
 *
 *     recip   2^63 / n          n in [2^31, 2^32)   the result as Q1.31, [2^31, 2^32)
 *     root    2^16 sqrt n       n in [2^30, 2^32)   as Q0.32, the same
 *     rsqrt   2^47 / sqrt n     n in [2^30, 2^32)   as Q1.31, the same
 *
 * The engine's functions of 16.16 receive the high half of n, and their results are shifted
 * to the same format. The tables are computed in integers before the count begins. */
#include "fixed/arithmetic.h"
#include "tests/charts/kernels.h"

#define METHOD static __attribute__((noinline)) uint32_t
#define RUN(method) \
    static void run_##method(const int32_t *in, int32_t *out) \
    { \
        for (uint32_t i = 0; i < KERNEL_UNITS; i++) \
            out[i] = (int32_t)method((uint32_t)in[i]); \
    }

static inline uint32_t high(uint32_t a, uint32_t b)
{
    return (uint32_t)((uint64_t)a * b >> 32);
}

/* Q1.31 from Q2.30; a result of 2 or slightly more is clamped to the last number below
 * 2. */
static inline uint32_t q31_of(uint32_t q30)
{
    return q30 >> 31 ? UINT32_MAX : 2 * q30;
}

static inline uint32_t q31_of_fx(tp_fx x)
{
    return x >> 17 ? UINT32_MAX : (uint32_t)x << 15;
}

/* -- numbers and tables -------------------------------------------------------------- */

static uint16_t table[256];         /* high half of the result at each step's middle */

static void fill_halves(int32_t *in)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++)
        in[i] = (int32_t)(i * KERNEL_STEP | 0x80000000u);
}

static void fill_quarters(int32_t *in)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++)
        in[i] = (int32_t)((1u << 30) + high(3u << 30, i * KERNEL_STEP));
}

/* Table indexed by the `bits` behind the leading bit. */
static void fill_recip(int32_t *in, int bits)
{
    fill_halves(in);
    for (uint32_t i = 0; i < 1u << bits; i++)
        table[i] = (uint16_t)(((uint64_t)1 << 47)
                              / (0x80000000u + ((2 * i + 1) << (30 - bits))));
}

/* Table indexed by the top `bits`; indices below 1/4 do not occur. */
static void fill_rsqrt(int32_t *in, int bits)
{
    fill_quarters(in);
    for (uint32_t i = 1u << (bits - 2); i < 1u << bits; i++)
        table[i] = (uint16_t)tp_isqrt64(((uint64_t)1 << 62)
                                        / ((2 * i + 1) << (31 - bits)));
}

static void fill_root(int32_t *in)
{
    fill_quarters(in);
    for (uint32_t i = 64; i < 256; i++)
        table[i] = (uint16_t)tp_isqrt64((2 * i + 1) << 23);
}

#define FILL(what, bits) \
    static void fill_##what##_##bits(int32_t *in) { fill_##what(in, bits); }
FILL(recip, 4) FILL(recip, 6) FILL(recip, 8)
FILL(rsqrt, 4) FILL(rsqrt, 6) FILL(rsqrt, 8)

/* -- reciprocals --------------------------------------------------------------------- */

RUN(tp_recip_norm)

METHOD fx_recip(uint32_t n) { return q31_of_fx(tp_fx_recip((tp_fx)(n >> 16))); }
METHOD fx_div(uint32_t n) { return q31_of_fx(tp_fx_div(TP_FX_ONE, (tp_fx)(n >> 16))); }
METHOD divide_32(uint32_t n) { return UINT32_MAX / (n >> 16) << 15; }
METHOD divide_64(uint32_t n)
{
    return (uint32_t)(((uint64_t)1 << 63) / n - (n == 0x80000000u));
}
RUN(fx_recip)
RUN(fx_div)
RUN(divide_32)
RUN(divide_64)

/* The engine's table without Newton's step. */
static const uint16_t recip_lines[257] = {
#include "fixed/recip_table.inc"
};

METHOD lines_recip(uint32_t n)
{
    const uint16_t *at = recip_lines + (n >> 23 & 0xff);
    const int32_t rise = at[1] - at[0];
    return ((0x10000u + at[0]) << 15)
        + (uint32_t)(rise * (int32_t)(n >> 7 & 0xffff) >> 1);
}
RUN(lines_recip)

/* Newton's steps r (2 - n r) in Q2.30. */
static inline uint32_t recip_newton(uint32_t n, uint32_t r, int steps)
{
    for (; steps > 0; steps--)
        r = (uint32_t)((uint64_t)r * (0x80000000u - high(n, r)) >> 30);
    return q31_of(r);
}

#define RECIP_TABLE(bits, steps) \
    METHOD recip_##bits##_##steps(uint32_t n) \
    { \
        return recip_newton(n, (uint32_t)table[(n << 1) >> (32 - bits)] << 15, steps); \
    } \
    RUN(recip_##bits##_##steps)
RECIP_TABLE(4, 0) RECIP_TABLE(4, 1) RECIP_TABLE(4, 2) RECIP_TABLE(4, 3)
RECIP_TABLE(6, 0) RECIP_TABLE(6, 1) RECIP_TABLE(6, 2)
RECIP_TABLE(8, 0) RECIP_TABLE(8, 1) RECIP_TABLE(8, 2)

/* Starts from the line 48/17 - 32/17 n, with an error of at most 1/17. */
#define RECIP_LINE(steps) \
    METHOD recip_line_##steps(uint32_t n) \
    { \
        const uint32_t line = 3031741621u - high(n, 2021161080u); \
        return recip_newton(n, line, steps); \
    } \
    RUN(recip_line_##steps)
RECIP_LINE(1) RECIP_LINE(2) RECIP_LINE(3)

/* -- roots --------------------------------------------------------------------------- */

METHOD isqrt64(uint32_t n) { return tp_isqrt64((uint64_t)n << 32); }
METHOD fx_sqrt(uint32_t n) { return (uint32_t)tp_fx_sqrt((tp_fx)(n >> 16)) << 16; }
METHOD by_rsqrt(uint32_t n) { return (uint32_t)((uint64_t)n * tp_rsqrt_norm(n) >> 31); }
METHOD root_256(uint32_t n) { return (uint32_t)table[n >> 24] << 16; }
RUN(isqrt64)
RUN(fx_sqrt)
RUN(by_rsqrt)
RUN(root_256)

/* Bit by bit: compares the remainder of n with the square of the next bit. */
METHOD bits_16(uint32_t n)
{
    uint32_t root = 0;
    for (uint32_t bit = 1u << 30; bit != 0; bit >>= 2) {
        const uint32_t more = root + bit;
        root >>= 1;
        if (n >= more) {
            n -= more;
            root += bit;
        }
    }
    return root << 16;
}

METHOD bits_32(uint32_t n)
{
    uint64_t left = (uint64_t)n << 32, root = 0;
    for (uint64_t bit = (uint64_t)1 << 62; bit != 0; bit >>= 2) {
        const uint64_t more = root + bit;
        root >>= 1;
        if (left >= more) {
            left -= more;
            root += bit;
        }
    }
    return (uint32_t)root;
}
RUN(bits_16)
RUN(bits_32)

/* Heron's steps (r + n / r) / 2 in 16 bits, with the processor's division, from the line
 * 0.3431 + 0.6863 n with an error of at most 0.03. */
static inline uint32_t heron(uint32_t n, int steps)
{
    uint32_t r = 22488 + high(n, 44977);
    for (; steps > 0; steps--)
        r = (r + n / r) >> 1;
    return r >> 16 ? UINT32_MAX : r << 16;
}

METHOD heron_1(uint32_t n) { return heron(n, 1); }
METHOD heron_2(uint32_t n) { return heron(n, 2); }
RUN(heron_1)
RUN(heron_2)

/* -- reciprocal roots ---------------------------------------------------------------- */

RUN(tp_rsqrt_norm)

METHOD fx_rsqrt(uint32_t n) { return q31_of_fx(tp_fx_rsqrt((tp_fx)(n >> 16))); }
METHOD divide_root(uint32_t n)
{
    return (uint32_t)((((uint64_t)1 << 63) - 1) / tp_isqrt64((uint64_t)n << 32));
}
RUN(fx_rsqrt)
RUN(divide_root)

static const uint16_t rsqrt_lines[193] = {
#include "fixed/rsqrt_table.inc"
};

METHOD lines_rsqrt(uint32_t n)
{
    const uint16_t *at = rsqrt_lines + ((n >> 24) - 64);
    const int32_t rise = at[1] - at[0];
    return ((0x10000u + at[0]) << 15)
        + (uint32_t)(rise * (int32_t)(n >> 8 & 0xffff) >> 1);
}
RUN(lines_rsqrt)

/* Newton's steps r (3 - n r^2) / 2, r in Q2.30 and n r^2 in Q4.28. */
static inline uint32_t rsqrt_newton(uint32_t n, uint32_t r, int steps)
{
    for (; steps > 0; steps--)
        r = (uint32_t)((uint64_t)r * ((3u << 28) - high(n, high(r, r))) >> 29);
    return q31_of(r);
}

#define RSQRT_TABLE(bits, steps) \
    METHOD rsqrt_##bits##_##steps(uint32_t n) \
    { \
        return rsqrt_newton(n, (uint32_t)table[n >> (32 - bits)] << 15, steps); \
    } \
    RUN(rsqrt_##bits##_##steps)
RSQRT_TABLE(4, 0) RSQRT_TABLE(4, 1) RSQRT_TABLE(4, 2) RSQRT_TABLE(4, 3)
RSQRT_TABLE(6, 0) RSQRT_TABLE(6, 1) RSQRT_TABLE(6, 2)
RSQRT_TABLE(8, 0) RSQRT_TABLE(8, 1) RSQRT_TABLE(8, 2)

/* Starts from the line 2.1328 - 1.21875 n, with an error of at most 0.086. */
#define RSQRT_LINE(steps) \
    METHOD rsqrt_line_##steps(uint32_t n) \
    { \
        const uint32_t line = 2290076562u - high(n, 1308622848u); \
        return rsqrt_newton(n, line, steps); \
    } \
    RUN(rsqrt_line_##steps)
RSQRT_LINE(1) RSQRT_LINE(2) RSQRT_LINE(3)

/* -- list of kernels ----------------------------------------------------------------- */

#define ROW(name, fill, method, bytes) { "roots", name, fill, run_##method, 1, 1, bytes }
#define RECIPS(name, bits, steps, bytes) \
    ROW("recip;" name, fill_recip_##bits, recip_##bits##_##steps, bytes)
#define RSQRTS(name, bits, steps, bytes) \
    ROW("rsqrt;" name, fill_rsqrt_##bits, rsqrt_##bits##_##steps, bytes)
const kernel kernels_roots[] = {
    ROW("recip;tp_recip_norm", fill_halves, tp_recip_norm, 514),
    ROW("recip;tp_fx_recip", fill_halves, fx_recip, 0),
    ROW("recip;tp_fx_div", fill_halves, fx_div, 0),
    ROW("recip;divide-32", fill_halves, divide_32, 0),
    ROW("recip;divide-64", fill_halves, divide_64, 0),
    ROW("recip;lines-256", fill_halves, lines_recip, 514),
    RECIPS("table-4-bits", 4, 0, 32), RECIPS("table-4-bits-newton-1", 4, 1, 32),
    RECIPS("table-4-bits-newton-2", 4, 2, 32), RECIPS("table-4-bits-newton-3", 4, 3, 32),
    RECIPS("table-6-bits", 6, 0, 128), RECIPS("table-6-bits-newton-1", 6, 1, 128),
    RECIPS("table-6-bits-newton-2", 6, 2, 128),
    RECIPS("table-8-bits", 8, 0, 512), RECIPS("table-8-bits-newton-1", 8, 1, 512),
    RECIPS("table-8-bits-newton-2", 8, 2, 512),
    ROW("recip;line-newton-1", fill_halves, recip_line_1, 0),
    ROW("recip;line-newton-2", fill_halves, recip_line_2, 0),
    ROW("recip;line-newton-3", fill_halves, recip_line_3, 0),
    ROW("root;tp_isqrt64", fill_quarters, isqrt64, 386),
    ROW("root;tp_fx_sqrt", fill_quarters, fx_sqrt, 386),
    ROW("root;tp_rsqrt_norm-times-n", fill_quarters, by_rsqrt, 386),
    ROW("root;table-8-bits", fill_root, root_256, 384),
    ROW("root;bitwise-16", fill_quarters, bits_16, 0),
    ROW("root;bitwise-32", fill_quarters, bits_32, 0),
    ROW("root;line-heron-1", fill_quarters, heron_1, 0),
    ROW("root;line-heron-2", fill_quarters, heron_2, 0),
    ROW("rsqrt;tp_rsqrt_norm", fill_quarters, tp_rsqrt_norm, 386),
    ROW("rsqrt;tp_fx_rsqrt", fill_quarters, fx_rsqrt, 386),
    ROW("rsqrt;tp_isqrt64-divide-64", fill_quarters, divide_root, 386),
    ROW("rsqrt;lines-192", fill_quarters, lines_rsqrt, 386),
    RSQRTS("table-4-bits", 4, 0, 24), RSQRTS("table-4-bits-newton-1", 4, 1, 24),
    RSQRTS("table-4-bits-newton-2", 4, 2, 24), RSQRTS("table-4-bits-newton-3", 4, 3, 24),
    RSQRTS("table-6-bits", 6, 0, 96), RSQRTS("table-6-bits-newton-1", 6, 1, 96),
    RSQRTS("table-6-bits-newton-2", 6, 2, 96),
    RSQRTS("table-8-bits", 8, 0, 384), RSQRTS("table-8-bits-newton-1", 8, 1, 384),
    RSQRTS("table-8-bits-newton-2", 8, 2, 384),
    ROW("rsqrt;line-newton-1", fill_quarters, rsqrt_line_1, 0),
    ROW("rsqrt;line-newton-2", fill_quarters, rsqrt_line_2, 0),
    ROW("rsqrt;line-newton-3", fill_quarters, rsqrt_line_3, 0),
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
