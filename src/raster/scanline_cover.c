/* SPDX-License-Identifier: MIT */
/* Fills a column of pixels between two lines of water.
 *
 * zi and slopes are linear from row to row. s and t are linear too, except in pieces long
 * and deep enough to show perspective: there s and t are exact at multiples of 16 rows
 * and at the ends of the piece, and linear between.  Every piece counts from its own
 * upper end, independent of the tile. */
#include "raster/scanline_cover.h"

#define FEW  2                  /* rows up to this number are computed one by one */
#define DEEP 4                  /* from this number of rows on, perspective is tested */

/* Returns the share for s and t, from a share on the screen: share zb / z. share zb is at
 * most z; the quotient is limited to below 2^31. */
int32_t tp_row_perspective_share(int32_t share, uint32_t za, uint32_t zb)
{
    uint32_t z =
        (uint32_t)add_share((int32_t)za, difference((int32_t)za, (int32_t)zb), share);
    uint64_t over = (uint64_t)(uint32_t)share * zb >> 31;
    int      shift = tp_clz(z | 1);
    uint64_t q = over * tp_recip_norm((z | 1) << shift) >> (32 - shift);

    return q < INT32_MAX ? (int32_t)q : INT32_MAX;
}

/* 65536 / n, n: rows or columns between two exact positions. */
static const uint32_t over[17] = { 0, 65536, 32768, 21845, 16384, 13107, 10923, 9362,
                                   8192, 7282, 6554, 5958, 5461, 5041, 4681, 4369, 4096 };

uint32_t tp_row_st_step(uint32_t from, uint32_t to, int32_t n)
{
    TP_ASSERT(n >= 0 && n <= 16);
    return (uint32_t)((int64_t)(int32_t)(to - from) * over[n] >> 16);
}

/* Returns the step of a key per row; the stencil bits of the step are 0. */
TP_ALWAYS_INLINE uint32_t key_step(int32_t zi_step)
{
    return ((uint32_t)zi_step * 2 + 128) & ~(uint32_t)0xff;
}

TP_ALWAYS_INLINE void advance_sample_rows(sample *p, const sample *step, uint32_t rows)
{
    p->key += step->key * rows;
    p->s += step->s * rows;
    p->t += step->t * rows;
    p->n += step->n * rows;
}

/* Fills rows [y, end); `now` is the sample at row `now_row`. */
TP_ALWAYS_INLINE void fill_column_rows(const tp_gbuffer *tile, int32_t x, int32_t y,
                                       int32_t end, int32_t now_row, sample now,
                                       sample step, bool tested)
{
    const size_t plane = plane_stride(tile), stride = tile->stride;
    uint32_t *at = key_pointer(tile, x, y);

    if (y > now_row)
        advance_sample_rows(&now, &step, (uint32_t)(y - now_row));
    for (int32_t count = end - y; count > 0; count--, at += stride) {
        write_sample(at, plane, &now, tested);
        advance_sample_rows(&now, &step, 1);
    }
}

static __attribute__((noinline)) void fill_tested(const tp_gbuffer *tile, int32_t x,
                                                  int32_t y, int32_t end, int32_t top,
                                                  const sample *now, const sample *step)
{
    fill_column_rows(tile, x, y, end, top, *now, *step, 1);
}

/* An interval between two lines: the lower line `near`, the upper line `far`. */
typedef struct {
    const tp_row_sample *far, *near;
    uint32_t inverse;           /* 2^31 / rows between the lines, rows in Q8 */
    int32_t  up;                /* share per row upwards, negative, Q.30; if rows > 1 */
} between;

TP_ALWAYS_INLINE between make_interval(const tp_row_sample *far, const tp_row_sample *near)
{
    TP_ASSERT((near->v - far->v) >> 8 > 0);
    uint32_t inverse = 0x7fffffffu / ((uint32_t)(near->v - far->v) >> 8);
    return (between){ far, near, inverse, (int32_t)(0u - 128 * inverse) };
}

TP_ALWAYS_INLINE int32_t row_share(const between *b, int32_t y)
{
    return (int32_t)((uint32_t)((y * ROW + ROW / 2 - b->far->v) >> 8) * b->inverse);
}

/* Sets start and step with s and t linear on the screen. */
TP_ALWAYS_INLINE void set_linear_sample(const between *b, int32_t y, sample *now,
                                        sample *step)
{
    const tp_row_sample *far = b->far, *near = b->near;
    int32_t share = row_share(b, y), up = b->up, d;

    d = difference((int32_t)far->zi, (int32_t)near->zi);
    now->key = make_water_key((uint32_t)add_share((int32_t)far->zi, d, share));
    step->key = key_step(-tp_mul_upper(d, up) * 4);
    d = difference(far->s, near->s);
    now->s = (uint32_t)add_share(far->s, d, share);
    step->s = 0u - (uint32_t)tp_mul_upper(d, up) * 4;
    d = difference(far->t, near->t);
    now->t = (uint32_t)add_share(far->t, d, share);
    step->t = 0u - (uint32_t)tp_mul_upper(d, up) * 4;
    now->n = interpolate_slopes(far->n, near->n, share);
    step->n = slopes_step(near->n, far->n, up);
}

typedef struct {
    uint32_t s, t;
} cover_st;

static cover_st interpolate_st(const between *b, int32_t y)
{
    const tp_row_sample *far = b->far, *near = b->near;
    int32_t share = tp_row_perspective_share(row_share(b, y), far->zi, near->zi);

    return (cover_st){ (uint32_t)add_share(far->s, difference(far->s, near->s), share),
                       (uint32_t)add_share(far->t, difference(far->t, near->t), share) };
}

/* Fills rows [y, end) of a piece that begins at row `top`. s and t are exact in
 * perspective at multiples of 16 rows and at the ends of the piece. */
static __attribute__((noinline)) void fill_perspective_rows(const tp_rows *rows,
                                                            const tp_row_sample *near,
                                                            const tp_row_sample *far,
                                                            int32_t x, int32_t y,
                                                            int32_t end, int32_t top)
{
    const between b = make_interval(far, near);
    int32_t last = first_row(near->v) - 1;
    int32_t from = (y & ~15) > top ? y & ~15 : top;
    cover_st   p = interpolate_st(&b, from);
    sample  now, step;

    for (int32_t stop; y < end; y = from = stop) {
        int32_t next = (from | 15) + 1, to = next < last ? next : last;
        cover_st   q = to > from ? interpolate_st(&b, to) : p;
        stop = next < end ? next : end;
        set_linear_sample(&b, from, &now, &step);
        now.s = p.s;
        now.t = p.t;
        step.s = to > from ? tp_row_st_step(p.s, q.s, to - from) : 0;
        step.t = to > from ? tp_row_st_step(p.t, q.t, to - from) : 0;
        fill_tested(rows->tile, x, y, stop, from, &now, &step);
        p = q;
    }
}

/* Fills rows [y, end) of column x, in a piece of at most FEW rows.  Each row is
 * interpolated on its own, without steps from row to row. */
TP_ALWAYS_INLINE void fill_few_rows(const tp_rows *rows, const tp_row_sample *near,
                                    const tp_row_sample *far, int32_t x, int32_t y,
                                    int32_t end)
{
    const tp_gbuffer *tile = rows->tile;
    const size_t plane = plane_stride(tile);
    const uint32_t inverse = 0x7fffffffu / ((uint32_t)(near->v - far->v) >> 8);
    const int32_t dz = difference((int32_t)far->zi, (int32_t)near->zi);
    const int32_t ds = difference(far->s, near->s), dt = difference(far->t, near->t);
    uint32_t share = (uint32_t)((y * ROW + ROW / 2 - far->v) >> 8) * inverse;
    uint32_t *at = key_pointer(tile, x, y);

    for (;;) {
        const int32_t w = (int32_t)share;
        const sample now = {
            make_water_key((uint32_t)add_share((int32_t)far->zi, dz, w)),
            (uint32_t)add_share(far->s, ds, w), (uint32_t)add_share(far->t, dt, w),
            interpolate_slopes(far->n, near->n, w),
        };
        write_sample(at, plane, &now, rows->solid);
        if (++y >= end)
            break;
        at += tile->stride;
        share += 256 * inverse;
    }
}

/* Fills rows [y, end) of column x by steps from row `top`, the piece's upper end. */
static __attribute__((noinline)) void fill_many_rows(const tp_rows *rows,
                                                     const tp_row_sample *near,
                                                     const tp_row_sample *far,
                                                     int32_t x, int32_t y, int32_t end,
                                                     int32_t top)
{
    const between b = make_interval(far, near);
    sample now, step;

    set_linear_sample(&b, top, &now, &step);
    if (rows->solid)
        fill_tested(rows->tile, x, y, end, top, &now, &step);
    else
        fill_column_rows(rows->tile, x, y, end, top, now, step, false);
}

void tp_rows_fill_column(const tp_rows *rows, const tp_row_sample *near,
                         const tp_row_sample *far, int32_t x, int32_t y, int32_t end,
                         int32_t top)
{
    TP_ASSERT(y < end && y >= top && end <= rows->tile->y1);
    TP_ASSERT(near->v - far->v >= 256);
    uint32_t apart = (uint32_t)(near->v - far->v);

    if (end - y == 1 && first_row(near->v) - top <= FEW)
        fill_few_rows(rows, near, far, x, y, y + 1);
    else if (first_row(near->v) - top <= FEW)
        fill_few_rows(rows, near, far, x, y, end);
    else if (apart >= DEEP * ROW && needs_row_perspective(far->zi, near->zi, apart >> 16))
        fill_perspective_rows(rows, near, far, x, y, end, top);
    else
        fill_many_rows(rows, near, far, x, y, end, top);
}

void tp_row_restart_column(tp_rows *rows, tp_row_column *column, const tp_row_sample *line,
                           bool behind_triangles)
{
    const tp_gbuffer *tile = rows->tile;
    int32_t top = first_row(line->v), y = top > tile->y0 ? top : tile->y0;
    int32_t end = (column->limit + ROW / 2) >> 16;
    const sample p = { make_water_key(line->zi), (uint32_t)line->s, (uint32_t)line->t,
                       line->n };

    mark_column_covered(rows, column, y);
    if (behind_triangles && top >= tile->y0 && top < end)
        write_sample(key_pointer(tile, tile->x0 + (int32_t)(column - rows->column), top),
                     plane_stride(tile), &p, rows->solid);
}
