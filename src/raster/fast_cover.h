/* SPDX-License-Identifier: MIT */
/* Internals shared by the files of raster/fast_scanlines.h. */
#ifndef TP_RASTER_FAST_COVER_H
#define TP_RASTER_FAST_COVER_H
#include "raster/fast_scanlines.h"
#include "raster/scanline_cover.h"

/* Writes the samples of a column, of the line `far` and the line before it, in rows [y, end):
 * of tiles with keys; without, of pixels; of pairs of pixels. */
typedef void (*tp_fast_fill)(const tp_fast_rows *rows, const tp_line_sample *far, int32_t y,
                             int32_t end);

void tp_fast_rows_fill_keyed(const tp_fast_rows *rows, const tp_line_sample *far, int32_t y,
                             int32_t end);
void tp_fast_rows_fill_pixels(const tp_fast_rows *rows, const tp_line_sample *far, int32_t y,
                              int32_t end);
void tp_fast_rows_fill_pairs(const tp_fast_rows *rows, const tp_line_sample *far, int32_t y,
                             int32_t end);

/* Draws the pixel of a line behind triangles, of a tile with keys. */
void tp_fast_rows_draw_line(const tp_fast_rows *rows, const tp_line_sample *far, int32_t y);

/* Handles the columns where the line just laid rises to its limit: draws the visible pixels
 * between the previous line and this line, if `kind` is TP_LINE_ON; this line then covers
 * the column. */
void tp_fast_rows_cover(tp_fast_rows *rows, tp_line_kind kind);

#endif
