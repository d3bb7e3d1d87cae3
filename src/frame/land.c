/* SPDX-License-Identifier: MIT */
/* The land that a sea floor becomes where it rises near the water's level or above it:
 * triangles over the same lines as the water's, drawn before it.  What lies deeper than
 * any trough is never seen through this water and is left out. */
#include "base/base.h"
#include "frame/frame.h"

/* Land as high or deep as this is as far as 16.16 tells from an eye 8 km up. */
#define HEIGHT_MOST (24000 * TP_FX_ONE)

static tp_land_vertex *vertex_at(const tp_frame *frame, uint32_t i, uint32_t j)
{
    return frame->parts.land_vertex + (size_t)j * frame->parts.grid->cols + i;
}

static tp_view_corner corner_at(const tp_frame *frame, uint32_t i, uint32_t j,
                                tp_floor_at *floor)
{
    tp_fx x = frame->parts.grid->column[i].place, z = frame->parts.grid->row[j].place;
    tp_view_corner c;

    *floor = tp_ocean_floor(frame->surface.ocean, x, z);
    tp_fx y = (tp_fx)tp_limit(-(int64_t)floor->depth, HEIGHT_MOST);
    tp_lens_view(&frame->lens, (tp_vec3){ x, y, z }, &c);
    c.s = c.t = 0;
    return c;
}

/* Up, less the slopes; of any length below 512. */
static void set_normal(int16_t n[3], tp_fx rise_x, tp_fx rise_z)
{
    tp_fx most = TP_FX_ONE + tp_abs(rise_x) + tp_abs(rise_z);

    n[0] = (int16_t)(-(int64_t)rise_x * 511 / most);
    n[1] = (int16_t)((int64_t)TP_FX_ONE * 511 / most);
    n[2] = (int16_t)(-(int64_t)rise_z * 511 / most);
}

static void place_corner(tp_frame *frame, uint32_t i, uint32_t j, tp_fx deepest)
{
    TP_ASSERT(i < frame->parts.grid->cols && j < frame->parts.grid->rows);
    tp_land_vertex *to = vertex_at(frame, i, j);
    tp_floor_at floor;
    tp_view_corner c = corner_at(frame, i, j, &floor);

    set_normal(to->n, floor.rise_x, floor.rise_z);
    to->out = (int16_t)((floor.depth > deepest ? TP_LAND_DEEP : 0)
                        | (c.depth < frame->lens.near ? TP_LAND_BEHIND : 0));
    if (tp_lens_holds(&frame->lens, &c))
        tp_lens_project(&frame->lens, &c, &to->u, &to->v, &to->zi);
    else
        to->u = TP_GRID_CUT;
}

/* A cell whose corners are all deep, or all behind the eye; one with some is drawn. */
static bool is_out(const tp_land_vertex *const p[4])
{
    return (p[0]->out & p[1]->out & p[2]->out & p[3]->out) != 0;
}

static bool is_cut(const tp_land_vertex *const p[4])
{
    return p[0]->u == TP_GRID_CUT || p[1]->u == TP_GRID_CUT || p[2]->u == TP_GRID_CUT
        || p[3]->u == TP_GRID_CUT;
}

/* The rows of pixels that a row of cells may touch; none: y0 > y1. */
static void place_band(tp_frame *frame, uint32_t j)
{
    const tp_land_vertex *at = vertex_at(frame, 0, j);
    tp_land_band band = { INT32_MAX, INT32_MIN };

    for (uint32_t i = 0; i + 1 < frame->parts.grid->cols; i++) {
        const tp_land_vertex *below = at + i + frame->parts.grid->cols;
        const tp_land_vertex *const p[4] = { at + i, at + i + 1, below, below + 1 };
        bool cut = is_cut(p);
        for (int k = 0; k < 4 && !is_out(p); k++) {
            int32_t low = cut ? INT32_MIN : p[k]->v >> 4;
            int32_t high = cut ? INT32_MAX : p[k]->v >> 4;
            band.y0 = low < band.y0 ? low : band.y0;
            band.y1 = high > band.y1 ? high : band.y1;
        }
    }
    frame->parts.land_band[j] = band;
}

static void place_land(tp_frame *frame)
{
    const tp_grid *grid = frame->parts.grid;
    tp_fx deepest = tp_surface_height(&frame->surface) + TP_FX_ONE;

    for (uint32_t j = 0; j < grid->rows; j++) {
        for (uint32_t i = 0; i < grid->cols; i++)
            place_corner(frame, i, j, deepest);
        if (j > 0)
            place_band(frame, j - 1);
    }
}

/* -- drawing ------------------------------------------------------------------------ */

static tp_corner packed(const tp_land_vertex *v)
{
    return (tp_corner){ .u = v->u, .v = v->v, .zi = v->zi,
                        .n = { v->n[0], v->n[1], v->n[2] } };
}

static void draw_clipped(const tp_frame *frame, const tp_samples *tile,
                         const uint32_t place[3][2])
{
    tp_view_corner in[3];
    tp_floor_at floor;

    for (int k = 0; k < 3; k++) {
        in[k] = corner_at(frame, place[k][0], place[k][1], &floor);
        set_normal(in[k].n, floor.rise_x, floor.rise_z);
    }
    tp_clipped_draw(&frame->lens, NULL, tile, in, TP_MARK_LAND, 0);
}

static void draw_cell(const tp_frame *frame, const tp_samples *tile, uint32_t i, uint32_t j)
{
    const tp_land_vertex *a = vertex_at(frame, i, j);
    const tp_land_vertex *b = a + 1, *d = a + frame->parts.grid->cols, *c = d + 1;

    const tp_land_vertex *const all[4] = { a, b, c, d };

    if (is_out(all))
        return;
    if (is_cut(all)) {
        const uint32_t first[3][2] = { { i, j }, { i, j + 1 }, { i + 1, j + 1 } };
        const uint32_t second[3][2] = { { i, j }, { i + 1, j + 1 }, { i + 1, j } };
        draw_clipped(frame, tile, first);
        draw_clipped(frame, tile, second);
        return;
    }
    tp_corner p[4] = { packed(a), packed(b), packed(c), packed(d) };
    tp_tri_solid(tile, &p[0], &p[3], &p[2], TP_MARK_LAND, 0, 16);
    tp_tri_solid(tile, &p[0], &p[2], &p[1], TP_MARK_LAND, 0, 16);
}

static void draw_land(const tp_frame *frame, tp_samples *tile)
{
    tile->front_only = true;
    for (uint32_t j = 0; j + 1 < frame->parts.grid->rows; j++) {
        const tp_land_band *band = &frame->parts.land_band[j];
        if (band->y0 >= tile->y1 || band->y1 < tile->y0)
            continue;
        for (uint32_t i = 0; i + 1 < frame->parts.grid->cols; i++)
            draw_cell(frame, tile, i, j);
    }
}

const struct tp_draw_land tp_draw_land = {
    place_land, draw_land
};
