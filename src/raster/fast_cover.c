/* SPDX-License-Identifier: MIT */
/* Finds the pixels of each column between two lines of water, the fast rung; see
 * fast_scanlines.h.  fast_fill.c writes their samples. */
#include "raster/fast_cover.h"

/* Handles a visible column of a line behind a gap. */
TP_NEVER_INLINE void restart(tp_fast_rows *rows, const tp_line_sample *far, int32_t end,
                             bool behind_triangles)
{
    const int32_t top = first_row(far->v), y0 = rows->tile->y0;

    rows->holes |= (top > y0 ? top : y0) < end;
    if (behind_triangles && rows->far_zi && top >= y0 && top < end)
        tp_fast_rows_draw_line(rows, far, top);
}

/* Handles a visible column, with water down to the previous line. */
TP_ALWAYS_INLINE void cover_column(tp_fast_rows *rows, const tp_line_sample *far,
                                   int32_t *limit, tp_fast_fill fill)
{
    const tp_line_sample *near =
        (const tp_line_sample *)(const void *)((const uint8_t *)far + rows->behind);
    int32_t y = first_row(far->v), end = (*limit + ROW / 2) >> 16;

    if (y > rows->y0) {
        *limit = v_limit_above_row(y);
    } else {
        y = rows->y0;
        *limit = INT32_MIN;
        rows->open--;
    }
    if (y >= end)
        return;
    if (near->v == TP_LINE_NONE) {
        restart(rows, far, end, false);
        return;
    }
    if (rows->means) {          /* no mean row at either end */
        y += tp_is_mean_row(y);
        end -= tp_is_mean_row(end - 1);
        if (y >= end)
            return;
    }
    fill(rows, far, y, end);
}

/* Handles the columns from `far` to `last`. */
static void cover_columns(tp_fast_rows *rows, const tp_line_sample *far,
                          const tp_line_sample *last, int32_t *limit, tp_fast_fill fill)
{
    do {
        if (far->v <= *limit)
            cover_column(rows, far, limit, fill);
        limit++;
    } while (++far != last);
}

/* The same behind a gap. */
static void restart_columns(tp_fast_rows *rows, const tp_line_sample *far,
                            const tp_line_sample *last, int32_t *limit,
                            bool behind_triangles)
{
    const int32_t y0 = rows->tile->y0;

    for (; far != last; far++, limit++) {
        const int32_t end = (*limit + ROW / 2) >> 16, top = first_row(far->v);
        if (far->v > *limit)
            continue;
        *limit = top > y0 ? v_limit_above_row(top) : INT32_MIN;
        rows->open -= top <= y0;
        restart(rows, far, end, behind_triangles);
    }
}

void tp_fast_rows_cover(tp_fast_rows *rows, tp_line_kind kind)
{
    const tp_line_sample *far = rows->far + (rows->laid0 - rows->first);
    const tp_line_sample *const last = rows->far + (rows->laid1 - rows->first);
    int32_t *limit = rows->limit + (rows->laid0 - rows->first);

    rows->behind = (const uint8_t *)rows->near - (const uint8_t *)rows->far;
    if (kind == TP_LINE_ON)
        cover_columns(rows, far, last, limit,
                      rows->far_zi ? tp_fast_rows_fill_keyed
                      : rows->column_bits > 4 ? tp_fast_rows_fill_pairs
                                              : tp_fast_rows_fill_pixels);
    else
        restart_columns(rows, far, last, limit, kind == TP_LINE_BEHIND_TRIANGLES);
}
