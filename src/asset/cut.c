/* SPDX-License-Identifier: MIT */
/* Cuts a polygon into triangles by clipping ears, in integers.
 *
 * The polygon is seen along the axis on which its area is largest.  An ear is a corner
 * that turns the polygon's way and whose triangle, borders included, no other corner
 * stands in the way of; it is cut off, and so on until three are left.  Every simple
 * polygon has an ear, also when some of its corners lie on straight edges: any
 * triangulation that uses all corners has a leaf (G. Meisters, "Polygons have ears",
 * 1975).  Outlines that touch themselves, as those that walk into a hole and back, are
 * handled by looking at the edges of a corner that stands on a corner of the triangle.
 * Where an outline crosses itself there may be no ear: then some corner is cut, so that
 * the work always ends with n - 2 triangles.
 *
 * Cost: a triangle stays free of the corners it was once free of, since cutting only
 * shrinks the polygon.  So each test goes on where the last one of that corner stopped,
 * and all of them take O(n^2) steps together. */
#include "asset/obj.h"

enum { EXTENT_BITS = 27 };

/* The polygon as seen along the axis, turning counter-clockwise. */
typedef struct {
    const int32_t *u, *v;
    tp_obj_cut    *cut;
} view;

typedef struct { int64_t x, y; } step;

/* Both components < 2^28, so twice an area stays below 2^57. */
static int64_t turn(step a, step b)
{
    return a.x * b.y - a.y * b.x;
}

static step between(const view *seen, uint8_t from, uint8_t to)
{
    return (step){ (int64_t)seen->u[to] - seen->u[from],
                   (int64_t)seen->v[to] - seen->v[from] };
}

/* Twice the area of a, b, c; positive: they turn the polygon's way. */
static int64_t area(const view *seen, uint8_t a, uint8_t b, uint8_t c)
{
    return turn(between(seen, a, b), between(seen, a, c));
}

/* -- what the polygon looks like --------------------------------------------------- */

/* One coordinate of all corners, moved to begin at 0; returns how far it reaches. */
static uint32_t to_origin(int32_t *at, uint32_t n)
{
    int32_t low = at[0], high = at[0];
    for (uint32_t i = 1; i < n; i++) {
        low  = at[i] < low ? at[i] : low;
        high = at[i] > high ? at[i] : high;
    }
    for (uint32_t i = 0; i < n; i++)
        at[i] -= low;
    return (uint32_t)(high - low);
}

/* Polygons of more than 2 km are cut on a grid of up to 16 units, 0.24 mm, so that the
 * areas of 256 corners sum up within 63 bits: 256 x 2 x (2^27)^2 = 2^63. */
static void normalise_extent(tp_obj_cut *cut, uint32_t n)
{
    uint32_t extent = 0;
    for (int k = 0; k < 3; k++)
        extent |= to_origin(cut->at[k], n);
    uint32_t shift = 0;
    while (extent >> shift >= 1u << EXTENT_BITS)
        shift++;
    for (int k = 0; shift > 0 && k < 3; k++) {
        for (uint32_t i = 0; i < n; i++)
            cut->at[k][i] >>= shift;
    }
}

/* Twice the area enclosed in the plane of u and v, by the shoelace formula. */
static int64_t whole_area(const int32_t *u, const int32_t *v, uint32_t n)
{
    int64_t sum = 0;
    for (uint32_t i = 2; i < n; i++)
        sum += (int64_t)(u[i - 1] - u[0]) * (v[i] - v[0])
             - (int64_t)(u[i] - u[0]) * (v[i - 1] - v[0]);
    return sum;
}

/* Chooses the axis; swapping u and v mirrors a polygon that turns the other way. */
static int64_t look_at(view *seen, uint32_t n)
{
    int64_t best = 0;
    for (int k = 0; k < 3; k++) {
        const int32_t *u = seen->cut->at[(k + 1) % 3], *v = seen->cut->at[(k + 2) % 3];
        const int64_t sum = whole_area(u, v, n), size = sum < 0 ? -sum : sum;
        if (size > best || k == 0) {
            best = size;
            seen->u = sum < 0 ? v : u;
            seen->v = sum < 0 ? u : v;
        }
    }
    return best;
}

/* -- ears --------------------------------------------------------------------------- */

/* Corner p stands on the border of a triangle, whose inside is seen from there between
 * the directions to y and, turning left, to z: does an edge of p lead in? */
static bool leads_inside(const view *seen, uint8_t p, uint8_t y, uint8_t z)
{
    const step to_y = between(seen, p, y), to_z = between(seen, p, z);
    const step before = between(seen, p, seen->cut->before[p]);
    const step after = between(seen, p, seen->cut->after[p]);
    return (turn(to_y, before) > 0 && turn(before, to_z) > 0)
        || (turn(to_y, after) > 0 && turn(after, to_z) > 0);
}

static bool same_place(const view *seen, uint8_t a, uint8_t b)
{
    return seen->u[a] == seen->u[b] && seen->v[a] == seen->v[b];
}

/* Does corner p stand in the way of cutting a, b, c?  It does within the triangle and on
 * the new edge between c and a; on a corner or on the outline's own edges a - b - c,
 * where the outline may touch itself, only if an edge of p goes in from there. */
static bool blocks(const view *seen, uint8_t p, uint8_t a, uint8_t b, uint8_t c)
{
    const int64_t ab = area(seen, a, b, p), bc = area(seen, b, c, p);
    if (ab < 0 || bc < 0 || area(seen, c, a, p) < 0)
        return false;
    if (ab > 0 && bc > 0)
        return true;
    if (same_place(seen, p, a))
        return leads_inside(seen, p, b, c);
    if (same_place(seen, p, b))
        return leads_inside(seen, p, c, a);
    if (same_place(seen, p, c))
        return leads_inside(seen, p, a, b);
    return ab == 0 ? leads_inside(seen, p, b, a) : leads_inside(seen, p, c, b);
}

/* cut->tried[b] is the corner where the last test of b stopped.  It may have been cut
 * off since: its `after` still leads on to corners that are left. */
static bool is_ear(const view *seen, uint8_t b)
{
    tp_obj_cut *const cut = seen->cut;
    const uint8_t a = cut->before[b], c = cut->after[b];
    if (area(seen, a, b, c) <= 0)
        return false;
    uint8_t p = cut->tried[b];
    while (p != a && (cut->before[cut->after[p]] != p || !blocks(seen, p, a, b, c)))
        p = cut->after[p];
    cut->tried[b] = p;
    return p == a;
}

static void forget(tp_obj_cut *cut, uint8_t b)
{
    cut->tried[b] = cut->after[cut->after[b]];
}

/* Does the outline come back from corner b the way it went there, or stand still?  To
 * cut that off takes no area and changes nothing. */
static bool is_spike(const view *seen, uint8_t b)
{
    const step in = between(seen, seen->cut->before[b], b);
    const step out = between(seen, b, seen->cut->after[b]);
    return turn(in, out) == 0 && in.x * out.x + in.y * out.y <= 0;
}

/* The corner to cut next, from `start` on: a spike or an ear, or else the start. */
static uint8_t choose(const view *seen, uint8_t start, uint32_t left)
{
    uint8_t b = start;
    for (uint32_t i = 0; i < left; i++, b = seen->cut->after[b]) {
        if (is_spike(seen, b) || is_ear(seen, b))
            return b;
    }
    return start;
}

static void take_off(tp_obj_cut *cut, uint8_t b, uint32_t number)
{
    const uint8_t a = cut->before[b], c = cut->after[b];
    cut->triangle[number][0] = a;
    cut->triangle[number][1] = b;
    cut->triangle[number][2] = c;
    cut->after[a] = c;
    cut->before[c] = a;
}

void tp_obj_cut_polygon(tp_obj_cut *cut, uint32_t n)
{
    view seen = { .cut = cut };
    normalise_extent(cut, n);
    const bool flat = look_at(&seen, n) != 0;
    for (uint32_t i = 0; i < n; i++) {
        cut->before[i] = (uint8_t)(i == 0 ? n - 1 : i - 1);
        cut->after[i] = (uint8_t)(i + 1 == n ? 0 : i + 1);
        cut->tried[i] = (uint8_t)((i + 2) % n);
    }
    uint8_t b = 1;
    for (uint32_t left = n; left > 2; left--) {
        if (flat && left > 3)
            b = choose(&seen, b, left);
        take_off(cut, b, n - left);
        forget(cut, cut->before[b]);
        forget(cut, cut->after[b]);
        b = cut->after[b];
    }
}
