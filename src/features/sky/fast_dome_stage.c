/* SPDX-License-Identifier: MIT */
/*
 * Fast stages of the visible dome: the colour is looked up at every 16th or 32nd column and
 * linear between.  Columns are counted from the picture's left edge.
 *
 *     quick_sky_dome     without stars and without light above white; the quality plan
 *                        chooses it with fast water
 *     sky_dome_fast      quality.sky=fast; near the sun the glow is looked up at each
 *                        column
 */
#include "features/sky/sky.h"
#include "shade/env.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

#if TP_DSP
#define FILL tp_gradient_fill_packed
#else
#define FILL tp_gradient_fill_scalar
#endif

/* -- the dome of the quality plan ---------------------------------------------------- */

#define CLOSE (1u << 23)        /* square of 10 degrees: beyond it the glow is smooth */

static uint32_t sample_dome(const tp_shade *shade, tp_ray v)
{
    return tp_env_dome(shade, 0, -v.x, -v.y, -v.z) & 0x00ffffff;
}

static bool is_near_sun(const tp_shade *shade, tp_ray v)
{
    return tp_square_length(v.x + shade->world.lx, v.y + shade->world.ly,
                        v.z + shade->world.lz) < CLOSE;
}

/* Looks up columns [k, end) of the 16 columns from ray a to ray b. */
static void sample_dome_columns(const tp_shade *shade, uint32_t *colour, tp_ray a,
                                tp_ray b, int32_t k, int32_t end)
{
    for (; k < end; k++) {
        tp_ray v = { a.x + ((b.x - a.x) * k >> 4), a.y + ((b.y - a.y) * k >> 4),
                     a.z + ((b.z - a.z) * k >> 4), 0 };
        *colour++ = sample_dome(shade, v);
    }
}

void tp_stage_quick_sky_dome(const tp_shade *shade, tp_run *run)
{
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    int32_t  x = run->x, end = run->x + run->count;
    tp_ray   a = tp_quick_ray(shade, &row, 16 * (x & ~15) + 8);
    uint32_t here = sample_dome(shade, a);

    while (x < end) {
        int32_t  from = x & ~15, stop = from + 16 < end ? from + 16 : end;
        tp_ray   b = tp_quick_ray(shade, &row, 16 * from + 16 * 16 + 8);
        uint32_t there = sample_dome(shade, b), *colour = run->colour + (x - run->x);
        if (is_near_sun(shade, a) || is_near_sun(shade, b))
            sample_dome_columns(shade, colour, a, b, x - from, stop - from);
        else
            FILL(colour, tp_quick_shade_make(here, there), x - from, stop - from);
        x = stop;
        a = b;
        here = there;
    }
}

/* -- the fast rung ------------------------------------------------------------------- */

/* Squared chords: beyond 8.8 degrees the glow is linear over 16 columns, within 2 levels;
 * beyond 14 degrees over 32 columns. */
#define NEAR (3u << 21)
#define WIDE (1u << 24)

/* A view ray at a column, and the dome's colour there. */
typedef struct {
    tp_ray   to;
    uint32_t square, colour;
} dome_knot;

TP_ALWAYS_INLINE tp_ray unit_ray(const tp_shade *shade, const tp_quick_ray_row *row,
                                 int32_t x)
{
    tp_ray v = tp_quick_ray_inline(shade, row, 16 * x + 8);
    return (tp_ray){ -v.x, -v.y, -v.z, 0 };
}

static dome_knot make_dome_knot(const tp_shade *shade, const tp_quick_ray_row *row,
                                int32_t x)
{
    const tp_dome *dome = shade->env.dome;
    tp_ray   to = unit_ray(shade, row, x);
    uint32_t square = tp_light_chord_square(shade, to.x, to.y, to.z);
    uint32_t glow = tp_dome_lookup_glow(dome, 0, square);

    return (dome_knot){ to, square, tp_dome_colour(dome, square, to.y, glow) };
}

/* Returns the square of 32 columns over the focal length, Q28: the largest squared chord
 * between two knots. */
static uint32_t knot_distance_square(const tp_shade *shade)
{
    uint32_t step = (uint32_t)tp_quick_over_focal(shade, 16 * 32);
    return step < 16384 ? step * step : 1u << 28;
}

/* Adds the glow to columns [k, end) of the block at column x; the sun's disc has light
 * above white.  The squared chord is a parabola through three rays: the error of the
 * divisions is below 2^8, that of the rays 2^12, where the disc's edge is 2^15 wide. */
static void add_glow(const tp_shade *shade, uint32_t *colour, uint32_t first, uint32_t middle,
                     uint32_t last, int32_t k, int32_t end)
{
    const tp_dome *dome = shade->env.dome;
    const int32_t twice = (int32_t)(first + last - 2 * middle);
    const int32_t bow = twice >> 7;
    const int32_t slope = ((int32_t)(last - first) >> 4) - (twice >> 3);
    int32_t square = (int32_t)first + (slope + bow * k) * k;
    int32_t step = slope + bow * (2 * k + 1);

    for (; k < end; k++, square += step, step += 2 * bow) {
        uint32_t glow = tp_dome_lookup_glow(dome, 0, square > 0 ? (uint32_t)square : 0);
        uint32_t sum = tp_colour_add(*colour, glow);
        *colour++ = glow >> 24 ? tp_light_colour_clamped(shade, sum | (glow & 0xff000000u))
                               : sum;
    }
}

/* Shades columns [k, end) of the block at column x, near the sun. */
static void shade_near_sun(const tp_shade *shade, const tp_quick_ray_row *row,
                           uint32_t *colour, const dome_knot knot[2], int32_t x, int32_t k,
                           int32_t end)
{
    const tp_dome *dome = shade->env.dome;

    if (knot[0].to.y < 0 || knot[1].to.y < 0) {         /* the dark sky below */
        for (; k < end; k++) {
            tp_ray   to = unit_ray(shade, row, x + k);
            uint32_t light = tp_env_dome(shade, 0, to.x, to.y, to.z);
            *colour++ = tp_light_colour_clamped(shade, light);
        }
        return;
    }
    tp_ray middle = unit_ray(shade, row, x + 8);
    FILL(colour, tp_quick_shade_make(
                     tp_dome_colour(dome, knot[0].square, knot[0].to.y, 0),
                     tp_dome_colour(dome, knot[1].square, knot[1].to.y, 0)), k, end);
    add_glow(shade, colour, knot[0].square,
             tp_light_chord_square(shade, middle.x, middle.y, middle.z), knot[1].square, k,
             end);
}

/* Shades columns [k, end) of the 16 between two knots; `to` is column k. */
static void shade_16_columns(const tp_shade *shade, const tp_quick_ray_row *row, uint32_t *to,
                             const dome_knot knot[2], int32_t x, int32_t k, int32_t end)
{
    const uint32_t near = NEAR + knot_distance_square(shade) / 4;

    if (k >= end)
        return;
    if (knot[0].square < near || knot[1].square < near)
        shade_near_sun(shade, row, to, knot, x, k, end);
    else
        FILL(to, tp_quick_shade_make(knot[0].colour, knot[1].colour), k, end);
}

/* Shades columns [k, end) of the 32 between two knots, with a knot in the middle. */
static void shade_halves(const tp_shade *shade, const tp_quick_ray_row *row, uint32_t *to,
                         const dome_knot *a, const dome_knot *b, int32_t x, int32_t k,
                         int32_t end)
{
    const dome_knot knot[3] = { *a, make_dome_knot(shade, row, x + 16), *b };
    const int32_t right = k > 16 ? k : 16;

    shade_16_columns(shade, row, to, knot, x, k, end < 16 ? end : 16);
    shade_16_columns(shade, row, to + (right - k), knot + 1, x + 16, right - 16, end - 16);
}

void tp_stage_sky_dome_fast(const tp_shade *shade, tp_run *run)
{
    TP_ASSERT(shade->env.dome != NULL);
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    const uint32_t wide = WIDE + knot_distance_square(shade);
    const int32_t  stop = run->x + run->count;
    dome_knot knot[2];
    uint32_t *to = run->colour;

    knot[1] = make_dome_knot(shade, &row, run->x & ~31);
    for (int32_t x = run->x & ~31; x < stop; x += 32) {
        int32_t k = x < run->x ? run->x - x : 0, end = stop - x < 32 ? stop - x : 32;
        knot[0] = knot[1];
        knot[1] = make_dome_knot(shade, &row, x + 32);
        if (knot[0].square < wide || knot[1].square < wide)
            shade_halves(shade, &row, to, &knot[0], &knot[1], x, k, end);
        else
            FILL(to, tp_quick_shade_make_long(knot[0].colour, knot[1].colour, 5), k, end);
        to += end - k;
    }
}
