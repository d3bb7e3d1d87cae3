/* SPDX-License-Identifier: MIT */
/*
 * The fast stage of the visible gradient, quality.sky=fast.  The height of the view vector
 * is looked up at every 32nd column and linear between; four columns share the colour in
 * their middle.  Columns are counted from the picture's left edge.
 */
#include "base/word_pairs.h"
#include "shade/shade.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

#define KNOTS 32                /* columns between two heights */

/* The heights of a row.  y: height of the ray at the middle column for focal length 1, Q14;
 * turn: its rise over a focal length to the right, Q14; square: squared distance of the row
 * from the middle row, Q24. */
typedef struct {
    int32_t  y, turn;
    uint32_t square;
} height_row;

/* Colours of the columns of a block.  A sine is Q20, in the middle of four columns. */
typedef struct {
    const uint32_t *sky;
    int32_t sine, step;         /* of the first four; change over four columns */
} colour_way;

static height_row height_row_make(const tp_shade *shade, int32_t y)
{
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, y);

    return (height_row){ -row.y, shade->world.right.y >> 16, row.square };
}

/* Returns the sine of the elevation of a column's ray, Q14, the y of tp_quick_ray negated.
 * Its roundings and those of the root add less than 32 to 16384: the sky's entries end
 * at 16384 + 63. */
TP_ALWAYS_INLINE int32_t height_sine(const tp_shade *shade, const height_row *row,
                                     int32_t x)
{
    const int32_t u = tp_quick_over_focal(shade, 16 * x + 8 - shade->u0);
    const int32_t unit = tp_rsqrt_one_plus(row->square + ((uint32_t)u * (uint32_t)u >> 4));

    return (row->y + (u * row->turn >> 14)) * unit >> 14;
}

TP_ALWAYS_INLINE uint32_t way_colour(const colour_way *way, int32_t sine)
{
    return way->sky[tp_usat(sine, 12, 9)];
}

/* Fills columns [k, end) of a block. */
TP_NEVER_INLINE void fill_part(const colour_way *way, uint32_t *to, int32_t k, int32_t end)
{
    for (; k < end; k++)
        *to++ = way_colour(way, way->sine + (k >> 2) * way->step);
}

/* Fills a block.  Most blocks have one colour. */
TP_ALWAYS_INLINE void fill_whole(const colour_way *way, uint32_t *to)
{
    const int32_t last = way->sine + (KNOTS / 4 - 1) * way->step;
    int32_t sine = way->sine;

    for (const uint32_t *end = to + KNOTS; to < end; sine += way->step) {
        const uint32_t colour = way_colour(way, sine);
        if (tp_usat(sine, 12, 9) == tp_usat(last, 12, 9)) {
            while (to < end) {
                tp_store_next_pair(&to, colour, colour);
                tp_store_next_pair(&to, colour, colour);
            }
            return;
        }
        tp_store_next_pair(&to, colour, colour);
        tp_store_next_pair(&to, colour, colour);
    }
}

void tp_stage_sky_fast(const tp_shade *shade, tp_run *run)
{
    const height_row row = height_row_make(shade, run->y);
    const int32_t first = run->x & -KNOTS, stop = run->x + run->count;
    int32_t a = height_sine(shade, &row, first);

    for (int32_t x = first; x < stop; x += KNOTS) {
        const int32_t b = height_sine(shade, &row, x + KNOTS);
        const int32_t k = x < run->x ? run->x - x : 0;
        const int32_t end = stop - x < KNOTS ? stop - x : KNOTS;
        const colour_way way = { shade->sky, 64 * a + 3 * (b - a), 8 * (b - a) };
        uint32_t *to = run->colour + (x + k - run->x);
        if (end - k == KNOTS)
            fill_whole(&way, to);
        else
            fill_part(&way, to, k, end);
        a = b;
    }
}
