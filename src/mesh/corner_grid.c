/* SPDX-License-Identifier: MIT */
/* The grid of a polygon's corners: mesh/obj.h.  A corner that was cut off leaves
 * its cell when a walk meets the corner. */
#include "base/base.h"
#include "mesh/obj.h"

enum { CELL_CORNERS = 8, ROW_STEPS = 8 };

uint32_t tp_cut_grid_cells(uint32_t n)
{
    return n / CELL_CORNERS + 1;
}

static uint32_t corner_row(const struct tp_obj_cut *cut, uint32_t corner)
{
    return (uint32_t)cut->v[corner] >> cut->shift;
}

static uint32_t corner_col(const struct tp_obj_cut *cut, uint32_t corner)
{
    return (uint32_t)cut->u[corner] >> cut->shift;
}

static uint32_t *grid_cell(const struct tp_obj_cut *cut, uint32_t row, uint32_t col)
{
    return &cut->cell[row * cut->cols + col];
}

void tp_cut_grid_fill(struct tp_obj_cut *cut, uint32_t n, uint32_t extent_u,
                      uint32_t extent_v)
{
    const uint32_t most = tp_cut_grid_cells(n);
    uint64_t cells;
    cut->shift = 0;
    for (;; cut->shift++) {
        cells = ((uint64_t)(extent_u >> cut->shift) + 1) * ((extent_v >> cut->shift) + 1);
        if (cells <= most)
            break;
    }
    TP_ASSERT(cells <= most);
    cut->cols = (extent_u >> cut->shift) + 1;
    for (uint32_t i = 0; i < cells; i++)
        cut->cell[i] = TP_NO_CORNER;
    for (uint32_t i = n; i-- > 0;) {
        uint32_t *const cell = grid_cell(cut, corner_row(cut, i), corner_col(cut, i));
        TP_ASSERT(cell < cut->cell + cells);
        cut->next[i] = *cell;
        *cell = i;
    }
}

/* -- walks --------------------------------------------------------------------------- */

static void widen(int64_t *low, int64_t *high, int64_t x)
{
    *low = x < *low ? x : *low;
    *high = x > *high ? x : *high;
}

/* Returns u where the edge from p to q crosses the height v between theirs, to within 1.
 * Products are below 2^54. */
static int64_t edge_crossing_u(const struct tp_obj_cut *cut, uint32_t p, uint32_t q,
                               int64_t v)
{
    const int64_t rise = (int64_t)cut->v[q] - cut->v[p];
    const int64_t way = (int64_t)cut->u[q] - cut->u[p];
    return rise == 0 ? cut->u[q] : cut->u[p] + way * (v - cut->v[p]) / rise;
}

/* Finds the extent of the triangle between two heights, from the parts of its
 * edges between them. */
static void find_row_extent(const tp_cut_walk *walk, int64_t bottom, int64_t top,
                            int64_t *low, int64_t *high)
{
    const struct tp_obj_cut *const cut = walk->cut;
    for (int k = 0; k < 3; k++) {
        const uint32_t a = walk->triangle[k], b = walk->triangle[k < 2 ? k + 1 : 0];
        const uint32_t p = cut->v[a] < cut->v[b] ? a : b, q = p == a ? b : a;
        if (cut->v[q] < bottom || cut->v[p] > top)
            continue;
        widen(low, high,
              cut->v[p] > bottom ? cut->u[p] : edge_crossing_u(cut, p, q, bottom));
        widen(low, high, cut->v[q] < top ? cut->u[q] : edge_crossing_u(cut, p, q, top));
    }
}

static void enter_row(tp_cut_walk *walk)
{
    const struct tp_obj_cut *const cut = walk->cut;
    walk->col = walk->low_col;
    walk->last_col = walk->high_col;
    if (walk->low_col < walk->high_col) {
        const int64_t bottom = (int64_t)walk->row << cut->shift;
        int64_t low = INT64_MAX, high = 0;
        find_row_extent(walk, bottom, bottom + ((int64_t)1 << cut->shift), &low, &high);
        const int64_t first = (low - 1) >> cut->shift, last = (high + 1) >> cut->shift;
        walk->col = first > walk->low_col ? (uint32_t)first : walk->low_col;
        walk->last_col = last < walk->high_col ? (uint32_t)last : walk->high_col;
        walk->steps += ROW_STEPS;
    }
}

static void enter_cell(tp_cut_walk *walk)
{
    walk->link = grid_cell(walk->cut, walk->row, walk->col);
    walk->steps++;
}

tp_cut_walk tp_cut_walk_begin(struct tp_obj_cut *cut, const uint32_t triangle[3],
                              uint32_t from)
{
    tp_cut_walk walk = { .cut = cut, .triangle = triangle,
                         .row = UINT32_MAX, .low_col = UINT32_MAX };
    for (int k = 0; k < 3; k++) {
        const uint32_t row = corner_row(cut, triangle[k]),
                       col = corner_col(cut, triangle[k]);
        walk.row = row < walk.row ? row : walk.row;
        walk.last_row = row > walk.last_row ? row : walk.last_row;
        walk.low_col = col < walk.low_col ? col : walk.low_col;
        walk.high_col = col > walk.high_col ? col : walk.high_col;
    }
    if (from != TP_NO_CORNER)
        walk.row = corner_row(cut, from);
    enter_row(&walk);
    if (from != TP_NO_CORNER)
        walk.col = corner_col(cut, from);
    enter_cell(&walk);
    if (from != TP_NO_CORNER)
        walk.link = &cut->next[from];
    return walk;
}

/* Advances to the next cell; false at the end. */
static bool enter_next_cell(tp_cut_walk *walk)
{
    if (walk->col < walk->last_col) {
        walk->col++;
    } else if (walk->row < walk->last_row) {
        walk->row++;
        enter_row(walk);
    } else {
        return false;
    }
    enter_cell(walk);
    return true;
}

uint32_t tp_cut_walk_next_corner(tp_cut_walk *walk)
{
    for (;;) {
        const uint32_t corner = *walk->link;
        if (corner == TP_NO_CORNER && !enter_next_cell(walk))
            return TP_NO_CORNER;
        if (corner == TP_NO_CORNER)
            continue;
        walk->steps++;
        uint32_t *const next = &walk->cut->next[corner];
        if (!tp_cut_is_removed(walk->cut, corner)) {
            walk->link = next;
            return corner;
        }
        *walk->link = *next;
    }
}
