/* SPDX-License-Identifier: MIT */
/* Fresnel reflectance of water for N.V as Q1.14, 0..1 [F1] [F2]: by the formulas, and by
 * tables with a number of steps, nearest entry or linear interpolation.
 *
 * A table's entry is a byte, in 1/256, like the engine's tables; interpolated tables have
 * 16-bit entries. The exact law fills the tables before the count begins. */
#include "shade/optics.h"
#include "tests/charts/kernels.h"
#include "shade/shade.h"

#define METHOD static __attribute__((noinline)) int32_t
#define RUN(method) \
    static void run_##method(const int32_t *in, int32_t *out) \
    { \
        for (uint32_t i = 0; i < KERNEL_UNITS; i++) \
            out[i] = method(in[i]); \
    }

enum { ONE = 16384 };

static uint8_t  bytes[257];
static uint16_t words[258];

static void fill(int32_t *in)
{
    for (uint32_t i = 0; i < KERNEL_UNITS; i++)
        in[i] = kernel_ramp(i, 0, ONE);
}

/* -- exact law and Schlick's form ---------------------------------------------------- */

METHOD law(int32_t nv) { return tp_fresnel(nv << 16); }
METHOD shortcut(int32_t nv) { return tp_fresnel_schlick(nv << 16); }
RUN(law)
RUN(shortcut)

/* Schlick's form in 32 bits: r0 + (1 - r0) (1 - c)^5, Q16. */
METHOD shortcut_q16(int32_t nv)
{
    const uint32_t m = (uint32_t)(ONE - nv) << 2, m2 = m * (m >> 1) >> 15;
    const uint32_t m4 = (m2 >> 1) * (m2 >> 1) >> 14, m5 = (m4 >> 1) * (m >> 1) >> 14;
    return (int32_t)(1335 + ((m5 >> 1) * (65536 - 1335) >> 15));
}
RUN(shortcut_q16)

/* -- the engine's tables ------------------------------------------------------------- */

METHOD engine(int32_t nv) { return (int32_t)tp_fresnel_table[nv >> 6]; }
METHOD engine_schlick(int32_t nv) { return (int32_t)tp_schlick_table[nv >> 6]; }
METHOD engine_near(int32_t nv) { return (int32_t)tp_fresnel_table[(nv + 32) >> 6]; }
RUN(engine)
RUN(engine_schlick)
RUN(engine_near)

/* -- nearest entries ----------------------------------------------------------------- */

static uint8_t byte_of(tp_q30 share)
{
    const int32_t b = (share + (1 << 21)) >> 22;
    return (uint8_t)(b > 255 ? 255 : b);
}

/* Entries at the middles of steps, so the nearest entry is taken; the last entry is for N.V
 * = 1 alone. */
static void fill_bytes(int32_t *in, int bits)
{
    fill(in);
    for (int32_t i = 0; i <= 1 << bits; i++)
        bytes[i] = byte_of(tp_fresnel((2 * i + 1) << (29 - bits)));
}

#define NEAREST(n, bits) \
    static void fill_bytes_##n(int32_t *in) { fill_bytes(in, bits); } \
    METHOD nearest_##n(int32_t nv) { return bytes[nv >> (14 - bits)]; } \
    RUN(nearest_##n)
NEAREST(16, 4)
NEAREST(32, 5)
NEAREST(64, 6)
NEAREST(128, 7)
NEAREST(256, 8)

/* -- linear interpolation ------------------------------------------------------------ */

static void fill_words(int32_t *in, int bits)
{
    fill(in);
    for (int32_t i = 0; i <= (1 << bits) + 1; i++) {
        const int32_t w = (tp_fresnel(i >> bits ? TP_Q30_ONE : i << (30 - bits))
                           + (1 << 13)) >> 14;
        words[i] = (uint16_t)(w > 65535 ? 65535 : w);
    }
}

#define LINES(n, bits) \
    static void fill_words_##n(int32_t *in) { fill_words(in, bits); } \
    METHOD lines_##n(int32_t nv) \
    { \
        const uint16_t *at = words + (nv >> (14 - bits)); \
        const int32_t part = nv & ((1 << (14 - bits)) - 1); \
        return at[0] + ((at[1] - at[0]) * part >> (14 - bits)); \
    } \
    RUN(lines_##n)
LINES(16, 4)
LINES(32, 5)
LINES(64, 6)
LINES(128, 7)
LINES(256, 8)

/* -- list of kernels ----------------------------------------------------------------- */

#define ROW(name, fill, method, bytes) { "fresnel", name, fill, run_##method, 1, 1, bytes }
const kernel kernels_fresnel[] = {
    ROW("law;0", fill, law, 514 + 386), ROW("schlick;0", fill, shortcut, 0),
    ROW("schlick-16-bit;0", fill, shortcut_q16, 0),
    ROW("table;256", fill, engine, 257),
    ROW("schlick-table;256", fill, engine_schlick, 257),
    ROW("table-nearest;256", fill, engine_near, 257),
    ROW("nearest;16", fill_bytes_16, nearest_16, 17),
    ROW("nearest;32", fill_bytes_32, nearest_32, 33),
    ROW("nearest;64", fill_bytes_64, nearest_64, 65),
    ROW("nearest;128", fill_bytes_128, nearest_128, 129),
    ROW("nearest;256", fill_bytes_256, nearest_256, 257),
    ROW("lines;16", fill_words_16, lines_16, 36),
    ROW("lines;32", fill_words_32, lines_32, 68),
    ROW("lines;64", fill_words_64, lines_64, 132),
    ROW("lines;128", fill_words_128, lines_128, 260),
    ROW("lines;256", fill_words_256, lines_256, 516),
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
