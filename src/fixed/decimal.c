/* SPDX-License-Identifier: MIT */
/* Conversion of decimal text to 16.16 and back, exact, in linear time.
 *
 * Rounding changes at odd multiples of 2^-17, and 2^-17 has exactly 17 decimal places.  The
 * result is decided by 17 places of the fraction and by a flag for non-zero digits after
 * them.  F / 10^17 in units of 2^-17 is F / 5^17: one division.  Before the point only 14
 * digits matter.  The reader passes over the digits twice.  The first pass finds the power
 * of ten of the first non-zero digit; an exponent behind the digits shifts the power.  The
 * second pass adds up the digits. */
#include <stdbool.h>
#include <stddef.h>
#include "base/base.h"
#include "fixed/arithmetic.h"

enum { PLACES = 17, WHOLE_DIGITS = 14 };    /* 10^14 x 2^17 < 2^64 */

static const int64_t EXPONENT_CAP = 1000000000000;  /* larger than any number of digits */

static const uint64_t power_of_ten[PLACES + 1] = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000,
    10000000000, 100000000000, 1000000000000, 10000000000000, 100000000000000,
    1000000000000000, 10000000000000000, 100000000000000000,
};

/* The digits of a number in the text; a point may stand among them. */
typedef struct {
    const char *first;          /* the first non-zero digit; NULL if all digits are 0 */
    const char *end;
    int64_t     power;          /* power of ten of the first digit */
} digits;

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

/* Reads digits [. digits].  Returns false if there is no digit at all. */
static bool scan_digits(const char *at, const char *end, digits *found)
{
    bool any = false, point = false;
    *found = (digits){ .first = NULL, .end = at, .power = -1 };
    for (; at < end; at++) {
        if (*at == '.' && !point) {
            point = true;
            continue;
        }
        if (!is_digit(*at))
            break;
        any = true;
        if (found->first == NULL && *at != '0')
            found->first = at;
        if (found->first != NULL && !point)
            found->power++;     /* counts digits before the point, less one */
        if (found->first == NULL && point)
            found->power--;     /* counts zeros after the point */
    }
    found->end = at;
    return any;
}

/* Reads [e [+-] digits] and returns the end.  Without digits there is no
 * exponent: returns `at`. */
static const char *scan_exponent(const char *at, const char *end, int64_t *exponent)
{
    *exponent = 0;
    if (at == end || (*at != 'e' && *at != 'E'))
        return at;
    const char *digit = at + 1;
    const bool negative = digit < end && *digit == '-';
    if (digit < end && (*digit == '-' || *digit == '+'))
        digit++;
    if (digit == end || !is_digit(*digit))
        return at;
    for (; digit < end && is_digit(*digit); digit++) {
        *exponent = *exponent * 10 + (*digit - '0');
        if (*exponent > EXPONENT_CAP)
            *exponent = EXPONENT_CAP;
    }
    if (negative)
        *exponent = -*exponent;
    return digit;
}

/* Returns the number in units of 2^-17, rounded down.  *exact becomes true if nothing was
 * cut off.  `power` of the first digit is -6..13: whole < 10^14, fraction < 10^17. */
static uint64_t half_units(const digits *number, int power, bool *exact)
{
    TP_ASSERT(number->first != NULL && power >= -6 && power < WHOLE_DIGITS);
    uint64_t whole = 0, fraction = 0;
    bool more = false;
    for (const char *at = number->first; at < number->end; at++) {
        if (*at == '.')
            continue;
        const unsigned digit = (unsigned)(*at - '0');
        if (power >= 0)
            whole = whole * 10 + digit;
        else if (power >= -PLACES)
            fraction = fraction * 10 + digit;
        else
            more = more || digit != 0;
        power -= power >= -PLACES;
    }
    if (power >= 0)
        whole *= power_of_ten[power + 1];
    if (power >= -PLACES)
        fraction *= power_of_ten[power >= 0 ? 0 : power + PLACES + 1];
    const uint64_t five_17 = 762939453125;
    *exact = !more && fraction % five_17 == 0;
    return (whole << PLACES) + fraction / five_17;
}

/* Rounds half up, also below zero: there an exact half loses magnitude. */
static int64_t round_to_nearest(uint64_t halves, bool exact, bool negative)
{
    const bool down = negative && exact;
    const int64_t units = (int64_t)((halves >> 1) + (down ? 0 : halves & 1));
    return negative ? -units : units;
}

/* Returns the number in units of 2^-16.  Numbers below 10^-6 round to 0, and 10^14 is the
 * end of the range: only powers in between need the digits. */
static int64_t evaluate_digits(const digits *number, int64_t power, bool negative)
{
    if (number->first == NULL || power < -6)
        return 0;
    if (power >= WHOLE_DIGITS)
        return negative ? -TP_WIDE_MAX : TP_WIDE_MAX;
    bool exact;
    const uint64_t halves = half_units(number, (int)power, &exact);
    return round_to_nearest(halves, exact, negative);
}

uint32_t tp_fx_read_wide(const char *text, uint32_t bytes, int64_t *x)
{
    TP_ASSERT(text != NULL || bytes == 0);
    TP_ASSERT(x != NULL);
    const char *const end = text + bytes, *at = text;
    const bool negative = at < end && *at == '-';
    if (at < end && (*at == '-' || *at == '+'))
        at++;
    digits number;
    if (!scan_digits(at, end, &number))
        return 0;
    int64_t exponent;
    at = scan_exponent(number.end, end, &exponent);
    *x = evaluate_digits(&number, number.power + exponent, negative);
    return (uint32_t)(at - text);
}

uint32_t tp_fx_read(const char *text, uint32_t bytes, tp_fx *x, int *beyond)
{
    int64_t wide;
    const uint32_t n = tp_fx_read_wide(text, bytes, &wide);
    if (n == 0)
        return 0;
    *x = tp_fx_saturate(wide);
    if (*x != wide && beyond != NULL)
        *beyond = 1;
    return n;
}

/* Finds the decimal number of fewest places within half a unit of x.  A decimal of up to 5
 * places never lies exactly at half a unit: no tie can read back as the neighbour of x. */
static uint32_t shortest_decimal(uint32_t units, int *places)
{
    for (*places = 0;; ++*places) {
        const uint64_t scale = power_of_ten[*places], exact = units * scale;
        const uint32_t n = (uint32_t)((exact + 0x8000) >> 16);
        const int64_t off = (int64_t)((uint64_t)n << 16) - (int64_t)exact;
        if (2 * (off < 0 ? -off : off) < (int64_t)scale)
            return n;                   /* always true at 5 places: 2^15 < 10^5 / 2 */
    }
}

uint32_t tp_fx_write(tp_fx x, char text[16])
{
    char reversed[12];                  /* 10 digits and the point */
    int places, length = 0;
    uint32_t n = shortest_decimal(x < 0 ? 0u - (uint32_t)x : (uint32_t)x, &places);
    for (int i = 0; i < places; i++, n /= 10)
        reversed[length++] = (char)('0' + n % 10);
    if (places > 0)
        reversed[length++] = '.';
    do {
        reversed[length++] = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    uint32_t written = 0;
    if (x < 0)
        text[written++] = '-';
    while (length > 0)
        text[written++] = reversed[--length];
    text[written] = '\0';
    return written;
}
