/* SPDX-License-Identifier: MIT */
/* Cells of water as quadrilaterals in 32 bits, for quality.triangles = fast.
 *
 * The pixels are those of the cell's two triangles by raster/tri.h: an edge crosses a row
 * at n / (16 dv) px, an exact quotient, and the diagonal is shared.  Cells and triangles
 * therefore meet without gaps.  Depth, s, t and slopes are planes through the mean of the
 * corners along both diagonals, counted from the cell's own pixel: a tile changes no bit.
 * A corner is off the plane by a quarter of the cell's twist.
 *
 * The triangles of a cell that is not convex have a plane each.  Cells wider or higher than
 * 64 px, thinner than 1/16 px, or so deep that affine s and t would stray by more than STRAY
 * are left to exact triangles.
 *
 * Bits: sides are at most 2^10 in 28.4 px and areas at most 2^21. */
#include "base/dsp.h"
#include "raster/raster.h"

#define SIDE_MOST (64 * 16)     /* of the bounding box, 28.4 px */
#define STEP_BITS 25            /* differences of depth, s and t are below 2^24 */
#define STRAY 4                 /* quarters of a pixel that affine s and t may stray */

/* The share of a diagonal in each quantity: its change per pixel to the right and down, and
 * its value at the origin, Q26. */
typedef struct {
    int32_t x, y, origin;
} diagonal_share;

/* A quantity: value at the origin, change per pixel. */
typedef struct {
    uint32_t value, dx, dy;
} plane;

typedef struct {
    const tp_screen_vertex *corner[4];  /* in turn, a front face */
    int32_t  x, y;              /* origin of the planes, px */
    int32_t  left;              /* edges count columns from here, px */
    plane    depth, s, t, slope_x, slope_z;
} cell;

static inline int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static inline int32_t most(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* -- planes -------------------------------------------------------------------------- */

/* Returns bits from 25 on if the difference is 2^24 or more either way. */
TP_ALWAYS_INLINE uint32_t excess(uint32_t difference)
{
    return difference + (1u << (STEP_BITS - 1));
}

/* Returns the plane of a quantity from its value at corner 0 and the differences of the
 * others. */
TP_ALWAYS_INLINE plane make_plane(uint32_t at_0, uint32_t to_1, uint32_t to_2, uint32_t to_3,
                                  const diagonal_share *a, const diagonal_share *b)
{
    const int32_t e1 = (int32_t)(to_2 << 6), e2 = (int32_t)((to_3 - to_1) << 6);

    return (plane){
        at_0 + (uint32_t)((int32_t)(to_1 + to_2 + to_3) >> 2)
            + (uint32_t)(tp_mul_upper(e1, a->origin) + tp_mul_upper(e2, b->origin)),
        (uint32_t)(tp_mul_upper(e1, a->x) + tp_mul_upper(e2, b->x)),
        (uint32_t)(tp_mul_upper(e1, a->y) + tp_mul_upper(e2, b->y)),
    };
}

/* The same for a slope, in the upper half of a word: differences of 17 bits, times 2^15,
 * leave 9 bits of fraction. */
TP_ALWAYS_INLINE plane make_slope_plane(const cell *of, int i, const diagonal_share *a,
                                        const diagonal_share *b)
{
    const int32_t n0 = of->corner[0]->n[i], n1 = of->corner[1]->n[i];
    const int32_t n2 = of->corner[2]->n[i], n3 = of->corner[3]->n[i];
    const int32_t e1 = (n2 - n0) * (1 << 15), e2 = (n3 - n1) * (1 << 15);

    return (plane){
        ((uint32_t)(n0 + n1 + n2 + n3) << 14)
            + ((uint32_t)(tp_mul_upper(e1, a->origin) + tp_mul_upper(e2, b->origin)) << 7),
        (uint32_t)(tp_mul_upper(e1, a->x) + tp_mul_upper(e2, b->x)) << 7,
        (uint32_t)(tp_mul_upper(e1, a->y) + tp_mul_upper(e2, b->y)) << 7,
    };
}

/* Fills the planes from the shares of both diagonals.  Returns false if a difference is out
 * of range. */
TP_ALWAYS_INLINE bool set_planes(cell *to, const diagonal_share *a, const diagonal_share *b)
{
    const tp_screen_vertex *p0 = to->corner[0], *p1 = to->corner[1];
    const tp_screen_vertex *p2 = to->corner[2], *p3 = to->corner[3];
    const uint32_t z = p0->zi, s = (uint32_t)p0->s, t = (uint32_t)p0->t;
    const uint32_t z1 = p1->zi - z, z2 = p2->zi - z, z3 = p3->zi - z;
    const uint32_t s1 = (uint32_t)p1->s - s, s2 = (uint32_t)p2->s - s;
    const uint32_t s3 = (uint32_t)p3->s - s, t1 = (uint32_t)p1->t - t;
    const uint32_t t2 = (uint32_t)p2->t - t, t3 = (uint32_t)p3->t - t;

    if ((excess(z1) | excess(z2) | excess(z3) | excess(s1) | excess(s2) | excess(s3)
         | excess(t1) | excess(t2) | excess(t3)) >> STEP_BITS)
        return false;
    to->depth = make_plane(z, z1, z2, z3, a, b);
    to->s = make_plane(s, s1, s2, s3, a, b);
    to->t = make_plane(t, t1, t2, t3, a, b);
    to->slope_x = make_slope_plane(to, 0, a, b);
    to->slope_z = make_slope_plane(to, 1, a, b);
    return true;
}

/* Returns a diagonal's share from its changes, Q26 and below 2^30, and the distance of the
 * origin from the mean of the corners, -31..32 of 1/64 px. */
TP_ALWAYS_INLINE diagonal_share make_share(int32_t x, int32_t y, int32_t off_u, int32_t off_v)
{
    return (diagonal_share){ x, y, ((x >> 7) * off_u + (y >> 7) * off_v) * 2 };
}

/* -- set-up -------------------------------------------------------------------------- */

/* Returns a doubled area: negative for a front face. */
TP_ALWAYS_INLINE int32_t twice_area(const tp_screen_vertex *a, const tp_screen_vertex *b,
                                    const tp_screen_vertex *c)
{
    return (b->u - a->u) * (c->v - a->v) - (c->u - a->u) * (b->v - a->v);
}

/* True if affine s and t stray too far: by a quarter of (depth ratio - 1) times the extent.
 * A wrong answer for differences of 2^31 and more is caught by set_planes. */
TP_ALWAYS_INLINE bool strays(const cell *of, int32_t side)
{
    const uint32_t a = of->corner[0]->zi, b = of->corner[1]->zi;
    const uint32_t c = of->corner[2]->zi, d = of->corner[3]->zi;
    uint32_t low = a < b ? a : b, high = a > b ? a : b;

    low = low < c ? low : c;
    high = high > c ? high : c;
    low = low < d ? low : d;
    high = high > d ? high : d;
    return (high - low) / STRAY * ((uint32_t)(side >> 4) + 1) > low;
}

/* Sets the planes of a convex cell with this doubled area, positive.  Returns false if the
 * cell is too coarse.  Sides shorter than the area keep the changes below 2^30. */
TP_ALWAYS_INLINE bool set_cell(cell *to, int32_t area, int32_t side)
{
    const tp_screen_vertex *p0 = to->corner[0], *p1 = to->corner[1];
    const tp_screen_vertex *p2 = to->corner[2], *p3 = to->corner[3];

    if (side >= area || strays(to, side))
        return false;
    const int32_t r = -(int32_t)((1u << 30) / (uint32_t)area);
    const int32_t u = p0->u + p1->u + p2->u + p3->u, v = p0->v + p1->v + p2->v + p3->v;
    to->x = u >> 6;
    to->y = v >> 6;
    const int32_t off_u = 64 * to->x + 32 - u, off_v = 64 * to->y + 32 - v;
    const diagonal_share a = make_share((p3->v - p1->v) * r, (p1->u - p3->u) * r, off_u, off_v);
    const diagonal_share b = make_share((p0->v - p2->v) * r, (p2->u - p0->u) * r, off_u, off_v);
    return set_planes(to, &a, &b);
}

/* -- rows ---------------------------------------------------------------------------- */

/* An edge on a row: its first pixel centre is column n / one, counted from cell.left. */
typedef struct {
    uint32_t n, one;
    int32_t  step;
    int32_t  end;               /* its first row below */
} edge;

/* Returns the edge on row y.  cell.left is at or before all corners, so n >= 0. */
TP_ALWAYS_INLINE edge make_edge(const tp_screen_vertex *from, const tp_screen_vertex *to,
                                int32_t left, int32_t y)
{
    const int32_t du = to->u - from->u, dv = to->v - from->v;
    const int32_t n = (from->u - 16 * left + 8) * dv + du * (16 * y + 8 - from->v) - 1;

    return (edge){ (uint32_t)n, 16 * (uint32_t)dv, 16 * du, tp_first_centre(to->v) };
}

TP_ALWAYS_INLINE uint32_t plane_value(const plane *p, uint32_t dx, uint32_t dy)
{
    return p->value + p->dx * dx + p->dy * dy;
}

TP_ALWAYS_INLINE uint32_t pack_slopes(uint32_t x, uint32_t z)
{
    return (x & 0xffff0000u) | z >> 16;
}

/* Returns n and so many steps: each half for itself. */
TP_ALWAYS_INLINE uint32_t stepped(uint32_t n, uint32_t step, uint32_t count)
{
    return tp_sadd16(n, (step & 0xffff0000u) * count | (step * count & 0xffff));
}

/* Fills pixels [x, end) of row y, inside the tile; the cell begins at `left`.  Slopes step
 * by whole units of Q12, from there on. */
TP_ALWAYS_INLINE void fill(const cell *of, const tp_gbuffer *tile, int32_t left, int32_t x,
                           int32_t end, int32_t y)
{
    const size_t at = (size_t)(uint32_t)(y - tile->y0) * tile->stride
                    + (uint32_t)(x - tile->x0);
    const uint32_t dx = (uint32_t)(x - of->x), dy = (uint32_t)(y - of->y);
    const uint32_t s_step = of->s.dx, t_step = of->t.dx, zi_step = of->depth.dx;
    const uint32_t n_step = pack_slopes(of->slope_x.dx + 0x8000, of->slope_z.dx + 0x8000);
    uint32_t zi = plane_value(&of->depth, dx, dy), s = plane_value(&of->s, dx, dy);
    uint32_t t = plane_value(&of->t, dx, dy);
    const uint32_t first = (uint32_t)(left - of->x);
    uint32_t n = pack_slopes(plane_value(&of->slope_x, first, dy),
                             plane_value(&of->slope_z, first, dy));
    uint32_t *key = tile->key + at;
    const ptrdiff_t plane_size = tile->s - tile->key;
    uint32_t *to = tile->t + at;

    if (x > left)
        n = stepped(n, n_step, (uint32_t)(x - left));
    for (uint32_t *stop = key + (end - x); key < stop; key++, to++) {
        const uint32_t depth = zi << 1 & ~(uint32_t)0xff;
        if (depth > (*key | 0xff)) {
            *key = depth | TP_MARK_WATER;
            key[plane_size] = s;
            to[0] = t;
            to[plane_size] = n;
        }
        zi += zi_step;
        s += s_step;
        t += t_step;
        n = tp_sadd16(n, n_step);
    }
}

/* Fills the rows.  From the topmost corner one side of the cell goes down by falling
 * numbers of corners, the left one, and one by rising numbers. */
TP_ALWAYS_INLINE void fill_rows(const cell *of, const tp_gbuffer *tile, uint32_t topmost,
                                int32_t y, int32_t bottom)
{
    uint32_t i = topmost, k = topmost;
    edge left = { .end = y }, right = { .end = y };

    while (y < bottom) {
        for (; left.end <= y; i++)
            if (tp_first_centre(of->corner[(i + 1) & 3]->v) > y)
                left = make_edge(of->corner[i & 3], of->corner[(i + 1) & 3], of->left, y);
        for (; right.end <= y; k--)
            if (tp_first_centre(of->corner[(k - 1) & 3]->v) > y)
                right = make_edge(of->corner[k & 3], of->corner[(k - 1) & 3], of->left, y);
        const int32_t end = least(least(left.end, right.end), bottom);
        for (; y < end; y++) {
            const int32_t first = (int32_t)(left.n / left.one) + of->left;
            const int32_t x = most(first, tile->x0);
            const int32_t to = least((int32_t)(right.n / right.one) + of->left, tile->x1);
            if (x < to)
                fill(of, tile, first, x, to, y);
            left.n += (uint32_t)left.step;
            right.n += (uint32_t)right.step;
        }
    }
}

/* -- cells --------------------------------------------------------------------------- */

/* Bounds of corners, 28.4 px. */
typedef struct {
    int32_t u0, u1, v0, v1;
} bounds;

TP_ALWAYS_INLINE bounds make_bounds(const tp_screen_vertex *a, const tp_screen_vertex *b,
                                    const tp_screen_vertex *c, const tp_screen_vertex *d)
{
    return (bounds){
        least(least(a->u, b->u), least(c->u, d->u)), most(most(a->u, b->u), most(c->u, d->u)),
        least(least(a->v, b->v), least(c->v, d->v)), most(most(a->v, b->v), most(c->v, d->v)),
    };
}

static int32_t longest_side(const bounds *b)
{
    return most(b->u1 - b->u0, b->v1 - b->v0);
}

/* Draws a convex cell of corners in turn.  Returns false if it is too coarse. */
static __attribute__((noinline)) bool draw_plane(const tp_gbuffer *tile, cell *of,
                                                 const bounds *b, int32_t area)
{
    const int32_t y = most(tp_first_centre(b->v0), tile->y0);
    const int32_t bottom = least(tp_first_centre(b->v1), tile->y1);
    uint32_t topmost = 0;

    if (y >= bottom)
        return true;
    of->left = b->u0 >> 4;
    if (!set_cell(of, area, longest_side(b)))
        return false;
    while (of->corner[topmost]->v > b->v0)
        topmost++;
    fill_rows(of, tile, topmost, y, bottom);
    return true;
}

/* Draws a triangle as a cell whose last two corners are one: the plane is exact.  Returns
 * false if it is too coarse. */
static bool draw_half(const tp_gbuffer *tile, const tp_screen_vertex *a,
                      const tp_screen_vertex *b, const tp_screen_vertex *c, int32_t area)
{
    const bounds box = make_bounds(a, b, c, c);
    cell of;

    if (area == 0 || (tile->front_only && area > 0))
        return true;
    of.corner[0] = a;
    of.corner[1] = area < 0 ? b : c;
    of.corner[2] = of.corner[3] = area < 0 ? c : b;
    return draw_plane(tile, &of, &box, area < 0 ? -area : area);
}

/* Puts the corners in turn.  Returns the doubled area of a convex cell, where each corner
 * and its neighbours turn the same way; else 0. */
TP_ALWAYS_INLINE int32_t set_corners(cell *to, const tp_screen_vertex left[2],
                                     const tp_screen_vertex right[2], int32_t a, int32_t b)
{
    const int32_t c = twice_area(&left[0], &left[1], &right[0]), d = a + b - c;
    const bool front = a + b < 0;

    if (front ? a > 0 || b > 0 || c > 0 || d > 0 : a < 0 || b < 0 || c < 0 || d < 0)
        return 0;
    to->corner[0] = &left[0];
    to->corner[1] = front ? &left[1] : &right[0];
    to->corner[2] = &right[1];
    to->corner[3] = front ? &right[0] : &left[1];
    return front ? -a - b : a + b;
}

uint32_t tp_cell_water_fast(const tp_gbuffer *tile, const tp_screen_vertex left[2],
                            const tp_screen_vertex right[2])
{
    const bounds box = make_bounds(&left[0], &left[1], &right[0], &right[1]);
    cell of;

    if (longest_side(&box) > SIDE_MOST)
        return TP_CELL_WHOLE;
    const int32_t a = twice_area(&left[0], &left[1], &right[1]);
    const int32_t b = twice_area(&left[0], &right[1], &right[0]);
    if (tile->front_only && a >= 0 && b >= 0)
        return 0;
    const int32_t area = set_corners(&of, left, right, a, b);
    if (area != 0)
        return draw_plane(tile, &of, &box, area) ? 0 : TP_CELL_WHOLE;
    const bool lower = draw_half(tile, &left[0], &left[1], &right[1], a);
    const bool upper = draw_half(tile, &left[0], &right[1], &right[0], b);
    return (lower ? 0 : TP_CELL_LOWER) | (upper ? 0 : TP_CELL_UPPER);
}
