/* SPDX-License-Identifier: MIT */
/* Samples of columns between two lines of water, the fast rung; see fast_scanlines.h.
 *
 * s and t follow far + (near - far) w with w = share + bend share (1 - share).  Slopes and
 * depth are linear.  Pieces of few rows take the mean of the last term, bend / 6, in all
 * their rows.  Longer ones have constant second differences from row to row; they begin anew
 * every 16 rows, counted from the piece's upper end. */
#include "raster/fast_cover.h"

#define FEW   12
#define BLOCK 16

/* A piece of a column. */
typedef struct {
    const tp_line_sample *far, *near;
    int32_t  top;               /* first row of the whole piece */
    uint32_t inverse;           /* 2^31 / rows between the lines, rows in Q8 */
    uint32_t far_zi, near_zi;   /* with keys */
    bool     one;               /* a pair of which only the first pixel is in the tile */
} piece;

/* Values of a row, or the steps to the next row. */
typedef struct {
    uint32_t s, t, n, key;
} values;

TP_ALWAYS_INLINE int32_t row_share(const piece *p, int32_t y)
{
    return (int32_t)((uint32_t)((y * ROW + ROW / 2 - p->far->v) >> 8) * p->inverse);
}

/* Returns q + share of d, share in Q.30: it may pass 1. */
TP_ALWAYS_INLINE uint32_t add_share_q30(uint32_t q, int32_t d, int32_t share)
{
    return q + (uint32_t)tp_mul_upper(d, share) * 4;
}

/* Returns the values at a share of the way, with share w, Q.30, of the way for s and t. */
TP_ALWAYS_INLINE values make_values(const piece *p, int32_t share, int32_t w, bool keyed)
{
    const tp_line_sample *far = p->far, *near = p->near;

    return (values){
        add_share_q30(far->s, (int32_t)(near->s - far->s), w),
        add_share_q30(far->t, (int32_t)(near->t - far->t), w),
        interpolate_slopes(far->n, near->n, share),
        keyed ? make_water_key((uint32_t)add_share(
                    (int32_t)p->far_zi, (int32_t)(p->near_zi - p->far_zi), share))
              : 0,
    };
}

/* Returns the steps from row to row, with a step dw of the share of s and t. */
TP_ALWAYS_INLINE values make_steps(const piece *p, int32_t dw, bool keyed)
{
    const tp_line_sample *far = p->far, *near = p->near;
    const int32_t per = (int32_t)(256 * p->inverse);        /* Q31 */
    const int32_t dzi =
        keyed ? tp_mul_upper((int32_t)(p->near_zi - p->far_zi), per) * 2 : 0;

    return (values){
        (uint32_t)tp_mul_upper((int32_t)(near->s - far->s), dw) * 2,
        (uint32_t)tp_mul_upper((int32_t)(near->t - far->t), dw) * 2,
        slopes_step(far->n, near->n, per >> 1),
        ((uint32_t)dzi * 2 + 128) & ~(uint32_t)0xff,
    };
}

TP_ALWAYS_INLINE void advance(values *now, const values *step, uint32_t rows)
{
    now->s += step->s * rows;
    now->t += step->t * rows;
    now->n += step->n * rows;
    now->key += step->key * rows;
}

/* Returns the key of the column's first pixel in row y. */
TP_ALWAYS_INLINE uint32_t *piece_pointer(const tp_fast_rows *rows, const tp_line_sample *far,
                                         int32_t y)
{
    const tp_gbuffer *tile = rows->tile;
    const size_t column = (size_t)(far - rows->far);

    return tile->key + (size_t)(uint32_t)(y - tile->y0) * tile->stride
         + (column << (rows->column_bits - 4));
}

/* Writes a row of a column: a pixel, or a pair of pixels half_s, half_t to both sides. */
TP_ALWAYS_INLINE void write_row(const tp_fast_rows *rows, uint32_t *at, size_t plane,
                                const values *now, bool one, bool keyed, bool pairs)
{
    const uint32_t hs = pairs ? (uint32_t)rows->half_s : 0;
    const uint32_t ht = pairs ? (uint32_t)rows->half_t : 0;

    if (keyed) {
        const sample a = { now->key, now->s - hs, now->t - ht, now->n };
        const sample b = { now->key, now->s + hs, now->t + ht, now->n };
        write_sample(at, plane, &a, rows->solid);
        if (pairs && !one)
            write_sample(at + 1, plane, &b, rows->solid);
    } else if (pairs) {
        tp_store_pair(at + plane, 0, now->s - hs, now->s + hs);
        tp_store_pair(at + 2 * plane, 0, now->t - ht, now->t + ht);
        tp_store_pair(at + 3 * plane, 0, now->n, now->n);
    } else {
        at[plane] = now->s;
        at[2 * plane] = now->t;
        at[3 * plane] = now->n;
    }
}

#define LEAST 4                 /* rows of a piece that is worth leaving rows out */

/* Returns the values some rows further down. */
TP_ALWAYS_INLINE values move_values(values now, const values *step, uint32_t more_s,
                                  uint32_t more_t, uint32_t rows)
{
    const uint32_t twice = rows * (rows - 1) / 2;

    now.s += step->s * rows + more_s * twice;
    now.t += step->t * rows + more_t * twice;
    now.n += step->n * rows;
    return now;
}

/* Writes those of `count` rows from row y on that are no mean rows, and the first. */
TP_ALWAYS_INLINE void write_even_rows(const tp_fast_rows *rows, uint32_t *at, int32_t y,
                                      int32_t count, values now, values step,
                                      uint32_t more_s, uint32_t more_t, bool pairs)
{
    const size_t plane = plane_stride(rows->tile), stride = rows->tile->stride;
    const int32_t begin = 2 - (y & 1), bottom = (y | 15) - y;

    write_row(rows, at, plane, &now, false, false, pairs);
    if (bottom > 0 && bottom < count) {
        const values last = move_values(now, &step, more_s, more_t, (uint32_t)bottom);
        write_row(rows, at + (size_t)(uint32_t)bottom * stride, plane, &last, false, false,
                  pairs);
    }
    now = move_values(now, &step, more_s, more_t, (uint32_t)begin);
    step.s = 2 * (step.s + more_s * (uint32_t)begin) + more_s;
    step.t = 2 * (step.t + more_t * (uint32_t)begin) + more_t;
    step.n *= 2;
    more_s *= 4;
    more_t *= 4;
    at += (size_t)(uint32_t)begin * stride;
    for (int32_t left = count - begin; left > 0; left -= 2) {
        write_row(rows, at, plane, &now, false, false, pairs);
        at += 2 * stride;
        now.s += step.s;
        now.t += step.t;
        now.n += step.n;
        step.s += more_s;
        step.t += more_t;
    }
}

/* Writes `count` rows from `at` on. */
TP_ALWAYS_INLINE void write_rows(const tp_fast_rows *rows, const piece *p, uint32_t *at,
                                 int32_t count, values now, values step, uint32_t more_s,
                                 uint32_t more_t, bool bent, bool keyed, bool pairs)
{
    const size_t plane = plane_stride(rows->tile), stride = rows->tile->stride;
    uint32_t *const stop = at + (size_t)(uint32_t)count * stride;

    do {
        write_row(rows, at, plane, &now, p->one, keyed, pairs);
        at += stride;
        now.s += step.s;
        now.t += step.t;
        now.n += step.n;
        if (bent) {
            step.s += more_s;
            step.t += more_t;
        }
        if (keyed)
            now.key += step.key;
    } while (at != stop);
}

/* Fills rows [y, end) of a piece of at most FEW rows. */
TP_ALWAYS_INLINE void fill_few(const tp_fast_rows *rows, const piece *p, int32_t y,
                               int32_t end, bool keyed, bool pairs)
{
    uint32_t *at = piece_pointer(rows, p->far, y);
    const int32_t share = row_share(p, p->top);
    values now = make_values(p, share, (share >> 1) + rows->mean_bend, keyed);

    if (end - y == 1 && y == p->top) {
        write_row(rows, at, plane_stride(rows->tile), &now, p->one, keyed, pairs);
        return;
    }
    const values step = make_steps(p, (int32_t)(256 * p->inverse), keyed);
    if (y > p->top)
        advance(&now, &step, (uint32_t)(y - p->top));
    write_rows(rows, p, at, end - y, now, step, 0, 0, false, keyed, pairs);
}

TP_ALWAYS_INLINE void fill_blocks(const tp_fast_rows *rows, const piece *p, int32_t y,
                                  int32_t end, bool keyed, bool pairs)
{
    const int32_t per = (int32_t)(256 * p->inverse), bend = rows->bend;
    const int32_t ddw = -tp_mul_upper(tp_mul_upper(per, per), bend) * 8;
    const uint32_t more_s = (uint32_t)tp_mul_upper((int32_t)(p->near->s - p->far->s), ddw) * 2;
    const uint32_t more_t = (uint32_t)tp_mul_upper((int32_t)(p->near->t - p->far->t), ddw) * 2;
    int32_t from = p->top + ((y - p->top) & ~(BLOCK - 1));

    for (int32_t stop; y < end; y = from = stop) {
        const int32_t share = row_share(p, from);
        const int32_t rest = (int32_t)(0x7fffffffu - 2 * (uint32_t)share - (uint32_t)per);
        const int32_t w =
            (share >> 1) + tp_mul_upper(tp_mul_upper(share, INT32_MAX - share), bend) * 2;
        const int32_t dw = per + tp_mul_upper(tp_mul_upper(per, rest), bend) * 4;
        values now = make_values(p, share, w, keyed), step = make_steps(p, dw, keyed);
        stop = from + BLOCK < end ? from + BLOCK : end;
        if (y > from) {
            const uint32_t down = (uint32_t)(y - from), twice = down * (down - 1) / 2;
            advance(&now, &step, down);
            now.s += more_s * twice;
            now.t += more_t * twice;
            step.s += more_s * down;
            step.t += more_t * down;
        }
        uint32_t *at = piece_pointer(rows, p->far, y);
        if (!keyed && rows->means && stop - y >= LEAST)
            write_even_rows(rows, at, y, stop - y, now, step, more_s, more_t, pairs);
        else
            write_rows(rows, p, at, stop - y, now, step, more_s, more_t, true, keyed,
                       pairs);
    }
}

TP_NEVER_INLINE void fill_plain_blocks(const tp_fast_rows *rows, const piece *p, int32_t y,
                                       int32_t end)
{
    if (rows->column_bits > 4)
        fill_blocks(rows, p, y, end, false, true);
    else
        fill_blocks(rows, p, y, end, false, false);
}

/* Fills the only row between two close lines with the values of the nearer line. */
TP_ALWAYS_INLINE void fill_single(const tp_fast_rows *rows, const piece *p, int32_t y,
                                  bool keyed, bool pairs)
{
    const int32_t down = y * ROW + ROW / 2 - p->far->v;
    const bool near = down > p->near->v - p->far->v - down;
    const tp_line_sample *by = near ? p->near : p->far;
    const values now = { by->s, by->t, by->n,
                         keyed ? make_water_key(near ? p->near_zi : p->far_zi) : 0 };

    write_row(rows, piece_pointer(rows, p->far, y), plane_stride(rows->tile), &now, p->one,
              keyed, pairs);
}

void tp_fast_rows_fill_keyed(const tp_fast_rows *rows, const tp_line_sample *far,
                             int32_t y, int32_t end)
{
    const size_t i = (size_t)(far - rows->far);
    const int32_t wide = 1 << (rows->column_bits - 4);
    const tp_line_sample *near = rows->near + i;
    const int32_t apart = near->v - far->v, x = (rows->first + (int32_t)i) * wide;
    piece p = { .far = far, .near = near, .top = first_row(far->v),
                .far_zi = rows->far_zi[i], .near_zi = rows->near_zi[i],
                .one = wide == 1 || x + 1 >= rows->tile->x1 };

    if (apart < ROW / 2) {
        fill_single(rows, &p, y, true, true);
        return;
    }
    p.inverse = 0x7fffffffu / ((uint32_t)apart >> 8);
    if (first_row(near->v) - p.top <= FEW)
        fill_few(rows, &p, y, end, true, true);
    else
        fill_blocks(rows, &p, y, end, true, true);
}

/* s and t of a pixel, or of a pair of pixels. */
typedef struct {
    uint32_t s, t, right_s, right_t;
} places;

TP_ALWAYS_INLINE places make_places(const tp_fast_rows *rows, uint32_t s, uint32_t t,
                                    bool pairs)
{
    const uint32_t hs = pairs ? (uint32_t)rows->half_s : 0;
    const uint32_t ht = pairs ? (uint32_t)rows->half_t : 0;

    return (places){ s - hs, t - ht, s + hs, t + ht };
}

/* Writes a row of a tile without keys; `plane`: bytes from plane to plane. */
TP_ALWAYS_INLINE void write_plain(uint8_t *at, size_t plane, const places *p, uint32_t n,
                                  bool pairs)
{
    uint32_t *to_s = (uint32_t *)(void *)at, *to_t = (uint32_t *)(void *)(at + plane);
    uint32_t *to_n = (uint32_t *)(void *)(at + 2 * plane);

    if (pairs) {
        tp_store_pair(to_s, 0, p->s, p->right_s);
        tp_store_pair(to_t, 0, p->t, p->right_t);
        tp_store_pair(to_n, 0, n, n);
    } else {
        *to_s = p->s;
        *to_t = p->t;
        *to_n = n;
    }
}

/* Writes rows [y, end) of a piece of at most FEW rows. */
TP_ALWAYS_INLINE void fill_plain_few(const tp_fast_rows *rows, const tp_line_sample *far,
                                     const tp_line_sample *near, uint32_t inverse,
                                     uint8_t *at, int32_t y, int32_t end, bool pairs)
{
    const int32_t top = first_row(far->v);
    const int32_t share = (int32_t)((uint32_t)((top * ROW + ROW / 2 - far->v) >> 8) * inverse);
    const int32_t w = (share >> 1) + rows->mean_bend;       /* Q30 */
    uint32_t n = interpolate_slopes(far->n, near->n, share);
    const int32_t ds = (int32_t)(near->s - far->s), dt = (int32_t)(near->t - far->t);
    places now = make_places(rows, add_share_q30(far->s, ds, w),
                             add_share_q30(far->t, dt, w), pairs);

    if (y == top && end - y == 1) {
        write_plain(at, rows->plane, &now, n, pairs);
        return;
    }
    const int32_t per = (int32_t)(256 * inverse);
    const uint32_t step_s = (uint32_t)tp_mul_upper(ds, per) * 2;
    const uint32_t step_t = (uint32_t)tp_mul_upper(dt, per) * 2;
    const uint32_t step_n = slopes_step(far->n, near->n, per >> 1), down = (uint32_t)(y - top);
    const size_t stride = rows->stride, plane = rows->plane;
    now.s += step_s * down;
    now.t += step_t * down;
    now.right_s += step_s * down;
    now.right_t += step_t * down;
    n += step_n * down;
    const uint8_t *const stop = at + (size_t)(uint32_t)(end - y) * stride;
    do {
        write_plain(at, plane, &now, n, pairs);
        at += stride;
        now.s += step_s;
        now.t += step_t;
        now.right_s += step_s;
        now.right_t += step_t;
        n += step_n;
    } while (at != stop);
}

/* The same values as fill_single, fill_few and fill_blocks, written for few registers. */
TP_ALWAYS_INLINE void fill_plain(const tp_fast_rows *rows, const tp_line_sample *far,
                                 int32_t y, int32_t end, bool pairs)
{
    const tp_line_sample *near =
        (const tp_line_sample *)(const void *)((const uint8_t *)far + rows->behind);
    const int32_t apart = near->v - far->v;
    uint8_t *at =
        rows->s_plane + (size_t)(uint32_t)y * rows->stride
        + ((size_t)((const uint8_t *)far - (const uint8_t *)rows->far) >> (pairs ? 1 : 2));

    if (apart < ROW / 2) {
        const bool by_near = y * ROW + ROW / 2 - far->v > near->v - (y * ROW + ROW / 2);
        const tp_line_sample *by = by_near ? near : far;
        const places now = make_places(rows, by->s, by->t, pairs);
        write_plain(at, rows->plane, &now, by->n, pairs);
        return;
    }
    const uint32_t inverse = 0x7fffffffu / ((uint32_t)apart >> 8);
    if (first_row(near->v) - first_row(far->v) > FEW) {
        const piece p = { .far = far, .near = near, .top = first_row(far->v),
                          .inverse = inverse };
        fill_plain_blocks(rows, &p, y, end);
        return;
    }
    fill_plain_few(rows, far, near, inverse, at, y, end, pairs);
}

void tp_fast_rows_fill_pixels(const tp_fast_rows *rows, const tp_line_sample *far,
                              int32_t y, int32_t end)
{
    fill_plain(rows, far, y, end, false);
}

void tp_fast_rows_fill_pairs(const tp_fast_rows *rows, const tp_line_sample *far,
                             int32_t y, int32_t end)
{
    fill_plain(rows, far, y, end, true);
}

void tp_fast_rows_draw_line(const tp_fast_rows *rows, const tp_line_sample *far, int32_t y)
{
    const size_t i = (size_t)(far - rows->far);
    const int32_t wide = 1 << (rows->column_bits - 4);
    const int32_t x = (rows->first + (int32_t)i) * wide;
    const values now = { far->s, far->t, far->n, make_water_key(rows->far_zi[i]) };

    write_row(rows, piece_pointer(rows, far, y), plane_stride(rows->tile), &now,
              wide == 1 || x + 1 >= rows->tile->x1, true, true);
}
