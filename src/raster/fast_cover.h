/* SPDX-License-Identifier: MIT */
/* Internals shared by the files of raster/fast_scanlines.h. */
#ifndef TP_RASTER_FAST_COVER_H
#define TP_RASTER_FAST_COVER_H
#include "raster/fast_scanlines.h"
#include "raster/scanline_cover.h"

/* Handles the columns where the line just laid rises to its limit: draws the visible pixels
 * between the previous line and this line, if `kind` is TP_LINE_ON; this line then covers
 * the column. */
void tp_fast_rows_cover(tp_fast_rows *rows, tp_line_kind kind);

#endif
