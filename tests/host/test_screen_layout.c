/* SPDX-License-Identifier: MIT */
/* Rows of every format in every pixel layout, read back bit by bit. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/fullscreen/pixel_layout.h"
#include "pixel/pixel.h"

#define WIDTH 67
#define GUARD 0xa5

static uint32_t next_random(uint32_t *seed)     /* xorshift32, Marsaglia 2003 */
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 17;
    *seed ^= *seed << 5;
    return *seed;
}

typedef struct { uint8_t rows[2 * 4 * WIDTH]; } memory;

static picture random_picture(tp_format format, memory *m, uint32_t seed)
{
    const size_t bytes = tp_format_row_bytes(format, WIDTH);
    for (size_t i = 0; i < sizeof m->rows; i++)
        m->rows[i] = (uint8_t)next_random(&seed);
    return (picture){ format, WIDTH, 2, bytes, m->rows };
}

/* Returns bit `i` of a pixel at `from`, from the lowest, for either byte order. */
static unsigned bit(const pixel_layout *l, const uint8_t *from, unsigned i)
{
    const unsigned bytes = l->bits / 8, byte = i / 8;
    return from[l->big ? bytes - 1 - byte : byte] >> i % 8 & 1u;
}

/* The channel's bits must be the high bits of the colour; bits below the eighth repeat
 * it. */
static bool channel_holds(const pixel_layout *l, const uint8_t *from, pixel_channel c,
                          unsigned value)
{
    for (unsigned i = 0; i < c.length; i++)
        if (bit(l, from, c.offset + c.length - 1u - i) != (value >> (7 - i % 8) & 1u))
            return false;
    return true;
}

static bool pixel_holds(const pixel_layout *l, const uint8_t *from, uint32_t rgb)
{
    if (l->indexed || l->grey)
        return false;
    for (unsigned i = 0; i < l->spare.length; i++)
        if (!bit(l, from, l->spare.offset + i))
            return false;
    return channel_holds(l, from, l->red, rgb >> 16 & 255)
        && channel_holds(l, from, l->green, rgb >> 8 & 255)
        && channel_holds(l, from, l->blue, rgb & 255);
}

/* Returns the number of correct pixels in the row. */
static int held(const pixel_layout *l, const picture *p, const uint8_t *row)
{
    int n = 0;
    for (int x = 0; x < WIDTH; x++)
        n += pixel_holds(l, row + (size_t)x * l->bits / 8,
                         tp_pixel_read(p->format, picture_row(p, 1), x));
    return n;
}

static void row_is_right(const pixel_layout *l, tp_format format, uint32_t seed)
{
    memory m;
    uint8_t row[4 * WIDTH + 1];
    const size_t bytes = WIDTH * l->bits / 8;
    const picture p = random_picture(format, &m, seed);
    memset(row, GUARD, sizeof row);
    pixel_layout_row(l, row, &p, 1);
    assert_int_equal(held(l, &p, row), WIDTH);
    assert_int_equal(row[bytes], GUARD);
    row[bytes / 2] ^= 0xff;                     /* one wrong byte is found */
    assert_int_equal(held(l, &p, row), WIDTH - 1);
}

static void usual_layouts_hold_every_format(void **state)
{
    static const pixel_layout of[] = {
        { 32, false, false, false, { 16, 8 }, { 8, 8 }, { 0, 8 }, { 24, 8 } },
        { 32, false, false, false, { 0, 8 }, { 8, 8 }, { 16, 8 }, { 24, 8 } },
        { 32, false, false, false, { 24, 8 }, { 16, 8 }, { 8, 8 }, { 0, 8 } },
        { 32, false, false, false, { 20, 10 }, { 10, 10 }, { 0, 10 }, { 30, 2 } },
        { 24, false, false, false, { 16, 8 }, { 8, 8 }, { 0, 8 }, { 0, 0 } },
        { 24, false, false, false, { 0, 8 }, { 8, 8 }, { 16, 8 }, { 0, 0 } },
        { 16, false, false, false, { 11, 5 }, { 5, 6 }, { 0, 5 }, { 0, 0 } },
        { 16, false, false, false, { 10, 5 }, { 5, 5 }, { 0, 5 }, { 15, 1 } },
        { 16, false, false, false, { 0, 5 }, { 5, 6 }, { 11, 5 }, { 0, 0 } },
        { 16, false, false, false, { 8, 4 }, { 4, 4 }, { 0, 4 }, { 12, 4 } },
        { 8, false, false, false, { 5, 3 }, { 2, 3 }, { 0, 2 }, { 0, 0 } },
    };
    (void)state;
    for (size_t i = 0; i < sizeof of / sizeof *of; i++)
        for (int big = 0; big < 2; big++)
            for (int format = 0; format < TP_FORMAT_COUNT; format++) {
                pixel_layout l = of[i];
                l.big = big;
                assert_true(pixel_layout_is_supported(&l));
                row_is_right(&l, (tp_format)format, 1u + (uint32_t)i);
            }
}

/* Channels of random lengths in random order, with gaps. */
static pixel_layout random_layout(uint32_t *seed)
{
    static const uint8_t orders[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 },
                                          { 1, 2, 0 }, { 2, 0, 1 }, { 2, 1, 0 } };
    pixel_layout l = { .bits = 8 + 8 * (next_random(seed) % 4),
                       .big = next_random(seed) & 1 };
    pixel_channel of[3];
    unsigned at = 0;
    const uint8_t *order = orders[next_random(seed) % 6];
    for (unsigned i = 0; i < 3; i++) {
        const unsigned room = l.bits - at - (2 - i);
        const unsigned most = room < 14 ? room : 14;
        const unsigned length = 1 + next_random(seed) % most;
        const unsigned gap = next_random(seed) % (room - length + 1) / 4;
        of[order[i]] = (pixel_channel){ (uint8_t)(at + gap), (uint8_t)length };
        at += gap + length;
    }
    l.red = of[0];
    l.green = of[1];
    l.blue = of[2];
    l.spare =
        (pixel_channel){ (uint8_t)at, (uint8_t)(next_random(seed) % (l.bits - at + 1)) };
    return l;
}

/* A byte without a bit of any channel may have any value: no check is possible. */
static void random_layouts_hold_every_format(void **state)
{
    uint32_t seed = 20240607;
    (void)state;
    for (int i = 0; i < 5000; i++) {
        const pixel_layout l = random_layout(&seed);
        const tp_format format = (tp_format)(next_random(&seed) % TP_FORMAT_COUNT);
        memory m;
        uint8_t row[4 * WIDTH];
        const picture p = random_picture(format, &m, seed);
        assert_true(pixel_layout_is_supported(&l));
        pixel_layout_row(&l, row, &p, 1);
        assert_int_equal(held(&l, &p, row), WIDTH);
    }
}

static void exact_formats_read_back_as_they_are(void **state)
{
    const pixel_layout wide = { 32, false, false, false, { 0, 8 }, { 8, 8 }, { 16, 8 },
                          { 24, 8 } };
    memory m;
    uint8_t row[4 * WIDTH];
    (void)state;
    for (int format = 0; format < TP_FORMAT_COUNT; format++) {
        const picture p = random_picture((tp_format)format, &m, 77);
        pixel_layout_row(&wide, row, &p, 0);
        for (int x = 0; x < WIDTH; x++) {
            const uint8_t *at = row + 4 * x;
            const uint32_t rgb = (uint32_t)at[0] << 16 | (uint32_t)at[1] << 8 | at[2];
            assert_int_equal(rgb, tp_pixel_read(p.format, m.rows, x));
        }
    }
}

static void indices_and_greys_show_the_colours(void **state)
{
    const pixel_layout indexed = { .bits = 8, .indexed = true },
                       grey = { .bits = 8, .grey = 1 };
    static const tp_format of[] = { TP_FORMAT_P8, TP_FORMAT_L8, TP_FORMAT_I1 };
    memory m;
    uint8_t row[WIDTH];
    (void)state;
    for (int i = 0; i < 3; i++) {
        const picture p = random_picture(of[i], &m, 5);
        assert_true(pixel_layout_accepts(&indexed, of[i]));
        assert_true(pixel_layout_accepts(&grey, of[i]) == (of[i] != TP_FORMAT_P8));
        pixel_layout_row(i ? &grey : &indexed, row, &p, 1);
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(pixel_layout_colour(of[i], row[x]),
                             tp_pixel_read(of[i], picture_row(&p, 1), x));
    }
    assert_false(pixel_layout_accepts(&indexed, TP_FORMAT_XRGB8888));
    assert_false(pixel_layout_accepts(&grey, TP_FORMAT_RGB565));
    assert_int_equal(pixel_layout_format(&indexed), TP_FORMAT_P8);
    assert_int_equal(pixel_layout_format(&grey), TP_FORMAT_L8);
}

static void strange_layouts_are_not_known(void **state)
{
    static const pixel_layout of[] = {
        { 15, false, false, false, { 10, 5 }, { 5, 5 }, { 0, 5 }, { 0, 0 } },
        { 4, true, false, false, { 0, 4 }, { 0, 4 }, { 0, 4 }, { 0, 0 } },
        { 16, false, true, false, { 0, 0 }, { 0, 0 }, { 0, 0 }, { 0, 0 } },
        { 32, false, false, false, { 16, 8 }, { 8, 8 }, { 8, 8 }, { 0, 0 } },
        { 32, false, false, false, { 26, 8 }, { 8, 8 }, { 0, 8 }, { 0, 0 } },
        { 32, false, false, false, { 16, 8 }, { 8, 8 }, { 0, 0 }, { 0, 0 } },
        { 32, false, false, false, { 16, 8 }, { 8, 8 }, { 0, 8 }, { 20, 8 } },
        { 0 },
    };
    (void)state;
    for (size_t i = 0; i < sizeof of / sizeof *of; i++)
        assert_false(pixel_layout_is_supported(&of[i]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(usual_layouts_hold_every_format),
        cmocka_unit_test(random_layouts_hold_every_format),
        cmocka_unit_test(exact_formats_read_back_as_they_are),
        cmocka_unit_test(indices_and_greys_show_the_colours),
        cmocka_unit_test(strange_layouts_are_not_known),
    };
    return cmocka_run_group_tests_name("screen layouts", tests, NULL, NULL);
}
