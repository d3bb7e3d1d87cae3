/* SPDX-License-Identifier: MIT */
/* The squares of the window without cover, and the kind of a block of samples by the box
 * around its rest positions. */
#include "base/base.h"
#include "features/foam/foam_window.h"

/* Returns a word with the bits of each byte that a cover at or above `least`, a power of 2,
 * has. */
static uint32_t high_bits(uint32_t least)
{
    return 0x01010101u * (256 - least);
}

/* Returns the bits of the squares of a row of squares without cover.  A square is one or two
 * words wide. */
static uint32_t find_by_words(const tp_shade_foam *f, uint32_t row, uint32_t mask)
{
    const uint32_t n = f->cells, square = 1u << f->square, words = square / 4;
    const uint32_t *word =
        (const uint32_t *)(const void *)(f->cover + (size_t)row * square * n);
    uint32_t empty = 0, bit = 1;

    for (uint32_t i = 0; i < n / square; i++, bit *= 2, word += words) {
        uint32_t any = 0;
        for (uint32_t j = 0; j < square; j++)
            any |= word[j * (n / 4)] | word[j * (n / 4) + words - 1];
        empty |= any & mask ? 0 : bit;
    }
    return empty;
}

/* The same for any number of cells. */
static uint32_t find_by_bytes(const tp_shade_foam *f, uint32_t row, uint32_t mask)
{
    const uint32_t n = f->cells, square = 1u << f->square, end = (row + 1) * square;
    uint32_t covered = 0;

    for (uint32_t j = row * square; j < end && j < n; j++)
        for (uint32_t i = 0; i < n; i++)
            covered |= f->cover[(size_t)j * n + i] & mask & 0xff ? 1u << (i >> f->square) : 0;
    return ~covered;
}

static uint32_t count_squares(const tp_shade_foam *f)
{
    return (f->cells + (1u << f->square) - 1) >> f->square;
}

/* Returns the bits of all squares of a row. */
static uint32_t all_bits(uint32_t squares)
{
    TP_ASSERT(squares >= 1 && squares <= 32);
    return (2u << (squares - 1)) - 1;
}

bool tp_foam_find_empty_squares(tp_shade_foam *f, uint32_t least)
{
    TP_ASSERT(f->cells <= 256 && least > 0 && (least & (least - 1)) == 0);
    f->square = f->cells <= 128 ? 2 : 3;
    const bool words = f->cells % 8 == 0 && ((uintptr_t)f->cover & 3) == 0;
    const uint32_t squares = count_squares(f), mask = high_bits(least);
    uint32_t covered = 0;

    for (uint32_t j = 0; j < squares; j++) {
        f->empty[j] = words ? find_by_words(f, j, mask) : find_by_bytes(f, j, mask);
        covered |= ~f->empty[j] & all_bits(squares);
    }
    return covered != 0;
}

/* -- cells around a box -------------------------------------------------------------- */

/* Squares of stored columns or rows, first and last; the last may lie before the first. */
typedef struct {
    uint32_t first, last;
    bool     all;
} squares;

/* Returns the squares of all cells that samples low..high cells, Q16, from the window's low
 * side read.  `before`: f->col or f->row. */
static squares find_squares(const tp_shade_foam *f, uint32_t low, uint32_t high,
                            uint32_t before)
{
    const uint32_t n = f->cells;
    uint32_t a = ((low + 32768) >> 16) + before;
    uint32_t b = ((high + 32768) >> 16) + before + 1;
    const bool all = b - a + (1u << f->square) >= n;

    a -= a >= n ? n : 0;
    b -= b >= n ? n : 0;
    b -= b >= n ? n : 0;
    return (squares){ a >> f->square, b >> f->square, all };
}

/* Returns the bits of squares first..last; the row of squares is a ring. */
static uint32_t column_bits(const squares *s, uint32_t count)
{
    const uint32_t all = all_bits(count);
    const uint32_t from = 0u - (1u << s->first), to = (2u << s->last) - 1;

    return s->all ? all : s->first <= s->last ? from & to : (from | to) & all;
}

static bool are_squares_empty(const tp_shade_foam *f, const squares *x, const squares *z)
{
    const uint32_t count = count_squares(f), bits = column_bits(x, count);
    uint32_t j = z->all ? 0 : z->first, last = z->all ? count - 1 : z->last;

    for (;; j = j + 1 < count ? j + 1 : 0) {
        if (bits & ~f->empty[j])
            return false;
        if (j == last)
            return true;
    }
}

bool tp_foam_is_range_empty(const tp_shade_foam *f, const uint32_t u[2],
                            const uint32_t w[2])
{
    if (f->square == 0)                     /* no square is known */
        return false;
    const squares x = find_squares(f, u[0], u[1], f->col),
                  z = find_squares(f, w[0], w[1], f->row);
    return are_squares_empty(f, &x, &z);
}

/* -- boxes --------------------------------------------------------------------------- */

static int32_t clamp_side(int32_t most, int64_t a)
{
    return a < -most ? -most : a > most ? most : (int32_t)a;
}

/* The window's side clips the box; false: the box lies outside. */
static bool clip_range(uint32_t side, uint32_t d, uint32_t half, uint32_t *low,
                       uint32_t *high)
{
    const int32_t middle = (int32_t)(d - side / 2), room = (int32_t)(side / 2);
    const int32_t a = clamp_side(room, (int64_t)middle - half),
                  b = clamp_side(room, (int64_t)middle + half);

    *low = (uint32_t)(a + room);
    *high = (uint32_t)(b + room) < side ? (uint32_t)(b + room) : side - 1;
    return (int64_t)middle - half <= room && (int64_t)middle + half >= -room;
}

/* Returns the squared distance of the box's nearest or farthest point from the window's
 * middle; the margin covers the rounding of tp_foam_window_weight, two units of 1/256
 * cell. */
static uint64_t square_of_distance(const tp_shade_foam *f, const tp_foam_box *box, int sign)
{
    const int64_t margin = f->side / f->cells / 64 + 4;
    const int64_t x = (int32_t)(box->ds - f->side / 2), z = (int32_t)(box->dt - f->side / 2);
    const int64_t dx = (x < 0 ? -x : x) + sign * (box->half_s + margin),
                  dz = (z < 0 ? -z : z) + sign * (box->half_t + margin);

    return (uint64_t)(dx > 0 ? dx * dx : 0) + (uint64_t)(dz > 0 ? dz * dz : 0);
}

/* Returns the kind of a box where foam goes on beyond the window. */
static tp_foam_block_kind classify_by_distance(const tp_shade_foam *f,
                                               const tp_foam_box *box)
{
    const uint64_t square = (uint64_t)(f->side / 2) * (f->side / 2);

    if (square_of_distance(f, box, 1) <= square / 16 * 9)
        return TP_FOAM_BLOCK_INSIDE;
    return square_of_distance(f, box, -1) > square ? TP_FOAM_BLOCK_OUTSIDE
                                                   : TP_FOAM_BLOCK_MIXED;
}

tp_foam_block_kind tp_foam_box_classify(const tp_shade_foam *f, const tp_foam_box *box)
{
    const bool far = f->far_fresh || f->floor;
    const tp_foam_block_kind kind =
        far && f->edge != UINT32_MAX ? classify_by_distance(f, box) : TP_FOAM_BLOCK_MIXED;
    uint32_t s[2], t[2];

    if (kind == TP_FOAM_BLOCK_OUTSIDE || (far && kind == TP_FOAM_BLOCK_MIXED))
        return kind;
    if (!clip_range(f->side, box->ds, box->half_s, &s[0], &s[1])
        || !clip_range(f->side, box->dt, box->half_t, &t[0], &t[1]))
        return TP_FOAM_BLOCK_EMPTY;
    const uint32_t u[2] = { tp_foam_cells(f, s[0]), tp_foam_cells(f, s[1]) };
    const uint32_t w[2] = { tp_foam_cells(f, t[0]), tp_foam_cells(f, t[1]) };
    return tp_foam_is_range_empty(f, u, w) ? TP_FOAM_BLOCK_EMPTY : kind;
}

/* The samples lie within the largest distance from the first, rounded up to all ones. */
tp_foam_block_kind tp_foam_block_classify(const tp_shade_foam *f, const tp_run *run,
                                          int32_t i, int32_t stop)
{
    const uint32_t s = run->s[i], t = run->t[i];
    uint32_t far_s = 0, far_t = 0;

    for (i++; i < stop; i++) {
        const int32_t ds = (int32_t)(run->s[i] - s), dt = (int32_t)(run->t[i] - t);
        far_s |= (uint32_t)(ds ^ ds >> 31);
        far_t |= (uint32_t)(dt ^ dt >> 31);
    }
    const tp_foam_box box = { s - (uint32_t)f->low_s, t - (uint32_t)f->low_t, far_s + 1,
                              far_t + 1 };
    return (far_s | far_t) >> 29 ? TP_FOAM_BLOCK_MIXED : tp_foam_box_classify(f, &box);
}
