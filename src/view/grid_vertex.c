/* SPDX-License-Identifier: MIT */
/* The loops over grid vertices; see the header for the idea. */
#include "view/wave_models.h"

/* -- positions ----------------------------------------------------------------------- */

/* Adds at most three swells along a view axis; three sets of numbers stay in registers.
 * A vertex starts at *from + rest.  Q.18 times Q.30 leaves 16.16 in the upper word,
 * rounded by adding a half below.  A swell moves a point by less than 2^9 m, so a product
 * has 57 bits. */
TP_ALWAYS_INLINE void add_swells(const tp_vertex_sincos *number,
                                 const tp_vertex_sincos *turn,
                                 uint32_t stride, const int32_t *from, int32_t rest,
                                 uint32_t count, int swells, int32_t *to)
{
    const tp_vertex_sincos none = { 0, 0 };
    const tp_vertex_sincos a = number[0], b = swells > 1 ? number[1] : none;
    const tp_vertex_sincos c = swells > 2 ? number[2] : none;
    const int32_t *end = to + count;

    do {
        uint32_t whole = (uint32_t)(*from++ + rest);
        int64_t sum = (int64_t)((uint64_t)whole << 32 | 0x80000000u);
        sum += (int64_t)a.sin * turn[0].sin;
        sum += (int64_t)a.cos * turn[0].cos;
        if (swells > 1) {
            sum += (int64_t)b.sin * turn[1].sin;
            sum += (int64_t)b.cos * turn[1].cos;
        }
        if (swells > 2) {
            sum += (int64_t)c.sin * turn[2].sin;
            sum += (int64_t)c.cos * turn[2].cos;
        }
        *to++ = tp_upper(sum);
        turn += stride;
    } while (to < end);
}

static void add_rest_offset(const int32_t *from, int32_t rest, uint32_t count, int32_t *to)
{
    for (uint32_t i = 0; i < count; i++)
        to[i] = from[i] + rest;
}

/* Converts 18.14 parts to 16.16.  Parts are clamped first: with the displacement of all
 * swells they might not fit 16.16. */
static void convert_18_14_to_16_16(const int32_t *from, int32_t rest, uint32_t count,
                                   int32_t margin, int32_t *to)
{
    const int32_t most = (TP_FX_MAX - margin) / 4;

    for (uint32_t i = 0; i < count; i++)
        to[i] = tp_clamp(from[i] + rest, -most, most) * 4;
}

/* Computes a view axis of a run; `at_rest`: without waves. */
static void compute_view_coordinate(const tp_vertex_batch_input *place, int axis,
                                    bool at_rest, int32_t *to)
{
    const tp_vertex_frame *frame = place->frame;
    const int32_t *from = place->columns->rest[axis] + place->first;
    int32_t rest = place->row->rest[axis];

    if (frame->wide) {
        convert_18_14_to_16_16(from, rest, place->count, frame->margin, to);
        from = to;
        rest = 0;
    } else if (at_rest) {
        add_rest_offset(from, rest, place->count, to);
    }
    if (!at_rest)
        frame->surface->by->swells->displace_axis(place, axis, from, rest, to);
}

void tp_batch_displace_axis(const tp_vertex_batch_input *place, int axis,
                            const int32_t *from, int32_t rest, int32_t *to)
{
    const tp_vertex_sincos *number = place->row->place[axis];
    const tp_vertex_sincos *turn
        = place->columns->turn + (size_t)place->first * place->frame->count;
    uint32_t stride = place->frame->count, left = stride, count = place->count;

    for (; left >= 3; left -= 3, number += 3, turn += 3, from = to, rest = 0)
        add_swells(number, turn, stride, from, rest, count, 3, to);
    if (left == 2)
        add_swells(number, turn, stride, from, rest, count, 2, to);
    else if (left == 1)
        add_swells(number, turn, stride, from, rest, count, 1, to);
}

/* -- slopes -------------------------------------------------------------------------- */

TP_ALWAYS_INLINE void add_slope_terms(tp_jacobian *j, uint32_t pair,
                                      const tp_vertex_tilt *w, bool crossed)
{
    j->hx = tp_add_pair_products(j->hx, pair, w->tilt_x);
    j->hz = tp_add_pair_products(j->hz, pair, w->tilt_z);
    j->jxx = tp_add_pair_products(j->jxx, pair, w->bend_xx);
    if (crossed) {
        j->bxz = tp_add_pair_products(j->bxz, pair, w->bend_xz);
        j->jzz = tp_add_pair_products(j->jzz, pair, w->bend_zz);
    }
}

/* Computes the slopes of a run from `swells` >= 1 swells; a literal 3 needs no inner
 * loop. */
TP_ALWAYS_INLINE void set_run_slopes(const tp_vertex_batch_input *place, uint32_t swells,
                                     bool crossed, tp_grid_vertex *to)
{
    const uint32_t *pair = place->columns->pair + (size_t)place->first * swells;
    const tp_vertex_tilt *tilts = place->row->tilt, *end = tilts + swells;
    int tilt = place->frame->tilt;

    for (uint32_t i = place->count; i > 0; i--, to++) {
        tp_jacobian j = { 0, 0, TP_JACOBIAN_ONE, TP_JACOBIAN_ONE, 0 };
        const tp_vertex_tilt *w = tilts;
        if (swells == 3) {
            add_slope_terms(&j, pair[0], &w[0], crossed);
            add_slope_terms(&j, pair[1], &w[1], crossed);
            add_slope_terms(&j, pair[2], &w[2], crossed);
            pair += 3;
        } else {
            do
                add_slope_terms(&j, *pair++, w, crossed);
            while (++w < end);
        }
        tp_set_slopes(&j, tilt, crossed, to);
    }
}

void tp_batch_set_slopes(const tp_vertex_batch_input *place, tp_grid_vertex *to)
{
    TP_ASSERT(place->frame->count > 0);
    uint32_t swells = place->frame->count;

    if (!place->frame->surface->deep->crossed)
        set_run_slopes(place, swells, false, to);
    else if (swells == 3)
        set_run_slopes(place, 3, true, to);
    else
        set_run_slopes(place, swells, true, to);
}

/* -- projection ---------------------------------------------------------------------- */

static inline int32_t max_int32(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* True if the whole run is inside the projection and far away.  Both undisplaced ends
 * of the run must be, with a margin above any displacement.  Between the ends,
 * positions change in a single direction. */
static bool is_run_far_in_view(const tp_vertex_batch_input *place)
{
    const tp_vertex_frame *frame = place->frame;
    uint32_t first = place->first, last = first + place->count - 1;
    int32_t  end[3][2], most = 0;

    if (frame->wide)
        return false;
    for (int axis = 0; axis < 3; axis++) {
        const int32_t *part = place->columns->rest[axis];
        end[axis][0] = part[first] + place->row->rest[axis];
        end[axis][1] = part[last] + place->row->rest[axis];
    }
    for (int axis = 0; axis < 2; axis++) {
        most = max_int32(most, tp_abs(end[axis][0]));
        most = max_int32(most, tp_abs(end[axis][1]));
    }
    int32_t least = (end[2][0] < end[2][1] ? end[2][0] : end[2][1]) - frame->margin;
    return least >= frame->far
           && (most + frame->margin) >> (TP_GUARD_LOG2 - frame->projection->m) < least;
}

/* Projects the vertices of a run for which is_run_far_in_view is true: no tests. */
static void project_run_far_in_view(const tp_projection *projection,
                                    const tp_vertex_batch *from, uint32_t count,
                                    tp_grid_vertex *to)
{
    const tp_projection local = { .m = projection->m,
                                  .zi_near = projection->zi_near,
                                  .u0 = projection->u0,
                                  .v0 = projection->v0 };
    const int32_t *at = from->at[0];

    for (uint32_t i = count; i > 0; i--, to++, at++)
        tp_projection_project_scaled(&local, at[0], at[TP_VERTEX_BATCH],
                                     at[2 * TP_VERTEX_BATCH], true, &to->u, &to->v,
                                     &to->zi);
}

/* Projects each vertex inside the guard band; marks all others for clipping. */
static void project_or_mark_for_clipping(const tp_projection *projection,
                                         const tp_vertex_batch *from, uint32_t count,
                                         tp_grid_vertex *to)
{
    for (uint32_t i = 0; i < count; i++, to++) {
        const tp_view_vertex c = { .x = from->at[0][i], .y = from->at[1][i],
                                   .depth = from->at[2][i] };
        if (tp_projection_can_project(projection, &c))
            tp_projection_project(projection, &c, &to->u, &to->v, &to->zi);
        else
            to->u = TP_GRID_NEEDS_CLIP;
    }
}

/* -- runs ---------------------------------------------------------------------------- */

/* Computes view coordinates and, if `sloped`, the slopes of `vertex`. */
static void displace_batch(const tp_vertex_batch_input *place, bool sloped,
                           tp_vertex_batch *run, tp_grid_vertex *vertex)
{
    const tp_surface *surface = place->frame->surface;
    bool at_rest = place->at_rest || place->frame->count == 0;
    bool sharpened = surface->deep->sharpened && !at_rest && surface->by->sharp;

    for (int axis = 0; axis < 3; axis++)
        compute_view_coordinate(place, axis, at_rest || sharpened, run->at[axis]);
    if (sharpened) {
        surface->by->sharp->run(place, run, vertex);
    } else if (at_rest) {
        for (uint32_t i = 0; i < place->count; i++)
            vertex[i].slope_x = vertex[i].slope_z = 0;
    } else if (sloped) {
        surface->by->swells->slope(place, vertex);
    }
    if (surface->rings)
        surface->by->rings->run(place, run, vertex);
    else if (tp_surface_has_rings_or_pools(surface))
        surface->by->pools->run(place, run, vertex);
}

void tp_vertex_evaluate_batch(const tp_vertex_frame *frame,
                              const tp_vertex_columns *columns, const tp_vertex_row *row,
                              uint32_t first, uint32_t count, bool at_rest,
                              tp_grid_vertex *vertex)
{
    TP_ASSERT(count > 0 && count <= TP_VERTEX_BATCH);
    const tp_vertex_batch_input place = { frame, columns, row, first, count, at_rest };
    tp_vertex_batch run;

    displace_batch(&place, true, &run, vertex);
    if (is_run_far_in_view(&place))
        project_run_far_in_view(frame->projection, &run, count, vertex);
    else
        project_or_mark_for_clipping(frame->projection, &run, count, vertex);
}

tp_view_vertex tp_vertex_make_view_vertex(const tp_vertex_frame *frame,
                                          const tp_vertex_columns *columns,
                                          const tp_vertex_row *row, uint32_t column,
                                          bool at_rest)
{
    const tp_vertex_batch_input place = { frame, columns, row, column, 1, at_rest };
    tp_grid_vertex vertex = { .slope_x = 0 };
    tp_vertex_batch run;

    displace_batch(&place, false, &run, &vertex);
    return (tp_view_vertex){
        .x = run.at[0][0], .y = run.at[1][0], .depth = run.at[2][0],
        .s = columns->line[column].place, .t = row->line.place,
    };
}
