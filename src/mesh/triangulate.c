/* SPDX-License-Identifier: MIT */
/* Cuts a polygon into triangles by ear clipping, in integers: mesh/obj.h.
 *
 * The polygon is projected along the axis with its largest area.  An ear is a corner that
 * turns the same way as the polygon, and whose triangle, borders included, no other corner
 * blocks.  The ear is cut off, and so on until three corners are left.  Every simple
 * polygon has an ear, even with corners on straight edges: any triangulation with all
 * corners has a leaf (G. Meisters, "Polygons have ears", 1975).  Some outlines touch
 * themselves, for example outlines that walk into a hole and back.  There a corner may
 * coincide with a corner of the triangle, and the test looks at the edges of this corner.
 * An outline that crosses itself may have no ear: then any corner is cut, and the work
 * always ends with n - 2 triangles.
 *
 * Cost: cutting only shrinks the polygon, and a triangle once free of a corner stays free.
 * Each test therefore resumes where the last test of the same corner stopped, and all tests
 * together take O(n^2) steps.  A test visits only the grid cells within reach of its
 * triangle: about a hundred steps per corner for outlines of tens of thousands of corners.
 * Steps are counted: after STEPS n steps the remaining corners are cut without tests. */
#include "base/base.h"
#include "mesh/obj.h"

enum { EXTENT_BITS = 27, STEPS = 2048 };

typedef struct { int64_t x, y; } step;

/* Both components < 2^28: twice an area stays below 2^57. */
static int64_t cross_product(step a, step b)
{
    return a.x * b.y - a.y * b.x;
}

static step corner_difference(const struct tp_obj_cut *cut, uint32_t from, uint32_t to)
{
    return (step){ (int64_t)cut->u[to] - cut->u[from], (int64_t)cut->v[to] - cut->v[from] };
}

/* Twice the area of a, b, c; positive if a, b, c turn the same way as the polygon. */
static int64_t twice_triangle_area(const struct tp_obj_cut *cut, uint32_t a, uint32_t b,
                                   uint32_t c)
{
    return cross_product(corner_difference(cut, a, b), corner_difference(cut, a, c));
}

/* -- projection of the polygon ------------------------------------------------------- */

/* Moves one coordinate of all corners to begin at 0.  Returns the extent. */
static uint32_t move_min_to_zero(int32_t *coordinate, uint32_t n)
{
    int32_t low = coordinate[0], high = coordinate[0];
    for (uint32_t i = 1; i < n; i++) {
        low  = coordinate[i] < low ? coordinate[i] : low;
        high = coordinate[i] > high ? coordinate[i] : high;
    }
    for (uint32_t i = 0; i < n; i++)
        coordinate[i] -= low;
    return (uint32_t)(high - low);
}

/* Polygons of more than 2048 units are cut on a coarser grid, of up to 16 units of
 * 2^-16. */
static void normalise_extent(struct tp_obj_cut *cut, uint32_t n, uint32_t extent[3])
{
    for (int k = 0; k < 3; k++)
        extent[k] = move_min_to_zero(cut->at[k], n);
    const uint32_t most = extent[0] | extent[1] | extent[2];
    uint32_t shift = 0;
    while (most >> shift >= 1u << EXTENT_BITS)
        shift++;
    for (int k = 0; shift > 0 && k < 3; k++) {
        for (uint32_t i = 0; i < n; i++)
            cut->at[k][i] >>= shift;
        extent[k] >>= shift;
    }
}

/* high x 2^32 + low: holds a sum of 2^24 terms below 2^55 each. */
typedef struct { int64_t high; uint64_t low; } sum;

/* Returns twice the area enclosed in the plane of u and v, by the shoelace
 * formula; low < 2^32. */
static sum twice_polygon_area(const int32_t *u, const int32_t *v, uint32_t n)
{
    sum all = { 0, 0 };
    for (uint32_t i = 2; i < n; i++) {
        const int64_t term = (int64_t)(u[i - 1] - u[0]) * (v[i] - v[0])
                           - (int64_t)(u[i] - u[0]) * (v[i - 1] - v[0]);
        all.high += term >> 32;
        all.low += (uint32_t)term;
    }
    return (sum){ all.high + (int64_t)(all.low >> 32), (uint32_t)all.low };
}

static sum sum_magnitude(sum x)
{
    if (x.high >= 0)
        return x;
    return (sum){ -x.high - (x.low != 0), (uint32_t)(0 - x.low) };
}

static bool is_larger(sum a, sum b)
{
    return a.high != b.high ? a.high > b.high : a.low > b.low;
}

/* Chooses the axis of projection.  Swapping u and v mirrors a polygon that turns right. */
static void project_polygon(struct tp_obj_cut *cut, uint32_t n, const uint32_t extent[3])
{
    sum best = { 0, 0 };
    int u = 1, v = 2;
    for (int k = 0; k < 3; k++) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        const sum signed_area = twice_polygon_area(cut->at[a], cut->at[b], n);
        const sum size = sum_magnitude(signed_area);
        if (is_larger(size, best)) {
            best = size;
            u = signed_area.high < 0 ? b : a;
            v = signed_area.high < 0 ? a : b;
        }
    }
    cut->u = cut->at[u];
    cut->v = cut->at[v];
    cut->flat = best.high == 0 && best.low == 0;
    tp_cut_grid_fill(cut, n, extent[u], extent[v]);
}

/* -- ears ---------------------------------------------------------------------------- */

/* Corner p stands on the border of a triangle.  Seen from p the inside lies between the
 * directions to y and, turning left, to z.  True if an edge of p leads inside. */
static bool has_edge_inside_angle(const struct tp_obj_cut *cut, uint32_t p,
                                  uint32_t right_arm, uint32_t left_arm)
{
    const step to_y = corner_difference(cut, p, right_arm),
               to_z = corner_difference(cut, p, left_arm);
    const step before = corner_difference(cut, p, cut->before[p]);
    const step after = corner_difference(cut, p, cut->after[p]);
    return (cross_product(to_y, before) > 0 && cross_product(before, to_z) > 0)
           || (cross_product(to_y, after) > 0 && cross_product(after, to_z) > 0);
}

static bool is_same_place(const struct tp_obj_cut *cut, uint32_t a, uint32_t b)
{
    return cut->u[a] == cut->u[b] && cut->v[a] == cut->v[b];
}

/* True if corner p blocks cutting a, b, c.  A corner within the triangle, or on the new
 * edge between c and a, blocks.  On a corner of the triangle, or on the existing edges a -
 * b - c, the outline may touch itself: there p blocks only if an edge of p leads inside. */
static bool is_blocking_corner(const struct tp_obj_cut *cut, uint32_t p, uint32_t a,
                               uint32_t b, uint32_t c)
{
    if (p == a || p == b || p == c)
        return false;
    const int64_t ab = twice_triangle_area(cut, a, b, p),
                  bc = twice_triangle_area(cut, b, c, p);
    if (ab < 0 || bc < 0 || twice_triangle_area(cut, c, a, p) < 0)
        return false;
    if (ab > 0 && bc > 0)
        return true;
    if (is_same_place(cut, p, a))
        return has_edge_inside_angle(cut, p, b, c);
    if (is_same_place(cut, p, b))
        return has_edge_inside_angle(cut, p, c, a);
    if (is_same_place(cut, p, c))
        return has_edge_inside_angle(cut, p, a, b);
    return ab == 0 ? has_edge_inside_angle(cut, p, b, a)
                   : has_edge_inside_angle(cut, p, c, b);
}

static void spend(struct tp_obj_cut *cut, uint32_t steps)
{
    cut->steps -= steps < cut->steps ? steps : cut->steps;
}

/* True if no corner blocks the triangle of corner b, which has an area.  cut->tried[b] is
 * the corner that blocked the last test. */
static bool is_triangle_empty(struct tp_obj_cut *cut, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t triangle[3] = { a, b, c };
    uint32_t p = cut->tried[b];
    if (p != TP_NO_CORNER && !tp_cut_is_removed(cut, p)
        && is_blocking_corner(cut, p, a, b, c))
        return false;
    tp_cut_walk walk = tp_cut_walk_begin(cut, triangle, p);
    do
        p = tp_cut_walk_next_corner(&walk);
    while (p != TP_NO_CORNER && !is_blocking_corner(cut, p, a, b, c));
    cut->tried[b] = p;
    spend(cut, walk.steps);
    return p == TP_NO_CORNER;
}

static bool is_ear(struct tp_obj_cut *cut, uint32_t b)
{
    const uint32_t a = cut->before[b], c = cut->after[b];
    return twice_triangle_area(cut, a, b, c) > 0 && is_triangle_empty(cut, a, b, c);
}

/* True if the outline returns from corner b the way it came, or stands still.  Cutting the
 * corner removes no area and changes nothing. */
static bool is_spike(const struct tp_obj_cut *cut, uint32_t b)
{
    const step in = corner_difference(cut, cut->before[b], b);
    const step out = corner_difference(cut, b, cut->after[b]);
    return cross_product(in, out) == 0 && in.x * out.x + in.y * out.y <= 0;
}

/* Returns the next corner to cut: the first spike or ear from the start on,
 * or else the start. */
static uint32_t choose_next_corner(struct tp_obj_cut *cut)
{
    uint32_t b = cut->start;
    for (uint32_t i = 0; i < cut->left && cut->steps > 0; i++, b = cut->after[b]) {
        spend(cut, 1);
        if (is_spike(cut, b) || is_ear(cut, b))
            return b;
    }
    return cut->start;
}

/* -- cutting ------------------------------------------------------------------------- */

struct tp_obj_cut *tp_cut_layout(tp_arena *arena, uint32_t corners)
{
    struct tp_obj_cut *const cut = tp_arena_alloc(arena, 1, sizeof *cut);
    struct tp_obj_cut lists = { .left = 0 };
    for (int k = 0; k < 3; k++)
        lists.at[k] = tp_arena_alloc(arena, corners, sizeof *lists.at[k]);
    lists.before = tp_arena_alloc(arena, corners, sizeof *lists.before);
    lists.after  = tp_arena_alloc(arena, corners, sizeof *lists.after);
    lists.tried  = tp_arena_alloc(arena, corners, sizeof *lists.tried);
    lists.next   = tp_arena_alloc(arena, corners, sizeof *lists.next);
    lists.cell   = tp_arena_alloc(arena, tp_cut_grid_cells(corners), sizeof *lists.cell);
    if (cut != NULL)
        *cut = lists;
    return cut;
}

void tp_cut_begin(struct tp_obj_cut *cut, uint32_t n)
{
    TP_ASSERT(cut != NULL && n >= 3);
    uint32_t extent[3];
    TP_ASSERT(cut != NULL && n >= 3);
    for (uint32_t i = 0; i < n; i++) {
        cut->before[i] = i == 0 ? n - 1 : i - 1;
        cut->after[i] = i + 1 == n ? 0 : i + 1;
        cut->tried[i] = TP_NO_CORNER;
    }
    normalise_extent(cut, n, extent);
    project_polygon(cut, n, extent);
    cut->start = 1;
    cut->left = n;
    cut->steps = (uint64_t)STEPS * n;
}

static void remove_ear(struct tp_obj_cut *cut, uint32_t a, uint32_t c)
{
    cut->after[a] = c;
    cut->before[c] = a;
    cut->tried[a] = cut->tried[c] = TP_NO_CORNER;
    cut->start = c;
    cut->left--;
}

bool tp_cut_next(struct tp_obj_cut *cut, uint32_t triangle[3])
{
    if (cut->left < 3)
        return false;
    const uint32_t b = !cut->flat && cut->left > 3 ? choose_next_corner(cut) : cut->start;
    triangle[0] = cut->before[b];
    triangle[1] = b;
    triangle[2] = cut->after[b];
    remove_ear(cut, triangle[0], triangle[2]);
    return true;
}
