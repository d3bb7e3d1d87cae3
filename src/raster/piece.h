/* SPDX-License-Identifier: MIT */
/* What the files of raster/rows.h share: numbers along a line and down a column.
 *
 * A share of the way is a Q.31; a part of a difference is the upper word of a product,
 * doubled.  Rows are 16.16, of 2^13 pixels at the most, so that differences stay below
 * 2^31. */
#ifndef TP_RASTER_PIECE_H
#define TP_RASTER_PIECE_H
#include "raster/rows.h"

#define ROW 65536               /* 16.16 */

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

/* cover.c: the share of s and t where that of the screen is given. */
int32_t tp_row_deep_share(int32_t share, uint32_t za, uint32_t zb);

/* A step between true places, n = 1..16 rows or columns apart. */
uint32_t tp_row_step_between(uint32_t from, uint32_t to, int32_t n);

/* Column of a line that rises to its limit: what is seen between the line that it
 * remembers and this one, which covers it from now on; or, without a line before, the
 * pixel at this one if it is `joined`. */
void tp_row_cover(tp_rows *rows, tp_row_column *column, const tp_row_sample *line);
void tp_row_start(tp_rows *rows, tp_row_column *column, const tp_row_sample *line,
                  bool joined);
#endif
