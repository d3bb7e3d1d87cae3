/* SPDX-License-Identifier: MIT */
/* Decimal text: rounding compared with boundaries written in decimal, long numbers, large
 * exponents, and every written number read back. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "fixed/arithmetic.h"
#include "tests/lib/measure.h"

enum { LONG = 1000000 };

static uint64_t seed;

static void reads_as(const char *text, tp_fx want, int want_beyond)
{
    tp_fx x = 12345;
    int beyond = 0;
    const uint32_t length = (uint32_t)strlen(text);
    if (tp_fx_read(text, length, &x, &beyond) != length || x != want
        || beyond != want_beyond)
        fail_msg("\"%s\" reads as %d, beyond %d", text, (int)x, beyond);
}

static void plain_numbers_are_read(void **state)
{
    (void)state;
    reads_as("0", 0, 0);
    reads_as("-0", 0, 0);
    reads_as("1", TP_FX_ONE, 0);
    reads_as("+1.5", TP_FX(1.5), 0);
    reads_as("-0.35", TP_FX(-0.35), 0);
    reads_as(".25", TP_FX(0.25), 0);
    reads_as("25.", TP_FX(25), 0);
    reads_as("007", TP_FX(7), 0);
    reads_as("1e3", TP_FX(1000), 0);
    reads_as("1E+3", TP_FX(1000), 0);
    reads_as("12345e-4", TP_FX(1.2345), 0);
    reads_as("0.000123e5", TP_FX(12.3), 0);
    reads_as("32767.99998", TP_FX_MAX, 0);
    reads_as("-32768", TP_FX_MIN, 0);
}

static void halves_round_up(void **state)
{
    (void)state;
    reads_as("0.00000762939453125", 1, 0);          /* 2^-17 */
    reads_as("0.00000762939453124999999999", 0, 0);
    reads_as("-0.00000762939453125", 0, 0);
    reads_as("-0.000007629394531250000001", -1, 0);
    reads_as("0.00002288818359375", 2, 0);
    reads_as("-0.00002288818359375", -1, 0);
    reads_as("762939453125e-17", 1, 0);
    reads_as("76293945312499e-19", 0, 0);
}

static void numbers_beyond_the_range_saturate(void **state)
{
    (void)state;
    reads_as("32767.9999923706054687499", TP_FX_MAX, 0);
    reads_as("32767.99999237060546875", TP_FX_MAX, 1);  /* half an LSB above the maximum */
    reads_as("-32768.00000762939453125", TP_FX_MIN, 0); /* half an LSB below the minimum */
    reads_as("-32768.000007629394531251", TP_FX_MIN, 1);
    reads_as("32768", TP_FX_MAX, 1);
    reads_as("99999.9", TP_FX_MAX, 1);
    reads_as("100000", TP_FX_MAX, 1);
    reads_as("-1e5", TP_FX_MIN, 1);
    reads_as("1e400000000", TP_FX_MAX, 1);
    reads_as("-1e99999999999999999999999999", TP_FX_MIN, 1);
    reads_as("1e-400000000", 0, 0);
    reads_as("-1e-99999999999999999999999999", 0, 0);
    reads_as("0e99999999999999999999999999", 0, 0);
    reads_as("0.0e-99999999999999999999999999", 0, 0);
}

static void beyond_is_kept_when_the_number_fits(void **state)
{
    (void)state;
    tp_fx x;
    int beyond = 1;
    assert_int_equal(tp_fx_read("2", 1, &x, &beyond), 1);
    assert_int_equal(beyond, 1);
    assert_int_equal(tp_fx_read("1e9", 3, &x, NULL), 3);
    assert_int_equal(x, TP_FX_MAX);
}

static void stops_at(const char *text, uint32_t want)
{
    tp_fx x = 12345;
    const uint32_t n = tp_fx_read(text, (uint32_t)strlen(text), &x, NULL);
    if (n != want || (want == 0) != (x == 12345))
        fail_msg("of \"%s\" %u bytes are read", text, (unsigned)n);
}

static void reading_stops_where_the_number_does(void **state)
{
    (void)state;
    static const char *const none[] = {
        "", "+", "-", ".", "-.", "e5", ".e5", " 1", "--1", "+-1", "x", "inf", "nan",
        "-inf", ",5", "/", ":",
    };
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++)
        stops_at(none[i], 0);
    stops_at("1 2", 1);
    stops_at("1e", 1);
    stops_at("1e+", 1);
    stops_at("1e-x", 1);
    stops_at("1ex", 1);
    stops_at("1.5.2", 3);
    stops_at("1..2", 2);
    stops_at("1e2.5", 3);
    stops_at("1e2e3", 3);
    stops_at("0x10", 1);
    stops_at("1,5", 1);
    stops_at("3/4/5", 1);
    stops_at("1-2", 1);
}

static void no_byte_behind_the_end_is_read(void **state)
{
    (void)state;
    const char text[] = "-12.5e-1";
    static const tp_fx want[] = {       /* for the first 0, 1, 2, ... bytes */
        12345, 12345, TP_FX(-1), TP_FX(-12), TP_FX(-12), TP_FX(-12.5), TP_FX(-12.5),
        TP_FX(-12.5), TP_FX(-1.25),
    };
    static const uint32_t length[] = { 0, 0, 2, 3, 4, 5, 5, 5, 8 };
    for (uint32_t bytes = 0; bytes < sizeof text; bytes++) {
        char *const part = malloc(bytes == 0 ? 1 : bytes);  /* watched by sanitizers */
        assert_non_null(part);
        memcpy(part, text, bytes);
        tp_fx x = 12345;
        assert_int_equal(tp_fx_read(part, bytes, &x, NULL), length[bytes]);
        assert_int_equal(x, want[bytes]);
        free(part);
    }
}

/* Compares whole.digits with the boundary half / 2^17, which has 17 places, digit by digit.
 * half >= 0. */
static int compare(uint32_t whole, const char *digits, uint64_t half)
{
    const uint64_t half_whole = half >> 17;
    if (whole != half_whole)
        return whole < half_whole ? -1 : 1;
    uint64_t places = (half & 0x1ffff) * 762939453125u;     /* 10^17 / 2^17 = 5^17 */
    for (uint64_t unit = 10000000000000000u; unit > 0; unit /= 10) {
        const int digit = (int)(places / unit);
        places %= unit;
        const int given = *digits != '\0' ? *digits++ - '0' : 0;
        if (given != digit)
            return given < digit ? -1 : 1;
    }
    for (; *digits != '\0'; digits++)
        if (*digits != '0')
            return 1;
    return 0;
}

/* True if x is the rounded number: 2 x - 1 <= number < 2 x + 1 in halves, for either
 * sign. */
static int is_rounded(int negative, uint32_t whole, const char *digits, tp_fx x)
{
    const int64_t low = 2 * (int64_t)x - 1, high = 2 * (int64_t)x + 1;
    if (!negative)
        return (low < 0 || compare(whole, digits, (uint64_t)low) >= 0)
            && compare(whole, digits, (uint64_t)high) < 0;
    return (high > 0 || compare(whole, digits, (uint64_t)-high) > 0)
        && compare(whole, digits, (uint64_t)-low) <= 0;
}

/* A fraction at or near a boundary, or any fraction; up to 60 digits. */
static void random_fraction(uint64_t *random, char digits[64])
{
    int n = 0;
    if (random_below(random, 2) == 0) {
        const uint64_t half = random_below(random, 1 << 17) | 1u;
        int64_t off = (int64_t)random_below(random, 5) - 2;
        n = snprintf(digits, 64, "%017" PRIu64,
                     (uint64_t)((int64_t)(half * 762939453125u) + off));
    }
    for (const int end = n + (int)random_below(random, 40); n < end; n++)
        digits[n] = (char)('0' + (n % 3 > 0 ? random_below(random, 10) : 0));
    digits[n] = '\0';
}

/* Writes whole.digits with the point moved `shift` places to the right, and the exponent
 * e-shift. */
static void write_shifted(char *text, size_t bytes, int negative, uint32_t whole,
                          const char *digits, int shift)
{
    char all[160];
    const int lead = 40, n = snprintf(all, sizeof all, "%040d%010u%s", 0, (unsigned)whole,
                                      digits);
    int point = lead + 10 + shift;
    for (int i = n; i < point; i++)
        all[i] = '0';
    const int end = n > point ? n : point;
    snprintf(text, bytes, "%s%.*s.%.*se%d", negative ? "-" : "", point, all, end - point,
             all + point, -shift);
}

static void any_number_is_rounded_to_nearest(void **state)
{
    (void)state;
    uint64_t random = seed;
    for (int i = 0; i < 1000000; i++) {
        char digits[64], text[256];
        random_fraction(&random, digits);
        const uint32_t whole = random_below(&random, 32767) >> random_below(&random, 16);
        const int negative = (int)random_below(&random, 2);
        const int shift = (int)random_below(&random, 81) - 40;
        if (random_below(&random, 2) == 0)
            snprintf(text, sizeof text, "%s%u.%s", negative ? "-" : "", (unsigned)whole,
                     digits);
        else
            write_shifted(text, sizeof text, negative, whole, digits, shift);
        tp_fx x = 0;
        const uint32_t length = (uint32_t)strlen(text);
        if (tp_fx_read(text, length, &x, NULL) != length
            || !is_rounded(negative, whole, digits, x))
            fail_msg("\"%s\" reads as %d", text, (int)x);
    }
    printf("    tp_fx_read         1000000 random decimals, all rounded to nearest\n");
}

static void wide_reads_as(const char *text, int64_t want)
{
    int64_t x = 12345;
    const uint32_t length = (uint32_t)strlen(text);
    if (tp_fx_read_wide(text, length, &x) != length || x != want)
        fail_msg("\"%s\" reads as %" PRId64, text, x);
}

static void wide_numbers_are_read_up_to_10_to_the_14(void **state)
{
    (void)state;
    wide_reads_as("32768", (int64_t)32768 << 16);
    wide_reads_as("-3443870976.5", -(((int64_t)3443870976 << 16) + 0x8000));
    wide_reads_as("99999999999999.99999", TP_WIDE_MAX - 1);
    wide_reads_as("9999999999999999999e-5", TP_WIDE_MAX - 1);
    wide_reads_as("123456789012345", TP_WIDE_MAX);
    wide_reads_as("-1e999999999999999999999", -TP_WIDE_MAX);
}

/* The whole part shifts a number and does not change the rounding of the fraction. */
static void any_wide_number_is_rounded_as_its_fraction(void **state)
{
    (void)state;
    uint64_t random = seed;
    for (int i = 0; i < 200000; i++) {
        char digits[64], text[128], small[80];
        const uint64_t any = random_next(&random) >> random_below(&random, 63);
        const uint64_t whole = any % 100000000000000;
        random_fraction(&random, digits);
        const char *const sign = random_below(&random, 2) ? "-" : "";
        snprintf(text, sizeof text, "%s%" PRIu64 ".%s", sign, whole, digits);
        snprintf(small, sizeof small, "%s0.%s", sign, digits);
        tp_fx fraction = 0;
        tp_fx_read(small, (uint32_t)strlen(small), &fraction, NULL);
        const int64_t units = (int64_t)whole * TP_FX_ONE;
        wide_reads_as(text, (*sign ? -units : units) + fraction);
    }
}

/* Reads the text: before, `count` times `fill`, after. */
static void long_reads_as(const char *before, char fill, size_t count, const char *after,
                          tp_fx want, int want_beyond)
{
    const size_t head = strlen(before), tail = strlen(after);
    char *const text = malloc(head + count + tail + 1);
    assert_non_null(text);
    memcpy(text, before, head);
    memset(text + head, fill, count);
    memcpy(text + head + count, after, tail + 1);
    tp_fx x = 12345;
    int beyond = 0;
    assert_int_equal(tp_fx_read(text, (uint32_t)(head + count + tail), &x, &beyond),
                     head + count + tail);
    assert_int_equal(x, want);
    assert_int_equal(beyond, want_beyond);
    free(text);
}

static void a_million_digits_are_read_exactly(void **state)
{
    (void)state;
    long_reads_as("", '9', LONG, "", TP_FX_MAX, 1);
    long_reads_as("-", '9', LONG, "e-999999", TP_FX(-10), 0);
    long_reads_as("1", '0', LONG, "e-1000000", TP_FX_ONE, 0);
    long_reads_as("1.5", '0', LONG, "", TP_FX(1.5), 0);
    long_reads_as("0.", '0', LONG, "125e1000001", TP_FX(1.25), 0);
    long_reads_as("0.", '0', LONG, "1e1000006", TP_FX_MAX, 1);
    long_reads_as("", '0', LONG, "7", TP_FX(7), 0);
    long_reads_as("0.00000762939453125", '0', LONG, "", 1, 0);
    long_reads_as("-0.00000762939453125", '0', LONG, "", 0, 0);
    long_reads_as("-0.00000762939453125", '0', LONG, "1", -1, 0);
    long_reads_as("0.00000762939453124", '9', LONG, "", 0, 0);
    long_reads_as("762939453125", '0', LONG, "1e-1000018", 1, 0);
    long_reads_as("1e", '0', LONG, "2", TP_FX(100), 0);
    long_reads_as("1e-", '9', LONG, "", 0, 0);
}

static void check_written(tp_fx x)
{
    char text[16];
    memset(text, '#', sizeof text);
    const uint32_t length = tp_fx_write(x, text);
    if (length > 14 || text[length] != '\0' || strlen(text) != length)
        fail_msg("%d is written in %u bytes", (int)x, (unsigned)length);
    tp_fx lag = ~x;
    int beyond = 0;
    if (tp_fx_read(text, length, &lag, &beyond) != length || lag != x || beyond)
        fail_msg("%d is written %s and reads back as %d", (int)x, text, (int)lag);
}

/* Asserts that neither neighbour decimal with one place less reads back as x. */
static void check_shortest(tp_fx x)
{
    char text[16], cut[48];
    tp_fx_write(x, text);
    const char *const point = strchr(text, '.');
    if (point == NULL)
        return;
    const int places = (int)strlen(point + 1) - 1;
    const int64_t scale = places == 0 ? 1 : places == 1 ? 10 : places == 2 ? 100
                        : places == 3 ? 1000 : 10000;
    const int64_t floor_units = ((int64_t)x * scale - (x < 0 ? 0xffff : 0)) / 65536;
    for (int64_t n = floor_units; n <= floor_units + 1; n++) {
        tp_fx lag = ~x;
        snprintf(cut, sizeof cut, "%" PRId64 "e-%d", n, places);
        tp_fx_read(cut, (uint32_t)strlen(cut), &lag, NULL);
        if (lag == x)
            fail_msg("%d is written %s, but %s would do", (int)x, text, cut);
    }
}

static void every_number_is_written_so_that_it_reads_back(void **state)
{
    (void)state;
    uint64_t inputs = 0;
    const uint32_t stride = sweep_stride();
    for (uint64_t word = 0; word <= UINT32_MAX; word += stride, inputs++)
        check_written((tp_fx)(uint32_t)word);
    for (tp_fx x = -70000; x <= 70000; x++, inputs++)
        check_written(x);
    check_written(TP_FX_MIN);
    check_written(TP_FX_MAX);
    printf("    tp_fx_write        %" PRIu64 " inputs, all read back\n", inputs);
}

static void the_shortest_decimal_is_written(void **state)
{
    (void)state;
    uint64_t random = seed;
    for (tp_fx x = -70000; x <= 70000; x++)
        check_shortest(x);
    for (int i = 0; i < 500000; i++)
        check_shortest((tp_fx)(uint32_t)random_next(&random));
}

static void writes(tp_fx x, const char *want)
{
    char text[16];
    tp_fx_write(x, text);
    assert_string_equal(text, want);
}

static void known_numbers_are_written_as_people_do(void **state)
{
    (void)state;
    writes(0, "0");
    writes(TP_FX(0.35), "0.35");
    writes(TP_FX(-9.81), "-9.81");
    writes(TP_FX(100), "100");
    writes(TP_FX(-0.05), "-0.05");
    writes(1, "0.00002");
    writes(TP_FX_MIN, "-32768");
    writes(TP_FX_MAX, "32767.99998");
    writes(TP_FX_MIN + 1, "-32767.99998");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain_numbers_are_read),
        cmocka_unit_test(halves_round_up),
        cmocka_unit_test(numbers_beyond_the_range_saturate),
        cmocka_unit_test(beyond_is_kept_when_the_number_fits),
        cmocka_unit_test(reading_stops_where_the_number_does),
        cmocka_unit_test(no_byte_behind_the_end_is_read),
        cmocka_unit_test(any_number_is_rounded_to_nearest),
        cmocka_unit_test(wide_numbers_are_read_up_to_10_to_the_14),
        cmocka_unit_test(any_wide_number_is_rounded_as_its_fraction),
        cmocka_unit_test(a_million_digits_are_read_exactly),
        cmocka_unit_test(every_number_is_written_so_that_it_reads_back),
        cmocka_unit_test(the_shortest_decimal_is_written),
        cmocka_unit_test(known_numbers_are_written_as_people_do),
    };
    seed = random_seed();
    return cmocka_run_group_tests_name("fixed/decimal", tests, NULL, NULL);
}
