/* SPDX-License-Identifier: MIT */
/* Internals shared by the files of raster/raster.h: interpolation along a line and down
 * a column.
 *
 * A share of an interval is Q.31.  The part of a difference is the upper word of a
 * product, doubled.  Rows are 16.16 and at most 2^13 px, so differences stay below 2^31. */
#ifndef TP_RASTER_SCANLINE_COVER_H
#define TP_RASTER_SCANLINE_COVER_H
#include "base/word_pairs.h"
#include "raster/raster.h"

#define ROW 65536               /* a row in 16.16 */

/* Returns the limit of a column covered from row `row` down; a line with v <= limit
 * begins above. */
static inline int32_t v_limit_above_row(int32_t row)
{
    return row * ROW - ROW / 2;
}

/* Returns the first row with its centre at or below v. */
static inline int32_t first_row(int32_t v)
{
    return (v + (ROW / 2 - 1)) >> 16;
}

/* Returns q + share of d, share in Q.31. */
TP_ALWAYS_INLINE int32_t add_share(int32_t q, int32_t d, int32_t share)
{
    return (int32_t)((uint32_t)q + (uint32_t)tp_mul_upper(d, share) * 2);
}

TP_ALWAYS_INLINE int32_t difference(int32_t from, int32_t to)
{
    return (int32_t)((uint32_t)to - (uint32_t)from);
}

/* Interpolates packed slopes, share in Q.31.  The halved difference loses its lowest bit.
 * The sum wraps to 16 bits; the result is between two slopes and fits. */
TP_ALWAYS_INLINE uint32_t interpolate_slopes(uint32_t from, uint32_t to, int32_t share)
{
    uint32_t half = tp_shsub16(to, from);
    uint32_t z = (uint32_t)(tp_smulwb(share, half) >> 14);
    uint32_t x = (uint32_t)tp_smulwt(share, half) << 2;

    return tp_sadd16(from, (x & 0xffff0000u) | (z & 0xffff));
}

/* Returns the step of both slopes, `share_per_step` in Q.30.  The low half may carry
 * into the high half, an error of an LSB, 2^-12. */
TP_ALWAYS_INLINE uint32_t slopes_step(uint32_t from, uint32_t to, int32_t share_per_step)
{
    uint32_t half = tp_shsub16(to, from);
    int32_t  x = (tp_smulwt(share_per_step, half) + 4096) >> 13;

    return ((uint32_t)x << 16) + (uint32_t)((tp_smulwb(share_per_step, half) + 4096) >> 13);
}

/* True if s and t need perspective between two points of different depth.  Linear s and t
 * deviate by a quarter of (ratio - 1) times the length; half a pixel is allowed. */
static inline bool needs_row_perspective(uint32_t za, uint32_t zb, uint32_t length)
{
    uint32_t least = za < zb ? za : zb, more = za < zb ? zb - za : za - zb;
    return (uint64_t)(more >> 1) * (length + 1) > least;
}

/* A sample of a column, or the step from row to row. */
typedef struct {
    uint32_t key, s, t, n;
} sample;

TP_ALWAYS_INLINE uint32_t make_water_key(uint32_t zi)
{
    return (zi << 1 & ~(uint32_t)0xff) | TP_MARK_WATER;
}

/* Writes a sample.  The four planes have equal distances, so an address and the distance
 * give all four. */
TP_ALWAYS_INLINE void write_sample(uint32_t *at, size_t plane, const sample *p, bool tested)
{
    if (tested && p->key <= (at[0] | 0xff))
        return;
    at[0] = p->key;
    at[plane] = p->s;
    at[2 * plane] = p->t;
    at[3 * plane] = p->n;
}

TP_ALWAYS_INLINE size_t plane_stride(const tp_gbuffer *tile)
{
    return (size_t)(tile->s - tile->key);
}

TP_ALWAYS_INLINE uint32_t *key_pointer(const tp_gbuffer *tile, int32_t x, int32_t y)
{
    TP_ASSERT(x >= tile->x0 && x < tile->x1 && y >= tile->y0 && y < tile->y1);
    return tile->key + (size_t)(uint32_t)(y - tile->y0) * tile->stride
         + (uint32_t)(x - tile->x0);
}

/* Marks a column as covered from row y down. */
TP_ALWAYS_INLINE void mark_column_covered(tp_rows *rows, tp_row_column *column, int32_t top)
{
    column->limit = v_limit_above_row(top);
    if (top == rows->tile->y0) {
        column->limit = INT32_MIN;
        rows->open--;
    }
}

/* scanline_cover.c: the share of s and t for a share on the screen. */
int32_t tp_row_perspective_share(int32_t share, uint32_t za, uint32_t zb);

/* Returns the step between two exact positions, n = 1..16 rows or columns apart. */
uint32_t tp_row_st_step(uint32_t from, uint32_t to, int32_t n);

/* Fills rows [y, end) of column x between two lines; the whole piece begins at row
 * `top`. */
void tp_rows_fill_column(const tp_rows *rows, const tp_row_sample *near,
                         const tp_row_sample *far, int32_t x, int32_t y, int32_t end,
                         int32_t top);

/* Handles a column where the first line behind a gap, or the edge of a side, rises above
 * the covered rows.  The column then counts as covered from this line down, but the rows
 * between the previous line and this line are not drawn.  `behind_triangles`: triangles
 * fill the gap, and the pixel at the line is drawn; see tp_rows_restart_line. */
void tp_row_restart_column(tp_rows *rows, tp_row_column *column, const tp_row_sample *line,
                           bool behind_triangles);
#endif
