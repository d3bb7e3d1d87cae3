/* SPDX-License-Identifier: MIT */
/*
 * Kept lines: lines of streamed water that a scratch keeps while the tiles of a strip are
 * drawn from top to bottom.  A line is a row of grid vertices, or a line of walked water.  A
 * tile then computes only the lines that the tiles above it did not need.
 *
 * Line n has slot n modulo the number of slots.  Of two lines with one slot the nearer stays,
 * which has the larger number: tiles further down need that line again.
 */
#ifndef TP_VIEW_KEPT_LINES_H
#define TP_VIEW_KEPT_LINES_H
#include "base/base.h"

/* The head of the lines in a scratch; the numbers of the lines follow, then the lines. */
typedef struct {
    uint64_t frame;             /* the frame's address, */
    uint32_t picture;           /* its picture, */
    uint32_t strip;             /* and the first column of the strip that the lines belong to */
    uint32_t count;             /* slots */
    uint32_t line_bytes;
    uint32_t number[];          /* of the line in each slot, plus 1; 0: none */
} tp_kept_lines;

/* Returns the bytes of `count` lines and their head: a multiple of 8. */
static inline size_t tp_kept_lines_bytes(uint32_t count, uint32_t line_bytes)
{
    return (sizeof(tp_kept_lines) + count * (sizeof(uint32_t) + line_bytes) + 7) & ~(size_t)7;
}

/* open: returns the lines in `memory`, at least two; NULL: the bytes are too few.  Lines of
 * another frame, picture or strip than in `wanted` are forgotten, and all before the first
 * tile of a strip.  wanted->count is not read.
 * find: returns the memory of a line; *known is true if the line is there.  Returns NULL, and
 * leaves *known alone, if the slot has a nearer line. */
struct tp_draw_kept_lines {
    tp_kept_lines *(*open)(void *memory, size_t bytes, const tp_kept_lines *wanted,
                           bool first_tile);
    void *(*find)(tp_kept_lines *kept, uint32_t number, bool *known);
};

#endif
