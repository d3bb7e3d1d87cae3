/* SPDX-License-Identifier: MIT */
/* Level water as the lens sees it, pixel by pixel, without a mesh.
 *
 * The ray of pixel (X, Y) is d = focal ahead + u right + v up, u and v pixels from the
 * picture's centre: a sum that is linear in X and Y, along any direction of the world.
 * From an eye h above the level it meets water at eye + d h / -d.y, so
 *     near / depth is linear in X and Y, a sum of its own;
 *     s and t take a reciprocal, of -d.y, which is one for all of a row without roll;
 *     each straight side of the water is one sign: h d.x <= (x1 - eye.x) (-d.y), say.
 * Values are those of absolute X and Y: no tiling shows. */
#ifndef TP_GEOM_LEVEL_H
#define TP_GEOM_LEVEL_H
#include "geom/geom.h"
#include "geom/grid.h"
#include "geom/surface.h"
#include "wave/wave.h"

/* at + x X + y Y at the centre of pixel (X, Y). */
typedef struct {
    int64_t at, x, y;
} tp_level_sum;

#define TP_LEVEL_SIDES 5        /* west, east, north, south, and the near plane */
#define TP_LEVEL_ZI    12       /* bits of zi beyond Q1.31 */

typedef struct {
    tp_level_sum down, east, south;     /* -d.y, d.x, d.z: pixels, Q.30 */
    tp_level_sum zi;                    /* near / depth, Q1.43 */
    tp_level_sum side[TP_LEVEL_SIDES];  /* water where none is negative */
    tp_fx height, x, z;                 /* of the eye */
    tp_grid_extent across, along;       /* of the water, and where its waves fade */
    bool  rolled;
} tp_level;

#define TP_LEVEL_HEIGHT TP_FX(0.0625)   /* of the eye, at the least */

/* The eye is TP_LEVEL_HEIGHT over the level or more. */
void tp_level_begin(tp_level *level, const tp_lens *lens, const tp_grid_extent *across,
                    const tp_grid_extent *along);

TP_ALWAYS_INLINE int64_t tp_level_at(const tp_level_sum *sum, int32_t x, int32_t y)
{
    return sum->at + sum->x * x + sum->y * y;
}

/* A straight line of the picture: the row of column X, pixels in Q.30, is at + x X. */
typedef struct {
    int64_t at, x;
} tp_level_line;

/* Where a sum is 0, if it grows downwards, and by no less than it does to a side. */
tp_level_line tp_level_zero(const tp_level_sum *sum);

/* A sum at column x and a row in Q.30; rows and sums are below 2^14. */
TP_ALWAYS_INLINE int64_t tp_level_at_row(const tp_level_sum *sum, int32_t x, int64_t row)
{
    return sum->at + sum->x * x + (sum->y * (row >> 14) >> 16);
}

/* h / -d.y: `factor` 2^-shift metres, 16.16, a pixel in Q.16. */
typedef struct {
    int32_t factor;
    int     shift;
} tp_level_reach;

tp_level_reach tp_level_reach_of(const tp_level *level, int64_t down);      /* > 0 */

/* Metres, 16.16: 31 bits times 30.  Bits above 32 are cut off. */
TP_ALWAYS_INLINE int64_t tp_level_along(tp_level_reach reach, int64_t pixels_q30)
{
    return (int64_t)reach.factor * (int32_t)(pixels_q30 >> 14) >> reach.shift;
}

/* The place that a pixel's centre shows, and whether it shows any within +-32 km. */
bool tp_level_place(const tp_level *level, int32_t x, int32_t y, tp_fx place[2]);

/* Pixels of row y between *x0 and *x1 that show water; their sides are those of `mask`. */
void tp_level_span(const tp_level *level, unsigned mask, int32_t y, int32_t *x0,
                   int32_t *x1);

/* The sides that some pixel of a tile, x1 and y1 not included, is beyond. */
unsigned tp_level_mask(const tp_level *level, int32_t x0, int32_t y0, int32_t x1,
                       int32_t y1);

/* The surface's point whose place at rest is given, of the waves that a lattice carries
 * whose points lie `step` apart there, one way and the other: waves shorter than two
 * steps are left out, those longer than four are whole.  All fade as the grid's do. */
tp_sea_point tp_level_point(const tp_level *level, const tp_surface *surface,
                            const tp_fx place[2], tp_fx step[2][2]);

/* Its slopes as samples have them. */
static inline uint32_t tp_level_slopes(const tp_sea_point *at)
{
    int32_t x = tp_clamp((at->slope_x + 8) >> 4, INT16_MIN, INT16_MAX);
    int32_t z = tp_clamp((at->slope_z + 8) >> 4, INT16_MIN, INT16_MAX);
    return (uint32_t)x << 16 | ((uint32_t)z & 0xffff);
}
#endif
