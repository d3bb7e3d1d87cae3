/* SPDX-License-Identifier: MIT */
/* Lays lines of water and finds the columns where they are visible; see the header. */
#include "raster/fast_scanlines.h"
#include "raster/fast_cover.h"

/* -- a tile -------------------------------------------------------------------------- */

#define SAMPLE_BYTES (2 * sizeof(tp_line_sample) + 3 * sizeof(uint32_t))

static int32_t count_columns(int32_t pixels, int column_bits)
{
    return (pixels + (1 << (column_bits - 4)) - 1) >> (column_bits - 4);
}

size_t tp_fast_rows_bytes(uint32_t columns, int column_bits)
{
    return (size_t)(uint32_t)count_columns((int32_t)columns, column_bits) * SAMPLE_BYTES;
}

void tp_fast_rows_begin(tp_fast_rows *rows, const tp_gbuffer *tile, void *memory,
                        int column_bits, bool keyed)
{
    TP_ASSERT(tile->x0 < tile->x1 && (uintptr_t)memory % 4 == 0);
    const int32_t columns = count_columns(tile->x1 - tile->x0, column_bits);
    const int32_t first = tile->x0 >> (column_bits - 4);
    const int32_t limit = v_limit_above_row(tile->y1);
    tp_line_sample *near = memory;
    uint32_t *words = (uint32_t *)(void *)(near + 2 * (size_t)(uint32_t)columns);

    *rows = (tp_fast_rows){
        .tile = tile, .column_bits = column_bits, .first = first, .x0 = first,
        .x1 = first + columns, .open = columns, .columns = columns, .near = near,
        .far = near + columns, .limit = (int32_t *)(void *)words,
        .near_zi = keyed ? words + columns : NULL,
        .far_zi = keyed ? words + 2 * columns : NULL,
        .y0 = tile->y0,
        .stride = tile->stride * sizeof *tile->s,
        .plane = (size_t)(tile->s - tile->key) * sizeof *tile->s,
    };
    rows->s_plane = (uint8_t *)tile->s - (size_t)(uint32_t)tile->y0 * rows->stride;
    for (int32_t i = 0; i < columns; i++) {
        rows->limit[i] = limit;
        near[i].v = TP_LINE_NONE;
    }
}

/* -- a segment ----------------------------------------------------------------------- */

/* Values of a line at a column, or the step to the next column. */
typedef struct {
    uint32_t v, s, t, n, zi;
} values;

/* A segment, with its first column and the first column behind it. */
typedef struct {
    const tp_row_point *a, *b;
    int32_t  first, stop;
    uint32_t inverse;           /* 2^31 / width, width in 28.4 px */
    bool     deep;              /* s and t need perspective */
} segment;

static int32_t first_column(const tp_fast_rows *rows, int32_t u)
{
    const int32_t half = 1 << (rows->column_bits - 1);
    return (u + half - 1) >> rows->column_bits;
}

TP_ALWAYS_INLINE int32_t column_share(const tp_fast_rows *rows, const segment *g, int32_t x)
{
    const int bits = rows->column_bits;
    return (int32_t)((uint32_t)(x * (1 << bits) + (1 << (bits - 1)) - g->a->u) * g->inverse);
}

TP_ALWAYS_INLINE values interpolate(const tp_fast_rows *rows, const segment *g, int32_t x)
{
    const tp_row_point *a = g->a, *b = g->b;
    const int32_t share = column_share(rows, g, x);
    const int32_t true_share = g->deep ? tp_row_perspective_share(share, a->zi, b->zi) : share;

    return (values){
        (uint32_t)add_share(a->v * 4096, (b->v - a->v) * 4096, share),
        (uint32_t)add_share(a->s, difference(a->s, b->s), true_share),
        (uint32_t)add_share(a->t, difference(a->t, b->t), true_share),
        interpolate_slopes(a->n, b->n, share),
        rows->far_zi ? (uint32_t)add_share((int32_t)a->zi,
                                           difference((int32_t)a->zi, (int32_t)b->zi), share)
                     : 0,
    };
}

/* Returns the steps from column to column of a segment with more than one column. */
TP_ALWAYS_INLINE values column_steps(const tp_fast_rows *rows, const segment *g)
{
    const tp_row_point *a = g->a, *b = g->b;
    const int32_t per = (int32_t)(g->inverse << (rows->column_bits - 1));    /* Q30 */

    return (values){
        (uint32_t)tp_mul_upper((b->v - a->v) * 4096, per) * 4,
        (uint32_t)tp_mul_upper(difference(a->s, b->s), per) * 4,
        (uint32_t)tp_mul_upper(difference(a->t, b->t), per) * 4,
        slopes_step(a->n, b->n, per),
        rows->far_zi
            ? (uint32_t)tp_mul_upper(difference((int32_t)a->zi, (int32_t)b->zi), per) * 4
            : 0,
    };
}

TP_ALWAYS_INLINE void advance(values *now, const values *step, uint32_t columns)
{
    now->v += step->v * columns;
    now->s += step->s * columns;
    now->t += step->t * columns;
    now->n += step->n * columns;
    now->zi += step->zi * columns;
}

/* Writes `count` columns of the line from column x on. */
TP_ALWAYS_INLINE void write_columns(tp_fast_rows *rows, int32_t x, int32_t count, values now,
                                    const values *step)
{
    uint32_t *to = (uint32_t *)(void *)(rows->far + (x - rows->first));
    uint32_t *const end = to + 4 * count;
    const uint32_t dv = step->v, ds = step->s, dt = step->t, dn = step->n;

    do {
        tp_store_next_pair(&to, now.v, now.s);
        tp_store_next_pair(&to, now.t, now.n);
        now.v += dv;
        now.s += ds;
        now.t += dt;
        now.n += dn;
    } while (to != end);
    if (!rows->far_zi)
        return;
    uint32_t *zi = rows->far_zi + (x - rows->first);
    for (int32_t i = 0; i < count; i++, now.zi += step->zi)
        zi[i] = now.zi;
}

/* Lays columns [x, end) of a long or deep segment: values are exact at multiples of 16
 * columns. */
TP_NEVER_INLINE void lay_long(tp_fast_rows *rows, const segment *g, int32_t x, int32_t end)
{
    values step = { .v = 0 };

    if (g->stop - g->first > 1)
        step = column_steps(rows, g);
    for (int32_t to; x < end; x = to) {
        const int32_t from = (x & ~15) > g->first ? x & ~15 : g->first;
        const int32_t next = (from | 15) + 1, last = next < g->stop ? next : g->stop - 1;
        values now = interpolate(rows, g, from);
        if (g->deep && last > from) {
            const values then = interpolate(rows, g, last);
            step.s = tp_row_st_step(now.s, then.s, last - from);
            step.t = tp_row_st_step(now.t, then.t, last - from);
        }
        to = next < end ? next : end;
        advance(&now, &step, (uint32_t)(x - from));
        write_columns(rows, x, to - x, now, &step);
    }
}

#define LONG 48                 /* columns of a segment that is stepped from end to end */

/* Columns without a part of this line keep the previous line. */
static void keep_columns(tp_fast_rows *rows, int32_t x, int32_t end)
{
    for (int32_t i = x - rows->first; i < end - rows->first; i++) {
        rows->far[i] = rows->near[i];
        if (rows->far_zi)
            rows->far_zi[i] = rows->near_zi[i];
    }
}

/* Takes columns [x, end) into the columns laid, if they do not follow them. */
TP_NEVER_INLINE void note_laid(tp_fast_rows *rows, int32_t x, int32_t end)
{
    const bool none = rows->laid0 >= rows->laid1;

    if (!none && x > rows->laid1)
        keep_columns(rows, rows->laid1, x);
    if (!none && end < rows->laid0)
        keep_columns(rows, end, rows->laid0);
    rows->laid1 = none || end > rows->laid1 ? end : rows->laid1;
    rows->laid0 = none || x < rows->laid0 ? x : rows->laid0;
}

void tp_fast_rows_lay(tp_fast_rows *rows, const tp_row_point *a, const tp_row_point *b)
{
    const int32_t first = first_column(rows, a->u), stop = first_column(rows, b->u);
    const int32_t x = first > rows->x0 ? first : rows->x0;
    const int32_t end = stop < rows->x1 ? stop : rows->x1;

    if (x >= end)
        return;
    const segment g = {
        a, b, first, stop, 0x7fffffffu / (uint32_t)(b->u - a->u),
        rows->oblique && needs_row_perspective(a->zi, b->zi, (uint32_t)(b->u - a->u) >> 4),
    };
    if (x == rows->laid1)
        rows->laid1 = end;
    else
        note_laid(rows, x, end);
    if (g.deep || stop - first > LONG) {
        lay_long(rows, &g, x, end);
        return;
    }
    values now = interpolate(rows, &(segment){ a, b, first, stop, g.inverse, false }, first);
    const values step = column_steps(rows, &g);
    if (x > first)
        advance(&now, &step, (uint32_t)(x - first));
    write_columns(rows, x, end - x, now, &step);
}

/* Lays segment i, from a to b, in columns from x on; returns the column behind it.  A
 * column's middle lies half of its width minus half a pixel behind its first pixel. */
TP_ALWAYS_INLINE int32_t lay_even_segment(tp_fast_rows *rows, const tp_even_line *line,
                                          int32_t i, int32_t x, const tp_even_point *a,
                                          const tp_even_point *b)
{
    const int wide = rows->column_bits - 4, log2 = 4 - wide;    /* columns between points */
    const int32_t off = x - (i << log2), across = b->v - a->v, first = x << wide;
    values now = {
        (uint32_t)a->v + (uint32_t)(wide ? across >> 5 : 0),
        line->s + (uint32_t)first * (uint32_t)line->step_s
            + (uint32_t)(wide ? line->step_s >> 1 : 0),
        line->t + (uint32_t)first * (uint32_t)line->step_t
            + (uint32_t)(wide ? line->step_t >> 1 : 0),
        interpolate_slopes(a->n, b->n, wide ? 1 << 26 : 0), line->zi,
    };
    const values by = {
        (uint32_t)(across >> log2), (uint32_t)line->step_s << wide,
        (uint32_t)line->step_t << wide, slopes_step(a->n, b->n, 1 << (30 - log2)), 0,
    };
    int32_t stop = (i + 1) << log2;

    now.v += by.v * (uint32_t)off;
    now.n += by.n * (uint32_t)off;
    stop = stop < rows->x1 ? stop : rows->x1;
    write_columns(rows, x, stop - x, now, &by);
    return stop;
}

void tp_fast_rows_lay_even(tp_fast_rows *rows, const tp_even_line *line)
{
    const int log2 = 8 - rows->column_bits;
    int32_t x = rows->x0;

    while (x < rows->x1) {
        const tp_even_point *a = &line->point[x >> log2];
        x = lay_even_segment(rows, line, x >> log2, x, a, a + 1);
    }
    rows->laid0 = rows->x0;
    rows->laid1 = rows->x1;
}

void tp_fast_rows_lay_even_segment(tp_fast_rows *rows, const tp_even_line *line, int32_t i,
                                   const tp_even_point pair[2])
{
    const int32_t begin = i << (8 - rows->column_bits);
    const int32_t x = begin > rows->x0 ? begin : rows->x0;

    if (x < rows->x1)
        rows->laid1 = lay_even_segment(rows, line, i, x, &pair[0], &pair[1]);
}

void tp_fast_rows_remove(tp_fast_rows *rows, int32_t left_28_4, int32_t right_28_4)
{
    const int32_t first = first_column(rows, left_28_4), stop = first_column(rows, right_28_4);
    const int32_t x = first > rows->x0 ? first : rows->x0;
    const int32_t end = stop < rows->x1 ? stop : rows->x1;

    for (int32_t i = x; i < end; i++)
        rows->near[i - rows->first].v = TP_LINE_NONE;
}

/* -- a line -------------------------------------------------------------------------- */

/* Returns four times the share of s and t, beyond one half, at the middle between two lines,
 * Q.31: the bend of the parabola.  Limited to 1, so that the parabola does not turn. */
static int32_t parabola_bend(uint32_t near_zi, uint32_t far_zi)
{
    const uint32_t near = near_zi >> 8, sum = near + (far_zi >> 8);
    const uint32_t half = sum ? (near << 8) / (sum >> 1 | 1) : 256;     /* Q9 */
    const int32_t bend = ((int32_t)half - 256) * (1 << 24);

    return half >= 384 ? INT32_MAX : bend > 0 ? bend : 0;
}

void tp_fast_rows_begin_line(tp_fast_rows *rows, const tp_line_scale scale[2])
{
    rows->laid0 = rows->laid1 = rows->x0;
    rows->bend = scale ? parabola_bend(scale[1].zi, scale[0].zi) : 0;
    rows->mean_bend = rows->bend / 12;
    rows->half_s = rows->half_t = 0;
    if (scale && rows->column_bits > 4) {
        rows->half_s = (scale[0].half_s + scale[1].half_s) >> 1;
        rows->half_t = (scale[0].half_t + scale[1].half_t) >> 1;
    }
}

void tp_fast_rows_end_line(tp_fast_rows *rows, tp_line_kind kind)
{
    if (rows->laid0 >= rows->laid1)
        return;
    tp_fast_rows_cover(rows, kind);
    keep_columns(rows, rows->first, rows->laid0);
    keep_columns(rows, rows->laid1, rows->first + rows->columns);
    tp_line_sample *const near = rows->near;
    uint32_t *const zi = rows->near_zi;
    rows->near = rows->far;
    rows->near_zi = rows->far_zi;
    rows->far = near;
    rows->far_zi = zi;
}

tp_water_rows tp_fast_rows_found(const tp_fast_rows *rows)
{
    int32_t low = INT32_MIN, high = INT32_MAX;

    if (rows->open == 0)
        return (tp_water_rows){ rows->tile->y0, rows->tile->y0 };
    for (int32_t i = 0; i < rows->columns; i++) {
        low = rows->limit[i] > low ? rows->limit[i] : low;
        high = rows->limit[i] < high ? rows->limit[i] : high;
    }
    const int32_t y0 = rows->tile->y0;
    return (tp_water_rows){
        high == INT32_MIN ? y0 : (high + ROW / 2) >> 16,
        low == INT32_MIN ? y0 : (low + ROW / 2) >> 16,
    };
}
