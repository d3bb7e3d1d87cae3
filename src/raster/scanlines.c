/* SPDX-License-Identifier: MIT */
/* Rasterizes lines of water; see the header for the idea.
 *
 * A segment of a line is walked over the pixel centres of the columns between its ends.
 * Values linear on the screen (v, zi, slopes) are exact at the start of a segment and at
 * multiples of 16 columns, with a step between.  The same holds for s and t; in segments
 * long and deep enough to show perspective, s and t are exact in perspective at these
 * columns. */
#include "raster/raster.h"
#include "raster/scanline_cover.h"

size_t tp_rows_bytes(uint32_t columns)
{
    return columns * sizeof(tp_row_column);
}

static bool has_any_sample(const tp_gbuffer *tile)
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

void tp_rows_begin(tp_rows *rows, const tp_gbuffer *tile, void *memory, bool solid)
{
    TP_ASSERT(tile->x0 < tile->x1 && (uintptr_t)memory % 4 == 0);
    int32_t limit = v_limit_above_row(tile->y1);

    *rows = (tp_rows){
        .tile = tile, .column = memory, .x0 = tile->x0, .x1 = tile->x1,
        .open = tile->x1 - tile->x0, .solid = solid && has_any_sample(tile),
    };
    for (int32_t i = 0; i < rows->open; i++) {
        rows->column[i].limit = limit;
        rows->column[i].line.v = TP_ROW_NONE;
    }
}

/* -- along a line -------------------------------------------------------------------- */

typedef struct {
    uint32_t s, t;
} column_st;

/* Kinds of segments: a line with water down to the previous line; the first line behind a
 * gap, as the edge of a side is, or behind triangles that fill the gap. */
enum { LINE, BEHIND_GAP, BEHIND_TRIANGLES };

/* Rows between two lines.  For closer lines a pixel between takes the values of the
 * nearer line. */
#define CLOSE (ROW / 2)

/* Draws the only row of column x with its centre between two close lines. */
TP_ALWAYS_INLINE void draw_single_pixel(const tp_rows *rows, const tp_row_sample *near,
                                        const tp_row_sample *far, int32_t x, int32_t y)
{
    const tp_gbuffer *tile = rows->tile;
    uint32_t *at = key_pointer(tile, x, y);
    const size_t plane = plane_stride(tile);
    const int32_t down = y * ROW + ROW / 2 - far->v;

    if (down > near->v - far->v - down) {
        const sample p = { make_water_key(near->zi), (uint32_t)near->s, (uint32_t)near->t,
                           near->n };
        write_sample(at, plane, &p, rows->solid);
    } else {
        const sample p = { make_water_key(far->zi), (uint32_t)far->s, (uint32_t)far->t,
                           far->n };
        write_sample(at, plane, &p, rows->solid);
    }
}

/* Handles a column where a line rises to its limit: draws the visible pixels between the
 * previous line and this line; this line then covers the column. */
TP_ALWAYS_INLINE void cover_column(tp_rows *rows, tp_row_column *column,
                                   const tp_row_sample *far, int32_t x)
{
    const int32_t y0 = rows->tile->y0, end = (column->limit + ROW / 2) >> 16;
    const int32_t near = column->line.v, top = first_row(far->v);
    int32_t y = top;

    if (top > y0) {
        column->limit = v_limit_above_row(top);
    } else {
        y = y0;
        column->limit = INT32_MIN;
        rows->open--;
    }
    if (y >= end || near == TP_ROW_NONE)
        return;
    if (near - far->v < CLOSE) {
        draw_single_pixel(rows, &column->line, far, x, y);
    } else {
        const tp_row_sample line = *far;
        tp_rows_fill_column(rows, &column->line, &line, x, y, end, top);
    }
}

/* Walks columns [x, end); `now` is the value at column x. */
TP_ALWAYS_INLINE void walk_columns(tp_rows *rows, const tp_row_sample *now,
                                   const tp_row_sample *step, int32_t x, int32_t end,
                                   int kind)
{
    TP_ASSERT(x < end && x >= rows->tile->x0 && end <= rows->tile->x1);
    tp_row_column *column = rows->column + (x - rows->tile->x0);
    uint32_t v = (uint32_t)now->v, zi = now->zi, s = (uint32_t)now->s;
    uint32_t t = (uint32_t)now->t, n = now->n;

    do {
        const tp_row_sample line = { (int32_t)v, zi, (int32_t)s, (int32_t)t, n };
        if ((int32_t)v <= column->limit) {
            if (kind == LINE)
                cover_column(rows, column, &line, x);
            else
                tp_row_restart_column(rows, column, &line, kind == BEHIND_TRIANGLES);
        }
        column->line.v = (int32_t)v;
        column->line.zi = zi;
        column->line.s = (int32_t)s;
        column->line.t = (int32_t)t;
        column->line.n = n;
        column++;
        v += (uint32_t)step->v;
        zi += step->zi;
        s += (uint32_t)step->s;
        t += (uint32_t)step->t;
        n += step->n;
    } while (++x < end);
}

/* A segment from a to b, with constants for interpolation. */
typedef struct {
    const tp_row_point *a, *b;
    uint32_t inverse;           /* 2^31 / width of the segment, width in 28.4 px */
    int32_t  dv, dz, ds, dt;
    bool     deep;
} segment;

static int32_t column_share(const segment *g, int32_t x)
{
    return (int32_t)((uint32_t)(16 * x + 8 - g->a->u) * g->inverse);
}

static column_st interpolate_st(const segment *g, int32_t x)
{
    int32_t share = column_share(g, x);

    if (g->deep)
        share = tp_row_perspective_share(share, g->a->zi, g->b->zi);
    return (column_st){ (uint32_t)add_share(g->a->s, g->ds, share),
                        (uint32_t)add_share(g->a->t, g->dt, share) };
}

/* Returns the steps from column to column; the segment has more than one column. */
static tp_row_sample column_steps(const segment *g)
{
    int32_t per = (int32_t)(g->inverse * 8);

    return (tp_row_sample){
        .v = tp_mul_upper(g->dv, per) * 4,
        .zi = (uint32_t)tp_mul_upper(g->dz, per) * 4,
        .s = tp_mul_upper(g->ds, per) * 4,
        .t = tp_mul_upper(g->dt, per) * 4,
        .n = slopes_step(g->a->n, g->b->n, per),
    };
}

static tp_row_sample interpolate_sample(const segment *g, int32_t x)
{
    int32_t share = column_share(g, x);
    column_st   p = interpolate_st(g, x);

    return (tp_row_sample){
        .v = add_share(g->a->v * 4096, g->dv, share),
        .zi = (uint32_t)add_share((int32_t)g->a->zi, g->dz, share),
        .s = (int32_t)p.s, .t = (int32_t)p.t,
        .n = interpolate_slopes(g->a->n, g->b->n, share),
    };
}

static void advance_columns(tp_row_sample *now, const tp_row_sample *step, int32_t columns)
{
    uint32_t n = (uint32_t)columns;

    now->v += step->v * columns;
    now->zi += step->zi * n;
    now->s = (int32_t)((uint32_t)now->s + (uint32_t)step->s * n);
    now->t = (int32_t)((uint32_t)now->t + (uint32_t)step->t * n);
    now->n += step->n * n;
}

/* Walks columns [x, end) of a segment with columns [first, stop). */
TP_ALWAYS_INLINE void walk_segment(tp_rows *rows, const segment *g, int32_t first,
                                   int32_t stop, int32_t x, int32_t end, int kind)
{
    tp_row_sample step = { .v = 0 };

    if (stop - first > 1)
        step = column_steps(g);
    for (int32_t to; x < end; x = to) {
        int32_t from = (x & ~15) > first ? x & ~15 : first, next = (from | 15) + 1;
        tp_row_sample now = interpolate_sample(g, from);
        if (g->deep && stop - first > 1) {
            int32_t last = next < stop ? next : stop - 1;
            column_st   q = interpolate_st(g, last);
            step.s = step.t = 0;
            if (last > from) {
                step.s = (int32_t)tp_row_st_step((uint32_t)now.s, q.s, last - from);
                step.t = (int32_t)tp_row_st_step((uint32_t)now.t, q.t, last - from);
            }
        }
        to = next < end ? next : end;
        advance_columns(&now, &step, x - from);
        walk_columns(rows, &now, &step, x, to, kind);
    }
}

TP_ALWAYS_INLINE void rasterize_segment(tp_rows *rows, const tp_row_point *a,
                                        const tp_row_point *b, int kind)
{
    int32_t first = tp_first_centre(a->u), stop = tp_first_centre(b->u);
    int32_t x = first > rows->x0 ? first : rows->x0;
    int32_t end = stop < rows->x1 ? stop : rows->x1;

    if (x >= end)
        return;
    const segment g = {
        a,
        b,
        0x7fffffffu / (uint32_t)(b->u - a->u),
        (b->v - a->v) * 4096,
        difference((int32_t)a->zi, (int32_t)b->zi),
        difference(a->s, b->s),
        difference(a->t, b->t),
        needs_row_perspective(a->zi, b->zi, (uint32_t)(b->u - a->u) >> 4),
    };
    walk_segment(rows, &g, first, stop, x, end, kind);
}

void tp_rows_draw_line(tp_rows *rows, const tp_row_point *point, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++)
        rasterize_segment(rows, &point[i - 1], &point[i], LINE);
}

void tp_rows_restart_line(tp_rows *rows, const tp_row_point *point, uint32_t count,
                          bool behind_triangles)
{
    const int kind = behind_triangles ? BEHIND_TRIANGLES : BEHIND_GAP;

    for (uint32_t i = 1; i < count; i++)
        rasterize_segment(rows, &point[i - 1], &point[i], kind);
}

void tp_rows_restart_side(tp_rows *rows, const tp_row_point *left,
                          const tp_row_point *right)
{
    const tp_row_point point[2] = { *left, *right };

    tp_rows_restart_line(rows, point, 2, false);
}

void tp_rows_mark_gap(tp_rows *rows, int32_t left_28_4, int32_t right_28_4)
{
    int32_t first = tp_first_centre(left_28_4), stop = tp_first_centre(right_28_4);
    int32_t end = stop < rows->x1 ? stop : rows->x1;

    for (int32_t x = first > rows->x0 ? first : rows->x0; x < end; x++)
        rows->column[x - rows->tile->x0].line.v = TP_ROW_NONE;
}
