/* SPDX-License-Identifier: MIT */
/* Sine of a turn, Q2.30, by the methods of [G5] and others: nearest entry of a table,
 * linear and parabolic interpolation, a Taylor series at the nearest entry, polynomials
 * over a quarter of a turn, and CORDIC.
 *
 * The engine's own rotations, whose sine is accurate to 5e-9, fill the tables in integers
 * before the count begins. Each method is a function of its own, like tp_sin, so the cost
 * of the call is equal for all. */
#include "fixed/arithmetic.h"
#include "tests/charts/kernels.h"

#define METHOD static __attribute__((noinline)) tp_q30

/* The name begins with run_: callgrind selects the counted functions by this prefix. */
#define RUN(method) \
    static void run_##method(const int32_t *in, int32_t *out) \
    { \
        for (uint32_t i = 0; i < KERNEL_UNITS; i++) \
            out[i] = method((tp_turn)in[i]); \
    }

enum { LARGEST = 4096 };

/* High word: a quarter of a product of two Q2.30, or the product with a Q0.32. */
static inline int32_t high(int32_t a, int32_t b)
{
    return (int32_t)((int64_t)a * b >> 32);
}

static inline uint32_t high_of(uint32_t a, uint32_t b)
{
    return (uint32_t)((uint64_t)a * b >> 32);
}

/* -- tables -------------------------------------------------------------------------- */

static int16_t near_table[LARGEST];             /* Q1.14, at the middles of steps */
static tp_q30  table[LARGEST + LARGEST / 4];

static tp_q30 fine_sine(tp_turn angle)
{
    return tp_rotation_from_angles(angle, 0, 0).x.z;
}

static void fill(int32_t *in)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++)
        in[i] = (int32_t)(i * KERNEL_STEP);
}

static void fill_near(int32_t *in, int bits)
{
    fill(in);
    for (uint32_t i = 0; i < 1u << bits; i++)
        near_table[i] = (int16_t)((fine_sine((2 * i + 1) << (31 - bits)) + 0x8000) >> 16);
}

/* Fills a turn and a quarter, from `before` entries before 0. */
static void fill_table(int32_t *in, int bits, uint32_t before)
{
    fill(in);
    for (uint32_t i = 0; i < 5u << (bits - 2); i++)
        table[i] = fine_sine((i - before) << (32 - bits));
}

/* Chords on both sides of the sine: a chord lies at most pi^2 / 2 / 1024^2 of the sine
 * below the sine, and half of that is added to each entry. */
static void fill_between(int32_t *in)
{
    fill_table(in, 10, 0);
    for (uint32_t i = 0; i < 258; i++)
        table[i] += tp_q30_mul(table[i], TP_Q30(9.8696044 / 4 / 1024 / 1024));
}

#define FILL_NEAR(bits) \
    static void fill_near_##bits(int32_t *in) { fill_near(in, bits); }
#define FILL_TABLE(bits) \
    static void fill_##bits(int32_t *in) { fill_table(in, bits, 0); }
FILL_NEAR(8) FILL_NEAR(10) FILL_NEAR(12)
FILL_TABLE(6) FILL_TABLE(8) FILL_TABLE(10)
static void fill_middle_6(int32_t *in) { fill_table(in, 6, 1); }

/* -- nearest entry ------------------------------------------------------------------- */

#define NEAREST(n, bits) \
    METHOD nearest_##n(tp_turn a) { return near_table[a >> (32 - bits)] * 65536; } \
    RUN(nearest_##n)
NEAREST(256, 8)
NEAREST(1024, 10)
NEAREST(4096, 12)

/* -- interpolation ------------------------------------------------------------------- */

RUN(tp_sin)

/* Linear interpolation in the table of tp_sin. */
METHOD between(tp_turn angle)
{
    const uint32_t a = angle & 0x40000000 ? 0u - angle : angle;
    const tp_q30 *at = table + (a >> 22 & 0x1ff);
    const uint32_t rise = (uint32_t)(at[1] - at[0]);
    const int32_t y = at[0] + (int32_t)high_of(rise, a << 10);
    return (int32_t)angle < 0 ? -y : y;
}
RUN(between)

/* A table of a whole turn needs no folding, and four times the bytes. Neighbouring entries
 * differ by less than 2^27. */
#define LINES(n, bits) \
    METHOD lines_##n(tp_turn a) \
    { \
        const tp_q30 *at = table + (a >> (32 - bits)); \
        return at[0] + high(2 * (at[1] - at[0]), (int32_t)(a << bits >> 1)); \
    } \
    RUN(lines_##n)
LINES(64, 6)
LINES(256, 8)
LINES(1024, 10)

/* Parabola through the nearest entry b and its neighbours a and c, at t = -1/2..1/2: b + t
 * ((c - a) + t (a + c - 2 b)) / 2. */
METHOD parabolas(tp_turn angle)
{
    const tp_q30 *at = table + ((angle + (1u << 25)) >> 26);
    const int32_t t = (int32_t)(angle << 6);
    const tp_q30 a = at[0], b = at[1], c = at[2];
    return b + high(t, (c - a + high(t, a + c - 2 * b)) >> 1);
}
RUN(parabolas)

/* Taylor series sin(a + d) = sin a + d cos a - d^2/2 sin a at the nearest entry; d in
 * radians. */
#define TWO_PI_Q32 26986075409
#define KNOTS(n, bits) \
    METHOD knots_##n(tp_turn a) \
    { \
        const tp_q30 *at = table + ((a + (1u << (31 - bits))) >> (32 - bits)) % n; \
        const int32_t d = high((int32_t)(a << bits), (int32_t)(TWO_PI_Q32 / n)); \
        return at[0] + high(d, at[n / 4]) - high(at[0], high(d, d) >> 1); \
    } \
    RUN(knots_##n)
KNOTS(64, 6)
KNOTS(256, 8)

/* Taylor series from the entries of tp_sin, equal to the last bit to the engine's
 * rotations. */
METHOD rotations(tp_turn angle)
{
    const tp_turn knot = (angle + (1u << 21)) & ~((1u << 22) - 1);
    const int32_t turns = (int32_t)(angle - knot);
    const tp_q30 d = (tp_q30)((turns * (int64_t)TP_Q30(1.5707963267948966)
                               + (1 << 29)) >> 30);
    const tp_q30 half_square = (tp_q30)(((int64_t)d * d + (1 << 30)) >> 31);
    const tp_q30 s = tp_sin(knot), c = tp_cos(knot);
    return s + tp_q30_mul(c, d) - tp_q30_mul(s, half_square);
}
RUN(rotations)

/* -- without a table ----------------------------------------------------------------- */

/* Parabola 4 x (1 - |x|), x in half turns from -1 to 1; Q2.30 from Q0.31. */
static inline tp_q30 parabola_of(tp_turn angle)
{
    const int32_t x = (int32_t)angle;
    return 4 * ((x >> 1) - high(x, x ^ x >> 31));
}

METHOD parabola(tp_turn angle) { return parabola_of(angle); }
RUN(parabola)

/* Corrected parabola y + 0.225 (y |y| - y), the well-known refinement; the correction is 0
 * in the middle of the curve. */
METHOD refined(tp_turn angle)
{
    const tp_q30 y = parabola_of(angle);
    return y + 4 * high(TP_Q30(0.225), 4 * high(y, y < 0 ? -y : y) - y);
}
RUN(refined)

/* Angle in quarters of a turn from -1 to 1, Q2.30; angles outside are mirrored. */
static inline int32_t quarters(tp_turn a)
{
    return (int32_t)((a ^ a << 1) & 0x80000000u ? 0x80000000u - a : a);
}

/* Minimax polynomials over a quarter of a turn; v is u^2 in Q1.31, and each step is
 * Q2.30. */
#define SQUARE uint32_t v = (uint32_t)((uint64_t)((int64_t)u * u) >> 29)
#define TAKE(from, rest) ((uint32_t)TP_Q30(from) - 2 * high_of(v, rest))

METHOD poly_3(tp_turn angle)
{
    const int32_t u = quarters(angle);
    SQUARE;
    return 4 * high(u, (int32_t)TAKE(1.548066186, TP_Q30(0.552557921)));
}
RUN(poly_3)

METHOD poly_5(tp_turn angle)
{
    const int32_t u = quarters(angle);
    SQUARE;
    return 4 * high(u, (int32_t)TAKE(1.570320019, TAKE(0.642113167, TP_Q30(0.071860854))));
}
RUN(poly_5)

METHOD poly_7(tp_turn angle)
{
    const int32_t u = quarters(angle);
    SQUARE;
    return 4 * high(u, (int32_t)TAKE(1.570791011,
        TAKE(0.645892850, TAKE(0.079434345, TP_Q30(0.004333095)))));
}
RUN(poly_7)

METHOD poly_9(tp_turn angle)
{
    const int32_t u = quarters(angle);
    SQUARE;
    return tp_q30_mul(u, (int32_t)TAKE(1.570796290, TAKE(0.645963360,
        TAKE(0.079688481, TAKE(0.004672228, TP_Q30(0.000150821))))));
}
RUN(poly_9)

/* CORDIC angles +- atan 2^-i. Each rotation lengthens the vector: a start of 0.60725 ends
 * at length 1. */
static const tp_turn arcs[24] = {
    536870912, 316933406, 167458907, 85004756, 42667331, 21354465, 10679838, 5340245,
    2670163, 1335087, 667544, 333772, 166886, 83443, 41722, 20861, 10430, 5215, 2608,
    1304, 652, 326, 163, 81,
};

static inline tp_q30 cordic(tp_turn angle, int steps)
{
    int32_t x = TP_Q30(0.607252935), y = 0, left = quarters(angle);

    for (int i = 0; i < steps; i++) {
        const int32_t s = left >> 31, dx = y >> i, dy = x >> i;
        x -= (dx ^ s) - s;
        y += (dy ^ s) - s;
        left -= ((int32_t)arcs[i] ^ s) - s;
    }
    return y;
}

METHOD cordic_16(tp_turn angle) { return cordic(angle, 16); }
METHOD cordic_24(tp_turn angle) { return cordic(angle, 24); }
RUN(cordic_16)
RUN(cordic_24)

/* -- list of kernels ----------------------------------------------------------------- */

#define ROW(name, fill, method, bytes) { "sine", name, fill, run_##method, 1, 1, bytes }
const kernel kernels_sine[] = {
    ROW("nearest;256", fill_near_8, nearest_256, 512),
    ROW("nearest;1024", fill_near_10, nearest_1024, 2048),
    ROW("nearest;4096", fill_near_12, nearest_4096, 8192),
    ROW("lines;64", fill_6, lines_64, 260),
    ROW("lines;256", fill_8, lines_256, 1028),
    ROW("lines;1024", fill_10, lines_1024, 4100),
    ROW("tp_sin;1024", fill, tp_sin, 1032),
    ROW("tp_sin-between;1024", fill_between, between, 1032),
    ROW("parabolas;64", fill_middle_6, parabolas, 264),
    ROW("knots;64", fill_6, knots_64, 320),
    ROW("knots;256", fill_8, knots_256, 1280),
    ROW("tp_rotation_from_angles;1024", fill, rotations, 1032),
    ROW("parabola;2", fill, parabola, 0),
    ROW("parabola;4", fill, refined, 0),
    ROW("polynomial;3", fill, poly_3, 0),
    ROW("polynomial;5", fill, poly_5, 0),
    ROW("polynomial;7", fill, poly_7, 0),
    ROW("polynomial;9", fill, poly_9, 0),
    ROW("cordic;16", fill, cordic_16, 64),
    ROW("cordic;24", fill, cordic_24, 96),
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
