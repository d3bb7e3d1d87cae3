/* SPDX-License-Identifier: MIT */
/* The water's grid; see the header for the idea. */
#include "geom/grid.h"
#include "wave/wave.h"

void tp_grid_carve(tp_grid *grid, tp_arena *arena, uint32_t cols, uint32_t rows)
{
    grid->cols = cols;
    grid->rows = rows;
    grid->blocks = (cols - 2) / TP_GRID_BLOCK + 1;
    grid->column = tp_arena_take(arena, cols, sizeof *grid->column);
    grid->row = tp_arena_take(arena, rows, sizeof *grid->row);
    grid->vertex = tp_arena_take(arena, (size_t)cols * rows, sizeof *grid->vertex);
    grid->span = tp_arena_take(arena, rows - 1, sizeof *grid->span);
    grid->box = tp_arena_take(arena, (size_t)(rows - 1) * grid->blocks,
                              sizeof *grid->box);
}

/* -- lines --------------------------------------------------------------------------- */

/* cell (g + g^2 + ... + g^n), saturated. */
static int64_t series(tp_fx cell, int64_t ratio, uint32_t n)
{
    int64_t step = cell, sum = 0;

    for (uint32_t i = 0; i < n && sum < (int64_t)1 << 40; i++) {
        step = step * ratio >> 16;
        sum += step;
    }
    return sum;
}

/* The ratio, 16.16, that takes n growing steps over `way`; at least 1. */
static int64_t ratio_over(tp_fx cell, int64_t way, uint32_t n)
{
    int64_t low = TP_FX_ONE, high = 256 * TP_FX_ONE;

    while (high - low > 1) {
        int64_t middle = (low + high) / 2;
        if (series(cell, middle, n) <= way)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* 3x^2 - 2x^3 of x in 16.16, clamped to 0..1. */
static tp_fx smoothstep(tp_fx x)
{
    x = tp_clamp(x, 0, TP_FX_ONE);
    return tp_fx_mul(tp_fx_mul(x, x), 3 * TP_FX_ONE - 2 * x);
}

/* `count` lines around `centre`: even ones in the middle, growing ones outside.  The
 * waves are gone at the middle's last line, so that the flanks are flat. */
static void lay_lines(tp_grid_line *line, uint32_t count, tp_fx centre,
                      const tp_grid_view *view)
{
    uint32_t flank = view->reach > 0 ? count / 8 : 0;
    if (flank > TP_GRID_FLANK)
        flank = TP_GRID_FLANK;
    uint32_t core = count - 2 * flank, last = flank + core - 1;
    tp_fx half = (tp_fx)((int64_t)view->cell * (core - 1) / 2);
    int64_t most = 16000 * TP_FX_ONE - half;
    int64_t way = view->reach < most ? view->reach : most;
    int64_t ratio = flank ? ratio_over(view->cell, way, flank) : 0;
    int64_t step = view->cell;
    uint32_t fading = flank ? core / 8 + 1 : 0;

    for (uint32_t k = flank; k <= last; k++) {
        uint32_t from_edge = k - flank < last - k ? k - flank : last - k;
        line[k].place = centre - half + (tp_fx)(k - flank) * view->cell;
        line[k].fade = fading == 0 ? TP_FX_ONE
                     : smoothstep((tp_fx)((from_edge << 16) / fading));
    }
    for (uint32_t k = 1; k <= flank; k++) {
        step = step * ratio >> 16;
        line[last + k].place = line[last + k - 1].place + (tp_fx)step;
        line[flank - k].place = line[flank - k + 1].place - (tp_fx)step;
        line[last + k].fade = line[flank - k].fade = 0;
    }
}

static void set_turns(tp_grid_line *line, uint32_t count, const tp_grid_view *view,
                      bool rows)
{
    for (uint32_t w = 0; w < view->sea->count; w++) {
        const tp_swell *swell = &view->sea->swell[w];
        int64_t per_metre = rows ? swell->turns_z : swell->turns_x;
        tp_turn phase = rows ? view->phases[w] : 0;
        for (uint32_t k = 0; k < count; k++)
            line[k].turns[w] = phase + tp_swell_turns(per_metre, line[k].place);
    }
}

/* The grid lies ahead of the eye, which stands a tenth of the middle from its rear
 * edge; rounded to whole cells. */
static tp_fx centre_of(tp_fx eye, tp_q30 ahead, uint32_t count, const tp_grid_view *view)
{
    if (!view->follow)
        return 0;
    int64_t core = (int64_t)view->cell * (count - 2 * (count / 8)) * 2 / 5;
    int64_t centre = eye + (core * ahead >> 30);
    int64_t cells = centre / view->cell;
    return (tp_fx)(cells * view->cell);
}

/* -- what may be seen ---------------------------------------------------------------- */

/* n.x of a plane over the box of a row of cells, at its most: at place x it is
 * n.x x + rest.  The crossings lie within `reach` of their places, all ways. */
static int64_t plane_rest(const tp_plane *p, tp_fx z0, tp_fx z1, tp_fx reach)
{
    tp_fx z = p->n.z > 0 ? z1 : z0;
    return ((int64_t)p->n.z * z >> 30) + p->d + reach + 2;
}

/* Cells of row j that touch the view: first and end narrowed plane by plane. */
static tp_grid_span seen_cells(const tp_grid *grid, const tp_plane *planes, uint32_t j,
                               tp_fx reach)
{
    uint32_t first = 0, end = grid->cols - 1;

    for (int k = 0; k < TP_LENS_PLANES; k++) {
        int64_t nx = planes[k].n.x;
        int64_t rest = plane_rest(&planes[k], grid->row[j].place,
                                  grid->row[j + 1].place, reach);
        if (nx > 0) {
            while (first < end && (nx * grid->column[first + 1].place >> 30) + rest < 0)
                first++;
        } else {
            while (first < end && (nx * grid->column[end - 1].place >> 30) + rest < 0)
                end--;
        }
    }
    return (tp_grid_span){ (uint16_t)first, (uint16_t)end };
}

/* -- crossings ----------------------------------------------------------------------- */

TP_ALWAYS_INLINE tp_sea_point point_at(const tp_grid_view *view,
                                       const tp_grid_line *column,
                                       const tp_grid_line *row)
{
    tp_fx fade = tp_fx_mul(column->fade, row->fade);
    tp_sea_sum sum = { 0 };

    if (fade == 0)
        return (tp_sea_point){ .position = { column->place, 0, row->place } };
    for (uint32_t w = 0; w < view->sea->count; w++)
        tp_swell_add(&sum, &view->sea->swell[w], column->turns[w] + row->turns[w]);
    return tp_sea_sum_point(&sum, column->place, row->place, fade);
}

static int16_t slope_q12(tp_fx slope)
{
    return (int16_t)((slope + 8) >> 4);         /* +-7.99 */
}

TP_ALWAYS_INLINE tp_view_corner corner_at(const tp_grid_view *view,
                                          const tp_grid_line *column,
                                          const tp_grid_line *row)
{
    tp_sea_point p = point_at(view, column, row);
    tp_view_corner c;

    tp_lens_view(view->lens, p.position, &c);
    c.s = column->place;
    c.t = row->place;
    c.n[0] = slope_q12(p.slope_x);
    c.n[1] = slope_q12(p.slope_z);
    c.n[2] = 0;
    return c;
}

tp_view_corner tp_grid_corner(const tp_grid *grid, const tp_grid_view *view,
                              uint32_t i, uint32_t j)
{
    return corner_at(view, &grid->column[i], &grid->row[j]);
}

static void place_row(tp_grid *grid, const tp_grid_view *view, uint32_t j,
                      uint32_t first, uint32_t end)
{
    tp_grid_vertex *vertex = grid->vertex + (size_t)j * grid->cols;

    for (uint32_t i = first; i < end; i++) {
        tp_view_corner c = corner_at(view, &grid->column[i], &grid->row[j]);
        tp_grid_vertex *to = &vertex[i];
        to->slope_x = c.n[0];
        to->slope_z = c.n[1];
        if (tp_lens_holds(view->lens, &c))
            tp_lens_project(view->lens, &c, &to->u, &to->v, &to->zi);
        else
            to->u = TP_GRID_CUT;
    }
    grid->vertices += end > first ? end - first : 0;
}

/* -- boxes --------------------------------------------------------------------------- */

static const tp_grid_box everywhere = { INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX };

static tp_grid_box box_of(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end)
{
    int32_t u0 = INT32_MAX, u1 = INT32_MIN, v0 = INT32_MAX, v1 = INT32_MIN;

    for (uint32_t k = 0; k < 2; k++) {
        const tp_grid_vertex *vertex = grid->vertex + (size_t)(j + k) * grid->cols;
        for (uint32_t i = first; i <= end; i++) {
            int32_t u = vertex[i].u, v = vertex[i].v;
            if (u == TP_GRID_CUT)
                return everywhere;
            u0 = u < u0 ? u : u0;
            u1 = u > u1 ? u : u1;
            v0 = v < v0 ? v : v0;
            v1 = v > v1 ? v : v1;
        }
    }
    return (tp_grid_box){ (int16_t)(u0 >> 4), (int16_t)(v0 >> 4),
                          (int16_t)(u1 >> 4), (int16_t)(v1 >> 4) };
}

static void place_boxes(tp_grid *grid, uint32_t j)
{
    tp_grid_span span = grid->span[j];

    for (uint32_t b = 0; b < grid->blocks; b++) {
        uint32_t first = b * TP_GRID_BLOCK, end = first + TP_GRID_BLOCK;
        first = first > span.first ? first : span.first;
        end = end < span.end ? end : span.end;
        if (first < end)
            grid->box[j * grid->blocks + b] = box_of(grid, j, first, end);
    }
}

void tp_grid_place(tp_grid *grid, const tp_grid_view *view)
{
    tp_plane planes[TP_LENS_PLANES];
    tp_fx reach = view->sea->height + view->sea->reach;
    tp_grid_span none = { 0, 0 };

    lay_lines(grid->column, grid->cols,
              centre_of(view->lens->eye.x, view->lens->ahead.x, grid->cols, view), view);
    lay_lines(grid->row, grid->rows,
              centre_of(view->lens->eye.z, view->lens->ahead.z, grid->rows, view), view);
    set_turns(grid->column, grid->cols, view, false);
    set_turns(grid->row, grid->rows, view, true);
    tp_lens_planes(view->lens, view->width, view->height, planes);

    grid->vertices = 0;
    for (uint32_t j = 0; j + 1 < grid->rows; j++)
        grid->span[j] = seen_cells(grid, planes, j, reach);
    for (uint32_t j = 0; j < grid->rows; j++) {
        tp_grid_span above = j > 0 ? grid->span[j - 1] : none;
        tp_grid_span below = j + 1 < grid->rows ? grid->span[j] : none;
        uint32_t first = grid->cols, end = 0;
        if (above.first < above.end) {
            first = above.first;
            end = above.end + 1u;
        }
        if (below.first < below.end) {
            first = below.first < first ? below.first : first;
            end = below.end + 1u > end ? below.end + 1u : end;
        }
        place_row(grid, view, j, first, end);
        if (j > 0)
            place_boxes(grid, j - 1);
    }
}
