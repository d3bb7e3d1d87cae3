/* SPDX-License-Identifier: MIT */
/* Lines of water into samples; see the header for the idea.
 *
 * A segment of a line is walked from centre to centre of the columns between its ends.
 * What is linear on the screen (v, zi, slopes) has its own value where a segment begins
 * and at multiples of 16 columns, and a step between.  So have s and t, which are true
 * there to the perspective in segments long and deep enough to show it.  Down a column
 * the same goes for rows.
 *
 * The share of the way along a segment or down a piece is a Q.31; a part of a difference
 * is the upper word of a product, doubled.  Places are 16.16 pixels of 2^13, so that
 * differences stay below 2^31. */
#include "raster/edge.h"
#include "raster/rows.h"

#define ROW 65536               /* 16.16 */

size_t tp_rows_bytes(uint32_t columns)
{
    return columns * sizeof(tp_row_column);
}

/* The limit of a column that is covered from row `top` down: v <= limit begins above. */
static inline int32_t limit_of(int32_t top)
{
    return top * ROW - ROW / 2;
}

/* The first row whose centre lies at or below v. */
static inline int32_t first_row(int32_t v)
{
    return (v + (ROW / 2 - 1)) >> 16;
}

static bool holds_any(const tp_samples *tile)
{
    size_t width = (size_t)(uint32_t)(tile->x1 - tile->x0);
    const uint32_t *key = tile->key;

    for (int32_t y = tile->y0; y < tile->y1; y++, key += tile->stride) {
        uint32_t any = 0;
        for (size_t x = 0; x < width; x++)
            any |= key[x];
        if (any)
            return true;
    }
    return false;
}

void tp_rows_begin(tp_rows *rows, const tp_samples *tile, void *memory, bool solid)
{
    int32_t limit = limit_of(tile->y1);

    *rows = (tp_rows){
        .tile = tile, .column = memory, .x0 = tile->x0, .x1 = tile->x1,
        .open = tile->x1 - tile->x0, .solid = solid && holds_any(tile),
    };
    for (int32_t i = 0; i < rows->open; i++) {
        rows->column[i].limit = limit;
        rows->column[i].v = TP_ROW_NONE;
    }
}

/* -- shares ---------------------------------------------------------------------------- */

/* q + share of d, Q.31. */
TP_ALWAYS_INLINE int32_t part(int32_t q, int32_t d, int32_t share)
{
    return (int32_t)((uint32_t)q + (uint32_t)tp_mul_upper(d, share) * 2);
}

TP_ALWAYS_INLINE int32_t difference(int32_t from, int32_t to)
{
    return (int32_t)((uint32_t)to - (uint32_t)from);
}

TP_ALWAYS_INLINE int32_t high(uint32_t n)
{
    return (int32_t)n >> 16;
}

TP_ALWAYS_INLINE int32_t low(uint32_t n)
{
    return (int16_t)n;
}

TP_ALWAYS_INLINE uint32_t packed(int32_t x, int32_t z)
{
    return (uint32_t)x << 16 | ((uint32_t)z & 0xffff);
}

/* Slopes between two, share in Q.14: differences of 17 bits. */
TP_ALWAYS_INLINE uint32_t slopes_between(uint32_t from, uint32_t to, int32_t share)
{
    int32_t w = share >> 17;
    return packed(high(from) + (((high(to) - high(from)) * w + 8192) >> 14),
                  low(from) + (((low(to) - low(from)) * w + 8192) >> 14));
}

/* A step of both: the low one may carry into the high one, an LSB of 2^-12. */
TP_ALWAYS_INLINE uint32_t slopes_step(uint32_t from, uint32_t to, int32_t per)
{
    int32_t x = (high(to) - high(from)) * 16384, z = (low(to) - low(from)) * 16384;
    return (uint32_t)((tp_mul_upper(x, per) + 2048) >> 12) * 65536u
         + (uint32_t)((tp_mul_upper(z, per) + 2048) >> 12);
}

/* s and t between two places of different depth stray from straight by a quarter of
 * (ratio - 1) times the length: half a pixel is allowed. */
static inline bool is_deep(uint32_t za, uint32_t zb, uint32_t length)
{
    uint32_t least = za < zb ? za : zb, more = za < zb ? zb - za : za - zb;
    return (uint64_t)(more >> 1) * (length + 1) > least;
}

/* The share of s and t where that of the screen is given: share zb / z.  share zb is no
 * more than z, and its quotient is kept below 2^31. */
static int32_t deep_share(int32_t share, uint32_t za, uint32_t zb)
{
    uint32_t z = (uint32_t)part((int32_t)za, difference((int32_t)za, (int32_t)zb), share);
    uint64_t over = (uint64_t)(uint32_t)share * zb >> 31;
    int      shift = tp_clz(z | 1);
    uint64_t q = over * tp_recip_norm((z | 1) << shift) >> (32 - shift);

    return q < INT32_MAX ? (int32_t)q : INT32_MAX;
}

/* -- down a column --------------------------------------------------------------------- */

/* A pixel of a column, or what is added from row to row. */
typedef struct {
    uint32_t key, s, t, n;
} sample;

TP_ALWAYS_INLINE uint32_t key_of(uint32_t zi)
{
    return (zi << 1 & ~(uint32_t)0xff) | TP_MARK_WATER;
}

/* A step of keys leaves the mark alone. */
TP_ALWAYS_INLINE uint32_t key_step(int32_t zi_step)
{
    return ((uint32_t)zi_step * 2 + 128) & ~(uint32_t)0xff;
}

TP_ALWAYS_INLINE void put(const tp_samples *tile, size_t at, const sample *p, int tested)
{
    if (tested && p->key <= (tile->key[at] | 0xff))
        return;
    tile->key[at] = p->key;
    tile->s[at] = p->s;
    tile->t[at] = p->t;
    tile->n[at] = p->n;
}

TP_ALWAYS_INLINE size_t place_in(const tp_samples *tile, int32_t x, int32_t y)
{
    return (size_t)(uint32_t)(y - tile->y0) * tile->stride + (uint32_t)(x - tile->x0);
}

TP_ALWAYS_INLINE void step_down(sample *p, const sample *step, uint32_t rows)
{
    p->key += step->key * rows;
    p->s += step->s * rows;
    p->t += step->t * rows;
    p->n += step->n * rows;
}

/* Rows [y, end), `now` that of row `top`. */
TP_ALWAYS_INLINE void fill(const tp_samples *tile, int32_t x, int32_t y, int32_t end,
                           int32_t top, sample now, sample step, int tested)
{
    const size_t stride = tile->stride;
    size_t at = place_in(tile, x, y);
    uint32_t *key = tile->key, *s = tile->s, *t = tile->t, *n = tile->n;

    if (y > top)
        step_down(&now, &step, (uint32_t)(y - top));
    for (int32_t count = end - y; count > 0; count--) {
        if (!tested || now.key > (key[at] | 0xff)) {
            key[at] = now.key;
            s[at] = now.s;
            t[at] = now.t;
            n[at] = now.n;
        }
        step_down(&now, &step, 1);
        at += stride;
    }
}

/* The lower line `near`, the upper one `far`, and shares of the way down. */
typedef struct {
    const tp_row_column *far, *near;
    uint32_t inverse;           /* 2^31 over the rows between, Q8 */
    int32_t  up;                /* what a row is of the way, negative, Q.30; of more
                                 * than one */
} between;

TP_ALWAYS_INLINE int32_t share_at(const between *b, int32_t y)
{
    return (int32_t)((uint32_t)((y * ROW + ROW / 2 - b->far->v) >> 8) * b->inverse);
}

/* s and t as on the screen; steps of more than one row. */
TP_ALWAYS_INLINE void set_straight(const between *b, int32_t y, bool steps, sample *now,
                                   sample *step)
{
    const tp_row_column *far = b->far, *near = b->near;
    int32_t share = share_at(b, y), up = b->up;
    int32_t dz = difference((int32_t)far->zi, (int32_t)near->zi);
    int32_t ds = difference(far->s, near->s), dt = difference(far->t, near->t);

    now->key = key_of((uint32_t)part((int32_t)far->zi, dz, share));
    now->s = (uint32_t)part(far->s, ds, share);
    now->t = (uint32_t)part(far->t, dt, share);
    now->n = slopes_between(far->n, near->n, share);
    *step = (sample){ 0, 0, 0, 0 };
    if (steps) {
        step->key = key_step(tp_mul_upper(difference((int32_t)near->zi, (int32_t)far->zi), up) * 4);
        step->s = (uint32_t)tp_mul_upper(difference(near->s, far->s), up) * 4;
        step->t = (uint32_t)tp_mul_upper(difference(near->t, far->t), up) * 4;
        step->n = slopes_step(near->n, far->n, up);
    }
}

typedef struct {
    uint32_t s, t;
} place;

static place place_at(const between *b, int32_t y)
{
    const tp_row_column *far = b->far, *near = b->near;
    int32_t share = deep_share(share_at(b, y), far->zi, near->zi);

    return (place){ (uint32_t)part(far->s, difference(far->s, near->s), share),
                    (uint32_t)part(far->t, difference(far->t, near->t), share) };
}

/* 65536 / n for the rows or columns between two true places. */
static const uint32_t over[17] = { 0, 65536, 32768, 21845, 16384, 13107, 10923, 9362,
                                   8192, 7282, 6554, 5958, 5461, 5041, 4681, 4369, 4096 };

static uint32_t step_between(uint32_t from, uint32_t to, int32_t n)
{
    return (uint32_t)((int64_t)(int32_t)(to - from) * over[n] >> 16);
}

/* Rows [y, end) of a piece that begins at row `top`, true in perspective at multiples of
 * 16 rows and at its own ends. */
static void fill_deep(const tp_rows *rows, const between *b, int32_t x, int32_t y,
                      int32_t end, int32_t top)
{
    int32_t last = first_row(b->near->v) - 1;
    int32_t from = (y & ~15) > top ? y & ~15 : top;
    place   p = place_at(b, from);
    sample  now, step;

    for (int32_t stop; y < end; y = from = stop) {
        int32_t next = (from | 15) + 1, to = next < last ? next : last;
        place   q = to > from ? place_at(b, to) : p;
        stop = next < end ? next : end;
        set_straight(b, from, true, &now, &step);
        now.s = p.s;
        now.t = p.t;
        step.s = to > from ? step_between(p.s, q.s, to - from) : 0;
        step.t = to > from ? step_between(p.t, q.t, to - from) : 0;
        fill(rows->tile, x, y, stop, from, now, step, 1);
        p = q;
    }
}

/* What lies below row y of a column is covered. */
TP_ALWAYS_INLINE void close(tp_rows *rows, tp_row_column *column, int32_t y)
{
    column->limit = limit_of(y);
    if (y == rows->tile->y0) {
        column->limit = INT32_MIN;
        rows->open--;
    }
}

TP_ALWAYS_INLINE void remember(tp_row_column *column, const tp_row_column *line)
{
    column->v = line->v;
    column->zi = line->zi;
    column->s = line->s;
    column->t = line->t;
    column->n = line->n;
}

/* Column x of the line where it lies at one pixel. */
static void put_alone(const tp_rows *rows, const tp_row_column *line, int32_t x, int32_t y)
{
    const sample p = { key_of(line->zi), (uint32_t)line->s, (uint32_t)line->t, line->n };

    if (rows->solid)
        put(rows->tile, place_in(rows->tile, x, y), &p, 1);
    else
        put(rows->tile, place_in(rows->tile, x, y), &p, 0);
}

static void fill_piece(const tp_rows *rows, const tp_row_column *near,
                       const tp_row_column *far, int32_t x, int32_t y, int32_t end,
                       int32_t top)
{
    uint32_t apart = (uint32_t)(near->v - far->v);
    uint32_t inverse = 0x7fffffffu / (apart >> 8);
    const between b = { far, near, inverse, (int32_t)(0u - 128 * inverse) };
    sample now, step;

    if (is_deep(far->zi, near->zi, apart >> 16)) {
        fill_deep(rows, &b, x, y, end, top);
        return;
    }
    set_straight(&b, top, end - top > 1, &now, &step);
    if (rows->solid)
        fill(rows->tile, x, y, end, top, now, step, 1);
    else
        fill(rows->tile, x, y, end, top, now, step, 0);
}

/* What is seen between the line that the column remembers and this one, which covers it
 * from now on.  Of lines less than a quarter of a row apart the far one is near enough. */
static __attribute__((noinline)) void cover(tp_rows *rows, tp_row_column *near,
                                            const tp_row_column *far)
{
    const tp_samples *tile = rows->tile;
    int32_t top = first_row(far->v), y = top > tile->y0 ? top : tile->y0;
    int32_t end = (near->limit + ROW / 2) >> 16, apart = near->v - far->v;
    int32_t x = tile->x0 + (int32_t)(near - rows->column);

    close(rows, near, y);
    if (y < end && near->v != TP_ROW_NONE) {
        if (apart >= ROW / 4)
            fill_piece(rows, near, far, x, y, end, top);
        else
            put_alone(rows, far, x, y);
    }
    remember(near, far);
}

/* The same without a line before; the pixel at this one is drawn if it is `joined`. */
static void begin(tp_rows *rows, tp_row_column *column, const tp_row_column *line,
                  bool joined)
{
    const tp_samples *tile = rows->tile;
    int32_t top = first_row(line->v), y = top > tile->y0 ? top : tile->y0;
    int32_t end = (column->limit + ROW / 2) >> 16;

    close(rows, column, y);
    if (joined && top >= tile->y0 && top < end)
        put_alone(rows, line, tile->x0 + (int32_t)(column - rows->column), top);
    remember(column, line);
}

/* -- along a line ---------------------------------------------------------------------- */

enum { LINE, START, JOINED, SIDE };

/* Columns [x, end), beginning with `now` at x. */
TP_ALWAYS_INLINE void walk(tp_rows *rows, const tp_row_column *now,
                           const tp_row_column *step, int32_t x, int32_t end, int kind)
{
    tp_row_column *column = rows->column + (x - rows->tile->x0);
    tp_row_column *stop = column + (end - x);
    uint32_t v = (uint32_t)now->v, zi = now->zi, s = (uint32_t)now->s;
    uint32_t t = (uint32_t)now->t, n = now->n;

    do {
        if ((int32_t)v > column->limit) {
            column->v = (int32_t)v;
            column->zi = zi;
            column->s = (int32_t)s;
            column->t = (int32_t)t;
            column->n = n;
        } else {
            const tp_row_column line = { 0, (int32_t)v, zi, (int32_t)s, (int32_t)t, n };
            if (kind == LINE)
                cover(rows, column, &line);
            else
                begin(rows, column, &line, kind == JOINED);
        }
        v += (uint32_t)step->v;
        zi += step->zi;
        s += (uint32_t)step->s;
        t += (uint32_t)step->t;
        n += step->n;
    } while (++column < stop);
}

/* A segment and shares of the way from a to b. */
typedef struct {
    const tp_row_point *a, *b;
    uint32_t inverse;           /* 2^31 over its width, 28.4 */
    int32_t  dv, dz, ds, dt;
    bool     deep;
} segment;

static int32_t share_of(const segment *g, int32_t x)
{
    return (int32_t)((uint32_t)(16 * x + 8 - g->a->u) * g->inverse);
}

static place place_along(const segment *g, int32_t x)
{
    int32_t share = share_of(g, x);

    if (g->deep)
        share = deep_share(share, g->a->zi, g->b->zi);
    return (place){ (uint32_t)part(g->a->s, g->ds, share),
                    (uint32_t)part(g->a->t, g->dt, share) };
}

/* Steps from column to column, of a segment of more than one. */
static tp_row_column steps_of(const segment *g)
{
    int32_t per = (int32_t)(g->inverse * 8);

    return (tp_row_column){
        .v = tp_mul_upper(g->dv, per) * 4,
        .zi = (uint32_t)tp_mul_upper(g->dz, per) * 4,
        .s = tp_mul_upper(g->ds, per) * 4,
        .t = tp_mul_upper(g->dt, per) * 4,
        .n = slopes_step(g->a->n, g->b->n, per),
    };
}

static tp_row_column value_at(const segment *g, int32_t x)
{
    int32_t share = share_of(g, x);
    place   p = place_along(g, x);

    return (tp_row_column){
        .v = part(g->a->v * 4096, g->dv, share),
        .zi = (uint32_t)part((int32_t)g->a->zi, g->dz, share),
        .s = (int32_t)p.s, .t = (int32_t)p.t,
        .n = slopes_between(g->a->n, g->b->n, share),
    };
}

static void go_along(tp_row_column *now, const tp_row_column *step, int32_t columns)
{
    uint32_t n = (uint32_t)columns;

    now->v += step->v * columns;
    now->zi += step->zi * n;
    now->s = (int32_t)((uint32_t)now->s + (uint32_t)step->s * n);
    now->t = (int32_t)((uint32_t)now->t + (uint32_t)step->t * n);
    now->n += step->n * n;
}

/* Columns [x, end) of those from `first` to `stop` that the segment has. */
TP_ALWAYS_INLINE void walk_segment(tp_rows *rows, const segment *g, int32_t first,
                                   int32_t stop, int32_t x, int32_t end, int kind)
{
    tp_row_column step = { .v = 0 };

    if (stop - first > 1)
        step = steps_of(g);
    for (int32_t to; x < end; x = to) {
        int32_t from = (x & ~15) > first ? x & ~15 : first, next = (from | 15) + 1;
        tp_row_column now = value_at(g, from);
        if (g->deep && stop - first > 1) {
            int32_t last = next < stop ? next : stop - 1;
            place   q = place_along(g, last);
            step.s = step.t = 0;
            if (last > from) {
                step.s = (int32_t)step_between((uint32_t)now.s, q.s, last - from);
                step.t = (int32_t)step_between((uint32_t)now.t, q.t, last - from);
            }
        }
        to = next < end ? next : end;
        go_along(&now, &step, x - from);
        walk(rows, &now, &step, x, to, kind);
    }
}

TP_ALWAYS_INLINE void along(tp_rows *rows, const tp_row_point *a, const tp_row_point *b,
                            int kind)
{
    int32_t first = tp_first_centre(a->u), stop = tp_first_centre(b->u);
    int32_t x = first > rows->x0 ? first : rows->x0;
    int32_t end = stop < rows->x1 ? stop : rows->x1;

    if (x >= end)
        return;
    const segment g = {
        a, b, 0x7fffffffu / (uint32_t)(b->u - a->u), (b->v - a->v) * 4096,
        difference((int32_t)a->zi, (int32_t)b->zi), difference(a->s, b->s),
        difference(a->t, b->t), is_deep(a->zi, b->zi, (uint32_t)(b->u - a->u) >> 4),
    };
    walk_segment(rows, &g, first, stop, x, end, kind);
}

void tp_rows_line(tp_rows *rows, const tp_row_point *point, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++)
        along(rows, &point[i - 1], &point[i], LINE);
}

void tp_rows_start(tp_rows *rows, const tp_row_point *point, uint32_t count, bool joined)
{
    for (uint32_t i = 1; i < count; i++) {
        if (joined)
            along(rows, &point[i - 1], &point[i], JOINED);
        else
            along(rows, &point[i - 1], &point[i], START);
    }
}

void tp_rows_side(tp_rows *rows, const tp_row_point *left, const tp_row_point *right)
{
    along(rows, left, right, SIDE);
}

void tp_rows_gap(tp_rows *rows, int32_t left_28_4, int32_t right_28_4)
{
    int32_t first = tp_first_centre(left_28_4), stop = tp_first_centre(right_28_4);
    int32_t end = stop < rows->x1 ? stop : rows->x1;

    for (int32_t x = first > rows->x0 ? first : rows->x0; x < end; x++)
        rows->column[x - rows->tile->x0].v = TP_ROW_NONE;
}
