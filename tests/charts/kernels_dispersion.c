/* SPDX-License-Identifier: MIT */
/* Wave numbers over a depth: k of k tanh(kh) = k_inf [B2], for k h from 0.01 to 10, by the
 * limits, by formulas without iteration [B4] [B5], by Newton's steps [B6], by Hunt's
 * fractions and by a table.
 *
 * With y = k_inf h and x = kh, Hunt (1979) has x^2 = y^2 + y / P(y) with a polynomial P.
 * The table holds x / sqrt(y), which is 1 at 0 and smooth. Inputs are k_inf in Q31.32, in
 * two words, and the depth; the result is k in the same format. */
#include "tests/charts/kernels.h"
#include "waves/coastal_water.h"
#include "waves/softfloat.h"

#define METHOD static __attribute__((noinline)) int64_t
#define RUN(method) \
    static void run_##method(const int32_t *in, int32_t *out) \
    { \
        for (uint32_t i = 0; i < KERNEL_UNITS; i++) { \
            const int64_t k = method(number_in(in + 3 * i), in[3 * i + 2]); \
            out[2 * i] = (int32_t)(uint32_t)k; \
            out[2 * i + 1] = (int32_t)(k >> 32); \
        } \
    }

static inline int64_t number_in(const int32_t *in)
{
    return (int64_t)((uint64_t)(uint32_t)in[1] << 32 | (uint32_t)in[0]);
}

/* y rises from 1e-4 to 10 by a constant factor; depths are 0.5 to 3 m in no order: the
 * wavelengths are then in the engine's range, 0.3 to 1900 m. */
static void fill(int32_t *in)
{
    uint64_t y = 429497;

    for (uint32_t i = 0; i < KERNEL_UNITS; i++) {
        const tp_fx depth = TP_FX(1.75) + kernel_spread(i, KERNEL_STEP, TP_FX(1.25));
        const uint64_t k = (y << 16) / (uint32_t)depth;
        in[3 * i] = (int32_t)(uint32_t)k;
        in[3 * i + 1] = (int32_t)(k >> 32);
        in[3 * i + 2] = depth;
        y += (y >> 8) * 48608924 >> 24;
    }
}

/* -- the engine's functions ---------------------------------------------------------- */

RUN(tp_depth_wave_number_eckart)
RUN(tp_depth_wave_number_fenton)
RUN(tp_depth_wave_number)
RUN(tp_depth_wave_number_exact)

METHOD steps_2(int64_t k_inf, tp_fx depth)
{
    const tp_scaled k = tp_scaled_from_wave_number(k_inf), h = tp_scaled_from_depth(depth);
    return tp_scaled_fixed(tp_depth_wave_number_scaled(k, h, 2), 32);
}
RUN(steps_2)

/* -- limits -------------------------------------------------------------------------- */

METHOD deep(int64_t k_inf, tp_fx depth)
{
    (void)depth;
    return k_inf;
}
RUN(deep)

METHOD shallow(int64_t k_inf, tp_fx depth)
{
    const tp_scaled over = tp_scaled_recip(tp_scaled_from_depth(depth));
    return tp_scaled_fixed(
        tp_scaled_sqrt(tp_scaled_mul(tp_scaled_from_wave_number(k_inf), over)), 32);
}
RUN(shallow)

/* -- Hunt's fractions ---------------------------------------------------------------- */

/* P(y) as Q15.17: for y below 12, P is below 2^15. */
static inline uint32_t polynomial(uint32_t y_q24, const uint32_t *of, int terms)
{
    uint32_t p = 0;

    for (int i = 0; i < terms; i++)
        p = (uint32_t)((uint64_t)(p + of[i]) * y_q24 >> 24);
    return p + (1u << 17);
}

/* k = k_inf sqrt(1 + 1 / (y P)). */
static inline int64_t hunt(int64_t k_inf, tp_fx depth, const uint32_t *of, int terms)
{
    const tp_scaled k = tp_scaled_from_wave_number(k_inf),
                    y = tp_scaled_mul(k, tp_scaled_from_depth(depth));
    const uint32_t y_q24 = tp_scaled_q24(y);

    if (y_q24 >= TP_DEPTH_DEEP_Q24)
        return k_inf;
    const tp_scaled p = tp_scaled_from_fixed(polynomial(y_q24, of, terms), 17);
    const tp_scaled part = tp_scaled_recip(tp_scaled_mul(y, p));
    const tp_scaled root = tp_scaled_sqrt(tp_scaled_add(tp_scaled_from_fixed(1, 0), part));
    return tp_scaled_fixed(tp_scaled_mul(k, root), 32);
}

#define Q17(x) ((uint32_t)((x) * 131072 + 0.5))

METHOD hunt_5(int64_t k_inf, tp_fx depth)
{
    static const uint32_t of[] = { Q17(0.0675), Q17(0.0864), 0, Q17(0.4622),
                                   Q17(0.6522) };
    return hunt(k_inf, depth, of, 5);
}
RUN(hunt_5)

METHOD hunt_6(int64_t k_inf, tp_fx depth)
{
    static const uint32_t of[] = { Q17(0.0065407983), Q17(0.0217540484),
        Q17(0.0632098765), Q17(0.1608465608), Q17(0.3555555556), Q17(0.6666666667) };
    return hunt(k_inf, depth, of, 6);
}
RUN(hunt_6)

/* -- a table ------------------------------------------------------------------------- */

enum { TABLE_END = 8 };             /* tanh x is 1 within 3e-7 from this y on */

static uint32_t table[258];         /* Q4.28 */

static void fill_table(int32_t *in, int bits)
{
    fill(in);
    table[0] = 1u << 28;
    for (uint32_t i = 1; i <= (1u << bits) + 1; i++) {
        const int64_t y_q32 = (int64_t)i << (35 - bits);
        const tp_scaled x =
            tp_scaled_from_wave_number(tp_depth_wave_number_exact(y_q32, TP_FX_ONE));
        const tp_scaled over = tp_scaled_rsqrt(tp_scaled_from_fixed((uint64_t)y_q32, 32));
        table[i] = (uint32_t)tp_scaled_fixed(tp_scaled_mul(x, over), 28);
    }
}

/* k = k_inf (x / sqrt y) / sqrt y. */
static inline tp_scaled near_number(tp_scaled k, tp_scaled y, uint32_t y_q24, int bits)
{
    const uint32_t *at = table + (y_q24 >> (27 - bits));
    const uint32_t part = y_q24 << (5 + bits);
    const uint32_t s = at[0] + (uint32_t)((uint64_t)(at[1] - at[0]) * part >> 32);
    return tp_scaled_mul(k, tp_scaled_mul(tp_scaled_from_fixed(s, 28), tp_scaled_rsqrt(y)));
}

/* Newton's step [B6] in the engine's form: x times 1 - (T - y / x^2) / (T + sech^2 x), T =
 * tanh x / x. */
static inline tp_scaled step(tp_scaled k, tp_scaled h, tp_scaled y)
{
    const tp_scaled x = tp_scaled_mul(k, h), over = tp_scaled_recip(x);
    const tp_scaled u = tp_scaled_mul(y, tp_scaled_mul(over, over));
    const tp_tanh at = tp_tanh_evaluate(tp_scaled_q24(x));
    const uint32_t below = (at.ratio_q31 >> 1) + (tp_sech_squared(at) >> 1);
    const int up = tp_clz(below);
    const int64_t gap = (int64_t)at.ratio_q31 - (uint32_t)tp_scaled_fixed(u, 31);
    const int64_t part = gap * (int64_t)tp_recip_norm(below << up);
    const uint32_t factor = 0x80000000u
                          - (uint32_t)((part + ((int64_t)1 << (32 - up))) >> (33 - up));
    return tp_scaled_mul(k, tp_scaled_from_fixed(factor, 31));
}

static inline int64_t by_table(int64_t k_inf, tp_fx depth, int bits, int steps)
{
    const tp_scaled k = tp_scaled_from_wave_number(k_inf), h = tp_scaled_from_depth(depth);
    const tp_scaled y = tp_scaled_mul(k, h);
    const uint32_t y_q24 = tp_scaled_q24(y);

    if (y_q24 >= TP_DEPTH_DEEP_Q24)
        return k_inf;
    const bool in_table = y_q24 < (uint32_t)TABLE_END << 24;
    const tp_scaled found = in_table ? near_number(k, y, y_q24, bits) : k;
    return tp_scaled_fixed(steps ? step(found, h, y) : found, 32);
}

#define TABLE(n, bits) \
    static void fill_##n(int32_t *in) { fill_table(in, bits); } \
    METHOD table_##n(int64_t k_inf, tp_fx h) { return by_table(k_inf, h, bits, 0); } \
    RUN(table_##n)
#define STEPPED(n, bits) \
    METHOD stepped_##n(int64_t k_inf, tp_fx h) { return by_table(k_inf, h, bits, 1); } \
    RUN(stepped_##n)
TABLE(32, 5)
TABLE(64, 6)
TABLE(256, 8)
STEPPED(32, 5)
STEPPED(64, 6)

/* -- list of kernels ----------------------------------------------------------------- */

/* Bytes of the tables of reciprocals, roots, and powers of e. */
enum { RECIP = 514, RSQRT = 386, EXP = 256 };

#define ROW(name, fill, method, bytes) \
    { "dispersion", name, fill, run_##method, 3, 2, bytes }
const kernel kernels_dispersion[] = {
    ROW("deep", fill, deep, 0),
    ROW("shallow", fill, shallow, RECIP + RSQRT),
    ROW("eckart", fill, tp_depth_wave_number_eckart, RECIP + RSQRT + EXP),
    ROW("fenton-mckee", fill, tp_depth_wave_number_fenton, RECIP + RSQRT + EXP),
    ROW("newton-1", fill, tp_depth_wave_number, RECIP + RSQRT + EXP),
    ROW("newton-2", fill, steps_2, RECIP + RSQRT + EXP),
    ROW("newton-3", fill, tp_depth_wave_number_exact, RECIP + RSQRT + EXP),
    ROW("hunt-5", fill, hunt_5, RECIP + RSQRT + 20),
    ROW("hunt-6", fill, hunt_6, RECIP + RSQRT + 24),
    ROW("table-32", fill_32, table_32, RSQRT + 4 * 33),
    ROW("table-64", fill_64, table_64, RSQRT + 4 * 65),
    ROW("table-256", fill_256, table_256, RSQRT + 4 * 257),
    ROW("table-32-newton", fill_32, stepped_32, RECIP + RSQRT + EXP + 4 * 33),
    ROW("table-64-newton", fill_64, stepped_64, RECIP + RSQRT + EXP + 4 * 65),
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
