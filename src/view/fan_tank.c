/* SPDX-License-Identifier: MIT */
/*
 * The rows of a tank, whose water ends at its walls: cells of equal size over the tank's
 * rectangle.
 *
 * Rows lie along x or z, whichever is nearer to across the heading, so rows and columns
 * cover the rectangle exactly from every camera, corners included, and the ends of rows
 * and columns are the water's edge at walls of glass.  Vertices keep their places in the
 * world when the camera moves; a turn past 45 degrees swaps rows and columns.  The pool's
 * cells have one size as well, and a tank is small against its distance from the eye, so
 * rows by distance would save little.
 */
#include "view/fan.h"

/* Returns the vertices along a side for square cells: sqrt(vertices side / other). */
static uint32_t side_vertices(int64_t side, int64_t other, uint32_t vertices)
{
    const uint64_t share = ((uint64_t)side << 8) / (uint64_t)(other > 0 ? other : 1);
    const uint64_t most = tp_fan_most_cols(vertices);
    const uint64_t count =
        share < 1 << 16 ? tp_isqrt64(((uint64_t)vertices * share) << 8) >> 8 : most;

    return (uint32_t)(count < 2 ? 2 : count < most ? count : most);
}

static tp_fan_law tank_law(const tp_fan_view *view, uint32_t vertices)
{
    const tp_rectangle *r = &view->sides;
    const int64_t wide = (int64_t)r->x1 - r->x0, deep = (int64_t)r->z1 - r->z0;
    tp_fan_law law = { .right = tp_fan_rows_direction(&view->projection->turn, true),
                       .height = TP_FX_ONE, .waves_end = TP_FX_MAX, .walls = &tp_fan_tank };
    const bool along_x = law.right.x != 0;
    const uint32_t x = side_vertices(wide, deep, vertices);
    const uint32_t z = side_vertices(deep, wide, vertices);

    law.cols = along_x ? x : z;
    law.rows = along_x ? z : x;
    return law;
}

/* Returns low or high, by a sign. */
static tp_fx end_by_sign(tp_fx low, tp_fx high, tp_q30 sign)
{
    return sign > 0 ? high : low;
}

static tp_fx tank_end(const tp_fan_law *law, const tp_fan_view *view)
{
    const tp_rectangle *r = &view->sides;

    return law->right.x != 0 ? end_by_sign(r->x0, r->x1, law->right.x)
                             : end_by_sign(r->z0, r->z1, law->right.z);
}

static tp_fan_row tank_row(const tp_fan_law *law, const tp_fan_view *view, uint32_t n)
{
    TP_ASSERT(n < law->rows && law->cols > 1 && law->rows > 1);
    const tp_rectangle *r = &view->sides;
    const int64_t wide = (int64_t)r->x1 - r->x0, deep = (int64_t)r->z1 - r->z0;
    const int64_t gaps = (int64_t)law->cols - 1, cells = (int64_t)law->rows - 1;
    const tp_q30 x = law->right.x, z = law->right.z;
    tp_fan_row row = { .x = end_by_sign(r->x1, r->x0, x), .z = end_by_sign(r->z1, r->z0, z) };

    if (x != 0) {               /* rows follow each other along -x of `right` in z */
        const int64_t at = deep * n / cells;
        row.z = (tp_fx)(x > 0 ? r->z1 - at : r->z0 + at);
        row.step_x = (tp_fx)((x > 0 ? wide : -wide) / gaps);
        row.across = (tp_fx)(wide / gaps);
        row.along = (tp_fx)(deep / cells);
    } else {
        const int64_t at = wide * n / cells;
        row.x = (tp_fx)(z > 0 ? r->x0 + at : r->x1 - at);
        row.step_z = (tp_fx)((z > 0 ? deep : -deep) / gaps);
        row.across = (tp_fx)(deep / gaps);
        row.along = (tp_fx)(wide / cells);
    }
    return row;
}

const struct tp_fan_walls tp_fan_tank = { tank_law, tank_row, tank_end };
